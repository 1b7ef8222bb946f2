//! A motion in two runs, the first of which ends in one of several ways, and the events that they report.

use core::ops::ControlFlow;
use std::cell::RefCell;

use lagrangian::prelude::*;
use lagrangian::{Dynamics, Resume, StopCondition};

pub(crate) type X = Phase<f64, 2>;

/// The events of a run with their times, and its last state.
pub(crate) fn run<D, I, C>(
    driver: &Driver<I, C>,
    equations: &D,
    start: &At<f64, X>,
    end: f64,
) -> (Vec<(usize, f64)>, At<f64, X>)
where
    D: Dynamics<f64, State = X>,
    I: Clone + Integrator<f64, D>,
    C: Clone + StopCondition<f64, D>,
{
    let motion = driver.clone().sample(equations, start, &[end]);
    let motion = motion.unwrap();
    let events = motion.events().iter().map(|event| (event.event, event.t));
    (events.collect(), *motion.last())
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

/// The events of two runs, the first of which ends at a time, or wherever its observer or step limit ends it.
pub(crate) fn in_two_runs<D, I, C>(
    driver: &Driver<I, C>,
    equations: &D,
    start: &At<f64, X>,
    (at, end): (f64, f64),
    kind: End,
) -> Vec<(usize, f64)>
where
    D: Dynamics<f64, State = X>,
    I: Clone + Resume<f64, D>,
    C: Clone + StopCondition<f64, D>,
{
    let seen = RefCell::new(Vec::new());
    let noting = driver.clone().observe(|progress: &Progress<'_, X>| {
        if let ObservationKind::Event(event) = progress.kind {
            seen.borrow_mut().push((event, progress.t));
        }
        ControlFlow::Continue(())
    });
    let stopping = |stops: bool| {
        if stops {
            ControlFlow::Break(())
        } else {
            ControlFlow::Continue(())
        }
    };
    let last = match kind {
        End::Time => noting.run_until(equations, start, at).unwrap().last,
        End::Sample => {
            let at_sample =
                |progress: &Progress<'_, X>| stopping(progress.kind == ObservationKind::Sample);
            let driver = noting.observe(at_sample);
            let outcome = driver.run_through(equations, start, &[at, end]).unwrap();
            assert!(outcome.reason == StopReason::Observer && outcome.met.contains(1));
            outcome.last
        }
        End::Steps => {
            let driver = noting.max_steps(3);
            driver
                .run_through(equations, start, &[at, end])
                .unwrap()
                .last
        }
        End::Event => {
            let at_event = |progress: &Progress<'_, X>| {
                stopping(matches!(progress.kind, ObservationKind::Event(_)))
            };
            let driver = noting.observe(at_event);
            driver.run_until(equations, start, end).unwrap().last
        }
        End::Call | End::Dynamics | End::Checkpoint => {
            let mut running = noting.clone().start(equations, start).unwrap();
            running.advance_to(at).unwrap();
            match kind {
                End::Dynamics => running.change_dynamics(equations).unwrap(),
                End::Checkpoint => {
                    let stored = running.checkpoint();
                    running = noting.clone().resume(equations, stored).unwrap();
                }
                _ => {}
            }
            running.advance_to(end).unwrap();
            running.sample()
        }
    };
    let mut all = seen.take();
    all.extend(run(driver, equations, &last, end).0);
    all
}
