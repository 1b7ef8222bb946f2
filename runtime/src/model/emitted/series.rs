//! The loops over the orders of Taylor series, which emitted code calls with its recurrences.

use nalgebra::SVector;

use crate::integrate::{
    BranchVisitor, Convolutions, FactorPairs, FewConvolutions, MetConditions, OnlineConvolutions,
    PairedConvolutions, SeriesMemory, TaylorCoefficients, UnrolledConvolutions,
};
use crate::limits::taylor::{MAX_PAIRED_CONVOLUTIONS, MAX_UNROLLED_CONVOLUTIONS, MIN_CONVOLUTIONS};
use crate::model::{Events, Phase, State};
use crate::scalar::Scalar;

/// Returns the coefficients of the inputs of order 0, and an iterator over the higher orders. Missing coefficients are
/// 0.
#[inline]
pub fn orders<S: Scalar, const U: usize>(
    series: &[SVector<S, U>],
) -> (SVector<S, U>, HigherOrders<'_, S, U>) {
    let zero = SVector::from_element(S::zero());
    let (initial, higher) = series.split_first().unwrap_or((&zero, &[]));
    (*initial, HigherOrders(higher.iter()))
}

/// The coefficients of the inputs from some order on.
#[derive(Clone, Debug)]
pub struct HigherOrders<'a, S: Scalar, const U: usize>(core::slice::Iter<'a, SVector<S, U>>);

impl<S: Scalar, const U: usize> HigherOrders<'_, S, U> {
    /// Returns the coefficients of the next order.
    #[inline]
    #[allow(clippy::should_implement_trait)] // It has no end.
    pub fn next(&mut self) -> SVector<S, U> {
        let next = self.0.next().copied();
        next.unwrap_or_else(|| SVector::from_element(S::zero()))
    }
}

/// The quantities that the recurrence for the Taylor coefficients of order k reads.
#[derive(Clone, Copy, Debug)]
pub struct Term<S: Scalar, const N: usize, const W: usize, const PAIRS: usize> {
    /// The coefficient of order k of the coordinates.
    pub q: SVector<S, N>,
    /// The coefficient of order k of the velocities, or of `W` quasi-velocities or other variables.
    pub v: SVector<S, W>,
    /// The coefficient of order k of the time.
    pub t: S,
    /// The order k.
    pub order: S,
    /// The reciprocal 1/k.
    pub reciprocal_order: S,
    /// Sums of products of terms of lower orders.
    pub convolutions: [S; PAIRS],
}

/// The place of a Taylor polynomial, and the memory for the terms of its convolutions.
type Expansion<'a, S, const N: usize, const HALF: usize> = (
    &'a mut TaylorCoefficients<Phase<S, N>, HALF>,
    Option<&'a mut SeriesMemory>,
);

/// Computes the Taylor polynomial of a motion.
///
/// `term` computes the accelerations of order k and the factors of the convolutions; the accelerations of order 0 are
/// given. `arrange` returns the factors of each pair, whose positions are in `pairs`.
#[inline]
pub fn taylor_series<
    S: Scalar,
    const N: usize,
    const FACTORS: usize,
    const PAIRS: usize,
    const LANES: usize,
    const HALF: usize,
>(
    state: &State<S, N>,
    unit: S,
    accelerations: SVector<S, N>,
    (coefficients, memory): Expansion<'_, S, N, HALF>,
    pairs: impl FactorPairs<PAIRS>,
    arrange: impl Fn(&[S; FACTORS]) -> [[S; PAIRS]; 2],
    mut term: impl FnMut(&Term<S, N, N, PAIRS>) -> (SVector<S, N>, [S; FACTORS]),
) {
    let term = |order: &Term<S, N, N, PAIRS>| {
        let (rates, factors) = term(order);
        (order.v, rates, factors)
    };
    expand::<_, _, _, _, _, LANES, HALF>(
        (state, unit, accelerations),
        (coefficients, memory),
        (pairs, arrange),
        Some,
        term,
    );
}

/// Computes the Taylor polynomial of a motion in `W` quasi-velocities or other variables.
///
/// `term` computes the velocities, the rates of order k and the factors of the convolutions; the rates of order 0 are
/// given.
#[inline]
pub fn taylor_series_in_quasi_velocities<
    S: Scalar,
    const N: usize,
    const W: usize,
    const FACTORS: usize,
    const PAIRS: usize,
    const LANES: usize,
    const HALF: usize,
