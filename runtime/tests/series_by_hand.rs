//! Systems whose Taylor series are written by hand, with the building blocks of the emitted ones.

mod common;

use common::assert_close;
use lagrangian::prelude::*;
use lagrangian::{Convolutions, Series, TaylorCoefficients};
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
        _: S,
        x: &Self::State,
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
    ) {
        *coefficients.initial_mut() = *x;
        let mut squares = Convolutions::<S, 1, 1, HALF>::new();
        let mut last = x[0];
        let mut order = S::zero();
        for coefficient in coefficients.higher_mut() {
            let square = if order.smallest() > 0.0 {
                let [sum] = squares.sums();
                squares.advance(&[last], &[[0, 0]]);
                sum + (x[0] + x[0]) * last
            } else {
                x[0] * x[0]
            };
            order += S::one();
            last = square * unit / order;
            *coefficient = SVector::from([last]);
        }
    }
}

#[test]
fn recurrences_can_be_written_by_hand() {
    let start = (0.0, SVector::from([1.0]));
    let end = Taylor::new().integrate_to(&Riccati, start, 0.99).unwrap();
    assert_close(end.x[0], 100.0, 1e-9);
}

#[test]
fn a_pole_of_the_solution_names_its_component() {
    let start = (0.0, SVector::from([1.0]));
    let error = Taylor::new()
        .integrate_to(&Riccati, start, 2.0)
        .unwrap_err();
    let IntegrationError::StepTooSmall {
        time, component, ..
    } = error
    else {
        panic!("{error}");
    };
    assert_close(time, 1.0, 1e-6);
    assert!(component.is_some());
}
