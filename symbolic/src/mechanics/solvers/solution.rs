//! The choice of the solver: the accelerations are found by each that applies, and the cheapest are taken by the
//! [cost model](crate::algebra::cost), without what depends on parameters alone unless the rest costs the same.
//!
//! Four solvers find q̈: the Boltzmann–Hamel equations in as many quasi-velocities as there are coordinates,
//! articulated-body elimination along the tree of quasi-velocities or along the links of a mechanism, and the symbolic
//! factorization of the mass matrix; where none applies, M is factored numerically. For a few coordinates the derivatives of q̈ are solved for
//! with the same factors.

use crate::limits::{MAX_DIFFERENTIATED_COORDINATES, SCHEDULING_MARGIN};
use crate::matrix::ldlt::Ldlt;
use crate::mechanics::solvers::articulated_bodies::ArticulatedBodies;
use crate::mechanics::solvers::articulated_links::ArticulatedLinks;
use crate::mechanics::solvers::boltzmann_hamel::BoltzmannHamel;
use crate::mechanics::solvers::implicit_equations::ImplicitEquations;
use crate::mechanics::solvers::link_derivatives::cheapest_derivatives;
use crate::mechanics::solvers::link_equations::LinkEquations;
use crate::mechanics::solvers::pivots::Pivot;
use crate::{Expression, Graph, Program, Symbol};

/// The accelerations q̈ as expressions.
pub struct Solution {
    /// The accelerations are valid where all of these are positive; where one is not, M is to be factored
    /// with pivoting. Empty if they are valid wherever M is regular.
    pub pivots: Vec<Expression>,
    /// The accelerations q̈.
    pub accelerations: Vec<Expression>,
    /// The intermediate results of a recursion along links, in its order; of other solvers none.
    pub recursion: Vec<Expression>,
    solver: Solver,
    /// The program of the pivots and the accelerations, if it was scheduled to compare solvers.
    scheduled: Option<Program>,
}

/// How M x = r is solved.
pub(crate) enum Solver {
    BoltzmannHamel(BoltzmannHamel),
    ArticulatedBodies(ArticulatedBodies),
    ArticulatedLinks(ArticulatedLinks),
    /// The factors of M, and f.
    Ldlt(Ldlt, Vec<Expression>),
}

impl Solver {
    /// x in M x = r; empty where M is not what is factored.
    fn solution(&self, graph: &mut Graph, right: &[Expression]) -> Vec<Expression> {
        match self {
            Self::ArticulatedBodies(solver) => solver.solution(graph, right),
            Self::ArticulatedLinks(solver) => solver.solution(graph, right),
            Self::Ldlt(solver, _) => solver.solve(graph, right),
            Self::BoltzmannHamel(_) => Vec::new(),
        }
    }
}

impl Solution {
    /// The solution by the cheapest of several solvers; of two with the same cost, by the later.
    pub(crate) fn cheapest(graph: &mut Graph, solvers: Vec<Solver>) -> Option<Self> {
        let mut solutions = Vec::with_capacity(solvers.len());
        for solver in solvers.into_iter().rev() {
            solutions.push(Self::by(graph, solver));
        }
        let unscheduled =
            |solution: &Self| graph.cost(&[&*solution.pivots, &solution.accelerations].concat());
        // Scheduling does not make up for a cost that is far higher before it.
        let least = solutions.iter().map(unscheduled).min().unwrap_or(0);
        solutions.retain(|solution| unscheduled(solution) <= SCHEDULING_MARGIN * least);
        if solutions.len() == 1 {
            return solutions.pop();
        }
        for solution in &mut solutions {
            solution.scheduled = Some(solution.scheduled_for_staging(graph));
        }
        solutions.into_iter().min_by_key(|solution| {
            let program = solution.scheduled_for_staging(graph);
            let staged = program.staged(graph.passes);
            (staged.kernel.count().cost(), staged.setup.count().cost())
        })
    }

    /// The program that computes the pivots and then the accelerations as one group, with invariants gathered.
    #[must_use]
    pub fn scheduled_for_staging(&self, graph: &Graph) -> Program {
        let known = self.scheduled.clone();
        known.unwrap_or_else(|| {
            Program::schedule_for_staging(graph, &[&[&*self.pivots, &self.accelerations].concat()])
        })
    }

    /// The solution by one solver.
    pub(crate) fn by(graph: &mut Graph, solver: Solver) -> Self {
        let mut recursion = Vec::new();
        let (pivots, accelerations) = match &solver {
            Solver::BoltzmannHamel(solver) => (solver.pivots(), solver.accelerations(graph)),
            Solver::ArticulatedBodies(solver) => {
                (solver.pivots.clone(), solver.accelerations(graph))
            }
            Solver::ArticulatedLinks(solver) => {
                let accelerations;
                (accelerations, recursion) = solver.accelerations(graph);
                (solver.pivots.clone(), accelerations)
            }
            Solver::Ldlt(solver, forcing) => {
                let accelerations = solver.solve(graph, forcing);
                let pivots = [&*solver.pivots, &solver.conditions].concat();
                (pivots, accelerations)
            }
        };
        Self {
            pivots,
            accelerations,
            recursion,
            solver,
            scheduled: None,
        }
    }

