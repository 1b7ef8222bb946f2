//! Energies and constraints with vectors that are resolved last.
//!
//! As components along inertial axes, the velocity of each link of an arm contains all rotations before it. In a graph of
//! their own the energies keep whole vectors, from which the solver reads how links follow each other, and the constraints the
//! velocities of the points that they restrict.

use crate::typed::components::Components;
use crate::typed::evaluation::Evaluation;
use crate::typed::graph::TypedGraph;
use crate::typed::operation::Value;
use crate::{Expression, Geometry};

/// T, V and constraints in a graph of their own, in which [vectors are resolved last](Geometry::with_unresolved_vectors):
/// symbols other than their components mean what they mean in the model.
#[derive(Clone, Debug)]
pub struct SystemInFrames {
    /// The arena of the energies.
    pub geometry: Geometry,
    /// The kinetic energy T.
    pub kinetic: Expression,
    /// The potential energy V.
    pub potential: Expression,
    /// w = G q̇ + a of each component of the constraints; none if one of them cannot be evaluated so.
    pub constraints: Option<Vec<Expression>>,
}

impl TypedGraph {
    /// T, V and constraints, each with whether it is holonomic, with vectors that are resolved last; none if an energy cannot be
    /// evaluated so.
    #[must_use]
    pub fn in_frames(
        &self,
        energies: [Value; 2],
        constraints: &[(Value, bool)],
    ) -> Option<SystemInFrames> {
        let geometry = Geometry::from(self.beginning.graph.clone());
        let mut geometry = geometry.with_unresolved_vectors(self.coordinates);
        let begin = self.beginning.values;
        let mut known = self.components[..begin].to_vec();
        let values = constraints.iter().map(|(value, _)| *value);
        let last = values.chain(energies).max()?.0 as usize;
        for operation in &self.operations[begin..=last] {
            let mut evaluation = Evaluation {
                geometry: &mut geometry,
                coordinates: self.coordinates,
                known: &known,
            };
            let components = evaluation.evaluate(operation).ok();
            known.push(components);
        }
        let [kinetic, potential] = energies.map(|energy| match known[energy.0 as usize] {
            Some(Components::Scalar(energy)) => Some(energy),
            _ => None,
        });
        let constraints = constraints.iter().map(|(value, is_holonomic)| {
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
            geometry,
            kinetic: kinetic?,
            potential: potential?,
        })
    }
}
