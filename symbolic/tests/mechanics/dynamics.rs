//! The accelerations, and their derivatives, against M q̈ = f.

use std::collections::BTreeMap;

use lagrangian_symbolic::{
    Equations, Expression, Graph, Kinetics, Model, ModularPoint, Rational, Solution, Symbol,
};
use lagrangian_symbolic_testing::systems::{
    Chain, Spelling, cardan_rates, cart_pole, charged, driven_pendulum, euler_rates, general_top,
    indefinite, node_rates, polar, stiffening, top,
};
use lagrangian_symbolic_testing::value;

/// All systems, by what they are.
fn systems() -> Vec<(String, Model)> {
    let mut systems: Vec<(String, Model)> = vec![
        ("general top".into(), top(euler_rates, [0, 1, 2])),
        ("(4.5) with I₁ = I₂".into(), top(euler_rates, [0, 0, 2])),
        ("symmetric top".into(), top(node_rates, [0, 0, 2])),
        ("Cardan's angles".into(), top(cardan_rates, [0, 1, 2])),
        ("cart and pole".into(), cart_pole()),
        ("moving pivot".into(), driven_pendulum()),
        ("polar coordinates".into(), polar()),
        ("magnetic field".into(), charged()),
        ("L = ẋẏ".into(), indefinite()),
        ("ẋ⁴".into(), stiffening()),
    ];
    for spelling in [Spelling::SecondExpanded, Spelling::Expanded] {
        systems.push((format!("{spelling:?}"), general_top(spelling)));
    }
    for links in 1..=8 {
        systems.push((format!("chain of {links}"), Chain::of(links).model()));
    }
    for (relative, different, driven) in [
        (false, true, false),
        (true, false, false),
        (true, true, true),
        (false, false, true),
    ] {
        let chain = Chain {
            relative,
            different,
            driven,
            ..Chain::of(3)
        };
        systems.push((format!("{chain:?}"), chain.model()));
    }
    systems
}

/// Whether all expressions vanish at three random points.
fn vanish(graph: &Graph, roots: &[Expression]) -> bool {
    let values = (0..64).filter_map(|seed| ModularPoint::new(seed).evaluate(graph, roots));
    let found: Vec<_> = values.take(3).collect();
    assert_eq!(found.len(), 3, "too few points");
    found.into_iter().flatten().all(|value| value == 0)
}

/// M x − r.
fn residuals(
    graph: &mut Graph,
    mass: &[Vec<Expression>],
    x: &[Expression],
    right: &[Expression],
) -> Vec<Expression> {
    let mut residuals = Vec::new();
    for (row, right) in mass.iter().zip(right) {
        let mut terms = vec![(*right, Rational::MINUS_ONE)];
        for (entry, x) in row.iter().zip(x) {
            terms.push((graph.multiply(*entry, *x), Rational::ONE));
        }
        residuals.push(graph.sum(terms));
    }
    residuals
}

#[test]
fn accelerations_solve_the_equations_of_motion() {
    for (what, mut model) in systems() {
        let equations = Equations::derive(&mut model).unwrap();
        let kinetics = Kinetics::cheapest(&mut model, &equations);
        let graph = &mut model.graph;
        let Some(solution) = kinetics.solution else {
            // No pivot to begin with: M is left to a numerical factorization.
            assert_eq!(what, "L = ẋẏ");
            continue;
        };
        let accelerations = &solution.accelerations;
        let rest = residuals(graph, &equations.mass, accelerations, &equations.forcing);
        assert!(vanish(graph, &rest), "{what}");
        assert!(solution.holds(graph, &equations), "{what}");
        for pivot in graph.evaluate(&solution.pivots, value) {
            assert!(pivot > 0.0, "{what}: pivot {pivot}");
        }
    }
}

#[test]
fn forcing_and_inverse_dynamics_are_lagranges() {
    for (what, mut model) in systems() {
        let equations = Equations::derive(&mut model).unwrap();
        let kinetics = Kinetics::cheapest(&mut model, &equations);
        let graph = &mut model.graph;
        let pairs = [
            (&kinetics.forcing, &equations.forcing),
            (&kinetics.inverse_dynamics, &equations.inverse_dynamics),
        ];
        for (found, expected) in pairs {
            let pairs = found.iter().zip(expected);
            let differences: Vec<_> = pairs.map(|(x, y)| graph.subtract(*x, *y)).collect();
            assert!(vanish(graph, &differences), "{what}");
        }
    }
}

