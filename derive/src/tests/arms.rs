//! Mechanisms in space, declared as a textbook does: their cost grows with the number of links, whatever way the energy is
//! spelt.

mod bodies;
mod declarations;
mod derivatives;
mod kane;
mod mechanisms;
mod ordering;
mod printed;
mod recursions;
mod series;
mod solvers;
mod spellings;

use lagrangian_symbolic::{Kinetics, Program, Symbol};
use proc_macro2::TokenStream;

use crate::plan::Method;
use crate::tests::derived::{Derived, derive};
use bodies::arm_of_bodies;
pub(super) use declarations::arm;
use declarations::parallel_joints;
use kane::{Arm, Numbers, solve};
use mechanisms::{others, wheels};
use spellings::spellings;

/// Additions, multiplications and divisions.
fn operations(program: &Program) -> usize {
    let count = program.count();
    count.additions + count.multiplications + count.divisions
}

/// What is derived from a declaration, and agrees with Lagrange's equations.
fn derived(declaration: TokenStream) -> Derived {
    let derived = derive(declaration);
    let found = derived.methods.disagreements(&derived.validator);
    assert!(found.is_empty(), "{found:?}");
    derived
}

/// The values of a method at a state, with what has been prepared for it.
fn values(derived: &Derived, method: &Method, value: impl Fn(Symbol) -> f64) -> Vec<f64> {
    let prepared = derived.methods.prepare.program.evaluate(&value).concat();
    let all = method.program.evaluate(|symbol| match symbol {
        Symbol::Invariant(i) => prepared[i as usize],
        _ => value(symbol),
    });
    all.concat()
}

#[track_caller]
fn assert_near(found: &[f64], expected: &[f64]) {
    let size = expected.iter().fold(1.0, |size: f64, x| size.max(x.abs()));
    assert_eq!(found.len(), expected.len());
    for (x, y) in found.iter().zip(expected) {
        assert!((x - y).abs() < 1e-11 * size, "{x} is not {y}");
    }
}

#[test]
fn arms_move_as_partial_velocities_say() {
    for links in [2, 3, 4, 6, 9] {
        let derived = derived(arm(links));
        for seed in 0..4 {
            let mut numbers = Numbers::new(seed);
            let arm = Arm::new(links, &mut numbers);
            let parameters = arm.parameters();
            let [q, v, a] = [3.0, 1.0, 1.0].map(|size| {
                let list = (0..links).map(|_| size * numbers.next());
                list.collect::<Vec<_>>()
            });
            let value = |symbol| match symbol {
                Symbol::Coordinate(i) => q[i as usize],
                Symbol::Velocity(i) => v[i as usize],
                Symbol::Acceleration(i) => a[i as usize],
                Symbol::Parameter(i) => parameters[i as usize],
                _ => f64::NAN,
            };
            let (mass, bias) = arm.equations(&q, &v);
            let methods = &derived.methods;
            let residual: Vec<f64> = (0..links)
                .map(|i| bias[i] + (0..links).map(|j| mass[i][j] * a[j]).sum::<f64>())
                .collect();
            assert_near(
                &values(&derived, &methods.inverse_dynamics, value),
                &residual,
            );
            assert_near(
                &values(&derived, &methods.mass_matrix, value),
                &mass.concat(),
            );
            let momenta: Vec<f64> = (0..links)
                .map(|i| (0..links).map(|j| mass[i][j] * v[j]).sum())
                .collect();
            assert_near(&values(&derived, &methods.momenta, value), &momenta);
            let forcing: Vec<f64> = bias.iter().map(|x| -x).collect();
            assert_near(&values(&derived, &methods.forcing, value), &forcing);
            let pivots = methods.accelerations.outputs.pivots().unwrap_or(0);
            let found = values(&derived, &methods.accelerations, value);
            assert_near(&found[pivots..], &solve(mass, forcing));
        }
    }
}

/// Links, and the operations of algorithms written by hand with parameters prepared: of accelerations by composite bodies
/// up to seven links and by articulated bodies beyond, and of inverse dynamics by Newton and Euler.
const BY_HAND: [[usize; 3]; 8] = [
    [2, 77, 72],
    [3, 256, 193],
    [4, 480, 315],
    [5, 737, 437],
    [6, 1022, 554],
    [7, 1347, 676],
    [10, 2360, 1037],
    [20, 5298, 2247],
];

#[test]
#[ignore = "long arms; run with `--include-ignored`"]
fn an_arm_costs_no_more_than_the_algorithms_written_by_hand() {
    compare_with_algorithms_by_hand(&BY_HAND);
}

#[test]
fn a_short_arm_costs_no_more_than_the_algorithms_written_by_hand() {
    compare_with_algorithms_by_hand(&BY_HAND[..7]);
}

