//! An integration that is stored, as text or as bytes, goes on to the last bit as if it had not stopped.

use lagrangian::prelude::*;
use lagrangian::{AugmentedPhase, Checkpoint, DoubleDouble, Lanes, Resume, StateTransition};
use serde::{Serialize, de::DeserializeOwned};

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(alpha, beta),
    define(
        p = [sin(alpha), -cos(alpha)],
        r = p + [sin(beta), -cos(beta)],
    ),
    kinetic = 0.5 * (dot(p).norm_squared() + dot(r).norm_squared()),
    potential = 9.81 * (p.y + r.y),
)]
struct DoublePendulum;

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = push))]
struct Cart {
    #[lagrangian(input)]
    push: f64,
}

const END: f64 = 7.5;

fn by_text<M: Serialize + DeserializeOwned>(checkpoint: &Checkpoint<M>) -> Checkpoint<M> {
    let text = serde_json::to_string(checkpoint).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn by_bytes<M: Serialize + DeserializeOwned>(checkpoint: &Checkpoint<M>) -> Checkpoint<M> {
    let bytes = postcard::to_allocvec(checkpoint).unwrap();
    postcard::from_bytes(&bytes).unwrap()
}

/// Stored after every third step, in turn as a value, as text and as bytes; also within what the last step shows.
fn interrupted_is_uninterrupted<S, D, I>(method: &I, dynamics: &D, initial: &At<f64, D::State>)
where
    S: Scalar,
    D: Dynamics<S>,
    D::State: Clone + PartialEq + std::fmt::Debug,
    I: Integrator<S, D> + Resume<S, D> + IntegrationMethod,
    I::Memory: Serialize + DeserializeOwned,
{
    for end in [END, -END] {
        let mut whole = method.driver().start(dynamics, initial).unwrap();
        whole.advance_to(end).unwrap();

        let driver = method.driver().max_steps(3);
        let mut running = driver.clone().start(dynamics, initial).unwrap();
        let mut stops = 0;
        while running.advance_to(end).unwrap().reason == StopReason::StepLimit {
            let checkpoint = match stops % 3 {
                0 => running.checkpoint(),
                1 => by_text(&running.checkpoint()),
                _ => by_bytes(&running.checkpoint()),
            };
            let mut resumed = driver.clone().resume(dynamics, checkpoint).unwrap();
            assert_eq!(resumed.sample(), running.sample());
            assert_eq!(resumed.statistics(), running.statistics());
            let middle = 0.5 * (running.previous_time() + running.time());
            assert!(running.previous_time() - middle != 0.0);
            assert_eq!(resumed.at(middle).unwrap(), running.at(middle).unwrap());
            running = driver
                .clone()
                .resume(dynamics, running.checkpoint())
                .unwrap();
            if stops % 2 == 0 {
                running = resumed;
            }
            stops += 1;
        }
        assert!(stops > 3, "{stops}");
        assert_eq!(running.sample(), whole.sample());
        let (found, expected) = (running.statistics(), whole.statistics());
        assert_eq!(
            (found.steps, found.rejected),
            (expected.steps, expected.rejected)
        );
    }
}

/// Dual numbers are stored with their derivatives, which their comparisons do not look at.
#[test]
fn derivatives_go_on_from_checkpoints() {
    let dynamics = DoublePendulum.dynamics();
    let initial = StateTransition::<2, 4>::initial(&State::new(0.0, [2.0, 1.0], [0.1, -0.3]));
    let driver = Taylor::new().driver();
    let mut whole = driver.clone().start(&dynamics, &initial).unwrap();
    whole.advance_to(END).unwrap();
    let expected = StateTransition::of(&whole.sample());
    let stopping = driver.clone().max_steps(3);
    let mut running = stopping.start(&dynamics, &initial).unwrap();
    running.advance_to(END).unwrap();
    for stored in 0..2 {
        let checkpoint = match stored {
            0 => by_text(&running.checkpoint()),
            _ => by_bytes(&running.checkpoint()),
        };
        let mut resumed = driver.clone().resume(&dynamics, checkpoint).unwrap();
        assert!(resumed.time() < END);
        resumed.advance_to(END).unwrap();
        assert_eq!(StateTransition::of(&resumed.sample()), expected);
    }
}

#[test]
fn every_method_goes_on_from_checkpoints() {
    let dynamics = DoublePendulum.dynamics();
    let start = || State::new(0.0, [2.0, 1.0], [0.1, -0.3]);
    interrupted_is_uninterrupted::<f64, _, _>(&RungeKutta::classical(0.01), &dynamics, &start());
    interrupted_is_uninterrupted::<f64, _, _>(&Dop853::new(), &dynamics, &start());
    interrupted_is_uninterrupted::<f64, _, _>(&Taylor::new(), &dynamics, &start());
    interrupted_is_uninterrupted::<f64, _, _>(&Taylor::order_12(), &dynamics, &start());
    interrupted_is_uninterrupted::<f64, _, _>(&Taylor::order_16(), &dynamics, &start());
    interrupted_is_uninterrupted::<f64, _, _>(&Taylor::order_40(), &dynamics, &start());
}

#[test]
fn every_scalar_goes_on_from_checkpoints() {
    fn start<S: Scalar>(number: impl Fn(f64) -> S) -> At<f64, Phase<S, 2>> {
        let q = [2.0, 1.0].map(&number);
        At::from((0.0, Phase::new(q, [0.1, -0.3].map(&number))))
    }
    let dynamics = DoublePendulum.dynamics();
    let doubled = start(|x| DoubleDouble::from_f64(x) / DoubleDouble::from_f64(3.0));
    let doubled = At { t: 0.0, ..doubled };
    interrupted_is_uninterrupted::<DoubleDouble, _, _>(&Taylor::order_40(), &dynamics, &doubled);
    let dynamics = DoublePendulum.dynamics();
    let lanes = At {
        t: 0.0,
        ..start(|x| Lanes([x, 0.5 * x, x + 0.1, -x]))
    };
    interrupted_is_uninterrupted::<Lanes<4>, _, _>(&Dop853::new(), &dynamics, &lanes);
    let dynamics = DoublePendulum.dynamics();
    #[allow(clippy::cast_possible_truncation)] // The digits of `f32` are the point.
    let single = start(|x| x as f32);
    let method = Dop853::new()
        .relative_tolerance(1e-6)
        .absolute_tolerance(1e-6);
    interrupted_is_uninterrupted::<f32, _, _>(&method, &dynamics, &single);
}

#[test]
fn the_states_of_a_controller_are_stored() {
    let cart = Cart { push: 0.0 };
    let law = |state: &State<f64, 1>, z: &SVector<f64, 1>| {
        let pull = -state.q[0] - z[0] - state.v[0];
        ([pull], [state.q[0] - 0.1 * z[0]])
    };
    let phase = AugmentedPhase {
        q: SVector::from([1.0]),
        v: SVector::from([0.2]),
        controller: SVector::from([0.0]),
    };
    let dynamics = cart.with_controller(law);
    let start = At { t: 0.0, x: phase };
    interrupted_is_uninterrupted::<f64, _, _>(&Dop853::new(), &dynamics, &start);
}

/// The settings are those of the driver that goes on.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 0.5 * k * x.powi(2),
)]
struct Oscillator {
    k: f64,
}

