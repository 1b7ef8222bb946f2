//! An integration that is stored, as text or as bytes, goes on to the last bit as if it had not stopped.

use lagrangian::prelude::*;
use lagrangian::{
    Checkpoint, DoubleDouble, Dual, EquationsOfMotion, Lanes, Resume, StateTransition,
};
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
const SOONER: f64 = 2.5;

fn by_text<M: Serialize + DeserializeOwned>(checkpoint: &Checkpoint<M>) -> Checkpoint<M> {
    let text = serde_json::to_string(checkpoint).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn by_bytes<M: Serialize + DeserializeOwned>(checkpoint: &Checkpoint<M>) -> Checkpoint<M> {
    let bytes = postcard::to_allocvec(checkpoint).unwrap();
    postcard::from_bytes(&bytes).unwrap()
}

/// Stored after every third step, in turn as a value, as text and as bytes; also within what the last step shows.
fn interrupted_is_uninterrupted<S, D, I>(method: I, last: f64, problem: impl Fn() -> Problem<S, D>)
where
    S: Scalar,
    D: Dynamics<S, State: PartialEq + std::fmt::Debug>,
    I: Copy + Resume<S, D, Memory: Serialize + DeserializeOwned>,
{
    let resume = |checkpoint| {
        let problem = problem().max_steps(3);
        problem.resume(checkpoint, method).unwrap()
    };
    for end in [last, -last] {
        let mut whole = problem().start(method).unwrap();
        whole.advance(end).unwrap();

        let mut run = problem().max_steps(3).start(method).unwrap();
        let mut stops = 0;
        while run.advance(end).unwrap().reason == StopReason::StepLimit {
            let checkpoint = match stops % 3 {
                0 => run.checkpoint(),
                1 => by_text(&run.checkpoint()),
                _ => by_bytes(&run.checkpoint()),
            };
            let mut resumed = resume(checkpoint);
            assert_eq!(resumed.state(), run.state());
            assert_eq!(resumed.statistics(), run.statistics());
            let middle = 0.5 * (run.previous_time() + run.state().t.smallest());
            assert!(run.previous_time() - middle != 0.0);
            assert_eq!(resumed.at(middle).unwrap(), run.at(middle).unwrap());
            run = if stops % 2 == 0 {
                resumed
            } else {
                resume(run.checkpoint())
            };
            stops += 1;
        }
        assert!(stops > 3, "{stops}");
        assert_eq!(run.state(), whole.state());
        let (found, expected) = (run.statistics(), whole.statistics());
        assert_eq!(
            (found.steps, found.rejected),
            (expected.steps, expected.rejected)
        );
    }
}

/// Dual numbers are stored with their derivatives, which their comparisons do not look at.
#[test]
fn derivatives_go_on_from_checkpoints() {
    let start = StateTransition::initial(&State::new(0.0, [2.0, 1.0], [0.1, -0.3]));
    let transition = |end: State<Dual<f64, 4>, 2>| StateTransition::of(&end);
    let problem = Problem::new(&DoublePendulum, start);
    let whole = problem.clone().solve(END, Taylor::new()).unwrap();
    let expected = transition(whole.last);
    let stopping = problem.clone().max_steps(3);
    let mut run = stopping.start(Taylor::new()).unwrap();
    run.advance(END).unwrap();
    for stored in 0..2 {
        let checkpoint = match stored {
            0 => by_text(&run.checkpoint()),
            _ => by_bytes(&run.checkpoint()),
        };
        let mut resumed = problem.clone().resume(checkpoint, Taylor::new()).unwrap();
        assert!(resumed.state().t.value < END);
        let end = resumed.advance(END).unwrap();
        assert_eq!(transition(end.last), expected);
    }
}

#[test]
#[ignore = "long integrations; run with `--include-ignored`"]
fn every_method_and_scalar_goes_on_from_later_checkpoints() {
    every_method(END);
    every_scalar(END);
}

#[test]
fn every_method_goes_on_from_checkpoints() {
    every_method(SOONER);
}

fn every_method(last: f64) {
    let start = State::new(0.0, [2.0, 1.0], [0.1, -0.3]);
    let problem = || Problem::new(&DoublePendulum, start);
    interrupted_is_uninterrupted(RungeKutta::classical(0.01), last, problem);
    interrupted_is_uninterrupted(Dop853::new(), last, problem);
    interrupted_is_uninterrupted(Taylor::new(), last, problem);
    interrupted_is_uninterrupted(Taylor::order_12(), last, problem);
}

/// Each order is compiled anew, which takes longer than the motions.
#[cfg(feature = "all-cases")]
#[test]
fn other_orders_go_on_from_checkpoints() {
    let start = State::new(0.0, [2.0, 1.0], [0.1, -0.3]);
    let problem = || Problem::new(&DoublePendulum, start);
    interrupted_is_uninterrupted(Taylor::order_16(), END, problem);
    interrupted_is_uninterrupted(Taylor::order_40(), END, problem);
}

#[test]
fn every_scalar_goes_on_from_checkpoints() {
    every_scalar(SOONER);
}

fn every_scalar(last: f64) {
    fn start<S: Scalar>(number: impl Fn(f64) -> S) -> State<S, 2> {
        let [q, v] = [[2.0, 1.0], [0.1, -0.3]].map(|x| x.map(&number));
        State::new(S::zero(), q, v)
    }
    let doubled = start(|x| DoubleDouble::from_f64(x) / DoubleDouble::from_f64(3.0));
    let problem = || Problem::new(&DoublePendulum, doubled);
    interrupted_is_uninterrupted(Taylor::order_40(), last, problem);
    let lanes = start(|x| Lanes([x, 0.5 * x, x + 0.1, -x]));
    let problem = || Problem::new(&DoublePendulum, lanes);
    interrupted_is_uninterrupted(Dop853::new(), last, problem);
    #[allow(clippy::cast_possible_truncation)] // The digits of `f32` are the point.
    let single = start(|x| x as f32);
    let method = Dop853::new()
        .relative_tolerance(1e-6)
        .absolute_tolerance(1e-6);
    interrupted_is_uninterrupted(method, last, || Problem::new(&DoublePendulum, single));
}

#[test]
fn the_states_of_a_controller_are_stored() {
    let cart = Cart { push: 0.0 };
    let start = State::new(0.0, [1.0], [0.2]);
    interrupted_is_uninterrupted(Dop853::new(), END, || {
        Problem::new(&cart, start).feedback_with_states([0.0], |x, z| {
            let pull = -x.q[0] - z[0] - x.v[0];
            (pull, x.q[0] - 0.1 * z[0])
        })
    });
}

/// A mass on a spring, whose stiffness may be zero.
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

static MODELS: [Oscillator; 2] = [Oscillator { k: 1.0 }, Oscillator { k: 0.0 }];

/// From a checkpoint between two steps a motion goes on without the spring, uniformly and without a rejected step.
fn goes_on_without_a_spring<I>(method: I)
where
    I: Copy + Resume<f64, EquationsOfMotion<&'static Oscillator, f64, 1>>,
{
    let start = State::new(0.0, [1.0], [0.0]);
    let [spring, free] = MODELS.each_ref().map(|model| Problem::new(model, start));
    let mut before = spring.start(method).unwrap();
    for _ in 0..3 {
        before.step(100.0).unwrap();
    }
    let there = before.state();
    let mut after = free.resume(before.checkpoint(), method).unwrap();
    let rejected = after.statistics().rejected;
    let end = after.advance(there.t + 0.5).unwrap();
    assert!((end.q[0] - (there.q[0] + 0.5 * there.v[0])).abs() < 1e-14);
    assert_eq!(after.statistics().rejected, rejected);
}

#[test]
fn other_parameters_begin_at_the_checkpoint() {
    for tolerance in [1e-4, 1e-8] {
        let method = Dop853::new()
            .relative_tolerance(tolerance)
            .absolute_tolerance(tolerance);
        goes_on_without_a_spring(method);
    }
    goes_on_without_a_spring(Taylor::new());
    goes_on_without_a_spring(RungeKutta::classical(0.25));
}

#[test]
fn checkpoints_are_checked() {
    let problem = Problem::new(&DoublePendulum, State::new(0.0, [2.0, 1.0], [0.1, -0.3]));
    let mut run = problem.clone().start(Dop853::new()).unwrap();
    run.advance(1.0).unwrap();
    let wrong = Dop853::new().relative_tolerance(f64::NAN);
    let error = problem.resume(run.checkpoint(), wrong).err().unwrap();
    assert!(
        matches!(error, IntegrationError::InvalidTolerance { .. }),
        "{error}"
    );
    let text = serde_json::to_string(&run.checkpoint()).unwrap();
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
