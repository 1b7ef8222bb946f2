//! From a checked declaration to a model: every name resolved, every number exact.

use lagrangian_symbolic::{Energies, Expression, Graph, Model};

use crate::ablation::passes;
use crate::declaration::{Clause, Declaration, Role};
use crate::diagnostics::Diagnostics;
use crate::expression::{Place, Translator};
use crate::names::plain;
use crate::scope::{Meaning, Scope};

/// Resolves a declaration. The model is there unless errors were reported or names are unknown.
pub(crate) fn lower(
    declaration: &Declaration,
    diagnostics: &mut Diagnostics,
) -> (Option<Model>, Scope) {
    let mut graph = Graph::new();
    graph.passes = passes(diagnostics);
    let mut translator = Translator {
        graph,
        scope: Scope::new(declaration),
        coordinates: count(declaration.clauses.coordinates.len()),
        diagnostics,
    };
    let parts = translator.parts(declaration);
    let complete = translator.diagnostics.is_empty() && translator.scope.unknown().next().is_none();
    let model = parts.filter(|_| complete).map(|parts| Model {
        graph: translator.graph,
        coordinates: translator.coordinates,
        inputs: count(declaration.fields_with(Role::Input).count()),
        energies: parts.energies,
        dissipation: parts.dissipation,
        forces: parts.forces,
        outputs: parts.outputs,
    });
    (model, translator.scope)
}

struct Parts {
    energies: Energies,
    dissipation: Expression,
    forces: Vec<Expression>,
    outputs: Vec<Expression>,
}

impl Translator<'_> {
    fn parts(&mut self, declaration: &Declaration) -> Option<Parts> {
        let clauses = &declaration.clauses;
        for definition in &clauses.definitions {
            let meaning = match self.translate(&definition.expression, Place::Observation) {
                Some(expression) => Meaning::Defined(expression),
                None => Meaning::Broken,
            };
            self.scope.define(&definition.name, meaning);
        }
        let kinetic = self.total(&clauses.kinetic);
        let potential = self.total(&clauses.potential);
        let lagrangian = self.total(&clauses.lagrangian);
        let dissipation = self.total(&clauses.dissipation);
        let forces = self.forces(declaration);
        let outputs: Vec<_> = clauses
            .outputs
            .iter()
            .map(|output| self.translate(&output.expression, Place::Observation))
            .collect();
        let energies = if clauses.lagrangian.is_empty() {
            self.check_velocities(&clauses.kinetic, kinetic?);
            Energies::Natural {
                kinetic: kinetic?,
                potential: potential?,
            }
        } else {
            self.check_velocities(&clauses.lagrangian, lagrangian?);
            Energies::General(lagrangian?)
        };
        Some(Parts {
            energies,
            dissipation: dissipation?,
            forces: forces?,
            outputs: outputs.into_iter().collect::<Option<_>>()?,
        })
    }

    /// The sum of all clauses with one keyword.
    fn total(&mut self, clauses: &[Clause]) -> Option<Expression> {
        let values: Vec<_> = clauses
            .iter()
            .map(|clause| self.translate(&clause.expression, Place::Energy))
            .collect();
        let zero = self.graph.zero();
        values
            .into_iter()
            .try_fold(zero, |total, value| Some(self.graph.add(total, value?)))
    }

    fn forces(&mut self, declaration: &Declaration) -> Option<Vec<Expression>> {
        let mut forces = vec![Some(self.graph.zero()); declaration.clauses.coordinates.len()];
        for force in &declaration.clauses.forces {
            let value = self.translate(&force.expression, Place::Energy);
            if let Some(coordinate) = self.scope.coordinate(&plain(&force.name)) {
                forces[coordinate] = value;
            }
        }
        forces.into_iter().collect()
    }

    fn check_velocities(&mut self, clauses: &[Clause], energy: Expression) {
        if self.coordinates == 0 {
            return;
        }
        let moving = self.graph.contents(energy).has_velocity();
        if let (false, Some(clause)) = (moving, clauses.first()) {
            self.diagnostics.error(
                &clause.expression,
                "this contains no velocity, so nothing moves: write velocities as `dot(q)`, \
                 as in `0.5 * m * dot(x).powi(2)`",
            );
        }
    }
}

/// Four billion names do not fit into a source file.
pub(crate) fn count(length: usize) -> u32 {
    u32::try_from(length).unwrap_or(u32::MAX)
}
