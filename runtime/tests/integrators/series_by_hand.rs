//! Systems whose Taylor series are written by hand, with building blocks.

use crate::common::{assert_close, in_lanes};
use lagrangian::prelude::*;
use lagrangian::recurrences::Square;
use lagrangian::{ComponentName, Series, SeriesMemory, TaylorCoefficients};
use nalgebra::SVector;

/// ẋ = x², whose solution from 1 is 1/(1 − t), written with the building blocks.
struct Riccati;

impl<S: Scalar> Dynamics<S> for Riccati {
    type State = SVector<S, 1>;

    fn derivative(&self, _: S, x: &Self::State) -> Self::State {
        SVector::from([x[0] * x[0]])
    }
}

impl<S: Scalar> Series<S> for Riccati {
    fn series<const HALF: usize>(
        &self,
        (t, x): (S, &Self::State),
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        _: Option<&mut SeriesMemory>,
    ) {
        let mut square = Square::<S, HALF>::new();
        coefficients.solve(t, x, unit, |_, x| SVector::from([square.next(x[0])]));
    }
}

#[test]
fn recurrences_can_be_written_by_hand() {
    let start = At::from((0.0, SVector::from([1.0])));
    let end = Problem::new(&Riccati, start)
        .solve(0.99, Taylor::new())
        .unwrap();
    assert_close(end[0], 100.0, 1e-9);
}

#[test]
fn a_pole_of_the_solution_names_its_component() {
    let start = At::from((0.0, SVector::from([1.0])));
    let error = Problem::new(&Riccati, start)
        .solve(2.0, Taylor::new())
        .unwrap_err()
        .error();
    let IntegrationError::StepTooSmall {
        time, component, ..
    } = error
    else {
        panic!("{error}");
    };
    assert_close(time, 1.0, 1e-6);
    assert!(component.is_some());
}

/// ẋ₀ = −x₀ beside ẋ₁ = x₁², which has a pole.
struct DecayAndPole;

impl<S: Scalar> Dynamics<S> for DecayAndPole {
    type State = SVector<S, 2>;

    fn derivative(&self, _: S, x: &Self::State) -> Self::State {
        SVector::from([-x[0], x[1] * x[1]])
    }
}

impl<S: Scalar> Series<S> for DecayAndPole {
    fn series<const HALF: usize>(
        &self,
        (t, x): (S, &Self::State),
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        _: Option<&mut SeriesMemory>,
    ) {
        let mut square = Square::<S, HALF>::new();
        coefficients.solve(t, x, unit, |_, x| SVector::from([-x[0], square.next(x[1])]));
    }
}

crate::alike_in_lanes!(DecayAndPole);

/// The component that limits the step is named, alone and in a lane.
#[test]
fn the_component_with_the_pole_is_named() {
    let start = At::from((0.0, SVector::from([1.0, 1.0])));
    let alone = Problem::new(&DecayAndPole, start).solve(2.0, Taylor::new());
    let in_lanes = in_lanes::<2, _, _>(Taylor::new(), &DecayAndPole, [(start, 2.0)]);
    for error in [
        alone.unwrap_err().error(),
        *in_lanes[0].as_ref().unwrap_err(),
    ] {
        let IntegrationError::StepTooSmall { component, .. } = error else {
            panic!("{error}");
        };
        assert_eq!(component, Some(ComponentName::Index(1)));
    }
}