>(
    state: &State<S, N>,
    unit: S,
    rates: SVector<S, W>,
    (coefficients, memory): Expansion<'_, S, N, HALF>,
    pairs: impl FactorPairs<PAIRS>,
    arrange: impl Fn(&[S; FACTORS]) -> [[S; PAIRS]; 2],
    term: impl FnMut(&Term<S, N, W, PAIRS>) -> (SVector<S, N>, SVector<S, W>, [S; FACTORS]),
) {
    expand::<_, _, _, _, _, LANES, HALF>(
        (state, unit, rates),
        (coefficients, memory),
        (pairs, arrange),
        |_| None,
        term,
    );
}

/// Computes the coefficients of a motion, given the rates of order 0, with the layout of the convolutions that suits
/// the scalar.
#[inline]
fn expand<
    S: Scalar,
    const N: usize,
    const W: usize,
    const FACTORS: usize,
    const PAIRS: usize,
    const LANES: usize,
    const HALF: usize,
>(
    (state, unit, rates): (&State<S, N>, S, SVector<S, W>),
    (coefficients, memory): Expansion<'_, S, N, HALF>,
    (pairs, arrange): (
        impl FactorPairs<PAIRS>,
        impl Fn(&[S; FACTORS]) -> [[S; PAIRS]; 2],
    ),
    velocities: impl Fn(SVector<S, W>) -> Option<SVector<S, N>>,
    term: impl FnMut(&Term<S, N, W, PAIRS>) -> (SVector<S, N>, SVector<S, W>, [S; FACTORS]),
) {
    *coefficients.initial_mut() = state.x;
    let first = (state.v * unit, rates * unit);
    let higher = coefficients.higher_mut();
    if const { pair_by_pair::<S, PAIRS, HALF>() } {
        let convolutions = PairedConvolutions::<S, PAIRS, LANES, HALF, _>::new(arrange);
        orders_of(unit, first, higher, pairs, convolutions, velocities, term);
    } else if PAIRS <= MAX_UNROLLED_CONVOLUTIONS {
        let (mut new, mut own) = (UnrolledConvolutions::<S, FACTORS, PAIRS, HALF>::new, None);
        let convolutions = kept(memory, &mut own, &mut new);
        convolutions.restart();
        orders_of(unit, first, higher, pairs, convolutions, velocities, term);
    } else {
        let mut own = None;
        let mut new = || Convolutions::<S, FACTORS, PAIRS, HALF>::of(&pairs);
        let convolutions = kept(memory, &mut own, &mut new);
        convolutions.restart(&pairs);
        orders_of(unit, first, higher, pairs, convolutions, velocities, term);
    }
}

/// Returns the convolutions that the memory keeps; without a memory, makes them in `own`.
#[inline]
fn kept<'a, C: 'static>(
    memory: Option<&'a mut SeriesMemory>,
    own: &'a mut Option<C>,
    new: &mut impl FnMut() -> C,
) -> &'a mut C {
    let kept = memory.and_then(|memory| memory.keep(&mut *new));
    match kept {
        Some(kept) => kept,
        None => own.insert(new()),
    }
}

/// Returns whether the terms are stored for each pair: if vector registers hold several numbers and the stack has room.
const fn pair_by_pair<S, const PAIRS: usize, const HALF: usize>() -> bool {
    let size = size_of::<PairedConvolutions<S, PAIRS, 1, HALF>>();
    size_of::<S>() <= size_of::<f64>() && size <= MAX_PAIRED_CONVOLUTIONS
}

/// Computes the coefficients of the motion, one order after the other, from order 1 on. If the variables are the
/// `velocities`, these are known before their term, which the last order then does not need.
#[inline]
fn orders_of<
    S: Scalar,
    P: FactorPairs<PAIRS>,
    const N: usize,
    const W: usize,
    const FACTORS: usize,
    const PAIRS: usize,
>(
    unit: S,
    first: (SVector<S, N>, SVector<S, W>),
    higher: &mut [Phase<S, N>],
    _: P,
    mut convolutions: impl OnlineConvolutions<S, FACTORS, PAIRS>,
    velocities_of: impl Fn(SVector<S, W>) -> Option<SVector<S, N>>,
    mut term: impl FnMut(&Term<S, N, W, PAIRS>) -> (SVector<S, N>, SVector<S, W>, [S; FACTORS]),
) {
    let (mut q, mut v) = first;
    let mut sums = [S::zero(); PAIRS];
    let mut order = S::one();
    let mut reciprocal_order = S::one();
    let mut t = unit;
    let Some((last, higher)) = higher.split_last_mut() else {
        return;
    };
    let mut higher = higher.iter_mut();
    loop {
        let (velocities, rates, factors) = term(&Term {
            q,
            v,
            t,
            order,
            reciprocal_order,
            convolutions: sums,
        });
        let Some(coefficient) = higher.next() else {
            *last = Phase::new(q, velocities);
            return;
        };
        *coefficient = Phase::new(q, velocities);
        order += S::one();
        reciprocal_order = S::one() / order;
        t = S::zero();
        let step = unit / order;
        (q, v) = (velocities * step, rates * step);
        if higher.len() == 0
            && let Some(velocities) = velocities_of(v)
        {
            *last = Phase::new(q, velocities);
            return;
        }
        sums = convolutions.advance::<P>(&factors);
    }
}

