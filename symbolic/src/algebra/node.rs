//! The nodes of the expression graph, and the handles to them.

use core::hash::{Hash, Hasher};

use crate::algebra::hashing::mix;
use crate::{Binary, ExternalFunction, Rational, Symbol, Unary};

/// A handle to an expression of one [`Graph`](crate::Graph).
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Debug)]
pub struct Expression(pub(super) u32);

impl Expression {
    /// The position in the arena: children have lower ones than their parents.
    #[must_use]
    pub const fn index(self) -> usize {
        self.0 as usize
    }
}

/// An expression, one level deep.
#[derive(Clone, PartialEq, Eq, Debug)]
pub enum Node {
    /// An exact number.
    Constant(Rational),
    /// The number π.
    Pi,
    /// A coordinate, velocity, parameter …
    Symbol(Symbol),
    /// Σ cᵢ·xᵢ, as pairs (xᵢ, cᵢ).
    Sum(Box<[(Expression, Rational)]>),
    /// Π xᵢ^kᵢ, as pairs (xᵢ, kᵢ).
    Product(Box<[(Expression, Rational)]>),
    /// A function of one argument.
    Unary(Unary, Expression),
    /// A function of two arguments.
    Binary(Binary, Expression, Expression),
    /// An external function, of as many arguments as it was declared with.
    Application(ExternalFunction, Box<[Expression]>),
    /// An opaque expression: the sums and products that contain it do not merge with it.
    Opaque(Expression),
}

impl Node {
    /// Calls `visit` with each operand.
    pub fn for_each_operand(&self, mut visit: impl FnMut(Expression)) {
        match self {
            Self::Constant(_) | Self::Pi | Self::Symbol(_) => {}
            Self::Sum(parts) | Self::Product(parts) => {
                for (operand, _) in parts {
                    visit(*operand);
                }
            }
            Self::Unary(_, x) | Self::Opaque(x) => visit(*x),
            Self::Binary(_, x, y) => {
                visit(*x);
                visit(*y);
            }
            Self::Application(_, arguments) => arguments.iter().for_each(|x| visit(*x)),
        }
    }
}

// Every construction of an expression hashes a node, so this is one loop and one call of the hasher.
impl Hash for Node {
    fn hash<H: Hasher>(&self, state: &mut H) {
        let code = match self {
            Self::Constant(value) => value.code(),
            Self::Pi => 1,
            Self::Symbol(symbol) => return symbol.hash(state),
            Self::Sum(parts) => code(2, parts),
            Self::Product(parts) => code(3, parts),
            Self::Unary(function, x) => mix(mix(4, *function as u64), u64::from(x.0)),
            Self::Binary(function, x, y) => {
                let operands = u64::from(x.0) << 32 | u64::from(y.0);
                mix(mix(5, *function as u64), operands)
            }
            Self::Application(function, arguments) => arguments
                .iter()
                .fold(mix(7, function.index() as u64), |code, x| {
                    mix(code, u64::from(x.0))
                }),
            Self::Opaque(x) => mix(6, u64::from(x.0)),
        };
        state.write_u64(code);
    }
}

/// A word that depends on all pairs.
fn code(kind: u64, parts: &[(Expression, Rational)]) -> u64 {
    let mut code = kind;
    for (x, number) in parts {
        code = mix(mix(code, u64::from(x.0)), number.code());
    }
    code
}
