//! What all dynamics of a model have in common, whatever sets the inputs.

use nalgebra::SVector;

use super::generalized_coordinates::GeneralizedCoordinates;
use super::phase::Phase;
use super::whole_periods::{is_large, less_whole_periods};
use crate::integrate::ComponentName;
use crate::linalg::ErrorTolerance;
use crate::scalar::Scalar;

/// What the dynamics of a model say of singularities: `self.model` is the model or a reference to it, `self.prepared` its prepared array, and `x.at(t)` the state of the
/// mechanical system.
macro_rules! singularities_of_the_model {
    () => {
        #[inline]
        fn singularity(
            &self,
            t: S,
            x: &Self::State,
            min_pivot: f64,
        ) -> Option<$crate::Singularity> {
            use $crate::model::singular_configuration::singularity;
            singularity::<M, S, N>(&self.model, &self.prepared, &x.at(t), min_pivot)
        }

        #[inline]
        fn singularity_in_motion(
            &self,
            t: S,
            x: &Self::State,
            min_pivot: f64,
        ) -> Option<$crate::Singularity> {
            use $crate::model::singular_configuration::singularity_in_motion;
            singularity_in_motion::<M, S, N>(&self.model, &self.prepared, &x.at(t), min_pivot)
        }

        #[inline]
        fn singularity_between(
            &self,
            lane: Option<usize>,
            before: &Self::State,
            (t, after): (S, &Self::State),
        ) -> Option<$crate::Singularity> {
            use $crate::model::singular_configuration::singularity_between;
            singularity_between::<M, S, N>(lane, &before.q, &after.at(t))
        }

        #[inline]
        fn singularity_in_lane(
            &self,
            lane: usize,
            t: S,
            x: &Self::State,
            min_pivot: f64,
        ) -> Option<$crate::Singularity> {
            use $crate::model::singular_configuration::singularity_in_lane;
            singularity_in_lane::<M, S, N>(&self.model, &self.prepared, lane, &x.at(t), min_pivot)
        }

        fn vanishing_inertia(&self, t: S, x: &Self::State) -> Option<$crate::Singularity> {
            use $crate::model::singular_configuration::vanishing_inertia;
            vanishing_inertia::<M, S, N>(&self.model, &self.prepared, &x.at(t))
        }

        fn vanishing_inertia_in_lane(
            &self,
            lane: usize,
            t: S,
            x: &Self::State,
        ) -> Option<$crate::Singularity> {
            use $crate::model::singular_configuration::vanishing_inertia_in_lane;
            vanishing_inertia_in_lane::<M, S, N>(&self.model, &self.prepared, lane, &x.at(t))
        }
    };
}
pub(super) use singularities_of_the_model;

/// What the dynamics of a model say of allowed errors, of singularities and of the names of components, whatever sets the
/// inputs, with the fields that [`singularities_of_the_model`] reads.
macro_rules! errors_of_the_model {
    () => {
        #[inline]
        fn allowed_error(
            &self,
            x: &$crate::Phase<S, N>,
            tolerance: &$crate::ErrorTolerance<S>,
        ) -> $crate::Phase<S, N> {
            $crate::model::common_dynamics::allowed_error::<M, S, N>(x, tolerance)
        }

        $crate::model::common_dynamics::singularities_of_the_model!();

        fn component_name(&self, index: usize) -> $crate::ComponentName {
            $crate::model::common_dynamics::component_name::<M, N>(index)
        }
    };
}
pub(super) use errors_of_the_model;

/// The phase with angles less whole periods.
#[inline]
pub(super) fn reduced<M, S, const N: usize>(
    x: &Phase<S, N>,
    compensation: &Phase<S, N>,
) -> Phase<S, N>
where
    M: GeneralizedCoordinates<N> + ?Sized,
    S: Scalar,
{
    let mut reduced = *x;
    for (i, angle) in reduced.q.iter_mut().enumerate() {
        let period = M::PERIODS[i];
        if period > 0 && !M::IGNORABLE[i] && is_large(*angle) {
            *angle = less_whole_periods(*angle, compensation.q[i], period);
        }
    }
    reduced
}

/// The allowed errors of coordinates of sizes |qᵢ| and of velocities of sizes |q̇ᵢ|. The size of an angle, which is
/// periodic, is 1, and that of another ignorable coordinate, whose value does not matter, is |q̇ᵢ| over the rate.
#[inline]
pub(crate) fn allowed_error<M, S, const N: usize>(
    x: &Phase<S, N>,
    tolerance: &ErrorTolerance<S>,
) -> Phase<S, N>
where
    M: GeneralizedCoordinates<N> + ?Sized,
    S: Scalar,
{
    let time = S::one() / tolerance.rate;
    let size = |i: usize| {
        if M::ANGLES[i] {
            S::one()
        } else if M::IGNORABLE[i] {
            x.v[i].abs() * time
        } else {
            x.q[i].abs()
        }
    };
    Phase {
        q: SVector::from_fn(|i, _| tolerance.of_coordinate(size(i))),
        v: x.v.map(|v| tolerance.of_velocity(v.abs())),
    }
}

/// The name of a component of a phase.
pub(crate) fn component_name<M: GeneralizedCoordinates<N> + ?Sized, const N: usize>(
    index: usize,
) -> ComponentName {
    let coordinate = M::COORDINATES.get(index);
    let velocity = index.checked_sub(N).and_then(|i| M::COORDINATES.get(i));
    match (coordinate, velocity) {
        (Some(name), _) => ComponentName::Coordinate(name),
        (None, Some(name)) => ComponentName::Velocity(name),
        (None, None) => ComponentName::Index(index),
    }
}
