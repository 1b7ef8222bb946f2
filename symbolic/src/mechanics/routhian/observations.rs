//! The outputs of a model in terms of the reduced one.
//!
//! The velocities u of the ignorable coordinates are those of the elimination, and their accelerations du/dt along the motion
//! of the others. What depends on an ignorable coordinate itself is not determined by the state of the reduced model.

use std::collections::BTreeMap;

use super::{Split, acceleration, coordinate, velocity};
use crate::mechanics::conservation::independent_of;
use crate::{Expression, Graph, Model, Symbol};

impl Split {
    /// The outputs, with these velocities of the ignorable coordinates, still in the numbers of the full model; or the
    /// position of an ignorable coordinate on which one depends.
    pub(super) fn outputs(
        &self,
        model: &Model,
        graph: &mut Graph,
        velocities: &[Expression],
    ) -> Vec<Result<Expression, usize>> {
        let accelerates = |symbol| matches!(symbol, Symbol::Acceleration(i) if self.ignorable.contains(&(i as usize)));
        let mut values: BTreeMap<Symbol, Expression> = BTreeMap::new();
        if model.graph.contains(&model.outputs, accelerates) {
            let rates = graph.time_derivatives(velocities, model.coordinates);
            let ignorable = self.ignorable.iter().map(|i| acceleration(*i));
            values.extend(ignorable.zip(rates));
        }
        let ignorable = self.ignorable.iter().map(|i| velocity(*i));
        values.extend(ignorable.zip(velocities.iter().copied()));
        let outputs = model.outputs.iter().map(|output| {
            self.without_ignorable_coordinates(model, graph, *output)
                .map(|output| graph.substitute(&[output], &values)[0])
        });
        outputs.collect()
    }

    /// An output at fixed values of the ignorable coordinates, unless it depends on one.
    fn without_ignorable_coordinates(
        &self,
        model: &Model,
        graph: &mut Graph,
        output: Expression,
    ) -> Result<Expression, usize> {
        let symbols: Vec<Symbol> = self.ignorable.iter().map(|i| coordinate(*i)).collect();
        let written = |symbol| symbols.contains(&symbol);
        if !graph.contains(&[output], written) {
            return Ok(output);
        }
        let absent = independent_of(model, output, &symbols);
        if let Some(position) = absent.iter().position(|absent| !absent) {
            return Err(self.ignorable[position]);
        }
        let fixed = self.fixed_with(graph, &[output], 1)[0];
        if graph.contains(&[fixed], written) {
            return Err(self.ignorable[0]);
        }
        Ok(fixed)
    }
}
