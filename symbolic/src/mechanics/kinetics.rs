//! The kinetics of a model: f, M q̈ − f and q̈, each by the cheapest method that applies.
//!
//! Lagrange's equations give f and M q̈ − f for every model; where quasi-velocities form a tree, or links follow
//! each other, recursions along them take fewer operations. Here the solvers for q̈ that apply are set up;
//! [`Solution::cheapest`] chooses among them. Where none applies, the emitted code factors M numerically.

use std::cell::OnceCell;

use crate::limits::{
    MAX_EXPANDED_COORDINATES, MAX_PIVOT_NEIGHBOURS, MAX_SOLVED_BY_COLUMNS,
    MIN_DIFFERENTIATED_ALONG_LINKS, SCHEDULING_MARGIN,
};
use crate::matrix::ldlt::Ldlt;
use crate::matrix::rows::agree;
use crate::mechanics::constraints::ConstraintEquations;
use crate::mechanics::energy_forms::quasi_velocities::QuasiVelocities;
use crate::mechanics::energy_functions::EnergyFunctions;
use crate::mechanics::linear_system::LinearSystem;
use crate::mechanics::mechanism::Mechanism;
use crate::mechanics::solvers::articulated_bodies::ArticulatedBodies;
use crate::mechanics::solvers::articulated_links::ArticulatedLinks;
use crate::mechanics::solvers::boltzmann_hamel::BoltzmannHamel;
use crate::mechanics::solvers::first_order_equations::FirstOrderEquations;
use crate::mechanics::solvers::implicit_equations::ImplicitEquations;
use crate::mechanics::solvers::kinematic_tree::KinematicTree;
use crate::mechanics::solvers::link_derivatives::cheapest_derivatives;
use crate::mechanics::solvers::link_equations::LinkEquations;
use crate::mechanics::solvers::motion_of_cosine;
use crate::mechanics::solvers::solution::{Solution, Solver};
use crate::{Equations, Expression, Graph, Model, Pass, Symbol};

/// The kinetics of a model, as expressions of its graph.
pub struct Kinetics {
    /// L, the energy function, T, V and the momenta.
    pub energies: EnergyFunctions,
    /// M, row by row.
    pub mass: Vec<Vec<Expression>>,
    /// The forcing f in M q̈ = f.
    pub forcing: Vec<Expression>,
    /// M q̈ − f with the accelerations as symbols.
    pub inverse_dynamics: Vec<Expression>,
    /// The intermediate results of the recursion along links that computes M q̈ − f, in its order; of other ways none.
    pub recursion: Vec<Expression>,
    /// M q̈ = f for numerical solution; with constraints, the saddle point problem for q̈ and λ.
    pub system: LinearSystem,
    /// The accelerations, and behind them the multipliers of the constraints; none for many coupled coordinates, where M is
    /// factored numerically.
    pub solution: Option<Solution>,
    /// The equations of the constraints.
    pub constraints: ConstraintEquations,
    /// The equations along the links, where the model is a mechanism.
    links: Option<LinkEquations>,
    /// Whether the derivatives of q̈ by the state are taken along the links.
    differentiates_along_links: OnceCell<bool>,
    /// By what M and f of `system` are divided.
    unit: Expression,
    /// The choices of as many quasi-velocities as there are coordinates.
    boltzmann_hamel: Vec<BoltzmannHamel>,
}

impl Kinetics {
    /// The kinetics of `model`.
    pub fn cheapest(model: &mut Model, equations: &Equations) -> Self {
        let (mut kinetics, solvers) = Self::with_solvers(model, equations);
        kinetics.solution = Solution::cheapest(&mut model.graph, solvers);
        kinetics
    }

