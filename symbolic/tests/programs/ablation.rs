//! What a pass changes is the cost of a result and never the result: with each of them switched off, and
//! with all, the accelerations solve the equations of motion and the programs compute them.

use lagrangian_symbolic::{Equations, Kinetics, Model, Pass, Passes, Program};
use lagrangian_symbolic_testing::systems::{Chain, Spelling, cart_pole, general_top, polar};

/// Every pass off by itself, and all together.
fn choices() -> impl Iterator<Item = Passes> {
    let all = Passes::default();
    let each = Pass::ALL.iter().map(move |pass| all.without(*pass));
    let none = Pass::ALL.iter().fold(all, |some, pass| some.without(*pass));
    each.chain([none])
}

fn check(model: &Model) {
    for passes in choices() {
        let mut model = model.clone();
        model.graph.passes = passes;
        let equations = Equations::derive(&mut model).unwrap();
        let kinetics = Kinetics::cheapest(&mut model, &equations);
        let mut roots = kinetics.forcing.clone();
        if let Some(solution) = kinetics.solution {
            assert!(solution.holds(&model.graph, &equations), "{passes:?}");
            roots.extend(solution.accelerations);
        }
        let groups = [roots.as_slice()];
        let program = Program::schedule_for_staging(&model.graph, &groups);
        let verdict = program.verify(&model.graph, &groups);
        assert_eq!(verdict, Ok(()), "{passes:?}");
    }
}

#[test]
fn tops_move_the_same_without_any_pass() {
    for spelling in [Spelling::Squares, Spelling::Expanded] {
        check(&general_top(spelling));
    }
}

#[test]
fn chains_move_the_same_without_any_pass() {
    for links in [2, 5] {
        let equal = Chain::of(links);
        check(&equal.model());
        check(
            &Chain {
                relative: true,
                different: true,
                ..equal
            }
            .model(),
        );
    }
}

#[test]
fn others_move_the_same_without_any_pass() {
    check(&cart_pole());
    check(&polar());
}

#[test]
fn nothing_is_prepared_without_preparation() {
    let model = Chain::of(2).model();
    let passes = Passes::default().without(Pass::Staging);
    let everything: Vec<_> = model.graph.nodes().map(|(root, _)| root).collect();
    let program = Program::schedule_for_staging(&model.graph, &[&everything]);
    assert!(program.hoist_invariants().setup.instructions().count() > 0);
    let all = program.count();
    let parts = program.staged(passes);
    assert_eq!(parts.setup.instructions().count(), 0);
    assert_eq!(parts.setup.groups.len(), 1);
    assert_eq!(parts.kernel.count(), all);
}
