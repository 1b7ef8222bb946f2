//! Vectors that remember the frames in which they are known.
//!
//! A vector may be known as a sum Σ Rᵢ vᵢ, where each Rᵢ is a product of rotations. What is invariant under
//! rotations can then be resolved in any of these frames, of which the cheapest is taken: |R v|² is |v|². Only
//! matrices that are rotations for all values of their symbols count, no parameters that are trusted to be
//! rotations: other matrices are part of vᵢ.

use crate::limits::{MOST_FACTORS, MOST_FACTORS_IN_SUM, MOST_FRAMES_IN_SUM};
use crate::matrix::axis::Axis;
use crate::matrix::dense::Matrix;
use crate::matrix::factor::MatrixFactor;
use crate::matrix::vector_in_frame::VectorInFrame;
use crate::{Expression, Graph, Rational};

impl Graph {
    /// Σ A Rᵢ vᵢ, where A is the product of `factors`, of a vector that may remember its parts.
    pub(crate) fn rotated_parts(
        &mut self,
        factors: &[MatrixFactor],
        vector: &Matrix,
    ) -> Vec<VectorInFrame> {
        let mut parts = Vec::new();
        for part in parts_of(vector) {
            let all = factors.iter().chain(&part.rotation).copied();
            let mut rotation = self.merged(all);
            let count = rotation.iter().take_while(|factor| factor.is_rotation());
            let others = rotation.split_off(count.count());
            let vector = others
                .into_iter()
                .rev()
                .fold(part.vector, |vector, factor| factor.apply(self, vector));
            parts.push(VectorInFrame { rotation, vector });
        }
        self.added_by_frame(parts)
    }

    /// The parts of Σ cᵢ xᵢ of pairs (xᵢ, cᵢ).
    pub(crate) fn parts_of_sum(&mut self, terms: &[(&Matrix, Rational)]) -> Vec<VectorInFrame> {
        if terms.iter().all(|(x, _)| x.known_parts().is_empty()) {
            return Vec::new();
        }
        let mut parts = Vec::new();
        for (x, c) in terms {
            for mut part in parts_of(x) {
                part.vector = part.vector.map(|x| self.scale(x, c));
                parts.push(part);
            }
        }
        self.added_by_frame(parts)
    }

    /// The parts of a multiple of a vector.
    pub(crate) fn parts_scaled(
        &mut self,
        vector: &Matrix,
        factor: Expression,
    ) -> Vec<VectorInFrame> {
        let mut parts = vector.known_parts().to_vec();
        for part in &mut parts {
            part.vector = part.vector.map(|x| self.multiply(factor, x));
        }
        parts
    }

    /// The parts of the time derivative: of R v it is R (ω × v + v̇), with the angular velocity ω of R
    /// in the frame of R.
    pub(crate) fn parts_of_derivative(
        &mut self,
        vector: &Matrix,
        coordinates: u32,
    ) -> Vec<VectorInFrame> {
        let mut parts = vector.known_parts().to_vec();
        for part in &mut parts {
            let Ok(velocity) = self.angular_velocity_of_product(&part.rotation, coordinates) else {
                return Vec::new();
            };
            let transport = self.cross(velocity, part.vector);
            let rates = self.time_derivatives(&part.vector, coordinates);
            part.vector = [0, 1, 2].map(|i| self.add(transport[i], rates[i]));
        }
        self.added_by_frame(parts)
    }

    /// The parts of x × y: R a × R b is R (a × b), for the rotation R that both begin with.
    pub(crate) fn parts_of_cross_product(&mut self, x: &Matrix, y: &Matrix) -> Vec<VectorInFrame> {
        let [first, second] = [x, y].map(parts_of);
        let rotation = common_rotation(first.iter().chain(&second));
        if rotation.is_empty() {
            return Vec::new();
        }
        let [a, b] = [first, second].map(|parts| self.resolve_in(&rotation, &parts));
        let vector = self.cross(a, b);
        vec![VectorInFrame { rotation, vector }]
    }