fn compare_with_algorithms_by_hand(counts: &[[usize; 3]]) {
    for &[links, accelerations, inverse_dynamics] in counts {
        let Derived { methods, .. } = derive(arm(links));
        let found = operations(&methods.accelerations.program);
        assert!(found <= accelerations, "{links}: {found}");
        // The momenta cost about what inverse dynamics does.
        let momenta = operations(&methods.momenta.program);
        assert!(momenta <= inverse_dynamics * 5 / 4, "{links}: {momenta}");
        let found = operations(&methods.inverse_dynamics.program);
        assert!(found <= inverse_dynamics, "{links}: {found}");
    }
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn the_spelling_of_an_arm_does_not_matter() {
    compare_spellings(6);
}

#[test]
fn the_spelling_of_a_short_arm_does_not_matter() {
    compare_spellings(3);
}

fn compare_spellings(links: usize) {
    let costs = |declaration| {
        let methods = derived(declaration).methods;
        let methods = [methods.accelerations, methods.inverse_dynamics];
        methods.map(|method| operations(&method.program))
    };
    let expected = costs(arm(links));
    for (spelling, declaration) in spellings(links) {
        let found = costs(declaration);
        println!("{links} links, {spelling}: {found:?}, {expected:?}");
        for (found, expected) in found.into_iter().zip(expected) {
            assert!(
                10 * found <= 11 * expected,
                "{links} links, {spelling}: {found}, {expected}"
            );
        }
    }
    // Angles against each other, and against the horizontal.
    let [relative, absolute] = [false, true].map(|is_absolute| costs(parallel_joints(is_absolute)));
    assert_eq!(relative, [469, 309]);
    assert_eq!(absolute, relative);
}

/// A free base and slides, whose velocities are computed along the links.
#[test]
fn velocities_that_are_computed_cost_what_those_of_positions_do() {
    for (name, declarations) in recursions::pairs() {
        let [expected, found] = declarations.map(|declaration| {
            let methods = derived(declaration).methods;
            let methods = [methods.accelerations, methods.inverse_dynamics];
            methods.map(|method| operations(&method.program))
        });
        println!("{name}: {found:?}, {expected:?}");
        for (found, expected) in found.into_iter().zip(expected) {
            assert!(10 * found <= 11 * expected, "{name}: {found}, {expected}");
        }
    }
}

/// With what has been prepared. That the tensor of a body is symmetric is known, and that of a matrix is not.
#[test]
fn an_arm_of_bodies_costs_no_more_than_one_of_numbers() {
    let costs = |declaration| {
        let Derived { model, methods, .. } = derived(declaration);
        let methods = [methods.accelerations, methods.inverse_dynamics];
        methods.map(|method| operations(&method.program.staged(model.graph.passes).kernel))
    };
    for links in [2, 3, 6] {
        let [bodies, numbers] = [arm_of_bodies(links), arm(links)].map(costs);
        println!("{links}: {bodies:?}, {numbers:?}");
        assert!(bodies[0] <= numbers[0] && bodies[1] <= numbers[1]);
    }
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn accelerations_solve_lagranges_equations() {
    solve_lagranges_equations(1);
}

#[test]
fn some_accelerations_solve_lagranges_equations() {
    solve_lagranges_equations(3);
}

/// Exactly, at random points of modular arithmetic: of one mechanism of so many.
fn solve_lagranges_equations(stride: usize) {
    for (name, declaration) in others().into_iter().step_by(stride) {
        let Derived {
            mut model,
            equations,
            ..
        } = derive(declaration);
        let kinetics = Kinetics::cheapest(&mut model, &equations);
        let solution = kinetics.solution.unwrap();
        assert!(solution.holds(&model.graph, &equations), "{name}");
    }
}

/// Branches, free bases, slides, gears, moving supports: all agree with Lagrange's equations.
#[test]
fn mechanisms_of_other_kinds() {
    let found = others().into_iter().map(|(name, declaration)| {
        let methods = derived(declaration).methods;
        (name, operations(&methods.accelerations.program))
    });
    let found: Vec<_> = found.collect();
    let expected = [
        ("branches", 842),
        ("free base", 849),
        ("slides", 471),
        ("gears", 545),
        ("moving support", 359),
        ("spherical joints", 737),
        ("springs", 305),
        ("rotors", 498),
        ("many rotors", 2218),
        ("Denavit and Hartenberg", 1447),
        ("wheels", 805),
    ];
    assert_eq!(found, expected);
}

#[test]
fn angles_of_wheels_are_in_no_equation() {
    let Derived {
        mut model,
        equations,
        ..
    } = derive(wheels());
    let kinetics = Kinetics::cheapest(&mut model, &equations);
    let written = model.graph.symbols(&equations.inverse_dynamics);
    let solution = kinetics.solution.unwrap();
    let roots = [
        kinetics.forcing,
        kinetics.inverse_dynamics,
        solution.accelerations,
    ];
    let left = model.graph.symbols(&roots.concat());
    for wheel in [7, 8] {
        let angle = Symbol::Coordinate(wheel);
        assert!(equations.coordinate_properties.ignorable[wheel as usize]);
        assert!(written.contains(&angle) && !left.contains(&angle));
    }
}
