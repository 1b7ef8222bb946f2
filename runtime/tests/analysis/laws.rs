//! Laws in general: actuators with a lag, laws that are types, owned models under a law.

use lagrangian::laws::Law;
use lagrangian::prelude::*;
use lagrangian::signals::{Polynomial, Sinusoid};
use nalgebra::Matrix4;

use crate::common::assert_close;

/// A mass on a spring with two forces.
#[derive(Lagrangian, Clone)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = 0.5 * k * x.powi(2),
    force(x = push + pull),
    event(middle = x - 0.5, weak = push - 0.25),
)]
struct Spring {
    m: f64,
    k: f64,
    #[lagrangian(input)]
    push: f64,
    #[lagrangian(input)]
    pull: f64,
}

const SPRING: Spring = Spring {
    m: 2.0,
    k: 8.0,
    push: 0.0,
    pull: 0.0,
};

const LAGS: [f64; 2] = [0.3, 0.05];

fn start() -> State<f64, 1> {
    State::new(0.0, [1.0], [0.0])
}

fn precise() -> Dop853 {
    let method = Dop853::new().relative_tolerance(1e-13);
    method.absolute_tolerance(1e-13)
}

/// (x, ẋ, push, pull) under push = −3 x − 2 ẋ and pull = 1, both with their lags.
fn lagged(t: f64) -> [f64; 4] {
    let Spring { m, k, .. } = SPRING;
    let [first, second] = LAGS;
    #[rustfmt::skip]
    let matrix = nalgebra::SMatrix::<f64, 5, 5>::from_row_slice(&[
        0.0, 1.0, 0.0, 0.0, 0.0,
        -k / m, 0.0, 1.0 / m, 1.0 / m, 0.0,
        -3.0 / first, -2.0 / first, -1.0 / first, 0.0, 0.0,
        0.0, 0.0, 0.0, -1.0 / second, 1.0 / second,
        0.0, 0.0, 0.0, 0.0, 0.0,
    ]);
    let x = (matrix * t).exp() * nalgebra::SVector::from([1.0, 0.0, 0.0, 0.0, 1.0]);
    [x[0], x[1], x[2], x[3]]
}

#[test]
fn actuators_lag_behind_a_feedback() -> Result<(), IntegrationError> {
    let motion = Problem::new(&SPRING, start())
        .feedback(|x| [-3.0 * x.q[0] - 2.0 * x.v[0], 1.0])
        .lagged(LAGS)
        .save([0.1, 0.7, 3.0])
        .solve(3.0, precise())?;
    for sample in motion.samples() {
        let exact = lagged(sample.t);
        let found = [sample.q[0], sample.v[0], sample.z.1[0], sample.z.1[1]];
        for (found, exact) in found.into_iter().zip(exact) {
            assert_close(found, exact, 1e-10);
        }
    }
    Ok(())
}

/// A controller in discrete time has a lag, too, and both methods see the same motion, its samplings and events.
#[test]
fn actuators_lag_behind_a_sampled_controller() -> Result<(), IntegrationError> {
    let problem = || {
        Problem::new(&SPRING, start())
            .sampled_feedback(0.1, [0.0], |x, sum| {
                sum[0] += x.q[0];
                [-3.0 * x.q[0] - 2.0 * x.v[0] - 0.1 * sum[0], 0.3]
            })
            .lagged(LAGS)
            .on([Spring::MIDDLE, Spring::WEAK])
            .record()
    };
    let [by_series, by_stages] = [
        problem().solve(3.0, Taylor::new())?,
        problem().solve(3.0, precise())?,
    ];
    assert_close(by_series.q[0], by_stages.q[0], 1e-11);
    assert_close(by_series.z.1[0], by_stages.z.1[0], 1e-11);
    assert_eq!(by_series.z.0.memory.len(), 1);
    assert_close(by_series.z.0.samplings, 30.0, 0.0);
    assert_eq!(by_series.events().len(), by_stages.events().len());
    assert!(by_series.events().len() > 3);
    for (one, other) in by_series.events().iter().zip(by_stages.events()) {
        assert_eq!(one.event, other.event);
        assert_close(one.t, other.t, 1e-10);
    }
    Ok(())
}

