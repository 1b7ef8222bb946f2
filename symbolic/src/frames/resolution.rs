//! Vectors that are known in frames.
//!
//! A vector may be known as a sum Σ Rᵢ vᵢ, where each Rᵢ is a product of rotations. What is invariant under
//! rotations can then be resolved in any of these frames, of which the cheapest is taken: |R v|² is |v|². Only
//! matrices that are rotations for all values of their symbols count, no parameters that are trusted to be
//! rotations: other matrices are part of vᵢ.

use crate::frames::frame_tree::Frame;
use crate::frames::vector_in_frames::{Term, VectorInFrames};
use crate::limits::{MAX_FACTORS, MAX_FACTORS_IN_SUM, MAX_FRAMES_IN_SUM};
use crate::matrix::axis::Axis;
use crate::matrix::dense::Matrix;
use crate::matrix::factor::MatrixFactor;
use crate::{Expression, Geometry, Graph, Node, Rational};

type Vector = [Expression; 3];

/// A vector R v, by the frame of R and its components v there.
type Part = (Frame, Vector);

impl Geometry {
    /// Whether a vector is known as a sum of vectors in frames.
    pub(crate) fn is_known_in_frames(&self, vector: &Matrix) -> bool {
        self.frames.vectors.contains_key(vector.elements())
    }

    /// The same vector, known as the sum of these parts from now on, unless they are many, none is rotated, or its components
    /// are numbers and parameters.
    pub(crate) fn with_parts(&mut self, vector: Matrix, parts: Vec<Part>) -> Matrix {
        let most_factors = if parts.len() > 1 {
            MAX_FACTORS_IN_SUM
        } else {
            MAX_FACTORS
        };
        let tree = &self.frames.tree;
        let is_short = parts.len() <= MAX_FRAMES_IN_SUM
            && parts
                .iter()
                .all(|(frame, _)| tree.depth(*frame) <= most_factors);
        let is_rotated = parts.iter().any(|(frame, _)| *frame != Frame::INERTIAL);
        // Such as (0, 0, 1), which may mean another vector elsewhere.
        let is_written = |x: &Expression| {
            let is_leaf = matches!(self.graph.node(*x), Node::Constant(_) | Node::Symbol(_));
            is_leaf && !self.graph.contents(*x).varies()
        };
        if let Some(components) = vector.components()
            && is_short
            && is_rotated
            && !components.iter().all(is_written)
        {
            let terms = parts.into_iter();
            let known = VectorInFrames {
                axes: Frame::INERTIAL,
                terms: terms.map(|(frame, v)| Term::Fixed(frame, v)).collect(),
            };
            self.frames.vectors.insert(components, known);
        }
        vector
    }

    /// The parts of a vector of three components that is known in frames; otherwise none.
    fn known_parts(&self, vector: &Matrix) -> Vec<Part> {
        let known = self.frames.vectors.get(vector.elements());
        let terms = known.map_or(&[][..], |known| &known.terms);
        let parts = terms.iter().filter_map(|term| match term {
            Term::Fixed(frame, v) => Some((*frame, *v)),
            Term::Rate(..) | Term::AngularVelocity(..) => None,
        });
        parts.collect()
    }

    /// The parts of a vector of three components: the known ones, or itself.
    fn parts_of(&self, vector: &Matrix) -> Vec<Part> {
        let mut parts = self.known_parts(vector);
        if parts.is_empty() {
            let components = vector.components().into_iter();
            parts.extend(components.map(|components| (Frame::INERTIAL, components)));
        }
        parts
    }

    /// Σ A Rᵢ vᵢ, where A is the product of `factors`, of a vector that may be known in frames.
    pub(crate) fn rotated_parts(&mut self, factors: &[MatrixFactor], vector: &Matrix) -> Vec<Part> {
        // Where vectors are resolved last, only they make frames.
        if self.frames.unresolved.is_some() {
            return Vec::new();
        }
        let mut parts = Vec::new();
        for (frame, vector) in self.parts_of(vector) {
            let own = self.frames.tree.factors(frame);
            let mut rotation = self.merged(factors.iter().copied().chain(own));
            let count = rotation.iter().take_while(|factor| factor.is_rotation());
            let others = rotation.split_off(count.count());
            let vector = others.into_iter().rev().fold(vector, |vector, factor| {
                factor.apply(&mut self.graph, vector)
            });
            parts.push((self.frames.tree.frame(&rotation), vector));
        }
        self.graph.added_by_frame(parts)
    }

    /// The parts of Σ cᵢ xᵢ of pairs (xᵢ, cᵢ).
    pub(crate) fn parts_of_sum(&mut self, terms: &[(&Matrix, Rational)]) -> Vec<Part> {
        if !terms.iter().any(|(x, _)| self.is_known_in_frames(x)) {
            return Vec::new();
        }
        let mut parts = Vec::new();
        for (x, c) in terms {
            for (frame, vector) in self.parts_of(x) {
                parts.push((frame, vector.map(|x| self.graph.scale(x, c))));
            }
        }
        self.graph.added_by_frame(parts)
    }

