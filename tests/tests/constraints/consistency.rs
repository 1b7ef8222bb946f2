//! Consistent states: what is found, what is refused, and how errors say it.
#![allow(clippy::float_cmp)] // What is held is not changed at all.

use lagrangian::assembly::AssemblyError;
use lagrangian::prelude::*;

/// A four-bar linkage by the angles of its bars.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    coordinates(crank, coupler, rocker),
    define(
        joint = [a * cos(crank), a * sin(crank)] + [b * cos(coupler), b * sin(coupler)],
        end = [d, 0.0] + [c * cos(rocker), c * sin(rocker)],
    ),
    kinetic = 0.5 * (inertia * dot(crank).powi(2) + inertia * dot(coupler).powi(2) + inertia * dot(rocker).powi(2)),
    constraint(closure = joint - end),
)]
struct FourBar {
    a: f64,
    b: f64,
    c: f64,
    d: f64,
    inertia: f64,
}

const FOUR_BAR: FourBar = FourBar {
    a: 1.0,
    b: 2.5,
    c: 2.0,
    d: 3.0,
    inertia: 0.1,
};

#[test]
fn a_linkage_is_assembled_with_its_crank_held() -> Result<(), AssemblyError> {
    let guess = State::new(0.0, [0.9, 0.2, 1.5], [2.0, 0.0, 0.0]);
    let found = FOUR_BAR
        .assemble(guess)
        .hold([FourBar::CRANK])
        .hold_velocities([FourBar::CRANK])
        .solve()?;
    let state = found.state;
    assert_eq!(state.q[0], 0.9);
    assert_eq!(state.v[0], 2.0);
    let (positions, velocities) = FOUR_BAR.constraint_residuals(&state);
    assert!(positions.amax() < 1e-15, "{positions}");
    assert!(velocities.amax() < 1e-15, "{velocities}");
    assert_eq!(found.moved.q[1], state.q[1] - 0.2);
    Ok(())
}

#[test]
fn a_linkage_that_cannot_be_closed_names_what_stays_open() {
    let long = FourBar { d: 6.0, ..FOUR_BAR };
    let guess = State::new(0.0, [0.9, 0.2, 1.5], [0.0; 3]);
    let error = long.assemble(guess).solve().unwrap_err();
    let AssemblyError::Positions(open) = error else {
        panic!("{error}");
    };
    let names: Vec<_> = open.iter().map(|(name, _)| name).collect();
    assert!(names.contains(&"closure[0]"), "{error}");
    assert!(error.to_string().contains("closure[0] by "), "{error}");
}

#[test]
fn velocities_that_are_held_and_cannot_be_are_refused() -> Result<(), AssemblyError> {
    let guess = State::new(0.0, [0.9, 0.2, 1.5], [0.0; 3]);
    let closed = FOUR_BAR.assemble(guess).solve()?.state;
    let moving = State::new(0.0, closed.q, SVector::from([1.0, 1.0, 0.0]));
    let held = FOUR_BAR.assemble(moving).hold_velocities([0, 1, 2]);
    let error = held.solve().unwrap_err();
    assert!(matches!(error, AssemblyError::Velocities(_)), "{error}");
    let guess = State::new(0.0, [f64::NAN, 0.2, 1.5], [0.0; 3]);
    let error = FOUR_BAR.assemble(guess).solve().unwrap_err();
    assert_eq!(
        error,
        AssemblyError::NotFinite {
            coordinate: "crank"
        }
    );
    Ok(())
}

#[test]
fn a_start_that_is_inconsistent_is_refused_by_name() -> Result<(), AssemblyError> {
    let guess = State::new(0.0, [0.9, 0.2, 1.5], [0.0; 3]);
    let error = Problem::new(&FOUR_BAR, guess)
        .solve(1.0, Dop853::new())
        .unwrap_err();
    let IntegrationError::Inconsistent {
        time,
        constraint,
        residual,
    } = error.error()
    else {
        panic!("{error}");
    };
    assert_eq!(time, 0.0);
    let expected = FOUR_BAR.constraint_residuals(&guess).0;
    let index = FourBar::CONSTRAINTS
        .iter()
        .position(|name| *name == constraint);
    assert_eq!(expected[index.unwrap()].abs(), residual.abs());
    // Velocities count, too.
    let closed = FOUR_BAR.assemble(guess).solve()?.state;
    let moving = State::new(0.0, closed.q, SVector::from([1.0, 0.0, 0.0]));
    let error = Problem::new(&FOUR_BAR, moving).solve(1.0, Dop853::new());
    let error = error.unwrap_err();
    assert!(error.to_string().contains("assemble"), "{error}");
    Ok(())
}

/// A constraint that has no value where x is not positive.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    coordinates(x, y, z),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2) + dot(z).powi(2)),
    constraint(wall = y - 1.0, growth = x.ln() - z),
)]
struct Growth {
    m: f64,
}

/// Returns the constraint that is named, and its residual.
fn inconsistency(error: IntegrationError) -> (&'static str, f64) {
    match error {
        IntegrationError::Inconsistent {
            constraint,
            residual,
            ..
        } => (constraint, residual),
        _ => panic!("{error}"),
    }
}

#[test]
fn a_residual_without_a_value_is_the_one_that_is_named() {
    let start = State::new(0.0, [-1.0, 5.0, 0.0], [0.0; 3]);
    let failed = Problem::new(&Growth { m: 1.0 }, start).solve(1.0, Dop853::new());
    let error = failed.expect_err("ln of −1 has no value").error();
    let (constraint, residual) = inconsistency(error);
    assert_eq!(constraint, "growth");
    assert!(residual.is_nan());
}

/// Two bodies on springs, held by constraints of which one is in large units.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = 0.5 * m * (x.powi(2) + y.powi(2)),
    constraint(wall = 1e9 * (y - 1.0), post = x - 2.0),
)]
struct Held {
    m: f64,
}

#[test]
fn the_unit_of_one_constraint_leaves_others_as_they_are() {
    let start = State::new(0.0, [2.0 + 1e-6, 1.0], [0.0; 2]);
    let failed = Problem::new(&Held { m: 1.0 }, start).solve(1.0, Dop853::new());
    let error = failed.expect_err("the post is elsewhere").error();
    let (constraint, residual) = inconsistency(error);
    assert_eq!(constraint, "post");
    assert!((residual - 1e-6).abs() < 1e-15, "{residual}");
}
