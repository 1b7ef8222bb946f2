//! Every error that an integration can end with.

use crate::common::{Oscillator, SymmetricTop, assert_close, equation};
use lagrangian::ComponentName;
use lagrangian::prelude::*;
use nalgebra::SVector;

type Plain = SVector<f64, 2>;

const TOP: SymmetricTop = SymmetricTop {
    transverse: 1.0,
    axial: 0.6,
    weight: 2.0,
};

const START: At<f64, Plain> = At {
    t: 0.0,
    x: Plain::new(1.0, 0.0),
};

/// The errors of a problem under each of the methods.
macro_rules! errors {
    ($problem:expr, $end:expr, [$($method:expr),+ $(,)?]) => {
        [$($problem.solve($end, $method).unwrap_err().error()),+]
    };
}

/// ẋ = x², which is infinite at t = 1 from x = 1.
fn blows_up() -> Problem<f64, impl Dynamics<State = SVector<f64, 1>>> {
    let square = equation::<1, _>(|_, x| SVector::from([x[0] * x[0]]));
    let start = At::from((0.0, SVector::from([1.0])));
    Problem::new(square, start)
}

#[test]
fn an_initial_state_that_is_not_finite_is_named() {
    let state = State::new(0.5, [0.0, f64::NAN, 0.0], [0.0, 0.0, 1.0]);
    let [error] = errors!(Problem::new(&TOP, state), 1.0, [Dop853::new()]);
    assert_eq!(error.to_string(), "the coordinate theta is NaN at t = 0.5");
    let state = State::new(0.5, [0.0, 1.0, 0.0], [0.0, 0.0, f64::INFINITY]);
    let [error] = errors!(Problem::new(&TOP, state), 1.0, [RungeKutta::classical(0.1)]);
    assert_eq!(error.to_string(), "the velocity of psi is inf at t = 0.5");
    let start = At::from((0.0, Plain::new(0.0, f64::NAN)));
    let [error] = errors!(Problem::new(Oscillator, start), 1.0, [Dop853::new()]);
    let IntegrationError::NonFiniteState { component, .. } = error else {
        panic!("{error}")
    };
    assert_eq!(component, ComponentName::Index(1));
}

#[test]
fn a_derivative_that_is_not_finite_is_an_error_at_once() {
    let dynamics = equation::<2, _>(|_, x| Plain::new(1.0, (-x[0]).sqrt()));
    for error in errors!(
        Problem::new(&dynamics, START),
        1.0,
        [Dop853::new(), RungeKutta::classical(0.1)]
    ) {
        let IntegrationError::NonFiniteDerivative {
            time,
            component,
            value,
        } = error
        else {
            panic!("{error}")
        };
        assert!(time == 0.0 && component == ComponentName::Index(1) && value.is_nan());
    }
}

#[test]
fn times_that_are_not_finite_are_errors() {
    for time in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let [adaptive, fixed] = errors!(
            Problem::new(Oscillator, START),
            time,
            [Dop853::new(), RungeKutta::classical(0.1)]
        );
        let start = At { t: time, ..START };
        let [begun] = errors!(Problem::new(Oscillator, start), 1.0, [Dop853::new()]);
        for error in [adaptive, begun, fixed] {
            assert!(
                matches!(error, IntegrationError::NonFiniteTime { .. }),
                "{error}"
            );
        }
        let mut stepper = Dop853::new().start(&Oscillator, START.t, START.x).unwrap();
        assert!(stepper.step(&Oscillator, time).is_err());
        let mut stepper = RungeKutta::classical(0.1)
            .start(&Oscillator, START.t, START.x)
            .unwrap();
        assert!(stepper.step(&Oscillator, time).is_err());
    }
}