/// From a checkpoint between two steps a motion goes on without the spring, uniformly and without a rejected step.
fn goes_on_without_a_spring<I, M>(method: &I, dynamics: [&M; 2])
where
    M: Dynamics<f64, State = Phase<f64, 1>>,
    I: Integrator<f64, M> + Resume<f64, M> + IntegrationMethod,
{
    let [spring, free] = dynamics;
    let mut before = method
        .driver()
        .start(spring, State::new(0.0, [1.0], [0.0]))
        .unwrap();
    for _ in 0..3 {
        before.step_towards(100.0).unwrap();
    }
    let [x, v] = [before.state().q[0], before.state().v[0]];
    let mut after = method.driver().resume(free, before.checkpoint()).unwrap();
    let rejected = after.statistics().rejected;
    after.advance_to(before.time() + 0.5).unwrap();
    assert!((after.state().q[0] - (x + 0.5 * v)).abs() < 1e-14);
    assert_eq!(after.statistics().rejected, rejected);
}

#[test]
fn other_parameters_begin_at_the_checkpoint() {
    let models = [1.0, 0.0].map(|k| Oscillator { k });
    let dynamics = models.each_ref().map(Lagrangian::dynamics);
    for tolerance in [1e-4, 1e-8] {
        let method = Dop853::new()
            .relative_tolerance(tolerance)
            .absolute_tolerance(tolerance);
        goes_on_without_a_spring(&method, dynamics.each_ref());
    }
    goes_on_without_a_spring(&Taylor::new(), dynamics.each_ref());
    goes_on_without_a_spring(&RungeKutta::classical(0.25), dynamics.each_ref());
}

#[test]
fn checkpoints_are_checked() {
    let dynamics = DoublePendulum.dynamics();
    let start = State::new(0.0, [2.0, 1.0], [0.1, -0.3]);
    let mut running = Dop853::new().driver().start(&dynamics, start).unwrap();
    running.advance_to(1.0).unwrap();
    let wrong = Dop853::new().relative_tolerance(f64::NAN).driver();
    let error = wrong.resume(&dynamics, running.checkpoint()).err().unwrap();
    assert!(
        matches!(error, IntegrationError::InvalidTolerance { .. }),
        "{error}"
    );
    let text = serde_json::to_string(&running.checkpoint()).unwrap();
    assert!(serde_json::from_str::<Checkpoint<()>>(&text).is_err());
    // More or fewer numbers than an array has.
    let lanes = serde_json::to_string(&Lanes([1.0, 2.0, 3.0])).unwrap();
    assert_eq!(
        serde_json::from_str::<Lanes<3>>(&lanes).unwrap(),
        Lanes([1.0, 2.0, 3.0])
    );
    assert!(serde_json::from_str::<Lanes<2>>(&lanes).is_err());
    assert!(serde_json::from_str::<Lanes<4>>(&lanes).is_err());
}
