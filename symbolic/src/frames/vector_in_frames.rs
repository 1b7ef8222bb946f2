//! Vectors as sums of vectors in frames, of their time derivatives, and of angular velocities.
//!
//! Such a vector is [resolved last](UnresolvedVectors): until then its components are symbols, so that an energy remains the
//! quadratic form in the components of whole vectors as which it was declared.

use std::collections::BTreeMap;

use crate::frames::frame_tree::Frame;
use crate::{Expression, Graph};

/// One term of a vector.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) enum Term {
    /// R v of a frame with the rotation R.
    Fixed(Frame, [Expression; 3]),
    /// The time derivative of R v, of a v without velocities.
    Rate(Frame, [Expression; 3]),
    /// A multiple of the angular velocity of a frame.
    AngularVelocity(Frame, Expression),
}

impl Term {
    /// The frame it belongs to.
    pub(crate) const fn frame(&self) -> Frame {
        match self {
            Self::Fixed(frame, _) | Self::Rate(frame, _) | Self::AngularVelocity(frame, _) => {
                *frame
            }
        }
    }

    /// Whether it contains velocities.
    pub(crate) fn moves(&self, graph: &Graph) -> bool {
        match self {
            Self::Fixed(_, vector) => vector.iter().any(|x| graph.contents(*x).has_velocity()),
            Self::Rate(..) | Self::AngularVelocity(..) => true,
        }
    }
}

/// A sum of terms along the axes of a frame.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct VectorInFrames {
    pub(crate) axes: Frame,
    pub(crate) terms: Vec<Term>,
}

/// A vector that is resolved last, by its number.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct VectorId(usize);

/// The vectors whose components are [symbols](crate::Symbol::VelocityComponent) until they are resolved.
#[derive(Clone, Debug, Default)]
pub(crate) struct UnresolvedVectors {
    /// How many coordinates the system has.
    pub(crate) coordinates: u32,
    vectors: Vec<VectorInFrames>,
    numbers: BTreeMap<VectorInFrames, VectorId>,
}

impl UnresolvedVectors {
    /// No vectors, of a system with so many coordinates.
    pub(crate) const fn new(coordinates: u32) -> Self {
        Self {
            coordinates,
            vectors: Vec::new(),
            numbers: BTreeMap::new(),
        }
    }

    /// The number of a vector.
    pub(crate) fn number(&mut self, vector: VectorInFrames) -> VectorId {
        let next = VectorId(self.vectors.len());
        let found = *self.numbers.entry(vector.clone()).or_insert(next);
        if found == next {
            self.vectors.push(vector);
        }
        found
    }

    /// The vector of a number.
    pub(crate) fn vector(&self, number: VectorId) -> &VectorInFrames {
        &self.vectors[number.0]
    }
}

impl VectorId {
    /// The vector and the axis of a component.
    pub(crate) const fn of_component(index: u32) -> (Self, usize) {
        let index = index as usize;
        (Self(index / 3), index % 3)
    }

    /// The numbers of its components.
    pub(crate) fn components(self) -> [u32; 3] {
        [0, 1, 2].map(|i| u32::try_from(3 * self.0 + i).unwrap_or(u32::MAX))
    }
}