#[test]
fn sample_times_must_advance() {
    let index_of = |times: &[f64], end: f64| {
        let problem = Problem::new(Oscillator, START).save(times);
        match problem.solve(end, Dop853::new()).unwrap_err().error() {
            IntegrationError::UnorderedTimes { index, .. } => index,
            // On the other side of the start.
            IntegrationError::OutsideSpan { time, .. } => {
                assert!((time < 0.0) != (end < 0.0));
                times.iter().position(|t| *t - time == 0.0).unwrap()
            }
            error => panic!("{error}"),
        }
    };
    assert_eq!(index_of(&[1.0, 0.5, 2.0], 2.0), 1);
    assert_eq!(index_of(&[-1.0, 2.0], 2.0), 0);
    assert_eq!(index_of(&[1.0, -2.0], -2.0), 0);
    assert_eq!(index_of(&[-1.0, -0.5, -2.0], -2.0), 1);
    assert_eq!(index_of(&[1.0, 2.0, 0.0], 2.0), 2);
}

#[test]
fn steps_and_tolerances_are_checked() {
    for step in [0.0, -0.1, f64::NAN, f64::INFINITY] {
        for error in errors!(
            Problem::new(Oscillator, START),
            1.0,
            [
                RungeKutta::classical(step),
                Dop853::new().max_step(step),
                Dop853::new().initial_step(step),
            ]
        ) {
            assert!(
                matches!(error, IntegrationError::InvalidStep { .. }),
                "{error}"
            );
        }
    }
    for (relative, absolute) in [
        (-1.0, 1.0),
        (1.0, -1.0),
        (f64::NAN, 1.0),
        (0.0, 0.0),
        (1.0, f64::INFINITY),
    ] {
        let method = Dop853::new()
            .relative_tolerance(relative)
            .absolute_tolerance(absolute);
        let [error] = errors!(Problem::new(Oscillator, START), 1.0, [method]);
        assert!(
            matches!(error, IntegrationError::InvalidTolerance { .. }),
            "{error}"
        );
    }
    // One of the tolerances may be zero.
    let start = At::from((0.0, Plain::new(1.0, 1.0)));
    let relative = Dop853::new().absolute_tolerance(0.0);
    assert!(Problem::new(Oscillator, start).solve(1.0, relative).is_ok());
}

#[test]
fn a_step_that_is_too_small_keeps_the_samples_before_it() {
    let interrupted = blows_up()
        .save([0.25, 0.5, 0.75, 1.5])
        .solve(1.5, Dop853::new())
        .unwrap_err();
    let error = interrupted.error();
    let IntegrationError::StepTooSmall { time, .. } = error else {
        panic!("{error}")
    };
    assert_close(time, 1.0, 1e-6);
    assert!(
        interrupted
            .to_string()
            .contains("(the solution is known until t = "),
        "{interrupted}"
    );
    let known = interrupted.into_solution();
    assert_eq!(
        (known.samples().len(), known.reason),
        (3, StopReason::Error)
    );
    for sample in known.samples() {
        assert_close(sample[0] * (1.0 - sample.t), 1.0, 1e-8);
    }
    assert_close(known.t, 1.0, 1e-6);
    assert!(known.statistics.steps > 10);
}

#[test]
fn a_state_that_becomes_infinite_ends_fixed_steps() {
    let interrupted = blows_up()
        .save([0.5, 5.0])
        .solve(5.0, RungeKutta::classical(0.1))
        .unwrap_err();
    let error = interrupted.error();
    assert!(
        matches!(error, IntegrationError::NonFiniteState { .. }),
        "{error}"
    );
    assert_eq!(interrupted.solution().samples().len(), 1);
}

/// ẋ = 1 for x < ½, and NaN beyond: the step shrinks to the limit.
#[test]
fn a_motion_out_of_the_domain_of_its_equations_names_the_component() {
    let bounded = equation::<2, _>(|_, x| Plain::new(0.0, 1.0 + 0.0 * (0.5 - x[1]).sqrt()));
    let interrupted = Problem::new(bounded, START)
        .save([0.25, 1.0])
        .solve(1.0, Dop853::new())
        .unwrap_err();
    let IntegrationError::NonFiniteState {
        time, component, ..
    } = interrupted.error()
    else {
        panic!("{interrupted}")
    };
    assert_eq!(component, ComponentName::Index(1));
    assert_close(time, 0.5, 1e-9);
    assert_eq!(interrupted.solution().samples().len(), 1);
}

