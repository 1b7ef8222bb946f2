//! Translation validation: in every build, all programs are compared with Lagrange's equations numerically.
//!
//! Where one disagrees, all are replaced by plain ones, derived without any optimization pass. That is a defect of
//! this crate, of which debug builds warn.

use std::collections::BTreeSet;

use lagrangian_symbolic as symbolic;
use lagrangian_symbolic::{
    AccelerationProgram, Equations, LinearizationProgram, Model, Passes, Program, Programs,
    Validator,
};

use super::constraint_methods::ConstraintMethods;
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
        let disagreements = validator.disagreements(self.programs(&self.observations()));
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

    /// What is observed: outputs, and then events.
    pub(crate) fn observations(&self) -> Vec<&Program> {
        let events = self.event_functions.iter();
        let all = core::iter::once(&self.outputs).chain(events);
        all.map(|method| &method.program).collect()
    }

    /// The programs as they are validated.
    pub(crate) fn programs<'a>(&'a self, outputs: &'a [&'a Program]) -> Programs<'a> {
        let accelerations = &self.accelerations.program;
        let inputs = &self.input_jacobian.program;
        let linearization = |linearize: &'a Method| {
            let state = &linearize.program;
            match linearize.outputs.pivots() {
                Some(pivots) => LinearizationProgram::Solved {
                    state,
                    inputs,
                    pivots,
                    is_along_variation: linearize.outputs.is_along_variation(),
                },
                None => LinearizationProgram::System { state, inputs },
            }
        };
        let has_program = |method: &Method| !matches!(method.outputs, MethodOutputs::ByColumns(_));
        let energies = self.energies.as_ref();
        let linearize = self.linearize.as_ref();
        let constraints = self.constraints.as_ref();
        Programs {
            lagrangian: &self.lagrangian.program,
            energies: energies.map(|energies| [&energies[0].program, &energies[1].program]),
            energy: &self.energy.program,
            momenta: &self.momenta.program,
            mass_matrix: has_program(&self.mass_matrix).then_some(&self.mass_matrix.program),
            forcing: &self.forcing.program,
            generalized_forces: &self.generalized_forces.program,
            inverse_dynamics: &self.inverse_dynamics.program,
            preparation: &self.prepare.program,
            accelerations: match self.accelerations.outputs.pivots() {
                Some(pivots) => AccelerationProgram::Solved(accelerations, pivots),
                None => AccelerationProgram::System(accelerations),
            },
            linearization: linearize
                .filter(|method| has_program(method))
                .map(linearization),
            input_jacobian: constraints.map(|_| (inputs, self.input_jacobian.outputs.pivots())),
            constraints: constraints.map(ConstraintMethods::programs),
            outputs,
            requested: self.requested.programs(),
        }
    }
}
