//! Singular configurations of constraints, if the steps of motions in lanes pass them.

use super::attempt::Attempt;
use super::verdicts::{Verdict, Verdicts};
use super::{TaylorLanes, lanes};
use crate::integrate::compensated::Compensated;
use crate::integrate::projected::reduced_on_manifold;
use crate::integrate::taylor::Series;
use crate::integrate::taylor::singular_configuration::SingularConfiguration;
use crate::limits::taylor::passing::{SHORT, SINGULAR_SINE};
use crate::linalg::LaneStates;
use crate::scalar::{Lanes, Scalar};

impl<X: LaneStates<L>, const L: usize, const HALF: usize> TaylorLanes<X, L, HALF> {
    /// Returns the singular configurations within reach of the steps of these lengths towards `ends`, and lengthens the
    /// steps of the moving lanes so that they pass, as [`TaylorStepper`](crate::TaylorStepper) does; `None` if the method
    /// does not pass them.
    pub(super) fn singular_configurations<D>(
        &self,
        dynamics: &D,
        (moving, ends): (&[bool; L], &[f64; L]),
        lengths: &mut [f64; L],
    ) -> Option<[SingularConfiguration; L]>
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        if !self.method.passes_singularities {
            return None;
        }
        let signed =
            core::array::from_fn(|lane| lengths[lane].copysign(ends[lane] - self.time[lane]));
        let steps = (&signed, self.method.min_part::<Lanes<L>>());
        let passed = SingularConfiguration::find(steps, |after| {
            let times = core::array::from_fn(|lane| self.time[lane] + after[lane]);
            let there = self.at(&times).state.into_value();
            let sines = dynamics.constraint_sine(Lanes(times), &there);
            sines.map_or([f64::NAN; L], |sines| sines.0)
        });
        let longest = self.method.max_step.unwrap_or(f64::INFINITY);
        for lane in lanes(moving) {
            lengths[lane] = passed[lane].lengthened(lengths[lane]).min(longest);
        }
        Some(passed)
    }

    /// Returns the reduced states at which the derivatives of the polynomials are compared with the equations, on the manifold
    /// of the dynamics if singular configurations are passed.
    pub(super) fn on_manifold<D>(&self, dynamics: &D, t: Lanes<L>, state: &Compensated<X>) -> X
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        let projection = if self.method.passes_singularities {
            dynamics.project(t, state.value())
        } else {
            None
        };
        reduced_on_manifold(dynamics, state, projection.as_ref())
    }

    /// Rejects the steps that end at singular configurations which were not found ahead of them, as
    /// [`TaylorStepper`](crate::TaylorStepper) does. `end` is the end of the steps on the manifold of the dynamics.
    pub(super) fn reject_overlooked<D>(
        &self,
        dynamics: &D,
        attempt: &Attempt<X, L>,
        (passed, end): (&[SingularConfiguration; L], &X),
        verdicts: &mut Verdicts<L>,
    ) where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        if !attempt.is_first {
            return;
        }
        let t = Lanes(attempt.targets);
        let Some(sines) = dynamics.constraint_sine(t, end) else {
            return;
        };
        let lengths = (t - Lanes(self.time)).abs();
        for lane in lanes(&verdicts.open) {
            let is_overlooked = passed[lane].is_overlooked(lengths.0[lane], sines.0[lane]);
            if is_overlooked && !attempt.lands[lane] {
                verdicts.put(lane, Verdict::Shorten(SHORT));
            }
        }
    }

    /// Removes the lanes that pass a singular configuration and are so near to it that accelerations are not known to the
    /// tolerance.
    pub(super) fn excuse<D>(&self, dynamics: &D, (t, x): (Lanes<L>, &X), failing: &mut [bool; L])
    where
        D: Series<Lanes<L>, State = X> + ?Sized,
    {
        if !self.method.passes_singularities {
            return;
        }
        let Some(sines) = dynamics.constraint_sine(t, x) else {
            return;
        };
        for lane in lanes(&failing.clone()) {
            failing[lane] = sines.0[lane].is_nan() || sines.0[lane] >= SINGULAR_SINE;
        }
    }
}
