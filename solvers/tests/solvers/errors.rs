//! What is refused, as a value.

use lagrangian::prelude::*;
use lagrangian::{ComponentName, Dynamics, Phase};
use lagrangian_solvers::{OdeSystem, SystemError};

use crate::models::{VanDerPol, top, van_der_pol};

#[test]
fn slices_of_other_sizes_are_refused() {
    let (model, start) = top();
    let system = OdeSystem::new(&model, start).unwrap();
    let (six, mut other) = ([0.5; 6], [0.0; 5]);
    let wrong = |expected, found| Err(SystemError::WrongSize { expected, found });
    assert_eq!(system.state(0.0, &other).map(|_| ()), wrong(6, 5));
    assert_eq!(system.derivative(0.0, &six, &mut other), wrong(6, 5));
    assert_eq!(system.derivative(0.0, &other, &mut [0.0; 6]), wrong(6, 5));
    assert_eq!(system.jacobian(0.0, &six, &mut [0.0; 6]), wrong(36, 6));
    assert_eq!(system.jacobian(0.0, &other, &mut [0.0; 36]), wrong(6, 5));
    assert_eq!(
        system.initial_array::<5>(),
        Err(SystemError::WrongSize {
            expected: 6,
            found: 5
        })
    );
    let message = "6 numbers are expected, not 5";
    assert_eq!(system.state(0.0, &other).unwrap_err().to_string(), message);
}

#[test]
fn initial_states_that_are_not_finite_are_refused() {
    let (model, _, _) = van_der_pol();
    let start = |t, x, v| OdeSystem::new(&model, State::new(t, [x], [v])).map(|_| ());
    assert_eq!(start(0.0, 1.0, 2.0), Ok(()));
    let Err(SystemError::NonFiniteTime { time }) = start(f64::NAN, 1.0, 2.0) else {
        panic!("a time that is no number");
    };
    assert!(time.is_nan());
    let infinite = SystemError::NonFiniteState {
        time: 0.0,
        component: ComponentName::Velocity("x"),
        value: f64::INFINITY,
    };
    assert_eq!(start(0.0, 1.0, f64::INFINITY), Err(infinite));
    let overflow = SystemError::NonFiniteDerivative {
        time: 0.0,
        component: ComponentName::Velocity("x"),
        value: f64::NEG_INFINITY,
    };
    assert_eq!(start(0.0, 1e200, 2.0), Err(overflow));
    assert_eq!(
        overflow.to_string(),
        "the derivative of the velocity of x is -inf at t = 0"
    );
}

#[test]
fn a_solver_that_ends_without_numbers_is_refused() {
    let (model, start) = top();
    let system = OdeSystem::new(&model, start).unwrap();
    let refused = system.state(2.5, &[0.0, 1.0, f64::INFINITY, 0.0, f64::NAN, 0.0]);
    let message = "the coordinate psi is inf at t = 2.5";
    assert_eq!(refused.unwrap_err().to_string(), message);
}

#[test]
fn a_top_upright_is_refused() {
    let (model, _) = top();
    let upright = State::new(0.0, [0.0; 3], [0.0, 1.0, 1.0]);
    let refused = OdeSystem::new(&model, upright).map(|_| ());
    assert!(
        matches!(refused, Err(SystemError::NonFiniteDerivative { .. })),
        "{refused:?}"
    );
}

/// Dynamics with an update, as a sampled controller has.
struct Sampled(VanDerPol);

impl Dynamics for Sampled {
    type State = Phase<f64, 1>;

    fn derivative(&self, t: f64, x: &Phase<f64, 1>) -> Phase<f64, 1> {
        self.0.dynamics().derivative(t, x)
    }

    fn next_update(&self, _: &Phase<f64, 1>) -> Option<f64> {
        Some(0.25)
    }
}

#[test]
fn updates_are_refused() {
    let (model, start, _) = van_der_pol();
    let refused = OdeSystem::new(&Sampled(model), start).map(|_| ());
    assert_eq!(refused, Err(SystemError::Updates { time: 0.25 }));
}

/// A mass whose actuator lags by less than nothing.
#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = push))]
struct Cart {
    #[lagrangian(input)]
    push: f64,
}

#[test]
fn parameters_without_meaning_are_refused() {
    let start = State::new(0.0, [0.0], [0.0]);
    let problem = Problem::new(Cart { push: 1.0 }, start).lagged([-0.5]);
    let start = At {
        t: 0.0,
        x: Phase {
            q: start.q,
            v: start.v,
            z: ((), SVector::from([1.0])),
        },
    };
    let refused = OdeSystem::new(problem.dynamics(), start).map(|_| ());
    let Err(error @ SystemError::InvalidParameter { .. }) = refused else {
        panic!("{refused:?}");
    };
    assert!(error.to_string().contains("is -0.5:"), "{error}");
}
