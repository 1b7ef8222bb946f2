//! The derivatives of q̈ by positions and velocities along the links, without the solution of M x = r for each of them (Jain and
//! Rodriguez, Linearization of manipulator dynamics using spatial operators, 1993; Carpentier and Mansard, Analytical
//! derivatives of rigid body dynamics algorithms, 2018).
//!
//! A change of one coordinate perturbs the motion of the first link that it moves. What is behind gives way like an articulated
//! body, so that the force that the perturbation takes there is that of one articulated-body inertia and one
//! [matrix for the velocities](crate::mechanics::solvers::articulated_coriolis). The coordinates behind respond to the motion of
//! the link: a row for each goes towards the root. All others respond to the force: the [response of the
//! link](crate::mechanics::solvers::link_responses) to a unit force at each of them comes from the root. So an entry takes two
//! products of vectors, however many links are between.

use std::collections::{BTreeMap, BTreeSet};

use crate::mechanics::mechanism::{difference, kept};
use crate::mechanics::solvers::articulated_links::ArticulatedLinks;
use crate::mechanics::solvers::link_derivatives::DerivativeTerms;
use crate::mechanics::solvers::link_responses::LinkResponses;
use crate::mechanics::solvers::link_vectors::Accelerations;
use crate::mechanics::solvers::perturbation_forces::{
    Column, Forces, JointSteps, Meeting, PassedJoint, coordinates_before, steps_of_joints,
};
use crate::mechanics::solvers::twist_elimination::{Step, Unknown};
use crate::{Expression, Graph, Rational, Symbol};

impl ArticulatedLinks {
    /// The derivatives of q̈, column by column; none where eliminations do not follow the links. Those by inputs are taken from
    /// M⁻¹ where that costs less than a solution for each.
    pub(crate) fn derivatives(
        &self,
        graph: &mut Graph,
        symbols: &[Symbol],
    ) -> Option<Vec<Expression>> {
        let are_inputs = symbols.iter().all(|x| matches!(x, Symbol::Input(_)));
        let entries = Entries::new(graph, self, !are_inputs)?;
        let columns = self.columns(graph, symbols, &entries).concat();
        if are_inputs {
            let solved = self.solved_columns(graph, symbols).concat();
            if graph.cost(&solved) <= graph.cost(&columns) {
                return Some(solved);
            }
        }
        Some(columns)
    }

    /// From the entries for the state and M⁻¹; by what links depend on otherwise, a solution.
    fn columns(
        &self,
        graph: &mut Graph,
        symbols: &[Symbol],
        entries: &Entries,
    ) -> Vec<Vec<Expression>> {
        let others = self.equations.residuals_of_others(graph);
        let slopes = graph.jacobian(&others, symbols);
        let mut columns = Vec::with_capacity(symbols.len());
        for (symbol, slopes) in symbols.iter().zip(slopes) {
            let is_known = matches!(
                symbol,
                Symbol::Coordinate(_) | Symbol::Velocity(_) | Symbol::Input(_)
            );
            if is_known {
                let rows = 0..slopes.len();
                let column = rows.map(|row| entries.sum(graph, *symbol, row, &slopes));
                columns.push(column.collect());
            } else {
                columns.extend(self.solved_columns(graph, &[*symbol]));
            }
        }
        columns
    }

    /// −M⁻¹ ∂(M q̈ − f)/∂x.
    fn solved_columns(&self, graph: &mut Graph, symbols: &[Symbol]) -> Vec<Vec<Expression>> {
        let residuals = self.equations.inverse_dynamics(graph);
        let slopes = graph.jacobian(&residuals, symbols);
        let columns = slopes.into_iter().map(|slopes| {
            let right: Vec<_> = slopes.into_iter().map(|x| graph.negate(x)).collect();
            self.solution(graph, &right)
        });
        columns.collect()
    }
}

/// The terms of the derivatives.
struct Entries {
    terms: DerivativeTerms,
    /// Entries of M⁻¹, on one side of the diagonal.
    inverse: BTreeMap<(usize, usize), Expression>,
}

impl Entries {
    /// The entries, of M⁻¹ alone unless `with_state`.
    fn new(graph: &mut Graph, solver: &ArticulatedLinks, with_state: bool) -> Option<Self> {
        let steps = steps_of_joints(solver)?;
        let needed = coordinates_before(solver, &steps)?;
        let joints = Forces::new(graph, solver, with_state).joints(graph, &steps);
        let mut entries = Self {
            terms: DerivativeTerms::new(),
            inverse: BTreeMap::new(),
        };
        entries.collect(graph, solver, &steps, &needed, &joints);
        Some(entries)
    }

