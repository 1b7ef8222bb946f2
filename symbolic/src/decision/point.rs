//! Exact decisions about identities, at random points in modular arithmetic.
//!
//! An expression that vanishes identically vanishes at every point. One that does not is zero at a
//! random point modulo a prime of sixty bits with a probability of about its degree over 10¹⁸. Sine,
//! cosine, exponential and hyperbolic functions are the homomorphisms that they are, so that
//! sin² + cos² = 1 and all addition theorems hold; square roots and absolute values square to what
//! they should. Every other function is an arbitrary function of the value of its argument.

use crate::decision::residue::{self, GENERATOR, I, P, Q};
use crate::{Binary, Expression, Graph, Node, Rational, Symbol, Unary};

/// A random point at which expressions are evaluated.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// What all values are drawn from.
    pub seed: u64,
    /// A symbol that has another value than the seed gives it.
    pub moved: Option<Symbol>,
    /// Whether addition theorems hold, and not only relations between functions of equal arguments.
    addition_theorems: bool,
}

/// The image of a number: modulo p, and its logarithm modulo q as far as phases go.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Image {
    pub(crate) value: u64,
    /// ℓ(x), additive and linear over the rationals: e^{ix} is the generator's ℓ-th power.
    phase: u64,
}

impl Point {
    /// The point drawn from `seed`.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self {
            seed,
            moved: None,
            addition_theorems: true,
        }
    }

    /// The same point with another value for `symbol`.
    #[must_use]
    pub const fn moving(self, symbol: Symbol) -> Self {
        Self {
            moved: Some(symbol),
            ..self
        }
    }

    /// The same point, where functions of different arguments have nothing to do with each other.
    pub(crate) const fn without_addition_theorems(self) -> Self {
        Self {
            addition_theorems: false,
            ..self
        }
    }

    /// The values of the roots modulo p, or `None` where one has no value at this point.
    #[must_use]
    pub fn evaluate(self, graph: &Graph, roots: &[Expression]) -> Option<Vec<u64>> {
        let descendants = graph.descendants(roots);
        let length = descendants.last().map_or(0, |last| last.index() + 1);
        let mut images = vec![Image { value: 0, phase: 0 }; length];
        for expression in descendants {
            images[expression.index()] = self.image(graph.node(expression), &images)?;
        }
        Some(
            roots
                .iter()
                .map(|root| images[root.index()].value)
                .collect(),
        )
    }

    fn image(self, node: &Node, images: &[Image]) -> Option<Image> {
        let of = |operand: Expression| images[operand.index()];
        let value = match node {
            Node::Sum(terms) => {
                let sum = linear_combination(terms, of)?;
                if self.addition_theorems {
                    return Some(sum);
                }
                sum.value
            }
            Node::Constant(number) => {
                let value = constant(number)?;
                if self.addition_theorems {
                    let phase = residue::multiply(reduce(number, Q)?, self.draw(2, 0) % Q, Q);
                    return Some(Image { value, phase });
                }
                value
            }
            Node::Pi => self.pi(),
            Node::Symbol(symbol) => self.symbol(*symbol),
            Node::Product(factors) => {
                let mut product = 1;
                for (x, k) in factors {
                    product = residue::multiply(product, self.power(of(*x).value, k)?, P);
                }
                product
            }
            Node::Unary(function, x) => self.unary(*function, of(*x))?,
            Node::Binary(function, x, y) => self.binary(*function, of(*x).value, of(*y).value),
        };
        Some(self.atom(value))
    }

    /// What is not linear has a phase of its own, the same for equal values.
    pub(crate) fn atom(self, value: u64) -> Image {
        let phase = self.draw(3, value) % Q;
        Image { value, phase }
    }

    pub(crate) fn pi(self) -> u64 {
        self.draw(1, 0) % P
    }

    fn draw(self, kind: u64, value: u64) -> u64 {
        residue::mix(residue::mix(self.seed, kind), value)
    }

    pub(crate) fn symbol(self, symbol: Symbol) -> u64 {
        let (kind, index) = match symbol {
            Symbol::Time => (0, 0),
            Symbol::Coordinate(index) => (1, index),
            Symbol::Velocity(index) => (2, index),
            Symbol::Acceleration(index) => (3, index),
            Symbol::Parameter(index) => (4, index),
            Symbol::Input(index) => (5, index),
        };
        let moved = u64::from(self.moved == Some(symbol));
        self.draw(16 + kind + 8 * moved, index.into()) % P
    }

    pub(crate) fn power(self, base: u64, exponent: &Rational) -> Option<u64> {
        if let Some(k) = exponent.to_integer() {
            return integer_power(base, k);
        }
        let (numerator, denominator) = exponent.to_fraction()?;
        if denominator == 2 {
            return integer_power(residue::square_root(base)?, numerator);
        }
        let power = self.binary(Binary::Power, base, reduce(&exponent.abs(), P)?);
        if exponent.is_negative() {
            residue::reciprocal(power, P)
        } else {
            Some(power)
        }
    }

    pub(crate) fn unary(self, function: Unary, x: Image) -> Option<u64> {
        // Real exponentials and phases are unrelated homomorphisms.
        let rate = match function {
            Unary::Exp | Unary::Sinh | Unary::Cosh | Unary::Tanh => self.draw(4, 0) % Q,
            _ => 1,
        };
        let phase = residue::power(GENERATOR, residue::multiply(x.phase, rate, Q), P);
        let inverse = residue::reciprocal(phase, P)?;
        let even = residue::add(phase, inverse, P);
        let odd = residue::add(phase, residue::negate(inverse, P), P);
        let quotient = |numerator: u64, denominator: u64| {
            Some(residue::multiply(
                numerator,
                residue::reciprocal(denominator, P)?,
                P,
            ))
        };
        let half = P.div_ceil(2);
        Some(match function {
            Unary::Sin => quotient(odd, residue::add(I, I, P))?,
            Unary::Cos | Unary::Cosh => residue::multiply(even, half, P),
            Unary::Sinh => residue::multiply(odd, half, P),
            Unary::Tan => quotient(odd, residue::multiply(I, even, P))?,
            Unary::Tanh => quotient(odd, even)?,
            Unary::Exp => phase,
            Unary::Abs => residue::multiply(x.value, residue::legendre(x.value), P),
            Unary::Signum => residue::legendre(x.value),
            Unary::Asin
            | Unary::Acos
            | Unary::Atan
            | Unary::Asinh
            | Unary::Acosh
            | Unary::Atanh
            | Unary::Ln => self.draw(128 + function as u64, x.value) % P,
        })
    }

    pub(crate) fn binary(self, function: Binary, x: u64, y: u64) -> u64 {
        let difference = residue::add(x, residue::negate(y, P), P);
        let distance = residue::multiply(difference, residue::legendre(difference), P);
        let sum = residue::add(x, y, P);
        let half = P.div_ceil(2);
        match function {
            Binary::Max => residue::multiply(half, residue::add(sum, distance, P), P),
            Binary::Min => {
                let twice = residue::add(sum, residue::negate(distance, P), P);
                residue::multiply(half, twice, P)
            }
            Binary::Atan2 | Binary::Power => {
                self.draw(192 + function as u64, residue::mix(x, y)) % P
            }
        }
    }
}

