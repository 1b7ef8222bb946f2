//! What is reported of states and choices that have no linear model.

use lagrangian::analysis::{IndependentVariables, StateSpace, TangentError, TangentSpace};
use lagrangian::prelude::*;

use super::linkages::*;
use super::mechanisms::*;

#[test]
fn coordinates_that_are_not_independent() {
    let bob = Bob::EXAMPLE;
    let hanging = bob.at(0.0, 0.0);
    let tangent = TangentSpace::at(&bob, &hanging).coordinates([Bob::Y]);
    let error = tangent.basis::<2>().expect_err("y does not determine x");
    let TangentError::NotIndependent {
        variables: IndependentVariables::Coordinates,
        free: "x",
        bound: "y",
        pivot,
    } = error
    else {
        panic!("{error}");
    };
    assert!(pivot < 1e-15);
    assert_eq!(
        error.to_string(),
        "the chosen coordinates are not independent at this state: `y` follows from the others, and none of them determines \
         `x` (pivot 0); choose `x` in place of `y`"
    );
    let tangent = TangentSpace::at(&bob, &hanging).velocities([Bob::Y]);
    let error = tangent.basis::<2>().expect_err("nor do velocities");
    let variables = IndependentVariables::Velocities;
    assert!(
        matches!(error, TangentError::NotIndependent { variables: found, .. } if found == variables)
    );
}

#[test]
fn numbers_of_variables() {
    let bob = Bob::EXAMPLE;
    let hanging = bob.at(0.0, 0.0);
    let tangent = || TangentSpace::at(&bob, &hanging);
    let error = tangent()
        .coordinates([0, 1])
        .basis::<3>()
        .expect_err("too many");
    let expected = TangentError::Count {
        variables: IndependentVariables::Coordinates,
        chosen: 2,
        independent: 1,
    };
    assert_eq!(error, expected);
    let error = tangent().basis::<4>().expect_err("another dimension");
    assert_eq!(
        error.to_string(),
        "the linear model has 1 coordinates and 1 velocities: `D` is 2, not 4"
    );
    let error = tangent()
        .velocities([7])
        .basis::<2>()
        .expect_err("no such coordinate");
    assert_eq!(error, TangentError::NoSuchCoordinate { index: 7 });
}

#[test]
fn states_off_the_constraints() {
    let bob = Bob::EXAMPLE;
    let mut state = bob.at(0.0, 0.0);
    state.q[Bob::Y] *= 1.001;
    let error = TangentSpace::at(&bob, &state)
        .basis::<2>()
        .expect_err("the rod is longer");
    assert!(
        matches!(error, TangentError::Inconsistent { constraint: "rod", residual } if residual > 1e-4)
    );
    let mut state = bob.at(0.0, 0.0);
    state.v[Bob::Y] = 1e-3;
    let error = TangentSpace::at(&bob, &state)
        .basis::<2>()
        .expect_err("the rod grows");
    assert!(matches!(
        error,
        TangentError::Inconsistent {
            constraint: "rod",
            ..
        }
    ));
}

#[test]
fn singular_configurations() {
    let rhombus = FourBar::RHOMBUS;
    let state = State::new(0.0, [0.0; 3], [0.0; 3]);
    let error = TangentSpace::at(&rhombus, &state)
        .along_motion()
        .basis::<2>();
    let error = error.expect_err("all bars lie in one line");
    let TangentError::Singular {
        constraint,
        rank: 1,
        nearby: 2,
    } = error
    else {
        panic!("{error}");
    };
    assert!(constraint.starts_with("joint"), "{constraint}");
}

#[test]
fn motions_that_are_not_steady() {
    let bob = Bob::EXAMPLE;
    let swinging = bob.at(0.0, 1.0);
    let error = TangentSpace::at(&bob, &swinging)
        .basis::<2>()
        .expect_err("it moves");
    assert!(
        matches!(error, TangentError::Moving { name: "x", velocity } if (velocity - 0.7).abs() < 1e-15)
    );
    let raised = bob.at(1.0, 0.0);
    let plant = StateSpace::<f64, 2, 0, 2>::reduced_free(&TangentSpace::at(&bob, &raised));
    let error = plant.expect_err("it falls");
    assert!(matches!(error, TangentError::Accelerated { .. }), "{error}");
    assert!(error.to_string().contains("along_motion"));
}

#[test]
fn what_acts_cannot_be_left_out() {
    let crank = Crank::EXAMPLE;
    let state = crank.turned(0.4, 0.0);
    let tangent = TangentSpace::at(&crank, &state)
        .without([Crank::ALPHA])
        .along_motion();
    let error = tangent.basis::<1>().expect_err("gravity and the spring");
    assert!(
        matches!(error, TangentError::Acts { coordinate: "alpha", on: "alpha", slope } if slope.abs() > 1.0)
    );
}
