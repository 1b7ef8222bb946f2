//! Images of expressions under a homomorphism into modular arithmetic: what is computed of them at a random point.

use crate::Expression;

/// The homomorphic image of a number: its value modulo p, and modulo q the discrete logarithm that stands for
/// its exponential.
#[derive(Clone, Copy, Debug)]
pub(crate) struct HomomorphicImage {
    pub(crate) value: u64,
    /// ℓ(x), additive and linear over the rationals: e^{ix} is the generator to the power ℓ.
    pub(super) logarithm: u64,
}

impl HomomorphicImage {
    pub(crate) const ZERO: Self = Self {
        value: 0,
        logarithm: 0,
    };
}

/// The images of expressions of one graph.
pub(crate) struct Images(pub(super) Vec<[u64; 2]>);

impl Images {
    /// Zeros, for the expressions of the first so many positions.
    pub(crate) fn zeros(length: usize) -> Self {
        Self(vec![[0; 2]; length])
    }

    pub(crate) fn get(&self, expression: Expression) -> HomomorphicImage {
        let [value, logarithm] = self.0[expression.index()];
        HomomorphicImage { value, logarithm }
    }

    pub(crate) fn set(&mut self, expression: Expression, image: HomomorphicImage) {
        self.0[expression.index()] = [image.value, image.logarithm];
    }
}
