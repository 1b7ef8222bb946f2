//! Exact algebra and analytical mechanics: expressions on a shared graph, Lagrange's equations, and
//! straight-line programs that evaluate them.
//!
//! This is what `lagrangian`'s derive macro is made of, as a library: it knows neither tokens nor time
//! steps.

// A module imports only from those before it (`.ci/imports`).
mod limits;
mod passes;
mod algebra;
mod identity;
mod matrix;
mod frames;
mod typed;
mod program;
mod mechanics;
mod validation;
mod print;

pub use algebra::contents::Contents;
pub use algebra::derivative_memory::Direction;
pub use algebra::external_function::ExternalFunction;
pub use algebra::function::{Binary, Symmetry, Unary};
pub use algebra::graph::Graph;
pub use algebra::node::{Expression, Node};
pub use algebra::rational::Rational;
pub use algebra::symbol::Symbol;
pub use frames::axis::Axis;
pub use frames::geometry::Geometry;
pub use frames::inverse::NoInverse;
pub use frames::matrix::Matrix;
pub use frames::rotation::NoRotation;
pub use identity::modular_point::ModularPoint;
pub use limits::{MAX_ARRAY, MAX_DETERMINANT, MAX_DIAGONAL_ROWS};
pub use matrix::ldlt::Ldlt;
pub use mechanics::conservation::Conservation;
pub use mechanics::constraint::Constraint;
pub use mechanics::constraints::{ConstraintDefect, ConstraintEquations};
pub use mechanics::coordinate_properties::CoordinateProperties;
pub use mechanics::defects::Defect;
pub use mechanics::energy_functions::EnergyFunctions;
pub use mechanics::equations::Equations;
pub use mechanics::kinetics::Kinetics;
pub use mechanics::linear_system::LinearSystem;
pub use mechanics::model::{Energies, Model};
pub use mechanics::regressor::{NoRegressor, Regressor, UnknownParameters};
pub use mechanics::routhian::{NoReduction, Obstacle, PoleForm, Reduction, Spoiler};
pub use mechanics::solvers::first_order_equations::FirstOrderEquations;
pub use mechanics::solvers::form::SolvedForm;
pub use mechanics::solvers::implicit_equations::ImplicitEquations;
pub use mechanics::solvers::pivots::Pivot;
pub use mechanics::solvers::quasi_velocity_equations::QuasiVelocityEquations;
pub use mechanics::solvers::solution::Solution;
pub use passes::{Pass, Passes, UnknownPass};
pub use print::formula::Formula;
pub use print::index::{Index, Range};
pub use print::listing::as_declared::{AsDeclared, DeclaredLine};
pub use print::listing::{Declared, Listing};
pub use print::names::{Letters, Names};
pub use print::printed::Printed;
pub use program::liveness::LiveValues;
pub use program::operation_count::OperationCount;
pub use program::staging::Staged;
pub use program::straight_line::{Instruction, Operand, Operation, OutputGroup, Program};
pub use program::taylor::{Convolution, NoSeries, SeriesOutputs, TaylorProgram};
pub use typed::array_function::{ARRAY_FUNCTIONS, ArrayFunction, ArrayNotation};
pub use typed::at_rest::AtRest;
pub use typed::components::{Components, NoValue};
pub use typed::declared_system::DeclaredSystem;
pub use typed::graph::TypedGraph;
pub use typed::operation::{TypedOperation, Value};
pub use typed::virtual_work::ConstraintForces;
pub use validation::{
    ConstraintTapes, Method, ReductionCheck, SeriesCheck, SolutionTape, Tape, Tapes, Validator,
    ValueSeriesCheck,
};

/// No part of the interface.
#[doc(hidden)]
#[cfg(any(test, feature = "testing"))]
pub mod testing;