/// Computes the Taylor coefficients of event functions along a motion.
///
/// `term` computes the terms of order k and the factors of the convolutions; the values of order 0 are given. The
/// convolutions are few, and have one layout for all scalars.
#[inline]
pub fn event_series<
    S: Scalar,
    const N: usize,
    const EVENTS: usize,
    const FACTORS: usize,
    const PAIRS: usize,
    const HALF: usize,
    const OF_MOTION: usize,
>(
    unit: S,
    motion: &TaylorCoefficients<Phase<S, N>, OF_MOTION>,
    values: [S; EVENTS],
    pairs: impl FactorPairs<PAIRS>,
    term: impl FnMut(&Term<S, N, N, PAIRS>) -> ([S; EVENTS], [S; FACTORS]),
) -> TaylorCoefficients<[S; EVENTS], HALF> {
    if HALF < MIN_CONVOLUTIONS {
        let convolutions = FewConvolutions::<S, FACTORS, HALF>::new();
        series_by(convolutions, unit, motion, values, pairs, term)
    } else {
        let convolutions = Convolutions::<S, FACTORS, PAIRS, HALF>::of(&pairs);
        series_by(convolutions, unit, motion, values, pairs, term)
    }
}

/// Computes the Taylor coefficients of event functions with the given convolutions.
#[inline]
fn series_by<
    S: Scalar,
    P: FactorPairs<PAIRS>,
    const N: usize,
    const EVENTS: usize,
    const FACTORS: usize,
    const PAIRS: usize,
    const HALF: usize,
    const OF_MOTION: usize,
>(
    mut convolutions: impl OnlineConvolutions<S, FACTORS, PAIRS>,
    unit: S,
    motion: &TaylorCoefficients<Phase<S, N>, OF_MOTION>,
    values: [S; EVENTS],
    _: P,
    mut term: impl FnMut(&Term<S, N, N, PAIRS>) -> ([S; EVENTS], [S; FACTORS]),
) -> TaylorCoefficients<[S; EVENTS], HALF> {
    let mut series = TaylorCoefficients::new(values);
    let mut factors = None;
    let mut order = S::zero();
    let mut t = unit;
    for (coefficient, of_motion) in series.higher_mut().iter_mut().zip(motion.higher()) {
        let sums = match &factors {
            Some(factors) => convolutions.advance::<P>(factors),
            None => [S::zero(); PAIRS],
        };
        order += S::one();
        let (terms, next_factors) = term(&Term {
            q: of_motion.q,
            v: of_motion.v,
            t,
            order,
            reciprocal_order: S::one() / order,
            convolutions: sums,
        });
        *coefficient = terms;
        factors = Some(next_factors);
        t = S::zero();
    }
    series
}

/// Visits the series of the arguments of branches.
#[inline]
pub fn visit_branches<S: Scalar, const B: usize, const HALF: usize>(
    series: &TaylorCoefficients<[S; B], HALF>,
    visit: &mut BranchVisitor<'_, S>,
) {
    for index in 0..B {
        let values = core::iter::once(series.initial()).chain(series.higher());
        visit(&mut values.map(|values| values[index]));
    }
}

/// Visits the series of the event functions of a model that are watched, and their values at the end of a step.
#[inline]
pub fn visit_events<M, S, const N: usize, const HALF: usize, const OF_MOTION: usize>(
    model: &M,
    (state, inputs): (&State<S, N>, &[M::Inputs]),
    prepared: &M::Prepared,
    (unit, motion): (S, &TaylorCoefficients<Phase<S, N>, OF_MOTION>),
    (end, inputs_at_end): (&State<S, N>, &M::Inputs),
    (watched, visit): (
        MetConditions,
        &mut impl FnMut(usize, &TaylorCoefficients<S, HALF>, S),
    ),
) where
    M: Events<N, S>,
    S: Scalar,
{
    let series = model.event_series::<HALF, _>(state, inputs, prepared, unit, motion);
    let Some(series) = series else { return };
    let last = model.event_functions(end, inputs_at_end, prepared);
    for (index, last) in last.as_ref().iter().enumerate() {
        if watched.contains(index) {
            let of_event = |values: &M::EventValues| values.as_ref().get(index).copied();
            let series = series.map(|values| of_event(values).unwrap_or_else(S::zero));
            visit(index, &series, *last);
        }
    }
}
