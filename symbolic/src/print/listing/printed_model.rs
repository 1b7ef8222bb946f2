//! What is listed of a model: its expressions as a reader wants them, without guards of removable singularities, and
//! with exponentials in place of functions that stand for sums of them.

use crate::mechanics::solvers::form::SolvedForm;
use crate::print::listing::Declared;
use crate::{Energies, Equations, Expression, Graph};

/// The expressions of a listing.
#[derive(Clone, Debug)]
pub(crate) struct PrintedModel {
    pub(crate) energies: Energies,
    pub(crate) equations: Equations,
    pub(crate) solved: SolvedForm,
    pub(crate) declared: Declared,
}

impl PrintedModel {
    /// The same without guards.
    pub(crate) fn without_guards(mut self, graph: &mut Graph) -> Self {
        let mut roots = Vec::new();
        self.for_each_expression(|x| roots.push(*x));
        let sums = graph.guarded_sums(&roots);
        if !sums.is_empty() {
            let mut plain = graph.replace(&roots, &sums).into_iter();
            self.for_each_expression(|x| *x = plain.next().unwrap_or(*x));
        }
        self
    }

    /// The same with exponential functions in place of logistic ones.
    pub(crate) fn by_exponentials(mut self, graph: &mut Graph) -> Self {
        if !(graph.has_exponential || graph.has_hyperbolic) {
            return self;
        }
        let mut roots = Vec::new();
        self.for_each_expression(|x| roots.push(*x));
        let mut plain = graph.by_exponentials(&roots).into_iter();
        self.for_each_expression(|x| *x = plain.next().unwrap_or(*x));
        self
    }

    fn for_each_expression(&mut self, mut visit: impl FnMut(&mut Expression)) {
        match &mut self.energies {
            Energies::Natural { kinetic, potential } => {
                visit(kinetic);
                visit(potential);
            }
            Energies::General(lagrangian) => visit(lagrangian),
        }
        let equations = &mut self.equations;
        visit(&mut equations.lagrangian);
        visit(&mut equations.energy);
        let lists = [
            &mut equations.momenta,
            &mut equations.forcing,
            &mut equations.generalized_forces,
            &mut equations.inverse_dynamics,
        ];
        lists.into_iter().flatten().for_each(&mut visit);
        let constraints = &mut equations.constraints;
        let lists = [&mut constraints.positions, &mut constraints.velocities];
        lists.into_iter().flatten().for_each(&mut visit);
        equations.mass.iter_mut().flatten().for_each(&mut visit);
        match &mut self.solved {
            SolvedForm::QuasiVelocities(equations) => {
                let lists = [
                    &mut equations.quasi_velocities,
                    &mut equations.velocities,
                    &mut equations.torques,
                    &mut equations.rates,
                ];
                lists.into_iter().flatten().for_each(&mut visit);
                equations.inertia.iter_mut().flatten().for_each(&mut visit);
            }
            SolvedForm::Accelerations(accelerations) => {
                accelerations.iter_mut().for_each(&mut visit);
            }
            SolvedForm::ArticulatedBodies | SolvedForm::Numerical => {}
        }
        let declared = &mut self.declared;
        let named = declared.definitions.iter_mut().chain(&mut declared.events);
        named.for_each(|(_, x)| visit(x));
    }
}
