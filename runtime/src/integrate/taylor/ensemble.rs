//! Ensembles: many motions of one system, several of them at once.

mod running;

pub(crate) use running::Running;

use super::{Series, Taylor};
use crate::integrate::at::At;
use crate::integrate::error::IntegrationError;
use crate::integrate::problem::Solution;
use crate::limits::taylor::SINGULARITY_TOLERANCE;
use crate::limits::{MAX_STEPS, MIN_SINGULARITY_TOLERANCE};
use crate::linalg::LaneStates;
use crate::scalar::{Lanes, Scalar};

/// Integrates many motions of one system by a [`Taylor`] method, `L` of them at once in SIMD lanes; made by
/// [`Taylor::ensemble`].
///
/// Each lane has steps, a final time, statistics and errors of its own. A lane whose motion has ended takes the next one,
/// so that all lanes are busy until the last motions. No motion depends on the others: it has the result that it has
/// alone, whatever their order. 4 or 8 lanes suit most processors, with `-C target-cpu=native`. Nothing is allocated but
/// by [`collect`](Self::collect).
///
/// An ensemble goes from each start to its end: it has no events, samples, reactions, stop conditions or observers. A
/// motion that needs them is a [`Problem`](crate::Problem), and many such motions are integrated on all cores, since
/// equations of motion are `Sync`.
///
/// A thousand initial values:
///
/// ```
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     taylor,
///     coordinates(theta),
///     kinetic = 0.5 * l.powi(2) * dot(theta).powi(2),
///     potential = -g * l * cos(theta),
/// )]
/// struct Pendulum { l: f64, g: f64 }
///
/// let pendulum = Pendulum { l: 1.0, g: 9.81 };
/// let starts = (0..1000).map(|i| State::new(0.0, [1e-3 * f64::from(i)], [0.0]));
/// let ensemble = Taylor::new().ensemble::<8>();
/// let ends = ensemble.collect(&pendulum.dynamics(), starts.map(|start| (start, 10.0)));
///
/// let start = State::new(0.0, [0.999], [0.0]);
/// let end = ends[999].as_ref().map_err(|error| *error)?;
/// assert!((pendulum.energy(end) - pendulum.energy(&start)).abs() < 1e-13);
/// # Ok::<(), IntegrationError>(())
/// ```
///
/// A thousand lengths, with [`run_members`](Self::run_members):
///
/// ```
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     taylor,
///     coordinates(theta),
///     kinetic = 0.5 * l.powi(2) * dot(theta).powi(2),
///     potential = -g * l * cos(theta),
/// )]
/// struct Pendulum { l: f64, g: f64 }
///
/// let lengths = (0..1000).map(|i| 0.5 + 1e-3 * f64::from(i));
/// let start = State::new(0.0, [1.0], [0.0]);
/// let mut highest = 0.0_f64;
/// Taylor::new().ensemble::<8>().run_members(
///     lengths.map(|l| (Pendulum { l, g: 9.81 }, start, 10.0)),
///     |_, result| {
///         let end = result.expect("a pendulum has no singularities");
///         highest = highest.max(end.q[0]);
///     },
/// );
/// assert!(highest > 0.99 && highest < 1.0 + 1e-13);
/// ```
///
/// A struct that is generic over its scalar has parameters that are lanes, with
/// [`run_with_parameters`](Self::run_with_parameters):
///
/// ```
/// use lagrangian::Lanes;
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     taylor,
///     coordinates(theta),
///     kinetic = 0.5 * l.powi(2) * dot(theta).powi(2),
///     potential = -g * l * cos(theta),
/// )]
/// struct Pendulum<T: Scalar> { l: T, g: f64 }
///
/// let mut pendulums = Pendulum { l: Lanes([1.0; 8]), g: 9.81 };
/// let lengths = (0..1000).map(|i| 0.5 + 1e-3 * f64::from(i));
/// let mut highest = 0.0_f64;
/// Taylor::new().ensemble::<8>().run_with_parameters(
///     &mut pendulums,
///     lengths,
///     |pendulums, lane, l| {
///         pendulums.l.set(lane, l);
///         (State::new(0.0, [1.0], [0.0]), 10.0)
///     },
///     |_, result| {
///         let end = result.expect("a pendulum has no singularities");
///         highest = highest.max(end.q[0]);
///     },
/// );
/// assert!(highest > 0.99 && highest < 1.0 + 1e-13);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Ensemble<const L: usize, const HALF: usize = 14> {
    method: Taylor<HALF>,
    max_steps: u64,
    singularity_tolerance: Option<f64>,
}

