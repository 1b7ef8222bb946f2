//! Where motions end, and the events on the way: of a model, and of its reduced model with the ignorable coordinates beside it.

use std::fmt;

use lagrangian::quantities::{Events, MotionSeries, RouthianSeries};
use lagrangian::{
    DeclaredEvent, Dop853, Ensemble, EquationsOfMotion, EventDynamics, InLanes, IntegrationError,
    Integrator, Lagrangian, Occurrence, Partial, Phase, Problem, RouthReduction, Routhian,
    Solution, State, StopReason, Taylor,
};
use nalgebra::SVector;

use crate::evaluation::{Entries, Found, beside};
use crate::{At, rows};

/// The tolerance of DOP853 by which those of its references are measured.
const DOP853_TOLERANCE: f64 = 1e-11;

/// How many steps a motion may take.
pub(crate) const MAX_STEPS: u64 = 5_000;

/// DOP853 as its references expect it.
pub(crate) fn dop853() -> Dop853 {
    Dop853::new()
        .relative_tolerance(DOP853_TOLERANCE)
        .absolute_tolerance(DOP853_TOLERANCE)
}

/// The last state of the motion by one of these methods, where there is a reference for it; of a motion that slides along a jump, the time from
/// which on it does.
macro_rules! ends_by {
    ($($name:ident = $method:expr;)*) => {$(
        #[doc = concat!("The end of a motion by ", stringify!($name), ".")]
        #[must_use]
        pub fn $name<M, const N: usize>(model: &M, at: &At) -> Vec<Found>
        where
            M: Lagrangian<N, Model: MotionSeries<N>>,
        {
            let name = stringify!($name);
            if !at.asks_for(name) {
                return Vec::new();
            }
            let problem = Problem::new(model, at.state::<N>()).max_steps(MAX_STEPS);
            let end = match problem.solve(at.end(), $method) {
                Ok(solution) => completed(solution.reason, solution.last),
                Err(partial) => Err(partial.into()),
            };
            vec![(name, state_or_slide(end))]
        }
    )*};
}

/// What a motion ends at. Each method is a function of its own, so that a model has to be compiled for those alone that it is asked for.
pub mod ends {
    use super::{
        At, Found, Lagrangian, MAX_STEPS, MotionSeries, Problem, Taylor, completed, state_or_slide,
    };

    ends_by! {
        taylor = Taylor::new();
        dop853 = super::dop853();
    }
}

/// Coordinates and velocities, or the time from which on a motion slides.
fn state_or_slide<const N: usize>(end: Result<Phase<f64, N>, Failure>) -> Entries {
    match end {
        Ok(x) => Ok(flat(x)),
        Err(Failure::Error(IntegrationError::SlidingMode { time, .. })) => Ok(vec![time]),
        Err(failure) => Err(failure.to_string()),
    }
}

/// Why a motion does not reach its end.
pub(crate) enum Failure {
    Error(IntegrationError),
    Stop(StopReason, f64),
}

impl From<IntegrationError> for Failure {
    fn from(error: IntegrationError) -> Self {
        Self::Error(error)
    }
}

impl<T> From<Partial<T>> for Failure {
    fn from(partial: Partial<T>) -> Self {
        Self::Error(partial.error())
    }
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Error(error) => error.fmt(f),
            Self::Stop(reason, t) => write!(f, "{reason:?} at t = {t}"),
        }
    }
}

fn completed<X>(reason: StopReason, last: lagrangian::At<f64, X>) -> Result<X, Failure> {
    if reason == StopReason::Completed {
        Ok(last.x)
    } else {
        Err(Failure::Stop(reason, last.t))
    }
}