    /// The cheapest x · y in the frame that all parts of both have in common, or in that of one of the parts;
    /// none where the frames are independent, for which the elements are cheaper.
    pub(crate) fn dot_product_of_parts(&mut self, x: &Matrix, y: &Matrix) -> Option<Expression> {
        let [first, second] = [x, y].map(parts_of);
        let common = common_rotation(first.iter().chain(&second));
        if common.is_empty() {
            return None;
        }
        let mut frames = vec![common];
        for part in first.iter().chain(&second) {
            if !frames.contains(&part.rotation) {
                frames.push(part.rotation.clone());
            }
        }
        let mut candidates = Vec::new();
        for rotation in &frames {
            let a = self.resolve_in(rotation, &first);
            let b = self.resolve_in(rotation, &second);
            candidates.push(self.sum_of_products(a.into_iter().zip(b)));
        }
        candidates.into_iter().min_by_key(|x| self.cost(&[*x]))
    }

    /// The vector that parts add up to.
    pub(crate) fn sum_of_parts(&mut self, parts: &[VectorInFrame]) -> [Expression; 3] {
        self.resolve_in(&[], parts)
    }

    /// Rᵀ Σ Rᵢ vᵢ: the components in the frame of R.
    ///
    /// The vector with most factors is rotated first, so that vectors are added before they are rotated further
    /// together.
    fn resolve_in(
        &mut self,
        rotation: &[MatrixFactor],
        parts: &[VectorInFrame],
    ) -> [Expression; 3] {
        let back: Vec<MatrixFactor> = rotation.iter().rev().map(MatrixFactor::transpose).collect();
        let mut waiting = Vec::with_capacity(parts.len());
        for part in parts {
            let all = back.iter().chain(&part.rotation).copied();
            waiting.push(VectorInFrame {
                rotation: self.merged(all),
                vector: part.vector,
            });
        }
        loop {
            waiting = self.added_by_frame(waiting);
            let longest = waiting.iter_mut().max_by_key(|part| part.rotation.len());
            let Some(part) = longest else {
                return [self.zero(); 3];
            };
            match part.rotation.pop() {
                Some(factor) => part.vector = factor.apply(self, part.vector),
                // All are in the frame asked for, and so added up.
                None => return part.vector,
            }
        }
    }

    /// The same parts, those of one frame added up, without zeros.
    fn added_by_frame(&mut self, parts: Vec<VectorInFrame>) -> Vec<VectorInFrame> {
        let mut added: Vec<VectorInFrame> = Vec::new();
        for part in parts {
            let known = added.iter_mut().find(|x| x.rotation == part.rotation);
            match known {
                Some(known) => {
                    known.vector = [0, 1, 2].map(|i| self.add(known.vector[i], part.vector[i]));
                }
                None => added.push(part),
            }
        }
        added.retain(|part| part.vector != [self.zero(); 3]);
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

impl Matrix {
    /// The same vector, which remembers its parts unless they are many or none is rotated.
    pub(crate) fn remembering_parts(self, parts: Vec<VectorInFrame>) -> Self {
        let most_factors = if parts.len() > 1 {
            MOST_FACTORS_IN_SUM
        } else {
            MOST_FACTORS
        };
        let is_short = parts.len() <= MOST_FRAMES_IN_SUM
            && parts.iter().all(|part| part.rotation.len() <= most_factors);
        let is_rotated = parts.iter().any(|part| !part.rotation.is_empty());
        if is_short && is_rotated {
            self.with_parts(parts)
        } else {
            self
        }
    }
}

/// The parts of a vector of three components: the remembered ones, or itself.
fn parts_of(vector: &Matrix) -> Vec<VectorInFrame> {
    if !vector.known_parts().is_empty() {
        return vector.known_parts().to_vec();
    }
    let itself = vector.components().map(|vector| VectorInFrame {
        rotation: Vec::new(),
        vector,
    });
    itself.into_iter().collect()
}

/// The factors with which the rotations of all parts begin.
fn common_rotation<'a>(parts: impl Iterator<Item = &'a VectorInFrame>) -> Vec<MatrixFactor> {
    let mut rotations = parts.map(|part| part.rotation.as_slice());
    let first = rotations.next().unwrap_or_default();
    let length = rotations.fold(first.len(), |length, other| {
        let pairs = first[..length].iter().zip(other);
        pairs.take_while(|(x, y)| x == y).count()
    });
    first[..length].to_vec()
}
