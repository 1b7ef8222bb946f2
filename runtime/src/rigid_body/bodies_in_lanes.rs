//! Several rotating bodies at once, one in each SIMD lane.

use nalgebra::Vector3;

use super::euler_equations::EulerEquations;
use super::moments::{ConstantForce, ConstantMoment, Damping, MomentSeries, NoMoment};
use super::rotation_state::RotationState;
use crate::integrate::InLanes;
use crate::linalg::{Factorization, LaneStates as _};
use crate::scalar::{Lanes, Scalar as _};

/// A moment on each of `L` bodies in SIMD lanes.
pub trait MomentInLanes<const L: usize>: MomentSeries<f64> {
    /// The moments on the bodies of all lanes.
    type InLanes: MomentSeries<Lanes<L>>;

    /// Returns this moment in every lane.
    fn in_lanes(&self) -> Self::InLanes;

    /// Sets the moment of a lane to this moment; does nothing if there is no such lane.
    fn set_lane(&self, moments: &mut Self::InLanes, lane: usize);
}

impl<const L: usize> MomentInLanes<L> for NoMoment {
    type InLanes = Self;

    fn in_lanes(&self) -> Self {
        Self
    }

    fn set_lane(&self, _: &mut Self, _: usize) {}
}

impl<const L: usize> MomentInLanes<L> for ConstantMoment {
    type InLanes = ConstantMoment<Lanes<L>>;

    fn in_lanes(&self) -> Self::InLanes {
        ConstantMoment(self.0.map(|component| Lanes([component; L])))
    }

    fn set_lane(&self, moments: &mut Self::InLanes, lane: usize) {
        moments.0.set_lane(lane, &self.0);
    }
}

impl<const L: usize> MomentInLanes<L> for Damping {
    type InLanes = Damping<Lanes<L>>;

    fn in_lanes(&self) -> Self::InLanes {
        Damping(self.0.map(|component| Lanes([component; L])))
    }

    fn set_lane(&self, moments: &mut Self::InLanes, lane: usize) {
        for (all, one) in moments.0.iter_mut().zip(self.0.iter()) {
            all.set(lane, *one);
        }
    }
}

impl<const L: usize> MomentInLanes<L> for ConstantForce {
    type InLanes = ConstantForce<Lanes<L>>;

    fn in_lanes(&self) -> Self::InLanes {
        ConstantForce {
            point: Vector3::broadcast(&self.point),
            force: Vector3::broadcast(&self.force),
        }
    }

    fn set_lane(&self, moments: &mut Self::InLanes, lane: usize) {
        moments.point.set_lane(lane, &self.point);
        moments.force.set_lane(lane, &self.force);
    }
}

/// Each lane has its own body and moment.
impl<M: MomentInLanes<L>, const L: usize> InLanes<L> for EulerEquations<f64, M> {
    type States = RotationState<Lanes<L>>;
    type Parameters = EulerEquations<Lanes<L>, M::InLanes>;
    type Together<'a>
        = &'a EulerEquations<Lanes<L>, M::InLanes>
    where
        Self: 'a;

    fn parameters(&self) -> Self::Parameters {
        self.map(Lanes::from_f64, MomentInLanes::in_lanes)
    }

    fn set_lane(&self, bodies: &mut Self::Parameters, lane: usize) {
        bodies.inertia = bodies.inertia.zip_map(&self.inertia, |mut all, one| {
            all.set(lane, one);
            all
        });
        bodies.factored = Factorization::new(bodies.inertia.matrix());
        self.moment.set_lane(&mut bodies.moment, lane);
    }

    fn together<'a>(&'a self, bodies: &'a Self::Parameters) -> Self::Together<'a> {
        bodies
    }
}
