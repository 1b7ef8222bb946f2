//! Settings of a driver count together, in any order: each of two conditions stops, each of two lists of events is reported,
//! each of two observers is called, and the outcome says which it was.

use core::cell::Cell;
use core::ops::ControlFlow;

use lagrangian::prelude::*;
use lagrangian::{EquationsOfMotion, StopCondition};

/// A stone that falls from a height of 5 for 1 s.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 10 * x,
    event(floor = x, ledge = x - 2),
)]
struct Stone;

type X = Phase<f64, 1>;
type Equations<'a> = EquationsOfMotion<'a, Stone, f64, 1>;

const FLOOR: f64 = 1.0;
/// √(2 · 3/10).
const LEDGE: f64 = 0.774_596_669_241_483_4;

fn height(_: f64, x: &X) -> f64 {
    x.q[0]
}

fn above_ledge(_: f64, x: &X) -> f64 {
    x.q[0] - 2.0
}

/// The end of a fall: why, which, and when.
fn fall<I, C>(driver: Driver<I, C>) -> (StopReason, Vec<usize>, f64)
where
    I: for<'a> Integrator<f64, Equations<'a>>,
    C: for<'a> StopCondition<f64, Equations<'a>>,
{
    let start = State::new(0.0, [5.0], [0.0]);
    let outcome = driver.run_until(&Stone.dynamics(), start, 1.5).unwrap();
    (
        outcome.reason,
        outcome.met.indices().collect(),
        outcome.last.t,
    )
}

/// The settings, by their numbers.
macro_rules! set {
    (0, $driver:expr) => {
        $driver.stop_when(|_, x: &X| x.v[0] < -9.0)
    };
    (1, $driver:expr) => {
        $driver.stop_at_zero(above_ledge)
    };
    (2, $driver:expr) => {
        $driver.stop_at_crossing(Event::falling(), height)
    };
    (3, $driver:expr) => {
        $driver.events(Crossing::Falling, above_ledge)
    };
    (4, $driver:expr) => {
        $driver.events(Event::falling().terminal(), height)
    };
    (5, $driver:expr) => {
        $driver.declared_events([(Stone::LEDGE, Event::falling())])
    };
    (6, $driver:expr) => {
        $driver.declared_events([(Stone::LEDGE, Event::falling().terminal())])
    };
}

/// When each of them stops alone; none if it does not.
const TIMES: [Option<f64>; 7] = [
    Some(0.9),
    Some(LEDGE),
    Some(FLOOR),
    None,
    Some(FLOOR),
    None,
    Some(LEDGE),
];

fn check(what: &str, found: &(StopReason, Vec<usize>, f64), times: [Option<f64>; 2]) {
    let first = times.iter().flatten().copied().fold(1.5, f64::min);
    assert!((found.2 - first).abs() < 6e-2, "{what}: {found:?}");
    if first >= 1.5 {
        assert_eq!(found.0, StopReason::Completed, "{what}");
        return;
    }
    assert_eq!(found.0, StopReason::Condition, "{what}");
    // The one that stopped is told by its place.
    for (place, time) in times.into_iter().enumerate() {
        if time == Some(first) {
            assert!(found.1.contains(&place), "{what}: {found:?}");
        }
    }
}

/// One setting and then each.
macro_rules! with_each {
    ($method:expr, $first:tt) => {
        with_each!($method, $first, 0 1 2 3 4 5 6);
    };
    ($method:expr, $first:tt, $($second:tt)*) => {$({
        let driver = set!($second, set!($first, $method.driver()));
        let what = concat!(stringify!($first), " then ", stringify!($second));
        check(what, &fall(driver), [TIMES[$first], TIMES[$second]]);
    })*};
}

macro_rules! all_pairs {
    ($method:expr) => {
        with_each!($method, 0);
        with_each!($method, 1);
        with_each!($method, 2);
        with_each!($method, 3);
        with_each!($method, 4);
        with_each!($method, 5);
        with_each!($method, 6);
    };
}

#[test]
fn all_pairs_of_conditions_and_events_count() {
    all_pairs!(Taylor::new().max_step(0.05));
    all_pairs!(Dop853::new().max_step(0.05));
    all_pairs!(RungeKutta::classical(0.05));
}

