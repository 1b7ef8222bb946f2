//! A motion in two runs, the first of which ends in one of several ways, and the events that they report.

use core::ops::ControlFlow;
use std::cell::RefCell;

use lagrangian::prelude::*;
use lagrangian::problem::Watched;
use lagrangian::{Dynamics, Resume};

pub(crate) type X = Phase<f64, 2>;

/// A problem with conditions and events.
pub(crate) type Watching<D, C> = Problem<f64, D, lagrangian::problem::End, C>;

/// The events of a run with their times.
pub(crate) fn run<D, I, C>(problem: Watching<D, C>, method: I, end: f64) -> Vec<(usize, f64)>
where
    D: Dynamics<f64, State = X>,
    I: Integrator<f64, D>,
    C: Watched<f64, D>,
{
    let motion = problem.solve(end, method).unwrap();
    let events = motion.events().iter().map(|event| (event.event, event.t));
    events.collect()
}

/// How the first of two runs ends.
#[derive(Clone, Copy, Debug)]
pub(crate) enum End {
    Time,
    Sample,
    Steps,
    Event,
    Call,
    Dynamics,
    Checkpoint,
}

pub(crate) const ENDS: [End; 7] = [
    End::Time,
    End::Sample,
    End::Steps,
    End::Event,
    End::Call,
    End::Dynamics,
    End::Checkpoint,
];

fn stopping(stops: bool) -> ControlFlow<()> {
    if stops {
        ControlFlow::Break(())
    } else {
        ControlFlow::Continue(())
    }
}

/// The events of two runs, the first of which ends at a time, or wherever its observer or step limit ends it.
pub(crate) fn in_two_runs<D, I, C>(
    problem: impl Fn(&At<f64, X>) -> Watching<D, C>,
    method: I,
    start: &At<f64, X>,
    (at, end): (f64, f64),
    kind: End,
) -> Vec<(usize, f64)>
where
    D: Dynamics<f64, State = X>,
    I: Copy + Resume<f64, D>,
    C: Watched<f64, D>,
{
    let seen = &RefCell::new(Vec::new());
    let noting = || {
        problem(start).each_step(move |progress| {
            if let ObservationKind::Event(event) = progress.kind {
                seen.borrow_mut().push((event, progress.t));
            }
        })
    };
    let last = match kind {
        End::Time => noting().solve(at, method).unwrap().last,
        End::Sample => {
            let first = noting()
                .each_step(|progress| stopping(progress.kind == ObservationKind::Sample))
                .save([at])
                .solve(end, method)
                .unwrap();
            assert!(first.reason == StopReason::Observer && first.met.contains(1));
            first.last
        }
        End::Steps => {
            let first = noting().max_steps(3).save([at]);
            first.solve(end, method).unwrap().last
        }
        End::Event => {
            let first = noting()
                .each_step(|progress| stopping(matches!(progress.kind, ObservationKind::Event(_))));
            first.solve(end, method).unwrap().last
        }
        End::Call | End::Dynamics | End::Checkpoint => {
            let mut running = noting().start(method).unwrap();
            running.advance(at).unwrap();
            match kind {
                End::Dynamics => running.change(|_, _| {}).unwrap(),
                End::Checkpoint => {
                    running = noting().resume(running.checkpoint(), method).unwrap();
                }
                _ => {}
            }
            running.advance(end).unwrap();
            running.state()
        }
    };
    let mut all = seen.take();
    all.extend(run(problem(&last), method, end));
    all
}
