//! What is done to expressions changes how values are computed, and never the values.
//!
//! Random trees, evaluated in numbers that bound their own error, against the same trees
//! after each pass. Nothing is compared where the tree itself has no value, or none that rounding leaves
//! any digit of.

use lagrangian_symbolic::testing::Fault;
use lagrangian_symbolic::{Expression, Graph, Program, Symbol};
use lagrangian_symbolic_testing::bounded::Bounded;
use lagrangian_symbolic_testing::machine::run;
use lagrangian_symbolic_testing::tree::{Tree, at, distributed, formulas, points, trees};
use lagrangian_symbolic_testing::{Number, evaluate};
use proptest::prelude::*;

/// Two trees, of all functions or of those that mechanics is made of.
fn pairs() -> impl Strategy<Value = [Tree; 2]> {
    prop_oneof![[trees(), trees()], [formulas(), formulas()], distributed(),]
}

/// Whether `found` can be the value that was `written`, which may have none.
fn keeps(written: Bounded, found: Bounded) -> bool {
    !written.is_reliable() || (!found.value.is_nan() && found.agrees(written))
}

/// Two expressions, and what they have in common with their sums and products.
fn family(graph: &mut Graph, trees: &[Tree; 2]) -> Vec<Expression> {
    let [x, y] = [0, 1].map(|i| trees[i].build(graph));
    let (sum, product) = (graph.add(x, y), graph.multiply(x, y));
    let square = graph.square(sum);
    vec![x, y, sum, product, square]
}

/// The values of the same family, from the trees as they stand.
fn values(trees: &[Tree; 2], symbol: &impl Fn(Symbol) -> Bounded) -> Vec<Bounded> {
    let [x, y] = [0, 1].map(|i| trees[i].evaluate(symbol));
    let sum = x.add(y);
    vec![x, y, sum, x.multiply(y), sum.multiply(sum)]
}

/// Whether a program is right at a random point in modular arithmetic, or too rich in poles for one.
fn is_verified(program: &Program, graph: &Graph, groups: &[&[Expression]]) -> bool {
    matches!(
        program.verify(graph, groups),
        Ok(()) | Err(Fault::Undecided)
    )
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn multiplying_out_keeps_values(trees in pairs(), point in points()) {
        let value = |symbol| Bounded::exact(at(&point, symbol));
        let mut graph = Graph::new();
        let roots = family(&mut graph, &trees);
        for (root, written) in roots.into_iter().zip(values(&trees, &value)) {
            let (simplest, factored) = (graph.simplest(root), graph.factored(root));
            prop_assert!(graph.cost(&[simplest]) <= graph.cost(&[root]));
            for form in [root, simplest, factored] {
                let found = evaluate(&graph, form, value);
                prop_assert!(keeps(written, found), "{written:?} became {found:?}: {:?}", graph.node(form));
            }
        }
    }

    #[test]
    fn programs_keep_values(trees in pairs(), point in points()) {
        let value = |symbol| Bounded::exact(at(&point, symbol));
        let mut graph = Graph::new();
        let roots = family(&mut graph, &trees);
        let groups = [&roots[..2], &roots[2..]];
        let program = Program::schedule(&graph, &groups);
        prop_assert!(is_verified(&program, &graph, &groups), "{program:?}");
        let found = run(&program, value).concat();
        let numbers = program.evaluate(|symbol| at(&point, symbol)).concat();
        for ((written, found), number) in values(&trees, &value).into_iter().zip(found).zip(numbers) {
            prop_assert!(keeps(written, found), "{written:?} became {found:?}: {program:?}");
            prop_assert!(keeps(found, Bounded::exact(number)), "{found:?} is not {number}");
        }
    }

    #[test]
    fn staged_programs_keep_values(trees in pairs(), point in points()) {
        let value = |symbol| Bounded::exact(at(&point, symbol));
        let mut graph = Graph::new();
        let roots = family(&mut graph, &trees);
        let groups = [&roots[..2], &roots[2..]];
        let program = Program::schedule_for_staging(&graph, &groups);
        prop_assert!(is_verified(&program, &graph, &groups), "{program:?}");
        let parts = program.hoist_invariants();
        let invariants = run(&parts.setup, |symbol| match symbol {
            Symbol::Parameter(_) => value(symbol),
            _ => panic!("{symbol:?} varies"),
        });
        let found = run(&parts.kernel, |symbol| match symbol {
            Symbol::Invariant(index) => invariants[0][index as usize],
            _ => value(symbol),
        });
        for (written, found) in values(&trees, &value).into_iter().zip(found.concat()) {
            prop_assert!(keeps(written, found), "{written:?} became {found:?}: {parts:?}");
        }
    }
}