/// With a tolerance near the machine epsilon a coupled system is still regular: at
/// θ = 0.1 the relative pivot is 0.016.
#[test]
fn a_regular_configuration_is_none_to_a_tight_tolerance() {
    let state = State::new(0.0, [0.0, 0.1, 0.0], [1.0, 0.0, 2.0]);
    let tight = Dop853::new()
        .relative_tolerance(1e-15)
        .absolute_tolerance(1e-12);
    let problem = Problem::new(&TOP, state);
    assert!(problem.clone().solve(0.01, tight).is_ok());
    let error = problem.singularity_tolerance(1e-15).solve(0.01, tight);
    assert!(error.is_err(), "unless it is asked for");
    let single = State::new(0.0, [0.0, 0.1, 0.0], [1.0, 0.0, 2.0_f32]);
    let fixed = RungeKutta::classical(0.001);
    assert!(Problem::new(&TOP, single).solve(0.01, fixed).is_ok());
}

#[test]
fn the_singularity_tolerance_must_be_positive() {
    for tolerance in [0.0, -1.0, f64::NAN] {
        let problem = Problem::new(Oscillator, START).singularity_tolerance(tolerance);
        let [error] = errors!(problem, 1.0, [Dop853::new()]);
        assert!(
            matches!(error, IntegrationError::InvalidSingularityTolerance { .. }),
            "{error}"
        );
    }
}

/// An error can be passed on alone.
#[test]
fn a_partial_trajectory_converts_to_its_error() {
    fn fails() -> Result<(), IntegrationError> {
        blows_up().save([2.0]).solve(2.0, Dop853::new())?;
        Ok(())
    }
    fails().unwrap_err();
}

#[test]
fn the_number_of_steps_is_limited() {
    let limited = |steps| Problem::new(Oscillator, START).max_steps(steps);
    for end in [
        limited(3).solve(1e3, Dop853::new()).unwrap(),
        limited(3).solve(1e3, RungeKutta::classical(0.1)).unwrap(),
    ] {
        assert_eq!(end.reason, StopReason::StepLimit);
        assert_eq!(end.statistics.attempts(), 3);
        assert!(end.t > 0.0 && end.t < 1e3);
    }
    let reason = |step| {
        let end = limited(4).solve(1.0, RungeKutta::classical(step));
        end.unwrap().reason
    };
    assert_eq!(reason(0.2), StopReason::StepLimit);
    assert_eq!(reason(0.25), StopReason::Completed);
}

#[test]
fn a_fixed_step_below_the_spacing_of_time_is_an_error() {
    let start = At { t: 1e9, ..START };
    let [error] = errors!(
        Problem::new(Oscillator, start),
        1e9 + 1.0,
        [RungeKutta::classical(1e-9)]
    );
    assert!(
        matches!(error, IntegrationError::StepTooSmall { .. }),
        "{error}"
    );
}

#[test]
fn an_upright_top_is_a_singular_configuration() {
    let state = State::new(0.0, [0.0, 0.0, 0.0], [1.0, 0.0, 2.0]);
    for error in errors!(
        Problem::new(&TOP, state),
        1.0,
        [Dop853::new(), RungeKutta::classical(0.01)]
    ) {
        let IntegrationError::SingularConfiguration {
            time,
            estimated_error,
            singularity,
        } = error
        else {
            panic!("{error}")
        };
        assert!(time == 0.0 && estimated_error > 0.1);
        let named: Vec<_> = singularity.coordinates().collect();
        assert_eq!(named, [("theta", 0.0)]);
        assert!(error.to_string().contains("theta = 0"), "{error}");
        assert!(error.to_string().contains("another sequence"), "{error}");
    }
}

