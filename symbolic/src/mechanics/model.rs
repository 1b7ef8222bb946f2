//! A mechanical system as declared: what comes into the derivation.

use crate::mechanics::constraint::Constraint;
use crate::{DeclaredSystem, Expression, Graph, Symbol};

/// The energies and forces of a system with `coordinates` degrees of freedom.
///
/// Symbols of the graph count up to the numbers given here. Energies, dissipation and forces contain
/// no accelerations; outputs may.
#[derive(Clone, Debug)]
pub struct Model {
    /// The arena of all expressions below.
    pub graph: Graph,
    /// The number of coordinates.
    pub coordinates: u32,
    /// The number of inputs.
    pub inputs: u32,
    /// What the Lagrangian is made of.
    pub energies: Energies,
    /// The same energies in the form in which their values keep most digits; none where it is the one above, which is
    /// differentiated.
    pub evaluated: Option<Energies>,
    /// Rayleigh's function D: Q gains −∂D/∂q̇. Zero if there is none.
    pub dissipation: Expression,
    /// The declared generalized force of each coordinate.
    pub forces: Vec<Expression>,
    /// The constraints.
    pub constraints: Vec<Constraint>,
    /// Quantities for observers.
    pub outputs: Vec<Expression>,
    /// The operations by which energies and constraints were declared, from which a mechanism is read; none where nothing
    /// turns.
    pub declaration: Option<DeclaredSystem>,
}

/// The Lagrangian function, as energies or directly.
#[derive(Clone, Copy, Debug)]
pub enum Energies {
    /// L = T − V.
    Natural {
        /// The kinetic energy T.
        kinetic: Expression,
        /// The potential energy V, which may contain velocities.
        potential: Expression,
    },
    /// A general L.
    General(Expression),
}

impl Energies {
    /// T and V, or L, and their weights in L.
    pub(crate) fn weighted(self) -> (Vec<Expression>, &'static [f64]) {
        match self {
            Self::Natural { kinetic, potential } => (vec![kinetic, potential], &[1.0, -1.0]),
            Self::General(lagrangian) => (vec![lagrangian], &[1.0]),
        }
    }
}

impl Model {
    /// The symbols qᵢ.
    #[must_use]
    pub fn coordinate_symbols(&self) -> Vec<Symbol> {
        (0..self.coordinates).map(Symbol::Coordinate).collect()
    }

    /// The symbols q̇ᵢ.
    #[must_use]
    pub fn velocity_symbols(&self) -> Vec<Symbol> {
        (0..self.coordinates).map(Symbol::Velocity).collect()
    }

    /// The indices of the constraints, the holonomic ones first.
    pub(crate) fn holonomic_first(&self) -> Vec<usize> {
        let mut indices: Vec<_> = (0..self.constraints.len()).collect();
        indices.sort_by_key(|i| !self.constraints[*i].is_holonomic());
        indices
    }

    /// How many constraints are holonomic.
    pub(crate) fn holonomic(&self) -> usize {
        let constraints = self.constraints.iter();
        constraints
            .filter(|constraint| constraint.is_holonomic())
            .count()
    }

    /// The symbols of the inputs.
    #[must_use]
    pub fn input_symbols(&self) -> Vec<Symbol> {
        (0..self.inputs).map(Symbol::Input).collect()
    }
}