/// The lag of a signal: u̇ = (a sin ω t − u)/τ has a closed form, to which the series come by their recurrence.
#[test]
fn actuators_lag_behind_signals() -> Result<(), IntegrationError> {
    let (amplitude, rate) = (1.5, 4.0);
    let end = Problem::new(&SPRING, start())
        .driven_by((Sinusoid::new(amplitude, rate), Polynomial([0.0, 1.0])))
        .lagged(LAGS)
        .solve(2.5, Taylor::new())?;
    let ramp = |tau: f64| end.t - tau + tau * (-end.t / tau).exp();
    let wave = |tau: f64| {
        let phase = rate * tau;
        let (sine, cosine) = (rate * end.t).sin_cos();
        let steady = (sine - phase * cosine) / (1.0 + phase * phase);
        amplitude * (steady + phase / (1.0 + phase * phase) * (-end.t / tau).exp())
    };
    assert_close(end.z.1[0], wave(LAGS[0]), 1e-13);
    assert_close(end.z.1[1], ramp(LAGS[1]), 1e-13);
    Ok(())
}

/// Actuators begin at the inputs of the model.
#[test]
fn a_lag_begins_at_the_inputs_of_the_model() -> Result<(), IntegrationError> {
    let pushed = SPRING.with_inputs([4.0, 0.0]);
    let problem = Problem::new(&pushed, start()).lagged([0.5, 0.5]);
    let end = problem.solve(1.0, Taylor::new())?;
    assert_close(end.z.1[0], 4.0, 1e-14);
    Ok(())
}

/// A damper on the first input; the second stays as it is.
struct Damper(f64);

impl Law<1, SVector<f64, 2>> for Damper {
    type States = ();

    fn evaluate(
        &self,
        given: &SVector<f64, 2>,
        _: f64,
        x: &Phase<f64, 1>,
    ) -> (SVector<f64, 2>, ()) {
        (SVector::from([-self.0 * x.v[0], given[1]]), ())
    }
}

/// An owned model under a law: a reaction changes the model, and the law acts on.
#[test]
fn a_law_acts_on_an_owned_model_that_changes() -> Result<(), IntegrationError> {
    let [damping, pull] = [4.0, 2.0];
    let spring = Spring { pull, ..SPRING };
    let motion = Problem::new(spring, start())
        .under(Damper(damping))
        .when(|x| x.t - 1.0)
        .then_with(|_, spring| spring.change(|spring| (spring.k, spring.pull) = (2.0, -1.0)))
        .solve(2.0, precise())?;
    let part = |k: f64, pull: f64, x: [f64; 2]| {
        #[rustfmt::skip]
        let matrix = Matrix4::new(
            0.0, 1.0, 0.0, 0.0,
            -k / SPRING.m, -damping / SPRING.m, pull / SPRING.m, 0.0,
            0.0, 0.0, 0.0, 0.0,
            0.0, 0.0, 0.0, 0.0,
        );
        let end = matrix.exp() * nalgebra::Vector4::new(x[0], x[1], 1.0, 0.0);
        [end[0], end[1]]
    };
    let exact = part(2.0, -1.0, part(8.0, pull, [1.0, 0.0]));
    assert_close(motion.q[0], exact[0], 1e-11);
    assert_close(motion.v[0], exact[1], 1e-11);
    Ok(())
}

/// Actuators lag by a time that is positive and finite, whichever law they follow and however the integration begins.
#[test]
fn time_constants_are_positive_numbers() {
    for time_constant in [0.0, -0.5, f64::NAN, f64::INFINITY] {
        let problem = || {
            let problem = Problem::new(&SPRING, start());
            problem.lagged([0.5, time_constant])
        };
        let solved = problem().solve(1.0, Dop853::new()).unwrap_err().error();
        let started = problem().start(Taylor::new()).map(|_| ()).unwrap_err();
        let together = Ensemble::new([problem()]).solve(1.0, Taylor::new());
        let together = together.into_iter().map(|found| found.unwrap_err().error());
        for error in [solved, started].into_iter().chain(together) {
            assert!(
                matches!(
                    error,
                    IntegrationError::InvalidTimeConstant { input: 1, .. }
                ),
                "{error}"
            );
            assert!(
                error.to_string().contains(&format!("is {time_constant}:")),
                "{error}"
            );
        }
    }
}
