//! Images of expressions under a homomorphism into modular arithmetic: what is computed of them at a random point.

use crate::Expression;
use crate::algebra::hashing::Table;

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
pub(crate) trait KnownImages {
    /// Value and logarithm of an expression that is known.
    fn at(&self, expression: Expression) -> [u64; 2];

    /// The image of an expression that is known.
    fn get(&self, expression: Expression) -> HomomorphicImage {
        let [value, logarithm] = self.at(expression);
        HomomorphicImage { value, logarithm }
    }
}

/// The images of many expressions, by position.
pub(crate) struct Images(Vec<[u64; 2]>);

impl Images {
    /// Zeros, for the expressions of the first so many positions.
    pub(crate) fn zeros(length: usize) -> Self {
        Self(vec![[0; 2]; length])
    }

    pub(crate) fn set(&mut self, expression: Expression, image: HomomorphicImage) {
        self.0[expression.index()] = [image.value, image.logarithm];
    }
}

impl KnownImages for Images {
    fn at(&self, expression: Expression) -> [u64; 2] {
        self.0[expression.index()]
    }
}

/// The images of a few expressions, wherever in a large graph they are.
#[derive(Default)]
pub(crate) struct FewImages(Table<Expression, [u64; 2]>);

impl FewImages {
    pub(crate) fn set(&mut self, expression: Expression, image: HomomorphicImage) {
        self.0.insert(expression, [image.value, image.logarithm]);
    }
}

impl KnownImages for FewImages {
    fn at(&self, expression: Expression) -> [u64; 2] {
        self.0.get(&expression).copied().unwrap_or_default()
    }
}