/// A top that is thrown so as to rise through the vertical: both momenta of (4.8) are zero, a pendulum through the
/// pole of its angles.
#[test]
fn a_motion_into_a_singularity_ends_there_with_its_samples() {
    let state = State::new(0.0, [0.1, 1.0, 0.2], [0.0, -4.0, 0.0]);
    let times: Vec<f64> = (0..100).map(|i| f64::from(i) * 0.01).collect();
    let interrupted = Problem::new(&TOP, state)
        .save(&times)
        .solve(0.99, Dop853::new().max_step(1e-3))
        .unwrap_err();
    let error = interrupted.error();
    let IntegrationError::SingularConfiguration {
        time,
        estimated_error,
        singularity,
    } = error
    else {
        panic!("{error}")
    };
    let (name, theta) = singularity.coordinates().next().unwrap();
    assert!(name == "theta" && theta.abs() < 0.01 && theta != 0.0);
    // The relative pivot of ψ is I sin²θ / (I sin²θ + Iₛ cos²θ), ε = 2⁻⁵².
    let pivot = theta.sin().powi(2) / (theta.sin().powi(2) + 0.6 * theta.cos().powi(2));
    assert_close(estimated_error * pivot / f64::EPSILON, 1.0, 1e-6);
    let known = interrupted.solution();
    assert!(known.samples().len() > 10);
    assert!(known.samples().iter().all(|sample| sample.t <= time));
    // The last state is the last accurate one, a step before.
    let late = time - known.t;
    assert!(late > 0.0 && late < 1.001e-3);

    // Without the check it passes within a step.
    let unchecked = Problem::new(&TOP, state).singularity_tolerance(f64::INFINITY);
    assert!(unchecked.solve(0.1, RungeKutta::classical(1e-3)).is_ok());
}

#[test]
fn a_zero_inertia_is_an_error_at_the_start() {
    let state = State::new(0.0, [0.0, 0.7, 0.0], [1.0, 0.0, 2.0]);
    let rod = SymmetricTop { axial: 0.0, ..TOP };
    let needle = SymmetricTop {
        transverse: 0.0,
        ..TOP
    };
    for model in [rod, needle] {
        for error in errors!(
            Problem::new(&model, state),
            1.0,
            [Dop853::new(), RungeKutta::classical(0.01)]
        ) {
            let IntegrationError::SingularConfiguration {
                time,
                estimated_error,
                ..
            } = error
            else {
                panic!("{error}")
            };
            assert!(time == 0.0 && estimated_error.is_infinite(), "{error}");
        }
    }
    let massless = crate::common::Pendulum {
        m: 0.0,
        g: 9.81,
        l: 1.0,
    };
    let state = State::new(0.0, [0.5], [0.0]);
    let [error] = errors!(Problem::new(&massless, state), 1.0, [Dop853::new()]);
    assert!(
        error.to_string().contains("whatever the coordinates are"),
        "{error}"
    );
}

/// The motion in a plane has nothing to do with the axis across, whatever the tolerance for 0 is.
#[test]
fn what_stays_exactly_zero_needs_no_tolerance() {
    let turning = equation(|_, x: &SVector<f64, 3>| SVector::from([x[1], -x[0], 0.0]));
    let method = Dop853::new()
        .relative_tolerance(1e-10)
        .absolute_tolerance(0.0);
    let start = At::from((0.0, SVector::from([1.0, 1.0, 0.0])));
    let end = Problem::new(turning, start).solve(0.5, method).unwrap();
    assert_close(end[0], 0.5_f64.cos() + 0.5_f64.sin(), 1e-9);
}

/// Samples within the step that comes too near to the pole are kept.
#[test]
fn the_samples_within_the_last_step_are_kept() {
    let state = State::new(0.0, [0.1, 1.0, 0.2], [0.0, -4.0, 0.0]);
    let times: Vec<f64> = (0..30_000).map(|i| f64::from(i) * 1e-5).collect();
    let interrupted = Problem::new(&TOP, state)
        .save(&times)
        .solve(0.3, Dop853::new().max_step(1e-3))
        .unwrap_err();
    let IntegrationError::SingularConfiguration { time, .. } = interrupted.error() else {
        panic!("{interrupted}")
    };
    let before = times.iter().filter(|t| **t < time).count();
    assert_eq!(interrupted.solution().samples().len(), before);
}
