//! Energies with vectors that are resolved last.
//!
//! As components along inertial axes, the velocity of each link of an arm contains all rotations before it. In a graph of
//! their own the energies keep whole vectors, from which the solver reads how links follow each other.

use crate::typed::components::Components;
use crate::typed::evaluation::Evaluation;
use crate::typed::graph::TypedGraph;
use crate::typed::operation::Value;
use crate::{Expression, Geometry};

/// T and V in a graph of their own, in which [vectors are resolved last](Geometry::with_unresolved_vectors): symbols
/// other than their components mean what they mean in the model.
#[derive(Clone, Debug)]
pub struct EnergiesInFrames {
    /// The arena of the energies.
    pub geometry: Geometry,
    /// The kinetic energy T.
    pub kinetic: Expression,
    /// The potential energy V.
    pub potential: Expression,
}

impl TypedGraph {
    /// T and V with vectors that are resolved last; none if one of them cannot be evaluated so.
    #[must_use]
    pub fn energies_in_frames(&self, energies: [Value; 2]) -> Option<EnergiesInFrames> {
        let geometry = Geometry::from(self.beginning.graph.clone());
        let mut geometry = geometry.with_unresolved_vectors(self.coordinates);
        let begin = self.beginning.values;
        let mut known = self.components[..begin].to_vec();
        let last = energies.into_iter().max()?.0 as usize;
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
        Some(EnergiesInFrames {
            geometry,
            kinetic: kinetic?,
            potential: potential?,
        })
    }
}
