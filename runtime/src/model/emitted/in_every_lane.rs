//! The fields of a struct with a type parameter for its scalar, converted to equal values in every lane.

use core::marker::PhantomData;

use nalgebra::SMatrix;

use crate::scalar::{Lanes, Scalar as _};

/// A field that uses the type parameter: the number itself, a vector or matrix of it, or an array of these.
pub trait InEveryLane<const L: usize> {
    /// The type of the field in the struct with lanes.
    type InLanes;

    /// Returns this value in every lane.
    fn in_every_lane(&self) -> Self::InLanes;
}

impl<const L: usize> InEveryLane<L> for f64 {
    type InLanes = Lanes<L>;

    fn in_every_lane(&self) -> Lanes<L> {
        Lanes::from_f64(*self)
    }
}

impl<const R: usize, const C: usize, const L: usize> InEveryLane<L> for SMatrix<f64, R, C> {
    type InLanes = SMatrix<Lanes<L>, R, C>;

    fn in_every_lane(&self) -> Self::InLanes {
        self.map(Lanes::from_f64)
    }
}

impl<P: InEveryLane<L>, const K: usize, const L: usize> InEveryLane<L> for [P; K] {
    type InLanes = [P::InLanes; K];

    fn in_every_lane(&self) -> Self::InLanes {
        core::array::from_fn(|i| self[i].in_every_lane())
    }
}

impl<const L: usize> InEveryLane<L> for PhantomData<f64> {
    type InLanes = PhantomData<Lanes<L>>;

    fn in_every_lane(&self) -> Self::InLanes {
        PhantomData
    }
}

/// A field that does not use the type parameter, and is copied.
pub trait Kept<const L: usize> {
    /// Returns a copy.
    #[must_use]
    fn kept(&self) -> Self;
}

impl<P: Clone, const L: usize> Kept<L> for P {
    fn kept(&self) -> Self {
        self.clone()
    }
}
