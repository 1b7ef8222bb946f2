//! Random points, and homomorphic images of expressions at them, in modular arithmetic (Gonnet, Determining
//! equivalence of expressions in random polynomial time, 1984).
//!
//! Sine, cosine, exponential and hyperbolic functions are computed from a discrete logarithm of their argument,
//! so that sin² + cos² = 1 and all addition theorems hold. Functions with several branches, √u, |u|, signum, min
//! and max, have two interpretations. *Uninterpreted*, they are arbitrary functions of the values of their
//! arguments. *By branches*, √u is either of the two roots, |u| is u or −u and signum u is 1 or −1, as drawn from
//! the seed, the same for equal arguments: √u² = u and |u|·signum u = u hold, and nothing that is true for one
//! sign only. Every other function, external ones included, is uninterpreted. What follows from values at such
//! points is said in `identity_testing.rs`.

use crate::identity::homomorphic_image::{HomomorphicImage, KnownImages};
use crate::identity::residue::{self, Field};
use crate::limits::MODULAR_ATTEMPTS;
use crate::{Binary, Expression, ExternalFunction, Node, Rational, Symbol, Unary};

/// A random point at which expressions are evaluated.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct ModularPoint {
    /// The seed of all values.
    pub seed: u64,
    /// A symbol that has another value than the seed gives it.
    pub moved: Option<Symbol>,
    /// Which of several motions this is: of points that share a seed, those of different motions differ in all symbols
    /// other than parameters.
    motion: u64,
    /// Whether they differ in the parameters, too.
    moves_parameters: bool,
    /// Whether addition theorems hold, and not only relations between functions of equal arguments.
    addition_theorems: bool,
    /// Whether functions with several branches are uninterpreted.
    uninterpreted: bool,
}

impl ModularPoint {
    /// The point drawn from `seed`.
    #[must_use]
    pub const fn new(seed: u64) -> Self {
        Self {
            seed,
            moved: None,
            motion: 0,
            moves_parameters: false,
            addition_theorems: true,
            uninterpreted: false,
        }
    }

    /// Points to try until one is in the domain.
    pub(crate) fn attempts() -> impl Iterator<Item = Self> {
        (0..MODULAR_ATTEMPTS).map(Self::new)
    }

    /// The same point with another value for `symbol`.
    #[must_use]
    pub const fn moving(self, symbol: Symbol) -> Self {
        Self {
            moved: Some(symbol),
            ..self
        }
    }

    /// The same values of the parameters in another motion.
    pub(crate) const fn in_motion(self, motion: u64) -> Self {
        Self { motion, ..self }
    }

    /// Lets the motions of this point differ in the parameters, too.
    pub(crate) const fn moving_parameters(self) -> Self {
        Self {
            moves_parameters: true,
            ..self
        }
    }

    /// The same point without addition theorems: functions of different arguments are unrelated.
    #[cfg(any(test, feature = "testing"))]
    pub(crate) const fn without_addition_theorems(self) -> Self {
        Self {
            addition_theorems: false,
            ..self
        }
    }

    /// The same point with functions of several branches uninterpreted: (√u)² = u does not hold, and every number
    /// has a square root.
    pub(crate) const fn uninterpreted(self) -> Self {
        Self {
            uninterpreted: true,
            ..self
        }
    }

    fn field(self) -> Field {
        Field::of(self.seed)
    }

    /// The prime modulus of values.
    pub(crate) fn p(self) -> u64 {
        self.field().p
    }

    fn q(self) -> u64 {
        self.field().q
    }

    /// The homomorphic image of a node, from those of its operands.
    pub(crate) fn image(self, node: &Node, images: &impl KnownImages) -> Option<HomomorphicImage> {
        let of = |operand: Expression| images.get(operand);
        // Macros run without optimization, and this runs most often: sums and products are plain loops.
        let value = match node {
            Node::Sum(terms) => {
                let sum = self.linear_combination(terms, images)?;
                if self.addition_theorems {
                    return Some(sum);
                }
                sum.value
            }
            Node::Opaque(x) => return Some(of(*x)),
            Node::Constant(number) => {
                let value = self.constant(number)?;
                if self.addition_theorems {
                    let logarithm = residue::multiply(
                        reduce(number, self.q())?,
                        self.draw(2, 0) % self.q(),
                        self.q(),
                    );
                    return Some(HomomorphicImage { value, logarithm });
                }
                value
            }
            Node::Pi => self.pi(),
            Node::Symbol(symbol) => self.symbol(*symbol),
            Node::Product(factors) => {
                let p = self.p();
                let mut product = 1;
                for (x, k) in factors {
                    let value = images.at(*x)[0];
                    let power = if k.is_one() {
                        value
                    } else {
                        self.power(value, k)?
                    };
                    product = if product == 1 {
                        power
                    } else {
                        residue::multiply(product, power, p)
                    };
                }
                product
            }
            Node::Unary(function, x) => self.unary(*function, of(*x))?,
            Node::Binary(function, x, y) => self.binary(*function, of(*x).value, of(*y).value),
            Node::Application(function, arguments) => {
                self.apply(*function, arguments.iter().map(|x| of(*x).value))
            }
        };
        Some(self.atom(value))
    }

