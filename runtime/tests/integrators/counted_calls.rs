//! What an ensemble with corners evaluates, and what its motions do alone.

use core::cell::Cell;

use crate::common::in_lanes;
use lagrangian::nalgebra::SVector;
use lagrangian::prelude::*;
use lagrangian::{BranchVisitor, Scalar, Series, SeriesMemory, TaylorCoefficients};

/// ẍ = −x − k max(x − ½, 0), with the calls that are made.
#[derive(Default)]
struct Counted {
    derivatives: Cell<u64>,
    series: Cell<u64>,
    branches: Cell<u64>,
}

const STIFFNESS: f64 = 30.0;

impl Counted {
    fn slope<S: Scalar>(x: S) -> [S; 2] {
        let excess = x - S::from_f64(0.5);
        let weight = S::from_f64(0.5) + S::from_f64(0.5) * excess.signum();
        [weight, excess]
    }

    fn count(calls: &Cell<u64>) {
        calls.set(calls.get() + 1);
    }

    fn counts(&self) -> [u64; 3] {
        [&self.derivatives, &self.series, &self.branches].map(Cell::get)
    }
}

impl<S: Scalar> Dynamics<S> for Counted {
    type State = SVector<S, 2>;

    fn derivative(&self, _: S, x: &Self::State) -> Self::State {
        Self::count(&self.derivatives);
        let [weight, excess] = Self::slope(x[0]);
        SVector::from([x[1], -x[0] - S::from_f64(STIFFNESS) * weight * excess])
    }
}

impl<S: Scalar> Series<S> for Counted {
    fn series<const HALF: usize>(
        &self,
        (_, x): (S, &Self::State),
        unit: S,
        coefficients: &mut TaylorCoefficients<Self::State, HALF>,
        _: Option<&mut SeriesMemory>,
    ) {
        Self::count(&self.series);
        let [weight, excess] = Self::slope(x[0]);
        let mut term = *x;
        *coefficients.initial_mut() = term;
        let mut constant = excess;
        for (order, slot) in (1_u32..).zip(coefficients.higher_mut()) {
            let rate = unit / S::from_f64(f64::from(order));
            let force = -term[0] - S::from_f64(STIFFNESS) * weight * constant;
            term = SVector::from([term[1] * rate, force * rate]);
            constant = term[0];
            *slot = term;
        }
    }

    fn branches<const HALF: usize>(
        &self,
        _: S,
        x: &Self::State,
        _: S,
        motion: &TaylorCoefficients<Self::State, HALF>,
        visit: &mut BranchVisitor<'_, S>,
    ) {
        Self::count(&self.branches);
        let higher = motion.higher().iter().map(|term| term[0]);
        visit(&mut core::iter::once(x[0] - S::from_f64(0.5)).chain(higher));
    }
}

crate::alike_in_lanes!(Counted);

/// A lane does nothing that it would not do alone: rejected, finished and idle ones cost nothing. Four lanes at once make at
/// most as many calls as their motions one after the other.
#[test]
fn lanes_make_no_more_calls_than_their_motions_alone() {
    let motions = (0..18).map(|i| {
        let i = f64::from(i);
        let start = SVector::from([0.6 - 0.07 * i, 0.3 + 0.05 * i]);
        (At::from((0.1 * i, start)), 3.0 + 2.5 * i)
    });
    let alone = Counted::default();
    let mut ends = Vec::new();
    for (start, end) in motions.clone() {
        let end = Problem::new(&alone, start).solve(end, Taylor::new());
        ends.push(end.unwrap());
    }
    let together = Counted::default();
    let in_lanes = in_lanes::<4, _, _>(Taylor::new(), &together, motions);
    for (lane, alone) in in_lanes.into_iter().zip(&ends) {
        let lane = lane.unwrap();
        assert_eq!(lane.last, alone.last);
        assert_eq!(lane.statistics.steps, alone.statistics.steps);
        assert_eq!(lane.statistics.rejected, alone.statistics.rejected);
    }
    let (alone, together) = (alone.counts(), together.counts());
    for (alone, together) in alone.into_iter().zip(together) {
        assert!(together <= alone, "{alone} alone, {together} in lanes");
    }
    let steps: u64 = ends.iter().map(|end| end.statistics.attempts()).sum();
    assert!(alone[2] < 4 * steps, "{steps} steps, {} searches", alone[2]);
}
