//! Exact algebra and analytical mechanics.

mod application;
mod call;
mod derivative;
mod evaluation;
mod formula;
mod function;
mod graph;
mod layout;
mod modular;
mod names;
mod notation;
mod numeral;
mod order;
mod product;
mod quotient;
mod rational;
mod residue;
mod spelling;
mod substitution;
mod sum;
mod symbol;

pub use derivative::Direction;
pub use formula::Formula;
pub use function::{Binary, Symmetry, Unary};
pub use graph::{Expression, Graph, Node};
pub use modular::Point;
pub use names::Names;
pub use rational::Rational;
pub use symbol::Symbol;
