//! An integration that is stored amid events goes on to the last bit as if it had not stopped, by every method: at terminal
//! events before and after the reaction to them, with several at a time, with parameters that reactions change, and where
//! the function of an event touches zero.

use std::cell::RefCell;

use lagrangian::prelude::*;
use lagrangian::problem::Watched;
use lagrangian::problem::{End, Run};
use lagrangian::{Checkpoint, EquationsOfMotion, Resume};
use serde::{Serialize, de::DeserializeOwned};

/// Three balls on a floor, in a field that grows with the height.
#[derive(Lagrangian, Clone)]
#[lagrangian(
    taylor,
    coordinates(y[3]),
    kinetic = (0..3).map(|i| 0.5 * dot(y[i]).powi(2)).sum(),
    potential = (0..3).map(|i| g * y[i] + 0.5 * k * y[i].powi(2)).sum(),
    event(floor = (0..3).map(|i| y[i]).collect(), apex = dot(y[2]), level = max(y[2] - 0.4, 0)),
)]
struct Balls {
    g: f64,
    k: f64,
}

/// Two fields, between which the impacts of the last ball switch.
static FIELDS: [Balls; 2] = [Balls { g: 9.81, k: 0.7 }, Balls { g: 6.2, k: 2.5 }];

type Motion = EquationsOfMotion<&'static Balls, f64, 3>;

/// An event as an observer is told of it, and the state then, in bits.
type Told = (usize, u64, Vec<u64>);

fn told(event: usize, t: f64, x: &Phase<f64, 3>) -> Told {
    let components = x.q.iter().chain(&x.v);
    (
        event,
        t.to_bits(),
        components.map(|x| x.to_bits()).collect(),
    )
}

fn by_text<M: Serialize + DeserializeOwned>(checkpoint: &Checkpoint<M>) -> Checkpoint<M> {
    let text = serde_json::to_string(checkpoint).unwrap();
    serde_json::from_str(&text).unwrap()
}

fn by_bytes<M: Serialize + DeserializeOwned>(checkpoint: &Checkpoint<M>) -> Checkpoint<M> {
    let bytes = postcard::to_allocvec(checkpoint).unwrap();
    postcard::from_bytes(&bytes).unwrap()
}

/// All events until the time 3, and the state then. If it is `interrupted`, the integration is stored after each step, at
/// each terminal event and after each reaction, in turn as a value, as text and as bytes, and goes on from there.
fn motion<I, C>(
    method: I,
    watched: impl Fn(Problem<f64, Motion>) -> Problem<f64, Motion, End, C>,
    interrupted: bool,
) -> Vec<Told>
where
    I: Copy + Resume<f64, Motion, Memory: Serialize + DeserializeOwned>,
    C: Watched<f64, Motion>,
{
    let told_so_far = RefCell::new(Vec::new());
    let observer = |progress: &Progress<'_, Phase<f64, 3>>| {
        if let ObservationKind::Event(event) = progress.kind {
            let told = told(event, progress.t, progress.x);
            told_so_far.borrow_mut().push(told);
        }
    };
    let start = State::new(0.0, [1.0, 1.0, 0.0], [0.0, 0.0, 4.0]);
    let problem = |field: usize| {
        let problem = watched(Problem::new(&FIELDS[field], start)).each_step(observer);
        if interrupted {
            problem.max_steps(1)
        } else {
            problem
        }
    };
    let (mut field, mut stored) = (0, 0);
    let mut run = problem(field).start(method).unwrap();
    let mut stored_and_resumed = |run: Run<_, _, I, _, _, _, _>, field| {
        if !interrupted {
            return run;
        }
        stored += 1;
        let checkpoint = match stored % 3 {
            0 => run.checkpoint(),
            1 => by_text(&run.checkpoint()),
            _ => by_bytes(&run.checkpoint()),
        };
        problem(field).resume(checkpoint, method).unwrap()
    };
    loop {
        let part = run.advance(3.0).unwrap();
        run = stored_and_resumed(run, field);
        match part.reason {
            StopReason::Completed => break,
            StopReason::StepLimit => continue,
            reason => assert_eq!(reason, StopReason::Condition),
        }
        run.change(|x, motion| {
            for ball in (0..3).filter(|ball| part.met.contains(*ball)) {
                x.v[ball] *= -0.8;
            }
            if part.met.contains(2) {
                field = 1 - field;
                *motion = FIELDS[field].dynamics();
            }
        })
        .unwrap();
        run = stored_and_resumed(run, field);
    }
    let last = run.state();
    assert!(!interrupted || stored > 10, "stored {stored} times");
    let mut all = told_so_far.take();
    all.push(told(usize::MAX, last.t, &last.x));
    all
}