    /// The kinetics without a solution, and the solvers that apply.
    pub(crate) fn with_solvers(model: &mut Model, equations: &Equations) -> (Self, Vec<Solver>) {
        let declared = QuasiVelocities::declared(&mut model.graph, equations.lagrangian);
        let forces = &equations.generalized_forces;
        let passes = model.graph.passes;
        let tree = declared
            .as_ref()
            .filter(|_| passes.has(Pass::ArticulatedBodies))
            .map(|declared| KinematicTree::new(model, declared, forces));
        let graph = &mut model.graph;
        let lagrange = LinearSystem {
            mass: equations.mass.clone(),
            forcing: equations.forcing.clone(),
            inverse_dynamics: equations.inverse_dynamics.clone(),
            recursion: Vec::new(),
        };
        let mut cheaper = match &tree {
            Some(tree) => lagrange.cheaper(graph, tree),
            None => lagrange,
        };
        let links = link_equations(model, equations);
        let energies = EnergyFunctions::cheapest(model, equations, links.as_ref());
        let graph = &mut model.graph;
        let constraints = &equations.constraints;
        // With surplus constraints the matrix is singular, and which are left out is decided at each configuration.
        let has_ldlt = passes.has(Pass::Ldlt) && constraints.surplus.is_empty();
        let ldlt = |graph: &mut Graph, system: &LinearSystem| {
            let system = system.clone().with_constraints(graph, constraints);
            ldlt_solvers(graph, &system, model.coordinates as usize)
        };
        let mut solvers = Vec::new();
        if has_ldlt {
            solvers.extend(ldlt(graph, &cheaper));
        }
        if let Some(links) = &links {
            let along_links = links.system(graph);
            if has_ldlt {
                solvers.extend(ldlt(graph, &along_links));
            }
            cheaper = cheaper.or(graph, along_links);
        }
        let is_free = constraints.is_empty();
        let mut system = cheaper.clone().with_constraints(graph, constraints);
        let mut unit = graph.one();
        if let Some(tree) = tree.filter(|_| is_free) {
            let scaled = tree.divided_by_unit(graph);
            unit = scaled.unit;
            system = system.scaled(graph, &scaled);
            let articulated_bodies = ArticulatedBodies::factor(graph, scaled, MAX_PIVOT_NEIGHBOURS);
            solvers.extend(articulated_bodies.map(Solver::ArticulatedBodies));
        }
        if let Some(links) = links.as_ref().filter(|_| constraints.surplus.is_empty()) {
            let rows = links.constraints(graph, constraints);
            let solver =
                rows.and_then(|rows| ArticulatedLinks::factor(graph, links.clone(), &rows));
            solvers.extend(solver.map(Solver::ArticulatedLinks));
        }
        let boltzmann_hamel = if is_free {
            boltzmann_hamel_solvers(model, equations, declared)
        } else {
            Vec::new()
        };
        solvers.extend(boltzmann_hamel.iter().cloned().map(Solver::BoltzmannHamel));
        let kinetics = Self {
            solution: None,
            energies,
            mass: cheaper.mass,
            forcing: cheaper.forcing,
            inverse_dynamics: cheaper.inverse_dynamics,
            recursion: cheaper.recursion,
            system,
            constraints: constraints.clone(),
            links,
            differentiates_along_links: OnceCell::new(),
            unit,
            boltzmann_hamel,
        };
        (kinetics, solvers)
    }

    /// The derivatives of q̈, column by column, with the accelerations as symbols; none where they are to be solved for
    /// numerically.
    pub fn acceleration_derivatives(
        &self,
        graph: &mut Graph,
        symbols: &[Symbol],
    ) -> Option<Vec<Expression>> {
        let solution = self.solution.as_ref()?;
        let is_parameter = |symbol: &Symbol| matches!(symbol, Symbol::Parameter(_));
        if !symbols.iter().any(is_parameter) && self.differentiates_along_links(graph) {
            return solution.derivatives_along_links(graph, symbols);
        }
        let (residuals, links) = self.residuals_and_links();
        solution.derivatives(graph, residuals, links, symbols)
    }

    /// The velocities that have the momenta p, [right-hand sides](Symbol::RightHandSide), by the factors that q̈ is solved for
    /// with: M(q, t) q̇ = p − p(q, 0, t). None where L is not quadratic in the velocities, and where M is factored
    /// numerically.
    pub fn velocities(&self, model: &mut Model) -> Option<Vec<Expression>> {
        let solution = self.solution.as_ref();
        let solution = solution.filter(|_| self.constraints.is_empty())?;
        let is_velocity = |symbol| matches!(symbol, Symbol::Velocity(_));
        let graph = &mut model.graph;
        if graph.contains(&self.mass.concat(), is_velocity) {
            return None;
        }
        let velocities: Vec<_> = (0..model.coordinates).map(Symbol::Velocity).collect();
        let offsets = graph.at_zero(&self.energies.momenta, &velocities);
        let mut right = Vec::with_capacity(offsets.len());
        for (i, offset) in (0..).zip(offsets) {
            let momentum = graph.symbol(Symbol::RightHandSide(i));
            right.push(graph.subtract(momentum, offset));
        }
        Some(solution.of_right_hand_side(graph, &right))
    }

    /// Whether the derivatives of q̈ by the state are taken along the links, which is decided once.
    fn differentiates_along_links(&self, graph: &mut Graph) -> bool {
        let decision = &self.differentiates_along_links;
        *decision.get_or_init(|| self.costs_less_along_links(graph))
    }