/// The solution's derivatives less those that M ∂q̈/∂x = −∂(M q̈ − f)/∂x gives, with q̈ put in.
fn derivative_residuals(
    model: &mut Model,
    equations: &Equations,
    kinetics: &Kinetics,
    solution: &Solution,
    symbols: &[Symbol],
) -> Option<Vec<Expression>> {
    let graph = &mut model.graph;
    let columns = kinetics.acceleration_derivatives(graph, symbols)?;
    let mut found = Vec::new();
    for (symbol, column) in symbols.iter().zip(columns.chunks(equations.mass.len())) {
        let slopes = graph.derivatives(&equations.inverse_dynamics, *symbol);
        let right: Vec<_> = slopes.into_iter().map(|x| graph.negate(x)).collect();
        found.extend(residuals(graph, &equations.mass, column, &right));
    }
    let accelerations = (0..).zip(&solution.accelerations);
    let values: BTreeMap<_, _> = accelerations
        .map(|(i, x)| (Symbol::Acceleration(i), *x))
        .collect();
    Some(graph.substitute(&found, &values))
}

#[test]
fn derivatives_solve_the_differentiated_equations() {
    let mut through_none = Vec::new();
    for (what, mut model) in systems() {
        let equations = Equations::derive(&mut model).unwrap();
        let kinetics = Kinetics::cheapest(&mut model, &equations);
        let Some(solution) = &kinetics.solution else {
            continue;
        };
        let coordinates = model.coordinate_symbols().into_iter();
        let mut symbols: Vec<_> = coordinates.chain(model.velocity_symbols()).collect();
        symbols.extend([Symbol::Time, Symbol::Input(0), Symbol::Parameter(1)]);
        match derivative_residuals(&mut model, &equations, &kinetics, solution, &symbols) {
            Some(rest) => assert!(vanish(&model.graph, &rest), "{what}"),
            None => through_none.push(what),
        }
    }
    let long: Vec<_> = (5..=8).map(|links| format!("chain of {links}")).collect();
    assert_eq!(through_none, long);
}

#[test]
fn derivatives_are_those_of_finite_differences() {
    let chosen = [
        "general top",
        "symmetric top",
        "chain of 3",
        "cart and pole",
    ];
    let systems = systems().into_iter();
    for (what, mut model) in systems.filter(|(what, _)| chosen.contains(&what.as_str())) {
        let equations = Equations::derive(&mut model).unwrap();
        let kinetics = Kinetics::cheapest(&mut model, &equations);
        let solution = kinetics.solution.as_ref().unwrap();
        let graph = &mut model.graph;
        let symbols = [
            Symbol::Coordinate(1),
            Symbol::Velocity(0),
            Symbol::Parameter(0),
        ];
        let columns = kinetics.acceleration_derivatives(graph, &symbols);
        let at = |shifted: Option<(Symbol, f64)>| {
            let value = |symbol| match shifted {
                Some((moved, step)) if moved == symbol => value(symbol) + step,
                _ => value(symbol),
            };
            graph.evaluate(&solution.accelerations, value)
        };
        let accelerations = at(None);
        let columns = graph.evaluate(&columns.unwrap(), |symbol| match symbol {
            Symbol::Acceleration(i) => accelerations[i as usize],
            _ => value(symbol),
        });
        let size = accelerations.len();
        for (symbol, column) in symbols.into_iter().zip(columns.chunks(size)) {
            let step = 1e-5;
            let (above, below) = (at(Some((symbol, step))), at(Some((symbol, -step))));
            for (i, found) in column.iter().enumerate() {
                let expected = (above[i] - below[i]) / (2.0 * step);
                // Rounding leaves 1e-11 of values of order ten, the formula about as much as step².
                let error = (found - expected).abs() / expected.abs().max(1.0);
                assert!(error < 1e-7, "{what}: {found} is not {expected}");
            }
        }
    }
}

#[test]
fn wrong_accelerations_do_not_hold() {
    for (what, mut model) in systems() {
        let equations = Equations::derive(&mut model).unwrap();
        let Some(mut solution) = Kinetics::cheapest(&mut model, &equations).solution else {
            continue;
        };
        assert!(solution.holds(&model.graph, &equations), "{what}");
        let last = solution.accelerations.len() - 1;
        let right = solution.accelerations.clone();
        // One of them doubled, all of them shifted, the first and the last exchanged.
        solution.accelerations[last] = model.graph.scale(right[last], &Rational::integer(2));
        assert!(!solution.holds(&model.graph, &equations), "{what}");
        solution.accelerations.clone_from(&right);
        for x in &mut solution.accelerations {
            *x = model.graph.add_constant(*x, &Rational::ONE);
        }
        assert!(!solution.holds(&model.graph, &equations), "{what}");
        solution.accelerations.clone_from(&right);
        solution.accelerations.swap(0, last);
        assert_eq!(
            solution.holds(&model.graph, &equations),
            last == 0,
            "{what}"
        );
    }
}