    /// The parts of a multiple of a vector.
    pub(crate) fn parts_scaled(&mut self, vector: &Matrix, factor: Expression) -> Vec<Part> {
        let mut parts = self.known_parts(vector);
        for (_, vector) in &mut parts {
            *vector = vector.map(|x| self.graph.multiply(factor, x));
        }
        parts
    }

    /// The parts of the time derivative: of R v it is R (ω × v + v̇), with the angular velocity ω of R
    /// in the frame of R.
    pub(crate) fn parts_of_derivative(&mut self, vector: &Matrix, coordinates: u32) -> Vec<Part> {
        let mut parts = self.known_parts(vector);
        for (frame, vector) in &mut parts {
            let factors = self.frames.tree.factors(*frame);
            let Ok(velocity) = self.angular_velocity_of_product(&factors, coordinates) else {
                return Vec::new();
            };
            let transport = self.graph.cross(velocity, *vector);
            let rates = self.time_derivatives(vector, coordinates);
            *vector = [0, 1, 2].map(|i| self.graph.add(transport[i], rates[i]));
        }
        self.graph.added_by_frame(parts)
    }

    /// The parts of x × y: R a × R b is R (a × b), for the rotation R that both begin with.
    pub(crate) fn parts_of_cross_product(&mut self, x: &Matrix, y: &Matrix) -> Vec<Part> {
        let [first, second] = [x, y].map(|x| self.parts_of(x));
        let frame = self.common_frame(&first, &second);
        if frame == Frame::INERTIAL {
            return Vec::new();
        }
        let [a, b] = [first, second].map(|parts| self.resolve_in(frame, &parts));
        vec![(frame, self.graph.cross(a, b))]
    }

    /// The cheapest x · y in the frame that all parts of both have in common, or in that of one of the parts;
    /// none where the frames are independent, for which the elements are cheaper.
    pub(crate) fn dot_product_of_parts(&mut self, x: &Matrix, y: &Matrix) -> Option<Expression> {
        let [first, second] = [x, y].map(|x| self.parts_of(x));
        let common = self.common_frame(&first, &second);
        if common == Frame::INERTIAL {
            return None;
        }
        let mut frames = vec![common];
        for (frame, _) in first.iter().chain(&second) {
            if !frames.contains(frame) {
                frames.push(*frame);
            }
        }
        let mut candidates = Vec::new();
        for frame in frames {
            let a = self.resolve_in(frame, &first);
            let b = self.resolve_in(frame, &second);
            candidates.push(self.graph.sum_of_products(a.into_iter().zip(b)));
        }
        candidates
            .into_iter()
            .min_by_key(|x| self.graph.cost(&[*x]))
    }

    /// The vector that parts add up to.
    pub(crate) fn sum_of_parts(&mut self, parts: &[Part]) -> Vector {
        self.resolve_in(Frame::INERTIAL, parts)
    }

    /// Rᵀ Σ Rᵢ vᵢ: the components in the frame of R.
    ///
    /// The vector with most factors is rotated first, so that vectors are added before they are rotated further
    /// together.
    fn resolve_in(&mut self, frame: Frame, parts: &[Part]) -> Vector {
        let rotation = self.frames.tree.factors(frame);
        let back: Vec<MatrixFactor> = rotation.iter().rev().map(MatrixFactor::transpose).collect();
        let mut waiting = Vec::with_capacity(parts.len());
        for (frame, vector) in parts {
            let own = self.frames.tree.factors(*frame);
            let relative = self.merged(back.iter().copied().chain(own));
            waiting.push((relative, *vector));
        }
        loop {
            waiting = self.graph.added_by_frame(waiting);
            let longest = waiting
                .iter_mut()
                .max_by_key(|(rotation, _)| rotation.len());
            let Some((rotation, vector)) = longest else {
                return [self.graph.zero(); 3];
            };
            match rotation.pop() {
                Some(factor) => *vector = factor.apply(&mut self.graph, *vector),
                // All are in the frame asked for, and so added up.
                None => return *vector,
            }
        }
    }

    /// The last frame that all parts have in common.
    fn common_frame(&self, first: &[Part], second: &[Part]) -> Frame {
        let frames = first.iter().chain(second).map(|(frame, _)| *frame);
        self.frames.tree.last_in_common(frames)
    }
}

impl Graph {
    /// The same vectors, those of one frame added up, without zeros.
    fn added_by_frame<F: PartialEq>(&mut self, parts: Vec<(F, Vector)>) -> Vec<(F, Vector)> {
        let mut added: Vec<(F, Vector)> = Vec::new();
        for (frame, vector) in parts {
            match added.iter_mut().find(|(known, _)| *known == frame) {
                Some((_, sum)) => *sum = [0, 1, 2].map(|i| self.add(sum[i], vector[i])),
                None => added.push((frame, vector)),
            }
        }
        added.retain(|(_, vector)| *vector != [self.zero(); 3]);
        added
    }

    /// x × y.
    pub(crate) fn cross(&mut self, x: [Expression; 3], y: [Expression; 3]) -> [Expression; 3] {
        Axis::ALL.map(|axis| {
            let [_, j, k] = axis.cycle();
            let ahead = self.multiply(x[j], y[k]);
            let behind = self.multiply(x[k], y[j]);
            self.subtract(ahead, behind)
        })
    }
}
