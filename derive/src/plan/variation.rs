//! The residuals of the equations of motion along a variation, from which the model in C finds the derivatives of the accelerations
//! that the model in Rust computes on dual numbers.
//!
//! At fixed accelerations and multipliers x, the derivatives δx along a variation solve A δx = −δ(A x − b), where A x = b are the
//! equations of motion and of the constraints (J. Carpentier and N. Mansard, Analytical derivatives of rigid body dynamics
//! algorithms, RSS 2018).

use lagrangian_symbolic::{Kinetics, Model, Symbol};

use super::derivatives::state_symbols;
use super::method::Method;
use super::outputs::MethodOutputs;

/// The methods that compute δ(A x − b).
pub(crate) struct VariationMethods {
    /// Along a variation of q, q̇ and t.
    pub(crate) state: Method,
    /// Along one of the inputs, for a model without constraints; for one with some, the inputs have a method in Rust.
    pub(crate) inputs: Option<Method>,
}

impl VariationMethods {
    pub(super) fn schedule(model: &mut Model, kinetics: &Kinetics) -> Self {
        let state = state_symbols(model);
        let has_inputs = model.inputs > 0 && kinetics.constraints.is_empty();
        let inputs = has_inputs.then(|| model.input_symbols());
        Self {
            state: along(model, kinetics, &state),
            inputs: inputs.map(|symbols| along(model, kinetics, &symbols)),
        }
    }
}

/// The residuals along a variation of some symbols, in their order.
fn along(model: &mut Model, kinetics: &Kinetics, symbols: &[Symbol]) -> Method {
    let residuals = kinetics.residuals_along(&mut model.graph, symbols);
    Method::single(model, &residuals, MethodOutputs::Vector)
}
