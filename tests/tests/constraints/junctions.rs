//! Events at the junctions of steps and of parts of a motion, where projections move the state: none is lost, and none is found
//! twice.
//!
//! The functions of the events are of coordinates that constraints determine, or of reactions, and the tolerances are so large that
//! projections move the ends of steps by much more than rounding.

use lagrangian::prelude::*;
use lagrangian::problem::{End, Run, Watched};
use lagrangian::{Checkpoint, Resume};

use crate::mechanisms::{Disc, FourBar, Hoop, Pendulum, Platform, SliderCrank};

/// How many ends of parts are tried around each event, and by how many units in the last place they may be off.
const OFFSETS: [i32; 5] = [0, -1, 1, -3, 4];

/// A motion that is in parts at an event.
struct Junctions<P, I> {
    problem: P,
    method: I,
    /// The count of parts that end where an event is.
    count: usize,
}

/// How often each event is found.
type Counts = [usize; 4];

/// How the first part becomes the second.
#[derive(Clone, Copy, Debug)]
enum Continuation {
    Call,
    Checkpoint,
    NewProblem,
}

const CONTINUATIONS: [Continuation; 3] = [
    Continuation::Call,
    Continuation::Checkpoint,
    Continuation::NewProblem,
];

/// The next number that many units in the last place away.
fn ulps(t: f64, count: i32) -> f64 {
    (0..count.abs()).fold(t, |t, _| {
        if count > 0 {
            t.next_up()
        } else {
            t.next_down()
        }
    })
}

/// The events of a motion until a time.
fn found<D, I, C>(run: &mut Run<f64, D, I, End, C>, end: f64) -> Vec<(usize, f64)>
where
    D: Dynamics<f64>,
    C: Watched<f64, D>,
    I: Integrator<f64, D>,
{
    let part = run.advance(end).unwrap();
    let events = part.events().iter();
    events.map(|event| (event.event, event.t)).collect()
}

fn counts(events: &[(usize, f64)]) -> Counts {
    let mut counts = Counts::default();
    for (event, _) in events {
        counts[*event] += 1;
    }
    counts
}

impl<P, I> Junctions<P, I> {
    /// Goes through a motion until `end`, and through each step with events again in two parts, the first of which ends at or near
    /// one of them.
    fn sweep<D, C, const N: usize>(&mut self, start: &State<f64, N>, end: f64)
    where
        P: Fn(&State<f64, N>) -> Problem<f64, D, End, C>,
        D: Dynamics<f64, State = Phase<f64, N>>,
        C: Watched<f64, D>,
        I: Copy + Resume<f64, D>,
    {
        let method = self.method;
        let mut run = (self.problem)(start).max_steps(1).start(method).unwrap();
        loop {
            let before = run.checkpoint();
            let part = run.advance(end).unwrap();
            let events: Vec<_> = part.events().iter().map(|x| (x.event, x.t)).collect();
            let (after, last) = (part.last.t, part.reason != StopReason::StepLimit);
            for event in events {
                self.split_at(start, &before, event, after);
            }
            if last {
                break;
            }
        }
    }

    fn split_at<D, C, const N: usize>(
        &mut self,
        start: &State<f64, N>,
        before: &Checkpoint<I::Memory>,
        (event, mut time): (usize, f64),
        after: f64,
    ) where
        P: Fn(&State<f64, N>) -> Problem<f64, D, End, C>,
        D: Dynamics<f64, State = Phase<f64, N>>,
        C: Watched<f64, D>,
        I: Copy + Resume<f64, D>,
    {
        let method = self.method;
        let resume = |checkpoint| (self.problem)(start).resume(checkpoint, method).unwrap();
        let length = after - resume(before.clone()).state().t;
        // Behind the step, with no event near the end.
        let mut end = after + 0.3 * length;
        let expected = loop {
            let events = found(&mut resume(before.clone()), end);
            if events.iter().all(|(_, t)| (t - end).abs() > 0.02 * length) {
                break counts(&events);
            }
            end += 0.05 * length;
        };
        for (n, offset) in OFFSETS.into_iter().enumerate() {
            let at = ulps(time, offset);
            let continuation = CONTINUATIONS[(self.count + n) % 3];
            let mut first = resume(before.clone());
            let mut events = found(&mut first, at);
            events.extend(match continuation {
                Continuation::Call => found(&mut first, end),
                Continuation::Checkpoint => found(&mut resume(first.checkpoint()), end),
                Continuation::NewProblem => {
                    let second = (self.problem)(&first.state());
                    found(&mut second.start(method).unwrap(), end)
                }
            });
            assert_eq!(
                counts(&events),
                expected,
                "event {event}, {continuation:?} at {at}: {events:?}"
            );
            // In parts, the event is elsewhere, by the error of the step.
            let distance = |t: f64| (t - at).abs();
            let times = events.iter().filter(|(number, _)| *number == event);
            let times = times.map(|(_, t)| *t);
            let nearest = times.min_by(|a, b| distance(*a).total_cmp(&distance(*b)));
            time = nearest.expect("it occurs");
        }
        self.count += OFFSETS.len();
    }
}

