//! Vectors that are known in frames.
//!
//! A vector may be known as a sum Σ Rᵢ vᵢ, where each Rᵢ is a product of rotations. What is invariant under
//! rotations can then be resolved in any of these frames, of which the cheapest is taken: |R v|² is |v|². Only
//! matrices that are rotations for all values of their symbols count, no parameters that are trusted to be
//! rotations: other matrices are part of vᵢ.

use crate::frames::axis::Axis;
use crate::frames::factor::MatrixFactor;
use crate::frames::frame_tree::Frame;
use crate::frames::matrix::{Matrix, Part, Structure};
use crate::limits::{MAX_FACTORS, MAX_FACTORS_IN_SUM, MAX_FRAMES_IN_SUM};
use crate::{Expression, Geometry, Graph};

type Vector = [Expression; 3];

impl Geometry {
    /// The vector with the structure of a sum of these parts, unless they are many or none is rotated.
    pub(crate) fn with_parts(&self, vector: Matrix, parts: Vec<Part>) -> Matrix {
        let most_factors = if parts.len() > 1 {
            MAX_FACTORS_IN_SUM
        } else {
            MAX_FACTORS
        };
        let is_short = parts.len() <= MAX_FRAMES_IN_SUM
            && parts
                .iter()
                .all(|(frame, _)| self.frames.depth(*frame) <= most_factors);
        let is_rotated = parts.iter().any(|(frame, _)| *frame != Frame::INERTIAL);
        if vector.components().is_some() && is_short && is_rotated {
            return vector.with_structure(Structure::Sum(parts));
        }
        vector
    }

    /// Σ A Rᵢ vᵢ, where A is the product of `factors`, of a vector that may be known in frames.
    pub(crate) fn rotated_parts(&mut self, factors: &[MatrixFactor], vector: &Matrix) -> Vec<Part> {
        // Where vectors are resolved last, only they make frames.
        if self.unresolved.is_some() {
            return Vec::new();
        }
        let mut parts = Vec::new();
        for (frame, vector) in parts_of(vector) {
            let own = self.frames.factors(frame);
            let mut rotation = self.merged(factors.iter().copied().chain(own));
            let count = rotation.iter().take_while(|factor| factor.is_rotation());
            let others = rotation.split_off(count.count());
            let vector = self.graph.turned_by(&others, vector);
            parts.push((self.frames.frame(&rotation), vector));
        }
        self.graph.added_by_frame(parts)
    }

    /// The parts of Σ fᵢ xᵢ of pairs (xᵢ, fᵢ).
    fn parts_of_sum(&mut self, terms: &[(&Matrix, Expression)]) -> Vec<Part> {
        if terms.iter().all(|(x, _)| x.parts().is_empty()) {
            return Vec::new();
        }
        let mut parts = Vec::new();
        for (x, factor) in terms {
            for (frame, vector) in parts_of(x) {
                parts.push((frame, vector.map(|x| self.graph.multiply(*factor, x))));
            }
        }
        self.graph.added_by_frame(parts)
    }

    /// The sum Σ fᵢ xᵢ with these elements, where it is resolved last or known in frames as its terms are.
    pub(crate) fn sum_with(
        &mut self,
        terms: &[(&Matrix, Expression)],
        elements: impl FnOnce(&mut Graph) -> Matrix,
    ) -> Matrix {
        let unresolved = self.unresolved_sum(terms);
        if let Some(sum) = unresolved.or_else(|| self.homogeneous_sum(terms)) {
            return sum;
        }
        let sum = elements(&mut self.graph);
        let parts = self.parts_of_sum(terms);
        self.with_parts(sum, parts)
    }

    /// The parts of the time derivative: of R v it is R (ω × v + v̇), with the angular velocity ω of R
    /// in the frame of R.
    pub(crate) fn parts_of_derivative(&mut self, vector: &Matrix, coordinates: u32) -> Vec<Part> {
        let mut parts = vector.parts().to_vec();
        for (frame, vector) in &mut parts {
            let factors = self.frames.factors(*frame);
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
        let [first, second] = [x, y].map(parts_of);
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
        let [first, second] = [x, y].map(parts_of);
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
    pub(crate) fn resolve_in(&mut self, frame: Frame, parts: &[Part]) -> Vector {
        let rotation = self.frames.factors(frame);
        let back: Vec<MatrixFactor> = rotation.iter().rev().map(MatrixFactor::transpose).collect();
        let mut waiting = Vec::with_capacity(parts.len());
        for (frame, vector) in parts {
            let own = self.frames.factors(*frame);
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
        self.frames.last_in_common(frames)
    }
}

/// The parts of a vector of three components: the known ones, or itself.
fn parts_of(vector: &Matrix) -> Vec<Part> {
    match (vector.parts(), vector.components()) {
        ([], Some(components)) => vec![(Frame::INERTIAL, components)],
        (parts, _) => parts.to_vec(),
    }
}

impl Graph {
    /// Adds up the vectors of each frame, and leaves zeros out.
    pub(crate) fn added_by_frame<F: PartialEq>(
        &mut self,
        parts: Vec<(F, Vector)>,
    ) -> Vec<(F, Vector)> {
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