    /// How M x = r is solved.
    pub(crate) const fn solver(&self) -> &Solver {
        &self.solver
    }

    /// Whether M itself is eliminated.
    #[must_use]
    pub fn eliminates_mass_matrix(&self) -> bool {
        matches!(self.solver, Solver::Ldlt(..))
    }

    /// Whether the factors of a saddle point problem are stable only where conditions hold.
    pub(crate) fn is_stable_in_part(&self) -> bool {
        match &self.solver {
            Solver::Ldlt(ldlt, _) => !ldlt.conditions.is_empty(),
            Solver::ArticulatedLinks(links) => !links.is_free(),
            Solver::BoltzmannHamel(_) | Solver::ArticulatedBodies(_) => false,
        }
    }

    /// What q̈ is divided by, as far as it is no number: where one of these vanishes, M is singular.
    #[must_use]
    pub fn divisors(&self, graph: &Graph) -> Vec<Pivot> {
        let mut divisors = match &self.solver {
            Solver::BoltzmannHamel(solver) => solver.divisors(),
            Solver::ArticulatedBodies(solver) => solver.divisors.clone(),
            Solver::ArticulatedLinks(solver) => solver.divisors.clone(),
            Solver::Ldlt(solver, _) => solver.divisors(),
        };
        divisors.retain(|pivot| graph.as_constant(pivot.value).is_none());
        divisors
    }

    /// The derivatives ∂q̈/∂x along the links of a mechanism, whatever they cost, where the solution is by articulated links.
    pub fn derivatives_along_links(
        &self,
        graph: &mut Graph,
        symbols: &[Symbol],
    ) -> Option<Vec<Expression>> {
        match &self.solver {
            Solver::ArticulatedLinks(solver) => solver.derivatives(graph, symbols),
            _ => None,
        }
    }

    /// The derivatives ∂q̈/∂x, column by column, with the accelerations as symbols; none where the
    /// columns are so many and long that a numerical factorization is better.
    pub(crate) fn derivatives(
        &self,
        graph: &mut Graph,
        inverse_dynamics: &[Expression],
        links: Option<&LinkEquations>,
        symbols: &[Symbol],
    ) -> Option<Vec<Expression>> {
        if let Solver::BoltzmannHamel(solver) = &self.solver {
            return Some(solver.derivatives(graph, symbols));
        }
        if inverse_dynamics.len() > MAX_DIFFERENTIATED_COORDINATES {
            return None;
        }
        let (residuals, links) = match &self.solver {
            Solver::ArticulatedBodies(solver) => (solver.inverse_dynamics(graph), None),
            Solver::ArticulatedLinks(solver) if solver.is_free() => {
                (solver.inverse_dynamics(graph), links)
            }
            _ => (inverse_dynamics.to_vec(), links),
        };
        let beside = [&*self.pivots, &self.accelerations].concat();
        let mut columns = Vec::new();
        for slopes in cheapest_derivatives(graph, links, &residuals, symbols, &beside) {
            let right: Vec<_> = slopes.iter().map(|slope| graph.negate(*slope)).collect();
            columns.extend(self.solver.solution(graph, &right));
        }
        Some(columns)
    }

    /// x in M x = r, valid where all pivots are positive.
    pub(crate) fn of_right_hand_side(
        &self,
        graph: &mut Graph,
        right: &[Expression],
    ) -> Vec<Expression> {
        match &self.solver {
            Solver::BoltzmannHamel(solver) => solver.solution(graph, right),
            // M in its unit is what is factored.
            Solver::ArticulatedBodies(solver) => {
                let unit = solver.unit();
                let right = right.iter().map(|x| graph.divide(*x, unit));
                let right: Vec<_> = right.collect();
                solver.solution(graph, &right)
            }
            solver => solver.solution(graph, right),
        }
    }

    /// The equations of motion in the form in which they are solved, with each of these residuals M q̈ − f that are for the
    /// same M, and with those in differences of angles; none where no matrix is factored.
    pub(crate) fn implicit_equations(
        &self,
        graph: &mut Graph,
        mut residuals: Vec<Vec<Expression>>,
        in_differences: Option<Vec<Expression>>,
    ) -> Vec<ImplicitEquations> {
        let mut others = in_differences;
        match &self.solver {
            Solver::BoltzmannHamel(_) => return Vec::new(),
            // Theirs are in the unit of the tree.
            Solver::ArticulatedBodies(solver) => {
                residuals = vec![solver.inverse_dynamics(graph)];
                for residual in others.iter_mut().flatten() {
                    *residual = graph.divide(*residual, solver.unit());
                }
            }
            Solver::ArticulatedLinks(solver) if solver.is_free() => {
                residuals.push(solver.inverse_dynamics(graph));
            }
            Solver::ArticulatedLinks(_) | Solver::Ldlt(..) => {}
        }
        residuals.extend(others);
        let symbols = (0..).map(Symbol::RightHandSide);
        let symbols = symbols.take(self.accelerations.len());
        let right: Vec<_> = symbols.map(|symbol| graph.symbol(symbol)).collect();
        let solution = self.solver.solution(graph, &right);
        let equations = residuals.into_iter().map(|residuals| ImplicitEquations {
            residuals,
            solution: solution.clone(),
        });
        equations.collect()
    }
}