/// Events of a model, declared and by functions of states, over a time under a method. Returns how many junctions there were.
macro_rules! sweep {
    ($Model:ident: $index:expr, $events:expr, $end:expr, $method:expr) => {{
        let (model, start) = $Model::numbered($index);
        let mut declared = Junctions {
            problem: |start: &State<f64, _>| Problem::new(&model, *start).on($events).record(),
            method: $method,
            count: 0,
        };
        declared.sweep(&start, $end);
        let functions = model.functions();
        let mut given = Junctions {
            problem: |start: &State<f64, _>| Problem::new(&model, *start).when(&functions).record(),
            method: $method,
            count: 0,
        };
        given.sweep(&start, $end);
        declared.count + given.count
    }};
}

/// All models, with as many members of each, under a method.
macro_rules! sweep_all {
    ($members:expr, $longest:expr, $method:expr) => {{
        let mut count = 0;
        for index in $members {
            count += sweep!(Pendulum: index,
                [Pendulum::SIDE, Pendulum::LEVEL, Pendulum::TURNING, Pendulum::PULL],
                2.0 * $longest, $method);
            count += sweep!(Hoop: index,
                [Hoop::HEIGHT, Hoop::BEHIND, Hoop::TURNING, Hoop::PUSH],
                2.0 * $longest, $method);
            count += sweep!(Platform: 3 * index,
                [Platform::SIDE, Platform::LEVEL, Platform::TURNING, Platform::PULL],
                2.0 * $longest, $method);
            count += sweep!(FourBar: 4 * index,
                [FourBar::FLAT, FourBar::ACROSS, FourBar::TURNING, FourBar::PUSH],
                2.0 * $longest, $method);
            count += sweep!(SliderCrank: index,
                [SliderCrank::UPRIGHT, SliderCrank::MIDDLE, SliderCrank::FLAT, SliderCrank::FORCE],
                $longest, $method);
            count += sweep!(Disc: index,
                [Disc::HEIGHT, Disc::FALLING, Disc::AXIS, Disc::LOAD],
                $longest, $method);
        }
        count
    }};
}

#[test]
fn events_at_junctions_of_taylor_polynomials_are_found_once() {
    let count = sweep_all!(1..2, 0.5, Taylor::order_12().relative_tolerance(1e-6));
    assert!(count > 100, "{count}");
}

#[test]
fn events_at_junctions_of_steps_of_dormand_and_prince_are_found_once() {
    let method = Dop853::new()
        .relative_tolerance(1e-5)
        .absolute_tolerance(1e-5);
    let count = sweep_all!(1..2, 0.5, method);
    assert!(count > 100, "{count}");
}

#[test]
fn events_at_junctions_of_steps_of_runge_and_kutta_are_found_once() {
    let count = sweep_all!(1..2, 0.5, RungeKutta::classical(0.02));
    assert!(count > 100, "{count}");
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn no_event_at_thousands_of_junctions_of_taylor_polynomials_is_lost_or_doubled() {
    let count = sweep_all!(0..3, 2.0, Taylor::order_12().relative_tolerance(1e-6));
    assert!(count > 3_400, "{count}");
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn no_event_at_thousands_of_junctions_of_dormand_and_prince_is_lost_or_doubled() {
    let method = Dop853::new()
        .relative_tolerance(1e-5)
        .absolute_tolerance(1e-5);
    let count = sweep_all!(0..3, 2.0, method);
    assert!(count > 3_400, "{count}");
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn no_event_at_thousands_of_junctions_of_runge_and_kutta_is_lost_or_doubled() {
    let count = sweep_all!(0..3, 2.0, RungeKutta::classical(0.02));
    assert!(count > 3_400, "{count}");
}
