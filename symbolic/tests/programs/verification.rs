//! Programs against the expressions that they were made from.

use lagrangian_symbolic::testing::Fault;
use lagrangian_symbolic::{Equations, Expression, Graph, ModularPoint, Program, Rational, Symbol};
use lagrangian_symbolic_testing::systems::rigid_body;
use lagrangian_symbolic_testing::{assert_close, value};

#[test]
fn programs_compute_what_they_were_made_from() {
    let mut model = rigid_body();
    let equations = Equations::derive(&mut model).unwrap();
    let mass: Vec<_> = equations.mass.concat();
    let groups: [&[Expression]; 2] = [&mass, &equations.inverse_dynamics];
    let program = Program::schedule(&model.graph, &groups);
    assert_eq!(program.verify(&model.graph, &groups), Ok(()));
    let values = program.evaluate(value);
    for (roots, values) in groups.iter().zip(values) {
        for (expected, found) in model.graph.evaluate(roots, value).into_iter().zip(values) {
            assert_close(found, expected);
        }
    }
}

#[test]
fn programs_expand_to_the_expressions_that_they_were_made_from() {
    let mut model = rigid_body();
    let equations = Equations::derive(&mut model).unwrap();
    let groups: [&[Expression]; 2] = [&equations.mass.concat(), &equations.forcing];
    let program = Program::schedule(&model.graph, &groups);
    let expanded = program.expand(&mut model.graph);
    for (root, again) in groups.concat().into_iter().zip(expanded.concat()) {
        let difference = model.graph.subtract(root, again);
        for seed in 0..3 {
            assert_eq!(
                ModularPoint::new(seed).evaluate(&model.graph, &[difference]),
                Some(vec![0])
            );
        }
    }
}

#[test]
fn a_wrong_program_is_found_out() {
    let mut model = rigid_body();
    let equations = Equations::derive(&mut model).unwrap();
    let groups: [&[Expression]; 1] = [&equations.forcing];
    let program = Program::schedule(&model.graph, &groups);

    let mut swapped = program.clone();
    swapped.groups[0].outputs.swap(0, 1);
    assert!(swapped.verify(&model.graph, &groups).is_err());

    let mut unordered = program.clone();
    unordered.groups[0].instructions.reverse();
    assert!(unordered.verify(&model.graph, &groups).is_err());

    let mut repeated = program;
    let first = repeated.groups[0].instructions[0].clone();
    repeated.groups[0].instructions.insert(1, first);
    assert!(repeated.verify(&model.graph, &groups).is_err());
}

#[test]
fn programs_with_roots_are_verified_too() {
    let mut graph = Graph::new();
    let roots: Vec<_> = (0..12)
        .map(|i| {
            let x = graph.symbol(Symbol::Parameter(i));
            let exponent = Rational::new(2 * i64::from(i) + 1, 2).unwrap();
            graph.power(x, &exponent)
        })
        .collect();
    let program = Program::schedule(&graph, &[&roots]);
    assert_eq!(program.verify(&graph, &[&roots]), Ok(()));
    let mut wrong = program;
    wrong.groups[0].outputs.swap(3, 4);
    assert!(matches!(
        wrong.verify(&graph, &[&roots]),
        Err(Fault::WrongOutput {
            group: 0,
            output: 3
        })
    ));
}
