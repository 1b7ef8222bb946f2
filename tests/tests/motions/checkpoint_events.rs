//! An integration that is stored amid events goes on to the last bit as if it had not stopped, by every method: at terminal
//! events before and after the reaction to them, with several at a time, with parameters that reactions change, and where
//! the function of an event touches zero.

use std::cell::RefCell;
use std::ops::ControlFlow;

use lagrangian::prelude::*;
use lagrangian::{Checkpoint, EquationsOfMotion, Resume, StopCondition};
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
const FIELDS: [Balls; 2] = [Balls { g: 9.81, k: 0.7 }, Balls { g: 6.2, k: 2.5 }];

type Motion<'a> = EquationsOfMotion<'a, Balls, f64, 3>;

/// An event as an observer or the outcome of a part tells it, and the state then, in bits.
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
fn motion<I, C>(driver: &Driver<I, C>, interrupted: bool) -> Vec<Told>
where
    I: Clone + for<'a> Resume<f64, Motion<'a>, Memory: Serialize + DeserializeOwned>,
    C: Clone + for<'a> StopCondition<f64, Motion<'a>>,
{
    let fields = FIELDS.each_ref().map(Lagrangian::dynamics);
    let told_so_far = RefCell::new(Vec::new());
    let observer = |progress: &Progress<'_, Phase<f64, 3>>| {
        if let ObservationKind::Event(event) = progress.kind {
            let told = told(event, progress.t, progress.x);
            told_so_far.borrow_mut().push(told);
        }
        ControlFlow::Continue(())
    };
    let driver = driver.clone().observe(observer);
    let driver = if interrupted {
        driver.max_steps(1)
    } else {
        driver
    };
    let start = State::new(0.0, [1.0, 1.0, 0.0], [0.0, 0.0, 4.0]);
    let (mut field, mut stored) = (0, 0);
    let mut running = driver.clone().start(&fields[field], start).unwrap();
    let mut store = |running: &RunningIntegration<'_, _, _, I, C, _>| {
        stored += 1;
        match stored % 3 {
            0 => running.checkpoint(),
            1 => by_text(&running.checkpoint()),
            _ => by_bytes(&running.checkpoint()),
        }
    };
    loop {
        let outcome = running.advance_to(3.0).unwrap();
        if interrupted {
            let checkpoint = store(&running);
            running = driver.clone().resume(&fields[field], checkpoint).unwrap();
        }
        match outcome.reason {
            StopReason::Completed => break,
            StopReason::StepLimit => continue,
            reason => assert_eq!(reason, StopReason::Condition),
        }
        let mut x = *running.state();
        for ball in (0..3).filter(|ball| outcome.met.contains(*ball)) {
            x.v[ball] *= -0.8;
        }
        running.restart(x).unwrap();
        if outcome.met.contains(2) {
            field = 1 - field;
            running.change_dynamics(&fields[field]).unwrap();
        }
        if interrupted {
            let checkpoint = store(&running);
            running = driver.clone().resume(&fields[field], checkpoint).unwrap();
        }
    }
    let last = told(usize::MAX, running.time(), running.state());
    assert!(!interrupted || stored > 10, "stored {stored} times");
    let mut all = told_so_far.take();
    all.push(last);
    all
}

/// The terminal events are the impacts; the others are the turning point and the level of the last ball.
const EVENTS: [Event; 5] = [
    Event::falling().terminal(),
    Event::falling().terminal(),
    Event::falling().terminal(),
    Event::falling(),
    Event::falling(),
];

fn functions(_: f64, x: &Phase<f64, 3>) -> [f64; 5] {
    let level = f64::max(x.q[2] - 0.4, 0.0);
    [x.q[0], x.q[1], x.q[2], x.v[2], level]
}

fn goes_on<I>(method: &I)
where
    I: IntegrationMethod
        + Clone
        + for<'a> Resume<f64, Motion<'a>, Memory: Serialize + DeserializeOwned>,
{
    let [first, second, third] = Balls::FLOOR;
    let indices = [first, second, third, Balls::APEX, Balls::LEVEL];
    let mut events = indices.into_iter().zip(EVENTS);
    let declared = core::array::from_fn::<_, 5, _>(|_| events.next().unwrap());
    let declared = method.driver().declared_events(declared);
    let given = method.driver().events(EVENTS, functions);
    let whole = [motion(&declared, false), motion(&given, false)];
    let parts = [motion(&declared, true), motion(&given, true)];
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
    goes_on(&RungeKutta::classical(0.01));
}

#[test]
fn dormand_prince_goes_on_amid_events() {
    goes_on(&Dop853::new());
}

#[test]
fn taylor_goes_on_amid_events() {
    goes_on(&Taylor::order_12());
    goes_on(&Taylor::order_16());
    goes_on(&Taylor::new());
    goes_on(&Taylor::order_40());
}

/// A height that is reached without being crossed at the end of a call is reported once, whether or not the integration is
/// stored there.
#[test]
fn a_zero_that_is_touched_at_the_checkpoint_is_reported_once() {
    let stone = Stone { top: 0.8 };
    let dynamics = stone.dynamics();
    for is_stored in [false, true] {
        let seen = RefCell::new(0);
        let driver = Taylor::new()
            .driver()
            .declared_events([(Stone::LIMIT, Event::either())])
            .observe(|progress: &Progress<'_, Phase<f64, 1>>| {
                let is_event = matches!(progress.kind, ObservationKind::Event(_));
                *seen.borrow_mut() += usize::from(is_event);
                ControlFlow::Continue(())
            });
        let start = State::new(0.0, [0.0], [4.0]);
        let mut running = driver.clone().start(&dynamics, start).unwrap();
        running.advance_to(0.4).unwrap();
        if is_stored {
            let checkpoint = by_bytes(&running.checkpoint());
            running = driver.resume(&dynamics, checkpoint).unwrap();
        }
        running.advance_to(1.0).unwrap();
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
