//! What the accelerations cost, however a system is spelt.

use lagrangian_symbolic::{Equations, Kinetics, Model, Program};
use lagrangian_symbolic_testing::Draft;
use lagrangian_symbolic_testing::systems::{
    Chain, Rates, Spelling, cardan_rates, cart_pole, euler_rates, general_top, node_rates, top,
};

/// The cost of one evaluation of the accelerations, in additions; hoisted invariants cost nothing.
fn cost(mut model: Model) -> usize {
    let equations = Equations::derive(&mut model).unwrap();
    let solution = Kinetics::cheapest(&mut model, &equations).solution.unwrap();
    let roots = [&*solution.pivots, &solution.accelerations];
    let program = Program::schedule_for_staging(&model.graph, &roots);
    assert_eq!(program.verify(&model.graph, &roots), Ok(()));
    program.hoist_invariants().kernel.count().cost()
}

#[test]
fn a_top_costs_the_same_however_its_energy_is_written() {
    let spellings = [
        Spelling::Squares,
        Spelling::SecondExpanded,
        Spelling::Expanded,
        Spelling::Tensor,
    ];
    let costs = spellings.map(|spelling| cost(general_top(spelling)));
    let (least, most) = (costs.iter().min().unwrap(), costs.iter().max().unwrap());
    assert!(10 * most <= 11 * least, "{spellings:?} cost {costs:?}");
    // Two pairs of sine and cosine are 24 of them and the division by sin θ 5: Euler's equations and the
    // kinematics have 42 additions and multiplications.
    assert!(*most <= 71, "{costs:?}");
}

#[test]
fn equal_inertias_make_a_symmetric_top() {
    let (general, symmetric) = (
        cost(top(euler_rates, [0, 0, 2])),
        cost(top(node_rates, [0, 0, 2])),
    );
    assert!(general <= symmetric, "(4.5): {general}, (4.7): {symmetric}");
    let different = cost(top(euler_rates, [0, 1, 2]));
    assert!(symmetric < different, "{symmetric} and {different}");
}

#[test]
fn angles_about_other_axes_cost_no_more() {
    let rates: [fn(&Draft) -> Rates<'_>; 2] = [euler_rates, cardan_rates];
    let [euler, cardan] = rates.map(|rates| cost(top(rates, [0, 1, 2])));
    assert!(10 * cardan <= 11 * euler, "{cardan} and {euler}");
}

#[test]
fn a_chain_grows_by_a_constant_for_each_link() {
    for different in [false, true] {
        let [two, five, eight] = [2, 5, 8].map(|links| {
            let chain = Chain {
                different,
                ..Chain::of(links)
            };
            cost(chain.model())
        });
        let (early, late) = (five - two, eight - five);
        assert!(10 * late <= 12 * early, "{two}, {five}, {eight}");
    }
}

#[test]
fn the_order_of_bodies_does_not_matter() {
    let chain = Chain {
        different: true,
        ..Chain::of(5)
    };
    let reversed = Chain {
        reversed: true,
        ..chain
    };
    let [first, second] = [chain, reversed].map(|chain| cost(chain.model()));
    assert!(10 * second.abs_diff(first) <= first, "{first} and {second}");
}

#[test]
fn a_cart_with_a_pole_costs_what_it_costs_by_hand() {
    // One pair of sine and cosine, one division, and thirteen additions and multiplications.
    let found = cost(cart_pole());
    assert!(found <= 30, "{found}");
}
