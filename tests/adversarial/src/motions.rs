//! Where motions end, and the events on the way: of a model, and of its reduced model with the ignorable coordinates beside it.

use lagrangian::{
    Dop853, Dynamics, Event, EventDynamics, Events, InitialValue, IntegrationMethod, Integrator,
    MotionSeries, Occurrence, Phase, ReconstructedPhase, RouthReduction, Routhian, RouthianSeries,
    State, StopReason, Taylor,
};
use nalgebra::SVector;

use crate::evaluation::{Entries, Found};
use crate::{At, rows};

/// The tolerance of DOP853 by which those of its references are measured.
const DOP853_TOLERANCE: f64 = 1e-11;

/// How many steps a motion may take.
pub(crate) const MOST_STEPS: u64 = 5_000;

/// DOP853 as its references expect it.
pub(crate) fn dop853() -> Dop853 {
    Dop853::new()
        .relative_tolerance(DOP853_TOLERANCE)
        .absolute_tolerance(DOP853_TOLERANCE)
}

/// The last state of the motion, by both adaptive methods.
#[must_use]
pub fn ends<M, const N: usize>(model: &M, at: &At) -> Vec<Found>
where
    M: MotionSeries<N>,
{
    let (dynamics, start, end) = (model.dynamics(), at.state::<N>(), at.end());
    let [taylor, dop853] = [
        last(&Taylor::new(), &dynamics, start, end),
        last(&dop853(), &dynamics, start, end),
    ];
    vec![("taylor", taylor.map(flat)), ("dop853", dop853.map(flat))]
}

/// The last state of the motion and the first two events that the model declares, of the model and of its reduced one.
#[must_use]
pub fn reduced_ends<M, const N: usize, const R: usize, const K: usize>(
    model: &M,
    ignorable: [usize; K],
    at: &At,
) -> Vec<Found>
where
    M: MotionSeries<N> + Events<N> + RouthReduction<N, R, Scalar = f64>,
    M::Reduced: MotionSeries<R> + Events<R> + RouthianSeries<R, K, FullState = State<f64, N>>,
{
    let (dynamics, start, end) = (model.dynamics(), at.state::<N>(), at.end());
    let (reduced, state) = model.reduce(&start);
    let places = SVector::from(ignorable.map(|i| start.q[i]));
    let equations = reduced.reconstruction();
    let back = |x: ReconstructedPhase<f64, R, K>| {
        let State { q, v, .. } = equations.full_state(end, &x);
        flat(Phase { q, v })
    };
    let taylor = with_events(&Taylor::new(), &dynamics, start, end);
    let eighth_order = with_events(&dop853(), &dynamics, start, end);
    let reduced_taylor = with_events(&Taylor::new(), &equations, (state, places), end);
    let reduced_eighth_order = with_events(&dop853(), &equations, (state, places), end);
    [
        named(["taylor", "taylor events"], taylor, flat),
        named(["dop853", "dop853 events"], eighth_order, flat),
        named(
            ["reduced taylor", "reduced taylor events"],
            reduced_taylor,
            back,
        ),
        named(
            ["reduced dop853", "reduced dop853 events"],
            reduced_eighth_order,
            back,
        ),
    ]
    .concat()
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

/// The state at the final time; why it is not reached otherwise.
pub(crate) fn last<I, D>(
    method: &I,
    dynamics: &D,
    start: impl InitialValue<D::State>,
    end: f64,
) -> Result<D::State, String>
where
    I: IntegrationMethod + Integrator<f64, D>,
    D: Dynamics<f64>,
{
    let driver = method.driver().max_steps(MOST_STEPS);
    let outcome = driver.run_until(dynamics, start, end);
    let outcome = outcome.map_err(|error| error.to_string())?;
    if outcome.reason == StopReason::Completed {
        Ok(outcome.last.x)
    } else {
        Err(format!("{:?} at t = {}", outcome.reason, outcome.last.t))
    }
}

fn with_events<I, D>(
    method: &I,
    dynamics: &D,
    start: impl InitialValue<D::State>,
    end: f64,
) -> Result<(D::State, Vec<f64>), String>
where
    I: IntegrationMethod + Integrator<f64, D>,
    D: EventDynamics<f64>,
{
    let driver = method.driver().max_steps(MOST_STEPS);
    let driver = driver.declared_events([(0, Event::either()), (1, Event::either())]);
    let motion = driver.sample(dynamics, start, &[end]);
    let motion = motion.map_err(|error| error.to_string())?;
    if motion.reason() != StopReason::Completed {
        return Err(format!("{:?} at t = {}", motion.reason(), motion.last().t));
    }
    Ok((motion.last().x.clone(), listed(motion.events())))
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

/// Motions in lanes beside references, and their distance from those that are integrated alone.
#[must_use]
pub fn lanes<M, const N: usize>(model: &M, at: &At) -> Vec<Found>
where
    M: MotionSeries<N> + MotionSeries<N, lagrangian::Lanes<4>>,
{
    let starts = at.starts::<N>();
    let alone = model.dynamics();
    let lanes = <M as lagrangian::Lagrangian<N, lagrangian::Lanes<4>>>::dynamics(model);
    let ensemble = Taylor::new().ensemble::<4>().max_steps(MOST_STEPS);
    let ends = ensemble.collect(&lanes, starts.iter().copied());
    let (mut together, mut apart) = (Entries::Ok(Vec::new()), Entries::Ok(Vec::new()));
    for ((start, end), outcome) in starts.iter().zip(ends) {
        let found = match outcome {
            Ok(outcome) if outcome.reason == StopReason::Completed => Ok(flat(outcome.last.x)),
            Ok(outcome) => Err(format!("{:?} at t = {}", outcome.reason, outcome.last.t)),
            Err(error) => Err(error.to_string()),
        };
        let expected = last(&Taylor::new(), &alone, *start, *end).map(flat);
        let differences = match (&found, expected) {
            (Ok(found), Ok(expected)) => {
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

fn append(all: &mut Entries, more: Entries) {
    match (all.as_mut(), more) {
        (Ok(all), Ok(more)) => all.extend(more),
        (Ok(_), Err(error)) => *all = Err(error),
        (Err(_), _) => {}
    }
}
