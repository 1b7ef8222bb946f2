//! Translation validation: in every build, all programs are compared with Lagrange's equations numerically.
//!
//! Where one disagrees, all are replaced by plain ones, derived without any optimization pass. That is a defect of
//! this crate, of which debug builds warn.

use std::collections::BTreeSet;

use lagrangian_symbolic as symbolic;
use lagrangian_symbolic::{
    ConstraintTapes, Equations, Model, Passes, SolutionTape, Tapes, Validator,
};

use crate::plan::{Method, MethodOutputs, Methods, Requested};
use crate::syntax::shape::Shape;

impl Methods {
    /// Where a method disagrees with the equations of `validator`, replaces all of them by what is derived without
    /// any pass, since they come from one derivation; says which ones disagreed.
    pub(crate) fn validate(
        &mut self,
        validator: &Validator,
        model: &mut Model,
        equations: &mut Equations,
        (shapes, requested): (&[Shape], &Requested),
    ) -> BTreeSet<symbolic::Method> {
        let disagreements = self.disagreements(validator);
        if disagreements.is_empty() {
            return disagreements;
        }
        let passes = core::mem::replace(&mut model.graph.passes, Passes::NONE);
        if let Ok(plain) = Equations::derive(model) {
            *self = Self::schedule(model, &plain, shapes, requested);
            *equations = plain;
        }
        model.graph.passes = passes;
        disagreements
    }

    /// The methods that do not compute what the equations of `validator` say.
    pub(crate) fn disagreements(&self, validator: &Validator) -> BTreeSet<symbolic::Method> {
        validator.disagreements(&self.tapes(validator))
    }

    fn tapes(&self, validator: &Validator) -> Tapes {
        let tape = |method: &Method| validator.tape([&method.program]);
        let tape_of_all = |methods: &mut dyn Iterator<Item = &Method>| {
            validator.tape(methods.map(|method| &method.program))
        };
        let solution = |method: &Method| SolutionTape {
            tape: tape(method),
            pivots: method.outputs.pivots(),
            is_along_variation: method.outputs.is_along_variation(),
        };
        let has_program = |method: &&Method| !matches!(method.outputs, MethodOutputs::ByColumns(_));
        let linearize = self.linearize.as_ref();
        let requested = &self.requested;
        Tapes {
            lagrangian: tape(&self.lagrangian),
            energies: tape_of_all(&mut self.energies.iter().flatten()),
            energy: tape(&self.energy),
            momenta: tape(&self.momenta),
            mass_matrix: Some(&self.mass_matrix).filter(has_program).map(tape),
            forcing: tape(&self.forcing),
            generalized_forces: tape(&self.generalized_forces),
            inverse_dynamics: tape(&self.inverse_dynamics),
            preparation: tape(&self.prepare),
            accelerations: solution(&self.accelerations),
            constraints: self.constraints.as_ref().map(|methods| ConstraintTapes {
                holonomic: methods.holonomic,
                are_independent: methods.are_independent,
                positions: tape(&methods.positions),
                velocities: tape(&methods.velocities),
                jacobian: tape(&methods.jacobian),
                rates: tape(&methods.rates),
            }),
            state_jacobian: linearize.filter(has_program).map(solution),
            input_jacobian: Some(&self.input_jacobian).filter(has_program).map(solution),
            outputs: tape_of_all(&mut [&self.outputs].into_iter().chain(&self.event_functions)),
            momentum_rates: requested.momentum_rates.as_ref().map(tape),
            velocities: requested.solved_velocities.as_ref().map(tape),
            energy_rate: requested.energy_rate.as_ref().map(tape),
            sensitivities: requested
                .sensitivities
                .as_ref()
                .map(|found| (solution(&found.method), found.parameters.clone())),
            regressor: requested.regressor.as_ref().map(|found| {
                [&found.regressor, &found.known_terms, &found.base_parameters].map(tape)
            }),
        }
    }
}
