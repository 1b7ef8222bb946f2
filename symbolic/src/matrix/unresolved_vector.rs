//! Vectors whose components come last: sums of vectors in frames, of their time derivatives, and of angular velocities.
//!
//! Frames form a tree, each turned against the one before it by one factor. A vector is a sum of terms and the frame
//! along whose axes it is to be resolved. Until then its components are [symbols](crate::Symbol::VelocityComponent), so
//! that an energy remains the quadratic form in the components of whole vectors as which it was declared.

use std::collections::BTreeMap;

use crate::matrix::factor::MatrixFactor;
use crate::{Expression, Graph};

/// A frame, by its position in the tree of frames.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct Frame(usize);

impl Frame {
    /// The inertial frame.
    pub(crate) const INERTIAL: Self = Self(0);
}

/// A vector that is resolved last, by its number.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct VectorId(usize);

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

/// A sum of terms that is resolved along the axes of a frame.
#[derive(Clone, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub(crate) struct UnresolvedVector {
    pub(crate) axes: Frame,
    pub(crate) terms: Vec<Term>,
}

/// All frames and vectors of a graph in which vectors are resolved last.
#[derive(Clone, Debug)]
pub(crate) struct UnresolvedVectors {
    /// How many coordinates the system has.
    pub(crate) coordinates: u32,
    /// Each frame but the inertial one: the frame before it, and how it is turned against that.
    frames: Vec<(Frame, MatrixFactor)>,
    children: BTreeMap<(Frame, MatrixFactor), Frame>,
    vectors: Vec<UnresolvedVector>,
    numbers: BTreeMap<UnresolvedVector, VectorId>,
}

impl UnresolvedVectors {
    /// No vectors, of a system with so many coordinates.
    pub(crate) const fn new(coordinates: u32) -> Self {
        Self {
            coordinates,
            frames: Vec::new(),
            children: BTreeMap::new(),
            vectors: Vec::new(),
            numbers: BTreeMap::new(),
        }
    }

    /// The frame with the rotation that is the product of these factors.
    pub(crate) fn frame(&mut self, factors: &[MatrixFactor]) -> Frame {
        let mut frame = Frame::INERTIAL;
        for factor in factors {
            let next = Frame(self.frames.len() + 1);
            let found = *self.children.entry((frame, *factor)).or_insert(next);
            if found == next {
                self.frames.push((frame, *factor));
            }
            frame = found;
        }
        frame
    }

    /// The frame before this one, with how this one is turned against it; none of the inertial frame.
    pub(crate) fn before(&self, frame: Frame) -> Option<(Frame, MatrixFactor)> {
        self.frames.get(frame.0.checked_sub(1)?).copied()
    }

    /// The frames that are turned against this one, each with its factor.
    pub(crate) fn behind(&self, frame: Frame) -> Vec<(Frame, MatrixFactor)> {
        let children = self.children.iter();
        let children = children.filter(|((before, _), _)| *before == frame);
        children
            .map(|((_, factor), next)| (*next, *factor))
            .collect()
    }

    /// The frames from the first one behind the inertial frame to this one, each with its factor.
    pub(crate) fn path(&self, frame: Frame) -> Vec<(Frame, MatrixFactor)> {
        let mut path = Vec::new();
        let mut frame = frame;
        while let Some((before, factor)) = self.before(frame) {
            path.push((frame, factor));
            frame = before;
        }
        path.reverse();
        path
    }

    /// The factors of a frame's rotation.
    pub(crate) fn factors(&self, frame: Frame) -> Vec<MatrixFactor> {
        let path = self.path(frame).into_iter();
        path.map(|(_, factor)| factor).collect()
    }

    /// The frames that are turned against inertial axes by at most so many factors, with these, in the order of their
    /// declaration.
    pub(crate) fn nearest(&self, most: usize) -> Vec<(Frame, Vec<MatrixFactor>)> {
        let frames = (1..=self.frames.len()).map(Frame);
        let frames = frames.map(|frame| (frame, self.factors(frame)));
        frames
            .filter(|(_, factors)| factors.len() <= most)
            .collect()
    }

    /// The number of a vector.
    pub(crate) fn number(&mut self, vector: UnresolvedVector) -> VectorId {
        let next = VectorId(self.vectors.len());
        let found = *self.numbers.entry(vector.clone()).or_insert(next);
        if found == next {
            self.vectors.push(vector);
        }
        found
    }

    /// The vector of a number.
    pub(crate) fn vector(&self, number: VectorId) -> &UnresolvedVector {
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
