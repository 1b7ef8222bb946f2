//! Which form builds on which, and forces along the tree against Lagrange's.

use super::*;
use crate::Equations;
use crate::testing::systems::{Chain, charged, euler_rates, kinetic, node_rates, top};
use crate::testing::{Draft, Quantity};

/// The tree of a model, and the equations that it was found from.
fn tree(model: &mut Model) -> (KinematicTree, Equations) {
    let equations = Equations::derive(model).unwrap();
    let declared = QuasiVelocities::declared(&mut model.graph, equations.lagrangian).unwrap();
    let tree = KinematicTree::new(model, &declared, &equations.generalized_forces);
    (tree, equations)
}

/// How many links each form is made of: itself and those before it.
fn depths(tree: &KinematicTree) -> Vec<usize> {
    let mut depths: Vec<usize> = Vec::new();
    for form in &tree.forms {
        depths.push(1 + form.parent.map_or(0, |parent| depths[parent]));
    }
    depths
}

#[test]
fn the_velocity_of_a_body_builds_on_that_of_the_body_before_it() {
    for (different, reversed, driven) in (0..8).map(|n| (n & 1 > 0, n & 2 > 0, n & 4 > 0)) {
        let chain = Chain {
            different,
            reversed,
            driven,
            ..Chain::of(5)
        };
        let (tree, _) = tree(&mut chain.model());
        // Where the pivot rests, the two squares of the first body are one, (l φ̇)², and the second
        // body's velocities have nothing to build on. Where it moves across, the first velocity down
        // is divided by its length, and a multiple of another length does not build on it.
        let expected: &[usize] = match (driven, different) {
            (true, false) => &[1, 1, 2, 2, 3, 3, 4, 4, 5, 5],
            (true, true) => &[1, 1, 1, 2, 2, 3, 3, 4, 4, 5],
            (false, _) => &[1, 1, 1, 2, 2, 3, 3, 4, 4],
        };
        let mut depths = depths(&tree);
        depths.sort_unstable();
        assert_eq!(depths, expected, "{chain:?}");
        let mut children = tree.forms.iter().filter(|form| form.parent.is_some());
        assert!(children.all(|form| form.local.len() == 1));
    }
}

#[test]
fn sums_of_relative_angular_velocities_build_on_each_other() {
    // Wheels on one axle, ½ Σ Jₖ (θ̇₁ + … + θ̇ₖ)², in either order.
    for reversed in [false, true] {
        let draft = Draft::new(4);
        let [v1, v2, v3, v4] = draft.vs();
        let mut rates = [v1, v1 + v2, v1 + v2 + v3, v1 + v2 + v3 + v4];
        if reversed {
            rates.reverse();
        }
        let energy = kinetic(&draft, &rates, &[0, 1, 2, 3]);
        let (tree, _) = tree(&mut draft.natural(energy, draft.zero()));
        let parents: Vec<_> = tree.forms.iter().map(|form| form.parent).collect();
        assert_eq!(parents, [None, Some(0), Some(1), Some(2)]);
        assert!(tree.forms.iter().all(|form| form.local.len() == 1));
    }
}

#[test]
fn forms_of_either_sign_build_on_each_other() {
    // Depths yₖ = −(cos q₁ + … + cos qₖ), of which those with many terms are opposites of sums.
    let draft = Draft::new(12);
    let cosines = draft.qs::<12>().map(Quantity::cos);
    let depths = (1..=12).map(|k| -draft.sum(cosines[..k].iter().copied()));
    let rates: Vec<_> = depths.map(Quantity::dot).collect();
    let indices: Vec<u32> = (0..12).collect();
    let energy = kinetic(&draft, &rates, &indices);
    let (tree, _) = tree(&mut draft.natural(energy, draft.zero()));
    let parents: Vec<_> = tree.forms.iter().map(|form| form.parent).collect();
    let expected: Vec<_> = (0..12_usize).map(|k| k.checked_sub(1)).collect();
    assert_eq!(parents, expected);
}

#[test]
fn forms_that_share_nothing_have_no_parents() {
    for mut model in [
        top(euler_rates, [0, 1, 2]),
        top(node_rates, [0, 0, 2]),
        charged(),
    ] {
        let (tree, _) = tree(&mut model);
        assert!(tree.forms.iter().all(|form| form.parent.is_none()));
    }
}

#[test]
fn forces_along_the_tree_are_lagranges() {
    let flags = (0..8).map(|n| (n & 1 > 0, n & 2 > 0, n & 4 > 0));
    let chains = flags.map(|(relative, different, driven)| Chain {
        relative,
        different,
        driven,
        ..Chain::of(3)
    });
    let others = [
        top(euler_rates, [0, 1, 2]),
        top(node_rates, [0, 0, 2]),
        charged(),
    ];
    for mut model in chains.map(Chain::model).chain(others) {
        let (tree, equations) = tree(&mut model);
        let graph = &mut model.graph;
        let found = [tree.forcing(graph), tree.inverse_dynamics(graph)].concat();
        let expected = [equations.forcing, equations.inverse_dynamics].concat();
        for (x, y) in found.into_iter().zip(expected) {
            let difference = graph.subtract(x, y);
            assert!(graph.vanishes(&[difference]));
        }
    }
}

#[test]
fn equal_inertias_are_divided_out_and_different_ones_are_not() {
    for (different, divided) in [(false, true), (true, false)] {
        let chain = Chain {
            different,
            ..Chain::of(2)
        };
        let mut model = chain.model();
        let (tree, _) = tree(&mut model);
        let scaled = tree.divided_by_unit(&mut model.graph);
        let entry = scaled.inertia[0][0];
        assert_eq!(model.graph.as_constant(entry).is_some(), divided);
        let one = model.graph.one();
        assert_eq!(scaled.unit != one, divided);
    }
}