/// The last state of the motion and the first two events that the model declares, of the model and of its reduced one.
macro_rules! reduced_ends_by {
    ($($name:ident = $method:expr, $names:expr;)*) => {$(
        #[doc = concat!("The ends and events of a model and of its reduced one by ", stringify!($name), ".")]
        #[must_use]
        pub fn $name<M, const N: usize, const R: usize, const K: usize>(
            model: &M,
            ignorable: [usize; K],
            at: &At,
        ) -> Vec<Found>
        where
            M: Lagrangian<N, Model: MotionSeries<N> + Events<N>> + RouthReduction<N, R, Scalar = f64>,
            M::Reduced: RouthianSeries<
                R,
                K,
                FullState = State<f64, N>,
                Model: MotionSeries<R> + Events<R>,
            >,
        {
            let names: [&'static str; 4] = $names;
            if !at.asks_for(names[0]) {
                return Vec::new();
            }
            let (start, end) = (at.state::<N>(), at.end());
            let (reduced, state) = model.reduce(&start);
            let places = SVector::from(ignorable.map(|i| start.q[i]));
            let equations = reduced.reconstruction();
            let back = |x: Phase<f64, R, SVector<f64, K>>| flat(equations.full_state(&(end, x).into()).x);
            let full = with_events(Problem::new(model, start), end, $method);
            let beside = Problem::new(&equations, beside(&state, places));
            let reduced = with_events(beside, end, $method);
            [
                named([names[0], names[1]], full, flat),
                named([names[2], names[3]], reduced, back),
            ]
            .concat()
        }
    )*};
}

/// What motions of a model with ignorable coordinates end at, by one of the methods.
pub mod reduced_ends {
    use super::{
        At, Events, Found, Lagrangian, MotionSeries, Phase, Problem, RouthReduction, Routhian as _,
        RouthianSeries, SVector, State, Taylor, beside, flat, named, with_events,
    };

    reduced_ends_by! {
        taylor = Taylor::new(), ["taylor", "taylor events", "reduced taylor", "reduced taylor events"];
        dop853 = super::dop853(), ["dop853", "dop853 events", "reduced dop853", "reduced dop853 events"];
    }
}

fn named<X>(
    [end, events]: [&'static str; 2],
    motion: Result<(X, Vec<f64>), String>,
    entries: impl Fn(X) -> Vec<f64>,
) -> Vec<Found> {
    match motion {
        Ok((x, found)) => vec![(end, Ok(entries(x))), (events, Ok(found))],
        Err(error) => vec![(end, Err(error.clone())), (events, Err(error))],
    }
}

/// Coordinates and velocities.
pub(crate) fn flat<const N: usize>(x: Phase<f64, N>) -> Vec<f64> {
    [rows(&x.q), rows(&x.v)].concat()
}

/// The state at the final time, and the first two events that are declared.
fn with_events<I, D>(
    problem: Problem<f64, D>,
    end: f64,
    method: I,
) -> Result<(D::State, Vec<f64>), String>
where
    I: Integrator<f64, D>,
    D: EventDynamics<f64>,
{
    let problem = problem
        .on([0, 1].map(DeclaredEvent::new))
        .record()
        .max_steps(MAX_STEPS);
    let motion = problem.solve(end, method);
    let motion = motion.map_err(|error| error.error().to_string())?;
    let events = listed(motion.events());
    let x = completed(motion.reason, motion.last).map_err(|failure| failure.to_string())?;
    Ok((x, events))
}

/// How many events there are, then the index and the time of each.
pub(crate) fn listed<X>(events: &[Occurrence<X>]) -> Vec<f64> {
    let pairs: Vec<(usize, f64)> = events.iter().map(|e| (e.event, e.t)).collect();
    list(&pairs)
}

/// How many events there are, then the index and the time of each.
#[allow(clippy::cast_precision_loss)] // They are few.
pub(crate) fn list(events: &[(usize, f64)]) -> Vec<f64> {
    let each = events.iter().flat_map(|(index, t)| [*index as f64, *t]);
    core::iter::once(events.len() as f64).chain(each).collect()
}

/// Motions in lanes beside references, and their distance from those that have all lanes for themselves; of one that slides along a jump, the
/// time from which on it does.
#[must_use]
pub fn lanes<M, const N: usize>(model: &M, at: &At) -> Vec<Found>
where
    M: Lagrangian<N>,
    for<'a> EquationsOfMotion<&'a M, f64, N>: InLanes<4, State = Phase<f64, N>>,
{
    let starts = at.starts::<N>();
    let ensemble = |motions: &[(State<f64, N>, f64)]| {
        let problems = motions.iter().map(|(start, _)| Problem::new(model, *start));
        let problems = problems.map(|problem| problem.max_steps(MAX_STEPS));
        let ends = |index: usize| motions[index].1;
        Ensemble::new(problems).solve(ends, Taylor::new())
    };
    let ends = ensemble(&starts);
    let (mut together, mut apart) = (Entries::Ok(Vec::new()), Entries::Ok(Vec::new()));
    for ((start, end), outcome) in starts.iter().zip(ends) {
        let found = state_or_slide(reached(outcome));
        let alone = ensemble(&[(*start, *end)]).remove(0);
        let expected = state_or_slide(reached(alone));
        let differences = match (&found, expected) {
            (Ok(found), Ok(expected)) if found.len() == expected.len() => {
                Ok(found.iter().zip(&expected).map(|(x, y)| x - y).collect())
            }
            // The same error, to the last digit, is the same result; that it should not be one is seen beside the reference.
            (Err(found), Err(expected)) if *found == expected => Ok(vec![0.0; 2 * N]),
            (_, expected) => Err(format!("in lanes {found:?}, alone {expected:?}")),
        };
        append(&mut together, found);
        append(&mut apart, differences);
    }
    vec![("lanes", together), ("lanes alone", apart)]
}

/// What a motion of an ensemble ends at.
fn reached<X>(solution: Result<Solution<f64, X>, Partial<Solution<f64, X>>>) -> Result<X, Failure> {
    let solution = solution?;
    completed(solution.reason, solution.last)
}

fn append(all: &mut Entries, more: Entries) {
    match (all.as_mut(), more) {
        (Ok(all), Ok(more)) => all.extend(more),
        (Ok(_), Err(error)) => *all = Err(error),
        (Err(_), _) => {}
    }
}
