//! Vectors that remember how they were turned.
//!
//! A vector may be known as a sum Σ Rᵢ vᵢ, where each Rᵢ is a product of rotations. What no rotation
//! changes can then be computed along other axes, of which the cheapest are taken: |R v|² is |v|². Only
//! rotations whatever the values of all symbols are count, no parameters that are trusted to be some:
//! other matrices are part of vᵢ.

use crate::geometry::axis::Axis;
use crate::geometry::factor::Factor;
use crate::geometry::matrix::Matrix;
use crate::{Expression, Graph, Rational};

/// A vector R v.
#[derive(Clone, Debug)]
pub(crate) struct TurnedVector {
    /// R, as the product of these rotations.
    pub(crate) rotation: Vec<Factor>,
    /// v.
    pub(crate) vector: [Expression; 3],
}

/// A sum of more vectors than this belongs to a link of a chain. It is cheaper along inertial axes, where
/// the links before it have been computed; with 6, five links on universal joints took twice the operations.
const MOST_PARTS: usize = 3;
/// So does a sum with a vector that is turned by more factors than this.
const MOST_FACTORS_IN_SUM: usize = 4;
/// Nor is a single vector remembered that is turned by more factors than this.
const MOST_FACTORS: usize = 12;

impl Graph {
    /// Σ A Rᵢ vᵢ, where A is the product of `factors`, of a vector that may remember its parts.
    pub(crate) fn parts_turned(
        &mut self,
        factors: &[Factor],
        vector: &Matrix,
    ) -> Vec<TurnedVector> {
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
            parts.push(TurnedVector { rotation, vector });
        }
        self.gathered(parts)
    }

    /// The parts of Σ cᵢ xᵢ of pairs (xᵢ, cᵢ).
    pub(crate) fn parts_of_sum(&mut self, terms: &[(&Matrix, Rational)]) -> Vec<TurnedVector> {
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
        self.gathered(parts)
    }

    /// The parts of a multiple of a vector.
    pub(crate) fn parts_scaled(
        &mut self,
        vector: &Matrix,
        factor: Expression,
    ) -> Vec<TurnedVector> {
        let mut parts = vector.known_parts().to_vec();
        for part in &mut parts {
            part.vector = part.vector.map(|x| self.multiply(factor, x));
        }
        parts
    }

    /// The parts of the time derivative: of R v it is R (ω × v + v̇), with the angular velocity ω of R
    /// along the axes that R turns.
    pub(crate) fn parts_of_derivative(
        &mut self,
        vector: &Matrix,
        coordinates: u32,
    ) -> Vec<TurnedVector> {
        let mut parts = vector.known_parts().to_vec();
        for part in &mut parts {
            let Ok(velocity) = self.composed(&part.rotation, coordinates) else {
                return Vec::new();
            };
            let turning = self.cross(velocity, part.vector);
            let rates = self.time_derivatives(&part.vector, coordinates);
            part.vector = [0, 1, 2].map(|i| self.add(turning[i], rates[i]));
        }
        self.gathered(parts)
    }

    /// The parts of x × y: R a × R b is R (a × b), for what both are turned by last.
    pub(crate) fn parts_of_cross_product(&mut self, x: &Matrix, y: &Matrix) -> Vec<TurnedVector> {
        let [first, second] = [x, y].map(parts_of);
        let rotation = common_rotation(first.iter().chain(&second));
        if rotation.is_empty() {
            return Vec::new();
        }
        let [a, b] = [first, second].map(|parts| self.along(&rotation, &parts));
        let vector = self.cross(a, b);
        vec![TurnedVector { rotation, vector }]
    }

    /// The cheapest x · y along the axes of what all parts of both are turned by last, or of one of the
    /// parts; none where parts are turned independently, of which the elements are cheaper.
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
            let a = self.along(rotation, &first);
            let b = self.along(rotation, &second);
            candidates.push(self.sum_of_products(a.into_iter().zip(b)));
        }
        candidates.into_iter().min_by_key(|x| self.cost(&[*x]))
    }

    /// The vector that parts add up to.
    pub(crate) fn sum_of_parts(&mut self, parts: &[TurnedVector]) -> [Expression; 3] {
        self.along(&[], parts)
    }

    /// Rᵀ Σ Rᵢ vᵢ: the components along the axes that R turns.
    ///
    /// What is turned by most factors is turned first, so that vectors are added before they are turned
    /// on together.
    fn along(&mut self, rotation: &[Factor], parts: &[TurnedVector]) -> [Expression; 3] {
        let back: Vec<Factor> = rotation.iter().rev().map(Factor::transpose).collect();
        let mut waiting = Vec::with_capacity(parts.len());
        for part in parts {
            let all = back.iter().chain(&part.rotation).copied();
            waiting.push(TurnedVector {
                rotation: self.merged(all),
                vector: part.vector,
            });
        }
        loop {
            waiting = self.gathered(waiting);
            let longest = waiting.iter_mut().max_by_key(|part| part.rotation.len());
            let Some(part) = longest else {
                return [self.zero(); 3];
            };
            match part.rotation.pop() {
                Some(factor) => part.vector = factor.apply(self, part.vector),
                // All are along the axes asked for, and so added up.
                None => return part.vector,
            }
        }
    }

    /// The same parts, those together that are turned alike, without zeros.
    fn gathered(&mut self, parts: Vec<TurnedVector>) -> Vec<TurnedVector> {
        let mut gathered: Vec<TurnedVector> = Vec::new();
        for part in parts {
            let known = gathered.iter_mut().find(|x| x.rotation == part.rotation);
            match known {
                Some(known) => {
                    known.vector = [0, 1, 2].map(|i| self.add(known.vector[i], part.vector[i]));
                }
                None => gathered.push(part),
            }
        }
        gathered.retain(|part| part.vector != [self.zero(); 3]);
        gathered
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
    /// The same vector, which remembers its parts unless they are many or nothing is turned.
    pub(crate) fn made_of(self, parts: Vec<TurnedVector>) -> Self {
        let most_factors = if parts.len() > 1 {
            MOST_FACTORS_IN_SUM
        } else {
            MOST_FACTORS
        };
        let is_short = parts.len() <= MOST_PARTS
            && parts.iter().all(|part| part.rotation.len() <= most_factors);
        let is_turned = parts.iter().any(|part| !part.rotation.is_empty());
        if is_short && is_turned {
            self.with_parts(parts)
        } else {
            self
        }
    }
}

/// The parts of a vector of three components: those that it remembers, or itself.
fn parts_of(vector: &Matrix) -> Vec<TurnedVector> {
    if !vector.known_parts().is_empty() {
        return vector.known_parts().to_vec();
    }
    let itself = vector.components().map(|vector| TurnedVector {
        rotation: Vec::new(),
        vector,
    });
    itself.into_iter().collect()
}

/// The factors with which the rotations of all parts begin.
fn common_rotation<'a>(parts: impl Iterator<Item = &'a TurnedVector>) -> Vec<Factor> {
    let mut rotations = parts.map(|part| part.rotation.as_slice());
    let first = rotations.next().unwrap_or_default();
    let length = rotations.fold(first.len(), |length, other| {
        let pairs = first[..length].iter().zip(other);
        pairs.take_while(|(x, y)| x == y).count()
    });
    first[..length].to_vec()
}
