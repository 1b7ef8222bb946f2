//! Derivatives of external functions that are needed and not declared.

use std::collections::BTreeMap;

use lagrangian_symbolic::{ExternalFunction, Graph};

use super::methods::Methods;
use super::table::EmittedMethod;

impl Methods {
    /// Derivatives of external functions that are needed and not declared, by the positions of function
    /// and argument, and what needs them.
    pub(crate) fn undeclared(&self, graph: &Graph) -> BTreeMap<(usize, usize), &'static str> {
        let mut undeclared = BTreeMap::new();
        for (emitted, method) in self.all() {
            for function in method.program.functions() {
                if let Some(missing) = first_undeclared(graph, function) {
                    undeclared.entry(missing).or_insert(needs(emitted));
                }
            }
        }
        undeclared
    }
}

/// What needs the derivatives that occur in a method, as an error says it.
const fn needs(method: EmittedMethod) -> &'static str {
    match method {
        EmittedMethod::Linearize
        | EmittedMethod::InputJacobian
        | EmittedMethod::Sensitivities
        | EmittedMethod::SensitivitiesAndMultipliers => "the derivatives of the accelerations need",
        EmittedMethod::Outputs => "an output needs",
        _ => "the equations of motion need",
    }
}

/// The declared function, and its argument, whose derivative `function` is or is made of, if that was not
/// declared.
fn first_undeclared(graph: &Graph, mut function: ExternalFunction) -> Option<(usize, usize)> {
    let mut found = None;
    while let Some((of, argument)) = graph.undeclared(function) {
        found = Some((of.index(), argument));
        function = of;
    }
    found
}