    /// Whether the derivatives of q̈ by the state cost less along the links than by a numerical solution for their columns.
    fn costs_less_along_links(&self, graph: &mut Graph) -> bool {
        let n = self.mass.len();
        let solution = self.solution.as_ref();
        let Some(solution) = solution.filter(|_| self.constraints.is_empty()) else {
            return false;
        };
        if n < MIN_DIFFERENTIATED_ALONG_LINKS {
            return false;
        }
        let symbols = |of: fn(u32) -> Symbol| (0..).map(of).take(n);
        let symbols = symbols(Symbol::Coordinate).chain(symbols(Symbol::Velocity));
        let symbols: Vec<_> = symbols.collect();
        let Some(mut columns) = solution.derivatives_along_links(graph, &symbols) else {
            return false;
        };
        if n > MAX_SOLVED_BY_COLUMNS {
            return true;
        }
        columns.extend(solution.pivots.iter().chain(&solution.accelerations));
        let mut system = self.system_derivatives(graph, &symbols);
        system.extend(
            self.system
                .mass
                .iter()
                .flatten()
                .chain(&self.system.forcing),
        );
        // The factors, and two triangles for each of 2 n + 1 columns.
        let numerical = 4 * n * n * n + 2 * n * n + n * n * n / 3;
        graph.cost(&columns) < graph.cost(&system) + numerical
    }

    /// The derivatives of M q̈ − f, column by column, beside other expressions of the same program.
    pub fn residual_derivatives(
        &self,
        graph: &mut Graph,
        symbols: &[Symbol],
        beside: &[Expression],
    ) -> Vec<Expression> {
        let (residuals, links) = self.residuals_and_links();
        cheapest_derivatives(graph, links, residuals, symbols, beside).concat()
    }

    /// M q̈ − f, and the links along which it is differentiated; with constraints, the residuals of the saddle point problem.
    fn residuals_and_links(&self) -> (&[Expression], Option<&LinkEquations>) {
        if self.constraints.is_empty() {
            (&self.inverse_dynamics, self.links.as_ref())
        } else {
            (&self.system.inverse_dynamics, None)
        }
    }

    /// δ(M q̈ − f) along a [variation](Symbol::Variation) of the state, where the derivatives of q̈ are found along the links of
    /// a mechanism.
    pub fn residual_variation(&self, graph: &mut Graph) -> Option<Vec<Expression>> {
        if !self.differentiates_along_links(graph) {
            return None;
        }
        let coordinates = u32::try_from(self.mass.len()).ok()?;
        let positions = (0..coordinates).map(Symbol::Coordinate);
        let velocities = (0..coordinates).map(Symbol::Velocity);
        let state = positions.chain(velocities).chain([Symbol::Time]);
        Some(self.residuals_along(graph, &state.collect::<Vec<_>>()))
    }

    /// δ(M q̈ − f) along a [variation](Symbol::Variation) of some symbols, with the accelerations as symbols; with constraints,
    /// that of the residuals of the saddle point problem, with the multipliers as symbols, too.
    pub fn residuals_along(&self, graph: &mut Graph, symbols: &[Symbol]) -> Vec<Expression> {
        let (residuals, _) = self.residuals_and_links();
        let variation = (0..).map(Symbol::Variation);
        let direction = symbols.iter().zip(variation);
        let direction = direction.map(|(symbol, change)| (*symbol, graph.symbol(change)));
        let direction = direction.collect();
        graph.directional_derivatives(residuals, &direction)
    }

    /// The derivatives of the [`system`](Self::system) for numerical solution by some symbols.
    pub fn system_derivatives(&self, graph: &mut Graph, symbols: &[Symbol]) -> Vec<Expression> {
        let system = &self.system;
        let (_, links) = self.residuals_and_links();
        let links = links.filter(|_| self.unit == graph.one());
        let beside = [&*system.mass.concat(), &system.forcing].concat();
        cheapest_derivatives(graph, links, &system.inverse_dynamics, symbols, &beside).concat()
    }

    /// The equations of motion in coordinates and quasi-velocities, for each choice of these that is known, and in the cosine
    /// of an angle, where it moves alone in a potential with poles.
    pub fn first_order_equations(
        &self,
        model: &mut Model,
        equations: &Equations,
    ) -> Vec<FirstOrderEquations> {
        let forces = &equations.generalized_forces;
        let choices = self.boltzmann_hamel.iter();
        let choices = choices.map(|choice| choice.equations(&mut model.graph, forces).into());
        let mut choices: Vec<_> = choices.collect();
        if self.constraints.is_empty() {
            choices.extend(motion_of_cosine::equations(model, equations));
        }
        choices
    }

    /// Whether the Taylor series of a motion are to be solved for with pivoting: where constraints may come to depend on each
    /// other, where the factors are not stable everywhere, or where a coordinate may lose its inertia, which a constraint replaces.
    pub fn needs_pivoting(&self, graph: &mut Graph) -> bool {
        let Some(solution) = &self.solution else {
            return false;
        };
        let coordinates = self.mass.len();
        let divisors = solution.divisors(graph);
        let mut of_coordinates = divisors
            .iter()
            .filter(|pivot| pivot.coordinates.iter().all(|i| *i < coordinates));
        !self.constraints.is_empty()
            && (self.constraints.len() > 1
                || solution.is_stable_in_part()
                || of_coordinates.any(|pivot| !graph.never_comes_to_vanish(pivot.value)))
    }

