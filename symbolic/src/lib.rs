//! Exact algebra and analytical mechanics.

mod rational;
mod symbol;
mod graph;
mod sum;
mod product;
mod call;
mod function;
mod derivative;
mod substitution;
mod evaluation;
mod residue;
mod modular;
mod model;
mod equations;
mod structure;
mod program;
mod schedule;
mod interpretation;
mod verify;

pub use derivative::Direction;
pub use equations::{Defect, Equations};
pub use function::{Binary, Symmetry, Unary};
pub use graph::{Expression, Graph, Node};
pub use model::{Energies, Model};
pub use modular::Point;
pub use program::{Instruction, Operand, Operation, OperationCount, Phase, Program};
pub use rational::Rational;
pub use structure::Structure;
pub use symbol::Symbol;
pub use verify::Fault;