/// Σ cᵢ·xᵢ, in value and in phase.
fn linear_combination(
    terms: &[(Expression, Rational)],
    of: impl Fn(Expression) -> Image,
) -> Option<Image> {
    let mut sum = Image { value: 0, phase: 0 };
    for (x, c) in terms {
        let value = residue::multiply(reduce(c, P)?, of(*x).value, P);
        let phase = residue::multiply(reduce(c, Q)?, of(*x).phase, Q);
        sum.value = residue::add(sum.value, value, P);
        sum.phase = residue::add(sum.phase, phase, Q);
    }
    Some(sum)
}

/// The image of a rational modulo p.
pub(crate) fn constant(number: &Rational) -> Option<u64> {
    reduce(number, P)
}

/// The image of a rational modulo a prime, unless the prime divides its denominator.
fn reduce(number: &Rational, modulus: u64) -> Option<u64> {
    use num_bigint::BigInt;
    use num_traits::ToPrimitive;

    let remainder = |integer: &BigInt| {
        let modulus = BigInt::from(modulus);
        ((integer % &modulus + &modulus) % &modulus).to_u64()
    };
    let (numerator, denominator) = if let Some((numerator, denominator)) = number.to_fraction() {
        let numerator = i128::from(numerator).rem_euclid(i128::from(modulus));
        (
            u64::try_from(numerator).ok()?,
            denominator.unsigned_abs() % modulus,
        )
    } else {
        let number = number.to_big();
        (remainder(number.numer())?, remainder(number.denom())?)
    };
    if denominator == 1 {
        return Some(numerator);
    }
    Some(residue::multiply(
        numerator,
        residue::reciprocal(denominator, modulus)?,
        modulus,
    ))
}

fn integer_power(base: u64, exponent: i64) -> Option<u64> {
    let power = residue::power(base, exponent.unsigned_abs(), P);
    if exponent < 0 {
        residue::reciprocal(power, P)
    } else {
        Some(power)
    }
}