    /// The image of a nonlinear expression: its logarithm is drawn at random, the same for equal values.
    pub(crate) fn atom(self, value: u64) -> HomomorphicImage {
        let logarithm = self.draw(3, value) % self.q();
        HomomorphicImage { value, logarithm }
    }

    /// The image of a sum.
    pub(crate) fn total(
        self,
        images: impl IntoIterator<Item = HomomorphicImage>,
    ) -> HomomorphicImage {
        let images = images.into_iter();
        images.fold(HomomorphicImage::ZERO, |sum, image| HomomorphicImage {
            value: residue::add(sum.value, image.value, self.p()),
            logarithm: residue::add(sum.logarithm, image.logarithm, self.q()),
        })
    }

    /// An expression that may have any value.
    pub(crate) fn indeterminate(self, expression: Expression) -> HomomorphicImage {
        self.atom(self.draw(69, expression.index() as u64) % self.p())
    }

    pub(crate) fn pi(self) -> u64 {
        self.draw(1, 0) % self.p()
    }

    fn draw(self, kind: u64, value: u64) -> u64 {
        residue::mix(residue::mix(self.seed, kind), value)
    }

    pub(crate) fn symbol(self, symbol: Symbol) -> u64 {
        let (kind, index) = symbol.code();
        let moved = u64::from(self.moved == Some(symbol));
        let value = self.draw(16 + kind + 8 * moved, index.into());
        let is_parameter = matches!(symbol, Symbol::Parameter(_) | Symbol::Invariant(_));
        match self.motion {
            motion @ 1.. if self.moves_parameters || !is_parameter => {
                residue::mix(value, motion) % self.p()
            }
            _ => value % self.p(),
        }
    }

    pub(crate) fn power(self, base: u64, exponent: &Rational) -> Option<u64> {
        let p = self.p();
        let power = match exponent.abs().to_fraction()? {
            (k, 1) => residue::power(base, k.unsigned_abs(), p),
            (k, 2) => {
                let integer_power = residue::power(base, k.unsigned_abs() / 2, p);
                residue::multiply(integer_power, self.root(base)?, p)
            }
            _ => self.binary(Binary::Power, base, reduce(&exponent.abs(), p)?),
        };
        if exponent.is_negative() {
            residue::reciprocal(power, p)
        } else {
            Some(power)
        }
    }

    /// A square root of `base`, if there is one: either of the two, as drawn from the seed.
    fn root(self, base: u64) -> Option<u64> {
        if self.uninterpreted {
            return Some(self.draw(65, base) % self.p());
        }
        let root = self.field().square_root(base)?;
        let lesser = root.min(residue::negate(root, self.p()));
        Some(self.signed(lesser, self.draw(66, base)))
    }

    /// `value`, or its opposite where the last bit of `draw` is set.
    fn signed(self, value: u64, draw: u64) -> u64 {
        if draw & 1 == 0 {
            value
        } else {
            residue::negate(value, self.p())
        }
    }

    /// |x|, an even function: by branches x or −x.
    fn absolute_value(self, x: u64) -> u64 {
        if self.uninterpreted {
            let lesser = x.min(residue::negate(x, self.p()));
            return self.draw(67, lesser) % self.p();
        }
        residue::multiply(x, self.sign(x), self.p())
    }

    /// signum x, an odd function: by branches 1 or −1, and 0 at 0.
    fn sign(self, x: u64) -> u64 {
        let opposite = residue::negate(x, self.p());
        let lesser = x.min(opposite);
        let draw = self.draw(68, lesser);
        let one = if self.uninterpreted {
            draw % self.p()
        } else {
            self.signed(1, draw)
        };
        match x {
            0 => 0,
            _ if x == lesser => one,
            _ => residue::negate(one, self.p()),
        }
    }

    /// The greater of two numbers, or the lesser one: ½ (x + y ± |x − y|), symmetric.
    fn extremum(self, function: Binary, x: u64, y: u64) -> u64 {
        let p = self.p();
        let distance = self.absolute_value(residue::add(x, residue::negate(y, p), p));
        let distance = match function {
            Binary::Min => residue::negate(distance, p),
            _ => distance,
        };
        let twice = residue::add(residue::add(x, y, p), distance, p);
        residue::multiply(p.div_ceil(2), twice, p)
    }