impl<const HALF: usize> Taylor<HALF> {
    /// An ensemble of motions that this method integrates `L` at a time.
    #[must_use]
    pub fn ensemble<const L: usize>(self) -> Ensemble<L, HALF> {
        const { assert!(L > 0, "an ensemble has at least one lane") }
        Ensemble {
            method: self,
            max_steps: MAX_STEPS,
            singularity_tolerance: None,
        }
    }
}

impl<const L: usize, const HALF: usize> Ensemble<L, HALF> {
    /// Limits the number of steps of each motion, rejected ones included, to 10⁸ unless set. A motion that has taken as
    /// many ends by [`StopReason::StepLimit`](crate::StopReason::StepLimit); it takes one at least.
    #[must_use]
    pub fn max_steps(mut self, steps: u64) -> Self {
        self.max_steps = steps;
        self
    }

    /// Sets the relative error of the accelerations at which a motion ends near a singularity of the mass matrix, as
    /// [`Problem::singularity_tolerance`](crate::Problem::singularity_tolerance) does.
    #[must_use]
    pub fn singularity_tolerance(mut self, tolerance: f64) -> Self {
        self.singularity_tolerance = Some(tolerance);
        self
    }

    /// Integrates each motion from its initial value to its final time, which may lie before it, and passes its position in
    /// `motions` and its solution, or its error, to `report`, in the order in which they end.
    ///
    /// All motions have the same parameters, which have the same value in all lanes. An invalid setting is an error of
    /// every motion.
    pub fn run<D>(
        &self,
        dynamics: &D,
        motions: impl IntoIterator<Item = (At<f64, Lane<D, L>>, f64)>,
        report: impl FnMut(usize, Result<Solution<f64, Lane<D, L>>, IntegrationError>),
    ) where
        D: Series<Lanes<L>, State: LaneStates<L>> + ?Sized,
    {
        let mut running = Running::new(self, motions.into_iter(), report);
        while running.fill(|_, motion| motion) {
            running.advance(dynamics);
        }
    }

    /// The solution or the error of each motion, in their order.
    #[cfg(feature = "alloc")]
    pub fn collect<D>(
        &self,
        dynamics: &D,
        motions: impl IntoIterator<Item = (At<f64, Lane<D, L>>, f64)>,
    ) -> alloc::vec::Vec<Result<Solution<f64, Lane<D, L>>, IntegrationError>>
    where
        D: Series<Lanes<L>, State: LaneStates<L>> + ?Sized,
    {
        let mut ends = alloc::vec::Vec::new();
        self.run(dynamics, motions, |index, result| {
            ends.push((index, result));
        });
        ends.sort_unstable_by_key(|(index, _)| *index);
        ends.into_iter().map(|(_, result)| result).collect()
    }

    /// The smallest relative pivot that does not end a motion; an error if the tolerance is not positive.
    fn min_pivot(&self) -> Result<f64, IntegrationError> {
        let tolerance = self.singularity_tolerance.unwrap_or_else(|| {
            let relative = self.method.tolerance::<Lanes<L>>().relative;
            let least = SINGULARITY_TOLERANCE.max(MIN_SINGULARITY_TOLERANCE * f64::EPSILON);
            relative.max(least)
        });
        if tolerance > 0.0 {
            Ok(Lanes::<L>::machine_epsilon() / tolerance)
        } else {
            Err(IntegrationError::InvalidSingularityTolerance { tolerance })
        }
    }
}

/// The state of one motion of a system in lanes.
type Lane<D, const L: usize> =
    <<D as crate::integrate::Dynamics<Lanes<L>>>::State as LaneStates<L>>::Lane;