/// Events of two lists are numbered through, come in the order of time, and each has its reaction.
#[test]
fn two_lists_of_events_are_numbered_through() {
    let start = State::new(0.0, [5.0], [0.0]);
    let driver = Taylor::new()
        .driver()
        .events([Event::falling(); 2], |_, x: &X| {
            [x.q[0] - 1.0, x.q[0] - 3.0]
        })
        .stop_when(|t, _: &X| t > 9.0)
        .declared_events([
            (Stone::LEDGE, Event::falling()),
            (Stone::FLOOR, Event::falling()),
        ]);
    let motion = driver
        .clone()
        .sample(&Stone.dynamics(), start, &[0.5, 0.8, 1.2])
        .unwrap();
    let events: Vec<usize> = motion.events().iter().map(|told| told.event).collect();
    assert_eq!(events, [1, 3, 0, 4]);
    for (told, drop) in motion.events().iter().zip([2.0, 3.0, 4.0, 5.0]) {
        assert!((told.t - f64::sqrt(0.2 * drop)).abs() < 1e-14);
    }
    let mut reactions = Vec::new();
    let outcome = driver
        .run_reacting(&mut Stone.dynamics(), start, 2.0, |event, _, x, _| {
            reactions.push(event);
            if event == 4 {
                x.v[0] = -x.v[0];
                return Reaction::Changed;
            }
            Reaction::Unchanged
        })
        .unwrap();
    assert_eq!(reactions, [1, 3, 0, 4]);
    assert!((outcome.last.x.q[0] - 5.0).abs() < 1e-12);
}

/// Two functions of two lists with one zero: both are reported, at one time, and both stop.
#[test]
fn simultaneous_events_of_two_lists_occur_together() {
    let driver = Taylor::new()
        .driver()
        .declared_events([(Stone::FLOOR, Event::falling().terminal())])
        .stop_at_crossing(Crossing::Falling, height);
    let (reason, met, time) = fall(driver);
    assert_eq!((reason, met), (StopReason::Condition, vec![0, 1]));
    assert!((time - FLOOR).abs() < 1e-14);
}

#[test]
fn two_observers_are_called_and_each_may_stop() {
    for stopping in [0, 1] {
        let calls = [const { Cell::new(0) }; 2];
        let observer = |index: usize| {
            let calls = &calls;
            move |progress: &Progress<'_, X>| {
                calls[index].set(calls[index].get() + 1);
                if index == stopping && progress.t > 0.5 {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            }
        };
        let driver = Dop853::new().max_step(0.125).driver();
        let driver = driver.observe(observer(0)).observe(observer(1));
        let start = State::new(0.0, [5.0], [0.0]);
        let outcome = driver.run_until(&Stone.dynamics(), start, 1.5).unwrap();
        assert_eq!(outcome.reason, StopReason::Observer);
        assert!(outcome.met.contains(stopping) && !outcome.met.contains(1 - stopping));
        assert_eq!(calls[0].get(), calls[1].get());
        assert!(calls[0].get() > 3);
    }
}

/// A crossing that is watched for does not stop the integration, and has its reactions.
#[test]
fn a_crossing_is_an_event_with_reactions() {
    let driver = Dop853::new().driver().events(Crossing::Falling, height);
    let start = State::new(0.0, [5.0], [0.0]);
    let mut reactions = 0;
    let outcome = driver.run_reacting(&mut Stone.dynamics(), start, 1.5, |_, _, x, _| {
        reactions += 1;
        x.v[0] = -x.v[0];
        Reaction::Changed
    });
    let outcome = outcome.unwrap();
    assert_eq!((reactions, outcome.reason), (1, StopReason::Completed));
}

/// What is known of two lists goes through a checkpoint.
#[test]
fn two_lists_go_on_from_a_checkpoint() {
    let driver = Taylor::new()
        .driver()
        .events(Event::falling(), above_ledge)
        .declared_events([(Stone::FLOOR, Event::falling().terminal())]);
    let dynamics = Stone.dynamics();
    let start = State::new(0.0, [5.0], [0.0]);
    let mut running = driver.clone().start(&dynamics, start).unwrap();
    assert!(running.advance_to(LEDGE).unwrap().occurred.contains(0));
    let stored = running.checkpoint();
    let mut running = driver.resume(&dynamics, stored).unwrap();
    let outcome = running.advance_to(1.1).unwrap();
    assert!(!outcome.occurred.contains(0));
    assert_eq!(outcome.reason, StopReason::Condition);
    assert_eq!(outcome.met.indices().collect::<Vec<_>>(), [1]);
}