    /// ∂q̈/∂x of a coordinate, where what no link has depends on x by these derivatives of M q̈ − f.
    fn sum(
        &self,
        graph: &mut Graph,
        symbol: Symbol,
        row: usize,
        others: &[Expression],
    ) -> Expression {
        let terms = self.terms.get(&(symbol, row)).cloned();
        let mut terms = terms.unwrap_or_default();
        for (coordinate, slope) in others.iter().enumerate() {
            if graph.is_zero(*slope) {
                continue;
            }
            let entry = self.inverse.get(&(row, coordinate));
            let entry = entry.or_else(|| self.inverse.get(&(coordinate, row)));
            if let Some(entry) = entry {
                let entry = kept(graph, *entry);
                terms.push((graph.multiply(entry, *slope), Rational::MINUS_ONE));
            }
        }
        graph.sum(terms)
    }

    fn enter(&mut self, column: &Column, row: usize, value: Expression) {
        let terms = self.terms.entry((column.symbol, row)).or_default();
        terms.push((value, Rational::MINUS_ONE));
    }

    /// Goes from the root to the leaves, with the responses of each link.
    fn collect(
        &mut self,
        graph: &mut Graph,
        solver: &ArticulatedLinks,
        steps: &[JointSteps<'_>],
        needed: &[BTreeSet<usize>],
        joints: &[PassedJoint],
    ) {
        let mechanism = &solver.equations.mechanism;
        let mut all: Vec<LinkResponses> = Vec::with_capacity(steps.len());
        for (i, joint) in steps.iter().enumerate() {
            let parent = mechanism.links[i].parent;
            let mut responses = parent.map_or_else(LinkResponses::default, |p| all[p].clone());
            // Coordinates behind the link before, and not behind this one.
            let own = |coordinate| {
                joints[i]
                    .passed
                    .iter()
                    .any(|row| row.coordinate == coordinate)
            };
            responses
                .to_coordinates
                .retain(|coordinate, _| !own(*coordinate));
            responses.undo(graph, joint.shift);
            responses.retain(i, &needed[i]);
            for step in joint.sliding.iter().rev() {
                responses.undo(graph, step);
                self.enter_inverse(step, &responses);
            }
            self.meet(graph, &joints[i].sliding, &responses);
            responses.undo(graph, joint.turn);
            for step in joint.turning.iter().rev() {
                responses.undo(graph, step);
                self.enter_inverse(step, &responses);
            }
            self.meet(graph, &joints[i].turning, &responses);
            let is_next = |j: &usize| mechanism.links[*j].parent == Some(i);
            let next: Vec<_> = (i + 1..steps.len()).filter(is_next).collect();
            if next.len() > 1 {
                for row in next.iter().flat_map(|j| &joints[*j].passed) {
                    responses.begin_behind(graph, row.coordinate, &row.forces);
                }
            }
            all.push(responses);
        }
    }

    /// The accelerations of a coordinate under unit forces at others.
    fn enter_inverse(&mut self, step: &Step, responses: &LinkResponses) {
        let Step::Eliminate(row) = step else {
            return;
        };
        let own = Unknown::Coordinate(row.coordinate);
        for (coordinate, response) in &responses.to_coordinates {
            if let Some(value) = response.values.get(&own) {
                self.inverse.insert((*coordinate, row.coordinate), *value);
            }
        }
    }

    /// Columns meet the rows of coordinates behind the joint, and the responses to forces at others.
    fn meet(&mut self, graph: &mut Graph, meeting: &Meeting, responses: &LinkResponses) {
        for column in &meeting.columns {
            for (coordinate, response) in &responses.to_coordinates {
                let value = column.forces.power(graph, response);
                self.enter(column, *coordinate, value);
            }
            if meeting.rows.is_empty() {
                continue;
            }
            let mut motion = Accelerations {
                values: responses.to_forces(graph, &column.forces.0),
            };
            for (unknown, value) in &mut motion.values {
                let change = column.perturbation.values.get(unknown);
                let change = change.copied().unwrap_or(graph.zero());
                *value = difference(graph, change, *value);
            }
            for row in &meeting.rows {
                let motion = row.forces.power(graph, &motion);
                let turning = row.of_turning.into_iter().zip(column.turning);
                let turning = graph.sum_of_products(turning);
                let value = graph.add(motion, turning);
                self.enter(column, row.coordinate, value);
            }
        }
    }
}