/// By events that the model declares and by functions: the terminal ones are the impacts; the others are the turning point
/// and the level of the last ball.
fn goes_on<I>(method: I)
where
    I: Copy + Resume<f64, Motion, Memory: Serialize + DeserializeOwned>,
{
    let [whole, parts] = [false, true].map(|interrupted| {
        let declared = |problem: Problem<f64, Motion>| {
            let problem = problem.on(Balls::FLOOR).falling().stop();
            problem.on([Balls::APEX, Balls::LEVEL]).falling().record()
        };
        let given = |problem: Problem<f64, Motion>| {
            let problem = problem.when(|x| [x.q[0], x.q[1], x.q[2]]).falling().stop();
            let problem = problem.when(|x| [x.v[2], f64::max(x.q[2] - 0.4, 0.0)]);
            problem.falling().record()
        };
        [
            motion(method, declared, interrupted),
            motion(method, given, interrupted),
        ]
    });
    for (whole, parts) in whole.iter().zip(&parts) {
        let count = |event| whole.iter().filter(|told| told.0 == event).count();
        // The first two balls fall at the same times, and none of that ends the motion of the third.
        assert!(count(0) >= 2 && count(0) == count(1), "{}", count(0));
        assert!(count(2) >= 2 && count(3) >= 2 && count(4) >= 1);
        let times = |event| whole.iter().filter(move |told| told.0 == event);
        assert!(times(0).map(|told| told.1).eq(times(1).map(|told| told.1)));
        assert_eq!(whole, parts);
    }
}

#[test]
fn classical_runge_kutta_goes_on_amid_events() {
    goes_on(RungeKutta::classical(0.01));
}

#[test]
fn dormand_prince_goes_on_amid_events() {
    goes_on(Dop853::new());
}

#[test]
fn taylor_goes_on_amid_events() {
    goes_on(Taylor::order_12());
    goes_on(Taylor::new());
}

/// Each order is compiled anew, which takes longer than the motions.
#[cfg(feature = "all-cases")]
#[test]
fn taylor_of_other_orders_goes_on_amid_events() {
    goes_on(Taylor::order_16());
    goes_on(Taylor::order_40());
}

/// A height that is reached without being crossed at the end of a call is reported once, whether or not the integration is
/// stored there.
#[test]
fn a_zero_that_is_touched_at_the_checkpoint_is_reported_once() {
    let stone = Stone { top: 0.8 };
    for is_stored in [false, true] {
        let seen = RefCell::new(0);
        let start = State::new(0.0, [0.0], [4.0]);
        let problem = Problem::new(&stone, start)
            .on(Stone::LIMIT)
            .record()
            .each_step(|progress| {
                let is_event = matches!(progress.kind, ObservationKind::Event(_));
                *seen.borrow_mut() += usize::from(is_event);
            });
        let mut run = problem.clone().start(Taylor::new()).unwrap();
        run.advance(0.4).unwrap();
        if is_stored {
            let checkpoint = by_bytes(&run.checkpoint());
            run = problem.resume(checkpoint, Taylor::new()).unwrap();
        }
        run.advance(1.0).unwrap();
        assert_eq!(*seen.borrow(), 1, "stored: {is_stored}");
    }
}

/// It rises to the height of 0.8 at the time 0.4.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(y),
    kinetic = 0.5 * dot(y).powi(2),
    potential = 10 * y,
    event(limit = y - top),
)]
struct Stone {
    top: f64,
}
