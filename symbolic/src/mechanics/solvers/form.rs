//! The form in which the equations of motion are solved, for those who read them.

use crate::mechanics::solvers::solution::Solver;
use crate::{Equations, Expression, Kinetics, Model, QuasiVelocityEquations};

/// How q̈ is found.
#[derive(Clone, Debug)]
pub enum SolvedForm {
    /// From equations in quasi-velocities: Euler's equations of a rigid body, for one.
    QuasiVelocities(QuasiVelocityEquations),
    /// By articulated-body elimination, along quasi-velocities or along the links of a mechanism.
    ArticulatedBodies,
    /// By symbolic factorization of M; these are the accelerations.
    Accelerations(Vec<Expression>),
    /// By numerical factorization of M.
    Numerical,
}

impl Kinetics {
    /// The form in which q̈ is found.
    pub fn solved_form(&self, model: &mut Model, equations: &Equations) -> SolvedForm {
        let Some(solution) = &self.solution else {
            return SolvedForm::Numerical;
        };
        match solution.solver() {
            Solver::BoltzmannHamel(solver) => {
                let forces = &equations.generalized_forces;
                SolvedForm::QuasiVelocities(solver.equations(&mut model.graph, forces))
            }
            Solver::ArticulatedBodies(_) | Solver::ArticulatedLinks(_) => {
                SolvedForm::ArticulatedBodies
            }
            Solver::Ldlt(..) => SolvedForm::Accelerations(solution.accelerations.clone()),
        }
    }
}
