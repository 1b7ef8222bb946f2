//! Values at rest: with all time derivatives zero.
//!
//! At rest a velocity does not depend on the coordinates: the velocity of a moving frame is a time derivative,
//! too, or a product ω × r as in (1.4), which belongs to the rate of r. The sum of a position and a velocity leaves the
//! position. As expressions of q and q̇ the two do not differ: hence the operations are evaluated in a graph of their own.

use crate::Geometry;
use crate::typed::components::Components;
use crate::typed::evaluation::{Evaluation, NoValue};
use crate::typed::graph::TypedGraph;
use crate::typed::operation::{TypedOperation, Value};
use crate::typed::rest::Rest;

/// The values of a typed graph at rest.
#[derive(Debug)]
pub struct AtRest {
    geometry: Geometry,
    rest: Rest,
    known: Vec<Option<Components>>,
    /// The first values, whose components are known.
    evaluated: Vec<bool>,
}

impl AtRest {
    /// The values of a graph at rest, which are evaluated where they are asked for.
    #[must_use]
    pub fn new(graph: &TypedGraph) -> Self {
        let beginning = graph.beginning.clone();
        Self {
            geometry: Geometry::from(beginning.graph),
            rest: Rest::default(),
            evaluated: vec![true; beginning.components.len()],
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
        self.evaluate(graph, value);
        let components = self.known[value.0 as usize].take();
        let depends = components.as_ref().is_none_or(|found| {
            let graph = &mut self.geometry.graph;
            self.rest
                .depends_on_position(graph, found.elements(), component)
        });
        self.known[value.0 as usize] = components;
        depends
    }

    /// Evaluates a value, and what it is made of, unless they are.
    fn evaluate(&mut self, graph: &TypedGraph, value: Value) {
        let end = value.0 as usize + 1;
        if self.evaluated.len() < end {
            self.known.resize(end, None);
            self.evaluated.resize(end, false);
        }
        let mut needed = vec![false; end];
        needed[end - 1] = true;
        for i in (0..end).rev() {
            if needed[i] && !self.evaluated[i] {
                for argument in graph.operations[i].arguments() {
                    needed[argument.0 as usize] = true;
                }
            }
        }
        for (i, operation) in graph.operations[..end].iter().enumerate() {
            if needed[i] && !self.evaluated[i] {
                self.known[i] = self.components_of(operation, graph.coordinates).ok();
                self.evaluated[i] = true;
            }
        }
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
        let mut evaluation = Evaluation {
            geometry: &mut self.geometry,
            coordinates,
            known: &self.known,
        };
        let components = evaluation.evaluate(operation)?;
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