    /// The equations of motion as M q̈ − f = 0, by each known way to compute this.
    pub fn implicit_equations(
        &self,
        model: &mut Model,
        equations: &Equations,
    ) -> Vec<ImplicitEquations> {
        let graph = &mut model.graph;
        let Some(solution) = &self.solution else {
            return vec![ImplicitEquations {
                residuals: self.system.inverse_dynamics.clone(),
                solution: Vec::new(),
            }];
        };
        let lagrange = &equations.inverse_dynamics;
        let mut residuals = vec![self.inverse_dynamics.clone(), lagrange.clone()];
        if !self.constraints.is_empty() {
            let residuals = residuals.iter_mut();
            residuals.for_each(|residuals| {
                *residuals = self.constraints.residuals(graph, residuals);
            });
        }
        residuals.dedup();
        let costs = residuals.iter().map(|residuals| graph.cost(residuals));
        let least = costs.min().unwrap_or(0);
        residuals.retain(|residuals| graph.cost(residuals) <= SCHEDULING_MARGIN * least);
        let in_differences = (model.coordinates <= MAX_EXPANDED_COORDINATES
            && self.constraints.is_empty())
        .then(|| in_angle_differences(graph, lagrange));
        let in_differences = in_differences.flatten();
        solution.implicit_equations(graph, residuals, in_differences)
    }
}

/// The solutions through the factors of M, or of the matrix of a saddle point problem. There as many pivots as there are
/// `coordinates` are positive where M is, and those of the multipliers negative; their opposites are the pivots.
fn ldlt_solvers(graph: &mut Graph, system: &LinearSystem, coordinates: usize) -> Vec<Solver> {
    let matrix = &system.mass;
    let mut factors = vec![Ldlt::factor(graph, matrix, MAX_PIVOT_NEIGHBOURS)];
    if matrix.len() > coordinates {
        factors.push(Ldlt::factor_by_pattern(graph, matrix, coordinates));
    }
    let mut solvers = Vec::with_capacity(factors.len());
    for ldlt in factors.into_iter().flatten() {
        let ldlt = ldlt.with_negative_pivots(graph, matrix, coordinates);
        solvers.extend(ldlt.map(|ldlt| Solver::Ldlt(ldlt, system.forcing.clone())));
    }
    solvers
}

/// The equations along the links of a mechanism, if the model is one and they are Lagrange's.
fn link_equations(model: &mut Model, equations: &Equations) -> Option<LinkEquations> {
    if !model.graph.passes.has(Pass::ArticulatedBodies) {
        return None;
    }
    let mut mechanism = Mechanism::read(model)?;
    let properties = &equations.coordinate_properties;
    if properties.has_ignorable(&model.graph, &equations.inverse_dynamics) {
        mechanism = mechanism.with_spins(&model.graph);
    }
    let links = LinkEquations::of_mechanism(model, mechanism, &equations.generalized_forces);
    let graph = &mut model.graph;
    let found = links.inverse_dynamics(graph);
    agree(graph, &found, &equations.inverse_dynamics).then_some(links)
}

/// The solvers by as many quasi-velocities as there are coordinates.
fn boltzmann_hamel_solvers(
    model: &mut Model,
    equations: &Equations,
    declared: Option<QuasiVelocities>,
) -> Vec<BoltzmannHamel> {
    let passes = model.graph.passes;
    if !passes.has(Pass::QuasiVelocities) {
        return Vec::new();
    }
    let combined = declared
        .as_ref()
        .and_then(|declared| declared.combined(&mut model.graph));
    let mut choices: Vec<_> = declared.into_iter().chain(combined).collect();
    if model.coordinates <= MAX_EXPANDED_COORDINATES && passes.has(Pass::RecoveredForms) {
        choices.extend(QuasiVelocities::recovered(&mut model.graph, equations));
    }
    choices.dedup_by(|a, b| a.forms == b.forms && a.inertia == b.inertia);
    let mut solvers = Vec::new();
    for choice in choices {
        let found = BoltzmannHamel::new(model, choice, &equations.generalized_forces);
        solvers.extend(found);
    }
    solvers
}

/// Residuals with functions of sums and differences of angles, where there are such.
fn in_angle_differences(graph: &mut Graph, residuals: &[Expression]) -> Option<Vec<Expression>> {
    let mut is_changed = false;
    let mut changed = Vec::with_capacity(residuals.len());
    for residual in residuals {
        let other = graph.with_angle_differences(*residual);
        is_changed |= other.is_some();
        changed.push(other.unwrap_or(*residual));
    }
    is_changed.then_some(changed)
}
