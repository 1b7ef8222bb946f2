//! States at which the mass matrix is singular, and the reports about them.

use nalgebra::{SMatrix, SVector};

use super::named_singularity::named;
use super::poles::at_pole;
use super::quantities::Quantities;
use super::saddle_point::least_pivot;
use super::state::State;
use crate::integrate::Singularity;
use crate::limits::{REFERENCE_OFFSETS, VANISHING_INERTIA};
use crate::linalg::Factorization;
use crate::scalar::Scalar;

/// A state of a model at which its mass matrix may be singular.
pub(super) struct Configuration<'a, M: Quantities<N, S> + ?Sized, S: Scalar, const N: usize> {
    pub(super) model: &'a M,
    pub(super) prepared: &'a M::Prepared,
    pub(super) state: State<S, N>,
}

impl<M: Quantities<N, S> + ?Sized, S: Scalar, const N: usize> Configuration<'_, M, S, N> {
    /// Returns the constraint that depends on others, or else the coordinate with the smallest relative pivot, if that is below
    /// `min_pivot`.
    #[inline]
    pub(super) fn singularity(&self, min_pivot: f64) -> Option<Singularity> {
        let (pivots, constraint) = self.model.pivots(&self.state, self.prepared);
        if let Some((constraint, pivot)) = constraint
            && pivot < min_pivot
        {
            let names = M::CONSTRAINTS;
            return Some(Singularity::of_constraint(pivot, constraint, names));
        }
        let regular = pivots
            .iter()
            .all(|pivot| pivot.abs().smallest() >= min_pivot);
        if regular {
            at_pole::<M, S, N>(&self.state, min_pivot)
        } else {
            Some(self.report(&pivots))
        }
    }

    /// Tests for a singularity in the course of a motion.
    #[inline]
    pub(super) fn singularity_in_motion(&self, min_pivot: f64) -> Option<Singularity> {
        if M::STAYS_REGULAR {
            at_pole::<M, S, N>(&self.state, min_pivot)
        } else {
            self.singularity(min_pivot)
        }
    }

    /// Returns the report of the smallest relative pivot.
    #[cold]
    fn report(&self, pivots: &SVector<S, N>) -> Singularity {
        let (coordinate, least) = least_pivot(pivots).unwrap_or((0, f64::INFINITY));
        let found = named::<M, S, N>(coordinate, least, &self.state);
        let (model, prepared) = (self.model, self.prepared);
        let value = model.lagrangian(&self.state, &model.inputs(), prepared);
        if value.smallest().is_nan() {
            found.outside_domain()
        } else {
            found
        }
    }

    /// Returns the coordinate whose inertia is the smallest relative to its inertia at other configurations, if it has
    /// nearly vanished.
    #[cold]
    pub(super) fn vanishing_inertia(&self) -> Option<Singularity> {
        let (coordinate, ratio) = self.least_inertia(Scalar::smallest)?;
        Some(named::<M, S, N>(coordinate, ratio, &self.state))
    }

    /// Returns the coordinate whose inertia has nearly vanished in one lane.
    #[cold]
    pub(super) fn vanishing_inertia_in_lane(&self, lane: usize) -> Option<Singularity> {
        let in_lane = |x: S| x.in_lane(lane);
        let (coordinate, ratio) = self.least_inertia(in_lane)?;
        let State { t, x } = &self.state;
        let state = State::new(in_lane(*t), x.q.map(in_lane), x.v.map(in_lane));
        Some(named::<M, f64, N>(coordinate, ratio, &state))
    }

    /// Returns the coordinate with the smallest relative inertia, and its inertia relative to other configurations.
    fn least_inertia(&self, read: impl Fn(S) -> f64) -> Option<(usize, f64)> {
        let here = self.inertias(&self.state);
        let ratios = (0..N).map(|i| {
            let elsewhere = REFERENCE_OFFSETS.map(|distance| {
                let mut moved = self.state;
                for j in M::SINGULARITIES[i] {
                    moved.q[*j] += S::from_f64(distance);
                }
                read(self.inertias(&moved)[i])
            });
            let most = elsewhere.into_iter().fold(0.0, f64::max);
            (i, read(here[i]) / most)
        });
        let least = ratios.fold((0, VANISHING_INERTIA), |least, (i, ratio)| {
            if ratio < least.1 { (i, ratio) } else { least }
        });
        (least.1 < VANISHING_INERTIA).then_some(least)
    }

    /// Returns the magnitude of the effective inertia of each coordinate while the others are free: 1 / (M⁻¹)ᵢᵢ.
    fn inertias(&self, state: &State<S, N>) -> SVector<S, N> {
        let mass = self.model.mass_matrix(state, self.prepared);
        let inverse = Factorization::new(mass).solve(&SMatrix::<S, N, N>::identity());
        SVector::from_fn(|i, _| S::one() / inverse[(i, i)].abs())
    }
}
