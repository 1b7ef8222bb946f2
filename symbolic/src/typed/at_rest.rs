//! Values at rest: with all time derivatives zero.
//!
//! At rest a velocity does not depend on the coordinates: the velocity of a moving frame is a time derivative,
//! too, or a product ω × r as in (1.4), which belongs to the rate of r. The sum of a position and a velocity leaves the
//! position. As expressions of q and q̇ the two do not differ: hence the operations are evaluated in a graph of their own.

use crate::Geometry;
use crate::typed::components::{Components, NoValue};
use crate::typed::graph::TypedGraph;
use crate::typed::operation::{TypedOperation, Value};
use crate::typed::rest::Rest;

/// The values of a typed graph at rest.
#[derive(Debug)]
pub struct AtRest {
    geometry: Geometry,
    rest: Rest,
    /// The components of the first values.
    known: Vec<Option<Components>>,
}

impl AtRest {
    /// The values of a graph at rest, which are evaluated as far as they are asked for.
    #[must_use]
    pub fn new(graph: &TypedGraph) -> Self {
        let beginning = graph.beginning.clone();
        Self {
            geometry: Geometry::from(beginning.graph),
            rest: Rest::default(),
            known: beginning.components,
        }
    }

    /// Whether a component of a value depends on coordinates at rest, as far as is known.
    pub fn depends_on_position(
        &mut self,
        graph: &TypedGraph,
        value: Value,
        component: usize,
    ) -> bool {
        let begin = self.known.len();
        let operations = graph.operations.iter().take(value.0 as usize + 1);
        for operation in operations.skip(begin) {
            let components = self.components_of(operation, graph.coordinates).ok();
            self.known.push(components);
        }
        let components = self.known[value.0 as usize].take();
        let depends = components.as_ref().is_none_or(|found| {
            let graph = &mut self.geometry.graph;
            self.rest
                .depends_on_position(graph, found.elements(), component)
        });
        self.known[value.0 as usize] = components;
        depends
    }

    /// The components of a value at rest: rates are unknown, and products with given vectors, which may be rates.
    fn components_of(
        &mut self,
        operation: &TypedOperation,
        coordinates: u32,
    ) -> Result<Components, NoValue> {
        let known = |x: Value| self.known[x.0 as usize].as_ref().ok_or(NoValue::Shapes);
        let graph = &mut self.geometry.graph;
        match operation {
            TypedOperation::TimeDerivative(x) => return Ok(self.rest.rate(graph, known(*x)?)),
            TypedOperation::AngularVelocity { rotation, .. } => {
                let rotation = known(*rotation)?.array().ok_or(NoValue::Shapes)?;
                let velocity = self.rest.angular_velocity(graph, rotation);
                return Ok(Components::Array(velocity));
            }
            _ => {}
        }
        let components = operation.evaluate(&mut self.geometry, coordinates, &self.known)?;
        if let (TypedOperation::OfArrays(function, arguments), Components::Array(product)) =
            (operation, &components)
            && function.name == "cross"
            && let [x, y] = arguments.as_slice()
        {
            let known = |x: &Value| self.known[x.0 as usize].as_ref()?.array();
            if let (Some(x), Some(y)) = (known(x), known(y)) {
                let graph = &mut self.geometry.graph;
                let product = self.rest.cross_product(graph, [x, y], product);
                return Ok(Components::Array(product));
            }
        }
        Ok(components)
    }
}
