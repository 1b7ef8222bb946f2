//! The typed graph of a declaration.

use crate::typed::components::{Components, NoValue};
use crate::typed::operation::{TypedOperation, Value};
use crate::{Expression, Geometry, Graph, Rational};

/// An arena of scalars, vectors and matrices, each with the [operation](TypedOperation) by which it is declared and its
/// [components](Components) as expressions of coordinates and velocities.
///
/// Values are evaluated as they are added, in the order in which they are added.
#[derive(Clone, Debug)]
pub struct TypedGraph {
    /// The arena of the components.
    pub geometry: Geometry,
    pub(crate) coordinates: u32,
    pub(crate) operations: Vec<TypedOperation>,
    pub(crate) components: Vec<Option<Components>>,
    /// What is there before the first value that depends on others.
    pub(crate) beginning: Beginning,
}

/// The symbols and functions of a declaration, before its definitions: where every evaluation begins.
#[derive(Clone, Debug, Default)]
pub(crate) struct Beginning {
    pub(crate) graph: Graph,
    /// The components of the first values.
    pub(crate) components: Vec<Option<Components>>,
}

impl TypedGraph {
    /// A graph without values, of a system with so many coordinates.
    #[must_use]
    pub fn new(graph: Graph, coordinates: u32) -> Self {
        Self {
            geometry: Geometry::from(graph),
            coordinates,
            operations: Vec::new(),
            components: Vec::new(),
            beginning: Beginning::default(),
        }
    }

    /// Marks the beginning of definitions and energies. What is added before is shared by [systems with whole
    /// vectors](crate::DeclaredSystem) and [positions at rest](crate::AtRest), which evaluate what is added afterwards.
    pub fn begin_definitions(&mut self) {
        self.beginning = Beginning {
            graph: self.geometry.graph.clone(),
            components: self.components.clone(),
        };
    }

    /// Adds the value of an operation.
    ///
    /// # Errors
    ///
    /// If its arguments have no such value.
    pub fn add(&mut self, operation: TypedOperation) -> Result<Value, NoValue> {
        let known = &self.components;
        let components = operation.evaluate(&mut self.geometry, self.coordinates, known)?;
        let value = Value(u32::try_from(self.operations.len()).map_err(|_| NoValue::Size)?);
        self.operations.push(operation);
        self.components.push(Some(components));
        Ok(value)
    }

    /// The components of a value.
    #[must_use]
    pub fn components(&self, value: Value) -> &Components {
        let found = self.components.get(value.0 as usize);
        found
            .and_then(Option::as_ref)
            .unwrap_or(&Components::EmptySum)
    }

    /// The expression of a scalar: of a sum without terms 0, and of an array its first element.
    #[must_use]
    pub fn expression(&self, value: Value) -> Expression {
        let elements = self.components(value).elements();
        let zero = self.geometry.graph.zero();
        elements.first().copied().unwrap_or(zero)
    }

    /// The number that a scalar is, if it is one.
    #[must_use]
    pub fn as_constant(&self, value: Value) -> Option<&Rational> {
        match self.components(value) {
            Components::Scalar(x) => self.geometry.graph.as_constant(*x),
            Components::Array(_) | Components::EmptySum => None,
        }
    }
}
