//! The steps that are tried in lanes.

use super::arrivals::Arrivals;
use crate::integrate::taylor::coefficients::power;
use crate::integrate::taylor::singular_configuration::SingularConfiguration;
use crate::scalar::{Lanes, Scalar};

/// What is known of the motions at the beginning of a step, besides the coefficients of their polynomials.
pub(super) struct Expansion<X, const L: usize> {
    /// The reduced states about which the polynomials are expanded.
    pub(super) from: X,
    pub(super) proposals: Proposals<L>,
    /// The singular configurations of constraints within reach; `None` if none are passed.
    pub(super) passed: Option<[SingularConfiguration; L]>,
}

impl<X, const L: usize> Expansion<X, L> {
    /// Returns the singular configuration within reach of the step of a lane.
    pub(super) fn passed(&self, lane: usize) -> SingularConfiguration {
        let passed = self.passed.as_ref();
        passed.map_or(SingularConfiguration::NONE, |passed| passed[lane])
    }
}

/// The next step in each lane, as proposed by the polynomials.
#[derive(Clone, Copy)]
pub(super) struct Proposals<const L: usize> {
    /// The length of the step, or of the one that is tried after it was rejected; 0 if there is none.
    pub(super) step: [f64; L],
    /// The larger of the two terms of about half the order, over their tolerances.
    pub(super) middle: Lanes<L>,
}

impl<const L: usize> Proposals<L> {
    /// Returns the larger of the two terms of about half the order at `h`, or at the proposed step if it is longer.
    #[inline]
    pub(super) fn middle_at(&self, h: Lanes<L>, unit: Lanes<L>, half_order: usize) -> Lanes<L> {
        // Selections instead of branches, which take 4 % more of all time.
        let finite = |step: f64| if step < f64::INFINITY { step } else { 0.0 };
        let longest = Scalar::max(Lanes(self.step.map(finite)), h);
        self.middle * power(longest / unit, half_order)
    }
}

/// The steps that are tried in all lanes.
pub(super) struct Attempt<X, const L: usize> {
    /// The lanes that take a step.
    pub(super) moving: [bool; L],
    /// Those of them whose steps are not accepted yet.
    pub(super) pending: [bool; L],
    /// The lengths of the steps, unless they land on the ends of the motions.
    pub(super) lengths: [f64; L],
    /// The times at which the steps end.
    pub(super) targets: [f64; L],
    /// The lanes whose steps land on the ends of the motions.
    pub(super) lands: [bool; L],
    /// Whether no longer steps were tried before.
    pub(super) is_first: bool,
    /// The components in which longer steps differed from the motions.
    pub(super) component: [Option<usize>; L],
    /// The arrivals of lanes whose steps end at discontinuity surfaces.
    pub(super) arrivals: Option<Arrivals<X, L>>,
    /// The changes by which the ends of the steps are corrected, if they are.
    pub(super) correction: Option<X>,
}

impl<X, const L: usize> Attempt<X, L> {
    /// The steps of these lengths from these times, before their ends are known.
    #[inline]
    pub(super) fn new(moving: [bool; L], lengths: [f64; L], times: [f64; L]) -> Self {
        Self {
            moving,
            pending: moving,
            lengths,
            targets: times,
            lands: [false; L],
            is_first: true,
            component: [None; L],
            arrivals: None,
            correction: None,
        }
    }
}