    pub(crate) fn unary(self, function: Unary, x: HomomorphicImage) -> Option<u64> {
        // Real exponentials and circular functions are unrelated homomorphisms.
        let rate = match function {
            Unary::Exp
            | Unary::Sinh
            | Unary::Cosh
            | Unary::Tanh
            | Unary::Sech
            | Unary::Logistic
            | Unary::Softplus
            | Unary::LogCosh => self.draw(4, 0) % self.q(),
            _ => 1,
        };
        let exponential = residue::power(
            self.field().generator(),
            residue::multiply(x.logarithm, rate, self.q()),
            self.p(),
        );
        let inverse = residue::reciprocal(exponential, self.p())?;
        let even = residue::add(exponential, inverse, self.p());
        let odd = residue::add(exponential, residue::negate(inverse, self.p()), self.p());
        let quotient = |numerator: u64, denominator: u64| {
            Some(residue::multiply(
                numerator,
                residue::reciprocal(denominator, self.p())?,
                self.p(),
            ))
        };
        let half = self.p().div_ceil(2);
        let unit = self.field().imaginary_unit();
        Some(match function {
            Unary::Sin => quotient(odd, residue::add(unit, unit, self.p()))?,
            Unary::Cos | Unary::Cosh => residue::multiply(even, half, self.p()),
            Unary::Sinh => residue::multiply(odd, half, self.p()),
            Unary::Tan => quotient(odd, residue::multiply(unit, even, self.p()))?,
            Unary::Tanh => quotient(odd, even)?,
            Unary::Sech => quotient(2, even)?,
            Unary::Exp => exponential,
            Unary::Logistic => quotient(exponential, residue::add(exponential, 1, self.p()))?,
            Unary::LogCosh => {
                let cosine = residue::multiply(even, half, self.p());
                self.draw(128 + Unary::Ln as u64, cosine) % self.p()
            }
            // The logarithm of what it is written as.
            Unary::Softplus => {
                let sum = residue::add(exponential, 1, self.p());
                self.draw(128 + Unary::Ln as u64, sum) % self.p()
            }
            Unary::Abs => self.absolute_value(x.value),
            Unary::Signum => self.sign(x.value),
            Unary::Asin
            | Unary::Acos
            | Unary::Atan
            | Unary::Asinh
            | Unary::Acosh
            | Unary::Atanh
            | Unary::Ln => self.draw(128 + function as u64, x.value) % self.p(),
        })
    }

    /// An external function: uninterpreted, an arbitrary function of the values of its arguments.
    pub(crate) fn apply(
        self,
        function: ExternalFunction,
        arguments: impl Iterator<Item = u64>,
    ) -> u64 {
        let kind = 256 + function.index() as u64;
        arguments.fold(self.draw(kind, 0), residue::mix) % self.p()
    }

    /// Σ cᵢ·xᵢ, value and logarithm.
    fn linear_combination(
        self,
        terms: &[(Expression, Rational)],
        images: &impl KnownImages,
    ) -> Option<HomomorphicImage> {
        let Field { p, q, .. } = self.field();
        let mut sum = HomomorphicImage::ZERO;
        for (x, c) in terms {
            let [mut value, mut logarithm] = images.at(*x);
            match c.to_fraction() {
                Some((1, 1)) => {}
                Some((-1, 1)) => {
                    value = residue::negate(value, p);
                    logarithm = residue::negate(logarithm, q);
                }
                _ => {
                    value = residue::multiply(reduce(c, p)?, value, p);
                    logarithm = residue::multiply(reduce(c, q)?, logarithm, q);
                }
            }
            sum.value = residue::add(sum.value, value, p);
            sum.logarithm = residue::add(sum.logarithm, logarithm, q);
        }
        Some(sum)
    }

    /// The residue of a rational modulo p.
    pub(crate) fn constant(self, number: &Rational) -> Option<u64> {
        reduce(number, self.p())
    }

    pub(crate) fn binary(self, function: Binary, x: u64, y: u64) -> u64 {
        match function {
            Binary::Min | Binary::Max => self.extremum(function, x, y),
            Binary::Atan2 | Binary::Power | Binary::Scale => {
                self.draw(192 + function as u64, residue::mix(x, y)) % self.p()
            }
        }
    }
}

/// The residue of a rational modulo a prime, unless the prime divides its denominator.
pub(super) fn reduce(number: &Rational, modulus: u64) -> Option<u64> {
    use num_bigint::BigInt;
    use num_traits::ToPrimitive;

    let remainder = |integer: &BigInt| {
        let modulus = BigInt::from(modulus);
        ((integer % &modulus + &modulus) % &modulus).to_u64()
    };
    let (numerator, denominator) = if let Some((numerator, denominator)) = number.to_fraction() {
        let size = numerator.unsigned_abs() % modulus;
        let numerator = if numerator < 0 {
            residue::negate(size, modulus)
        } else {
            size
        };
        (numerator, denominator.unsigned_abs() % modulus)
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
