//! Exact algebra and analytical mechanics.

mod call;
mod derivative;
mod evaluation;
mod function;
mod graph;
mod modular;
mod product;
mod rational;
mod residue;
mod substitution;
mod sum;
mod symbol;

pub use derivative::Direction;
pub use function::{Binary, Symmetry, Unary};
pub use graph::{Expression, Graph, Node};
pub use modular::Point;
pub use rational::Rational;
pub use symbol::Symbol;
