//! Settings of a problem count together, in any order: each of two conditions stops, each of two lists of events is reported,
//! each of two observers is called, and the solution says which it was.

use core::cell::{Cell, RefCell};
use core::ops::ControlFlow;

use lagrangian::prelude::*;

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

type X = State<f64, 1>;

const FLOOR: f64 = 1.0;
/// √(2 · 3/10).
const LEDGE: f64 = 0.774_596_669_241_483_4;

// Functions of one type: each closure, and each function by its name, is a type of its own, and so would be each problem.
type Function = fn(&X) -> f64;

fn is_fast(x: &X) -> bool {
    x.v[0] < -9.0
}

fn height(x: &X) -> f64 {
    x.q[0]
}

fn heights(x: &X) -> [f64; 1] {
    [height(x)]
}

fn above_ledge(x: &X) -> f64 {
    x.q[0] - 2.0
}

fn start() -> X {
    State::new(0.0, [5.0], [0.0])
}

/// The end of a fall: why, which, and when.
fn end(motion: &Solution<f64, Phase<f64, 1>>) -> (StopReason, Vec<usize>, f64) {
    (motion.reason, motion.met.indices().collect(), motion.t)
}

/// The settings, by their numbers.
macro_rules! set {
    (0, $problem:expr) => {
        $problem.stop_when(is_fast)
    };
    (1, $problem:expr) => {
        $problem.when(above_ledge as Function).stop()
    };
    (2, $problem:expr) => {
        $problem.when(height as Function).falling().stop()
    };
    (3, $problem:expr) => {
        $problem.when(above_ledge as Function).falling().record()
    };
    (4, $problem:expr) => {
        $problem.when(heights).falling().stop()
    };
    (5, $problem:expr) => {
        $problem.on(Stone::LEDGE).falling().record()
    };
    (6, $problem:expr) => {
        $problem.on(Stone::LEDGE).falling().stop()
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
        let problem = set!($second, set!($first, Problem::new(&Stone, start())));
        let motion = problem.solve(1.5, $method).unwrap();
        let what = concat!(stringify!($first), " then ", stringify!($second));
        check(what, &end(&motion), [TIMES[$first], TIMES[$second]]);
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
    let motion = Problem::new(&Stone, start())
        .when(|x| [x.q[0] - 1.0, x.q[0] - 3.0])
        .falling()
        .record()
        .stop_when(|x| x.t > 9.0)
        .on([Stone::LEDGE, Stone::FLOOR])
        .falling()
        .record()
        .save([0.5, 0.8, 1.2])
        .solve(1.2, Taylor::new())
        .unwrap();
    let numbers = |events: &[Occurrence<Phase<f64, 1>>]| -> Vec<usize> {
        events.iter().map(|told| told.event).collect()
    };
    assert_eq!(numbers(motion.events()), [1, 3, 0, 4]);
    for (told, drop) in motion.events().iter().zip([2.0, 3.0, 4.0, 5.0]) {
        assert!((told.t - f64::sqrt(0.2 * drop)).abs() < 1e-14);
    }
    // Which reaction, and at which height.
    let reactions = RefCell::new(Vec::new());
    let told = |list: usize, x: &X| reactions.borrow_mut().push((list, x.q[0].round()));
    let motion = Problem::new(&Stone, start())
        .when(|x| [x.q[0] - 1.0, x.q[0] - 3.0])
        .falling()
        .then(|x| told(0, x))
        .stop_when(|x| x.t > 9.0)
        .on([Stone::LEDGE, Stone::FLOOR])
        .falling()
        .then(|x| {
            told(1, x);
            if x.q[0] < 1.0 {
                x.v[0] = -x.v[0];
            }
        })
        .solve(2.0, Taylor::new())
        .unwrap();
    assert_eq!(reactions.take(), [(0, 3.0), (1, 2.0), (0, 1.0), (1, 0.0)]);
    assert_eq!(numbers(motion.events()), [1, 3, 0, 4]);
    assert!((motion.q[0] - 5.0).abs() < 1e-12);
}

/// Two functions of two lists with one zero: both are reported, at one time, and both stop.
#[test]
fn simultaneous_events_of_two_lists_occur_together() {
    let motion = Problem::new(&Stone, start())
        .on(Stone::FLOOR)
        .falling()
        .stop()
        .when(height)
        .falling()
        .stop()
        .solve(1.5, Taylor::new())
        .unwrap();
    let (reason, met, time) = end(&motion);
    assert_eq!((reason, met), (StopReason::Condition, vec![0, 1]));
    assert!((time - FLOOR).abs() < 1e-14);
}

#[test]
fn two_observers_are_called_and_each_may_stop() {
    for stopping in [0, 1] {
        let calls = [const { Cell::new(0) }; 2];
        let observer = |index: usize| {
            let calls = &calls;
            move |progress: &Progress<'_, Phase<f64, 1>>| {
                calls[index].set(calls[index].get() + 1);
                if index == stopping && progress.t > 0.5 {
                    ControlFlow::Break(())
                } else {
                    ControlFlow::Continue(())
                }
            }
        };
        let problem = Problem::new(&Stone, start());
        let problem = problem.each_step(observer(0)).each_step(observer(1));
        let motion = problem.solve(1.5, Dop853::new().max_step(0.125)).unwrap();
        assert_eq!(motion.reason, StopReason::Observer);
        assert!(motion.met.contains(stopping) && !motion.met.contains(1 - stopping));
        assert_eq!(calls[0].get(), calls[1].get());
        assert!(calls[0].get() > 3);
    }
}

/// A crossing that is watched for does not stop the integration, and has its reactions.
#[test]
fn a_crossing_is_an_event_with_reactions() {
    let mut reactions = 0;
    let motion = Problem::new(&Stone, start())
        .when(height)
        .falling()
        .then(|x| {
            reactions += 1;
            x.v[0] = -x.v[0];
        })
        .solve(1.5, Dop853::new())
        .unwrap();
    assert_eq!((reactions, motion.reason), (1, StopReason::Completed));
}

/// What is known of two lists goes through a checkpoint.
#[test]
fn two_lists_go_on_from_a_checkpoint() {
    let problem = Problem::new(&Stone, start())
        .when(above_ledge)
        .falling()
        .record()
        .on(Stone::FLOOR)
        .falling()
        .stop();
    let mut running = problem.clone().start(Taylor::new()).unwrap();
    let first = running.advance(LEDGE).unwrap();
    assert!(first.events().iter().any(|told| told.event == 0));
    let stored = running.checkpoint();
    let mut running = problem.resume(stored, Taylor::new()).unwrap();
    let motion = running.advance(1.1).unwrap();
    assert!(motion.events().iter().all(|told| told.event != 0));
    assert_eq!(motion.reason, StopReason::Condition);
    assert_eq!(motion.met.indices().collect::<Vec<_>>(), [1]);
}
