//! The energies and constraints of a declaration, as the operations by which they were declared.
//!
//! As components along inertial axes, the velocity of each link of an arm contains all rotations before it. Evaluated
//! once more, the energies keep whole vectors, from which the solver reads how links follow each other, and the
//! constraints keep the velocities of the points that they restrict.

use crate::typed::components::Components;
use crate::typed::graph::TypedGraph;
use crate::typed::operation::{TypedOperation, Value};
use crate::{Expression, Geometry, Graph};

/// T, V and constraints in the part of a typed graph that they need.
#[derive(Clone, Debug)]
pub struct DeclaredSystem {
    /// The components of the first values, which are symbols.
    given: Vec<Option<Components>>,
    /// The operations behind them.
    operations: Vec<TypedOperation>,
    coordinates: u32,
    /// T and V.
    energies: [Value; 2],
    /// The constraints, each with whether it is holonomic.
    constraints: Vec<(Value, bool)>,
}

/// T, V and constraints with the components of vectors that are [resolved last](Geometry::with_unresolved_vectors).
pub(crate) struct SystemInFrames {
    /// T.
    pub(crate) kinetic: Expression,
    /// V.
    pub(crate) potential: Expression,
    /// w = G q̇ + a of each component of the constraints; none if one of them cannot be evaluated so.
    pub(crate) constraints: Option<Vec<Expression>>,
}

impl TypedGraph {
    /// The graph of the components, and the system with these energies T and V, and with these constraints, each with whether
    /// it is holonomic.
    #[must_use]
    pub fn into_system(
        mut self,
        energies: [Value; 2],
        constraints: Vec<(Value, bool)>,
    ) -> (Graph, DeclaredSystem) {
        let values = constraints.iter().map(|(value, _)| *value).chain(energies);
        self.operations
            .truncate(values.map(|value| value.0 as usize + 1).max().unwrap_or(0));
        let begin = self.beginning.components.len().min(self.operations.len());
        let system = DeclaredSystem {
            given: self.beginning.components,
            operations: self.operations.split_off(begin),
            coordinates: self.coordinates,
            energies,
            constraints,
        };
        (self.geometry.graph, system)
    }
}

impl DeclaredSystem {
    /// The system in a geometry of its symbols in which vectors are resolved last; none if an energy cannot be evaluated so.
    pub(crate) fn in_frames(&self, geometry: &mut Geometry) -> Option<SystemInFrames> {
        let mut known = self.given.clone();
        for operation in &self.operations {
            let components = operation.evaluate(geometry, self.coordinates, &known);
            known.push(components.ok());
        }
        let [kinetic, potential] = self.energies.map(|energy| match known[energy.0 as usize] {
            Some(Components::Scalar(energy)) => Some(energy),
            _ => None,
        });
        let constraints = self.constraints.iter().map(|(value, is_holonomic)| {
            let components = known[value.0 as usize].as_ref()?.elements().iter();
            let velocities = components.map(|x| {
                if *is_holonomic {
                    geometry.rate_in_frames(*x, self.coordinates)
                } else {
                    Some(*x)
                }
            });
            velocities.collect::<Option<Vec<_>>>()
        });
        let constraints: Option<Vec<_>> = constraints.collect();
        Some(SystemInFrames {
            constraints: constraints.map(|constraints| constraints.concat()),
            kinetic: kinetic?,
            potential: potential?,
        })
    }
}
