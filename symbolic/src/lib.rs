//! Exact algebra and analytical mechanics: expressions on a shared graph, Lagrange's equations, and
//! straight-line programs that evaluate them.
//!
//! This is what `lagrangian`'s derive macro is made of, as a library: it knows neither tokens nor time
//! steps.

mod passes;
mod algebra;
mod decision;
mod geometry;
mod mechanics;
mod program;
mod validation;
mod print;

pub use algebra::contents::Contents;
pub use algebra::derivative::Direction;
pub use algebra::function::{Binary, Symmetry, Unary};
pub use algebra::graph::{Expression, Graph, Node};
pub use algebra::outside::Function;
pub use algebra::rational::Rational;
pub use algebra::symbol::Symbol;
pub use decision::point::Point;
pub use geometry::axis::Axis;
pub use geometry::determinant::{LARGEST_DETERMINANT, NoInverse};
pub use geometry::matrix::Matrix;
pub use geometry::rotation::NoRotation;
pub use mechanics::elimination::Elimination;
pub use mechanics::equations::{Defect, Equations};
pub use mechanics::kinetics::{Kinetics, LinearSystem};
pub use mechanics::model::{Energies, Model};
pub use mechanics::solution::Solution;
pub use mechanics::structure::Structure;
pub use passes::{Pass, Passes, UnknownPass};
pub use print::formula::Formula;
pub use print::names::{Letters, Names};
pub use program::preparation::Prepared;
pub use program::straight_line::{Instruction, Operand, Operation, OperationCount, Phase, Program};
pub use program::verify::Fault;
pub use validation::{AccelerationProgram, LinearizationProgram, Method, Programs, Validator};

/// No part of the interface.
#[doc(hidden)]
#[cfg(any(test, feature = "testing"))]
pub mod testing;
