//! The derivatives of inverse dynamics by positions and velocities along the links (Carpentier and Mansard, Analytical
//! derivatives of rigid body dynamics algorithms, 2018; Singh, Russell and Wensing, Efficient analytical derivatives of rigid-body
//! dynamics using spatial vector algebra, 2022).
//!
//! A change of one coordinate perturbs the motion of the first link that it moves; what is behind follows as a rigid body. So
//! each joint gives a column, the change of the wrench on all that it carries, and a row, the power of that change at its own
//! rate. Both go towards the root, where the columns meet the rates of other joints, and the rows the perturbations
//! by other coordinates: a few products for each pair, however many links are between them.
//!
//! Where a joint slides and turns, it slides first, seen from the link before.

use std::collections::BTreeMap;

use crate::limits::MAX_DIFFERENTIATED_BOTH_WAYS;
use crate::mechanics::mechanism::{Inertia, Vector, total};
use crate::mechanics::solvers::coriolis_matrix::CoriolisMatrix;
use crate::mechanics::solvers::joint_perturbations::{JointPerturbations, symbols};
use crate::mechanics::solvers::link_equations::LinkEquations;
use crate::mechanics::solvers::newton_euler::JointPart;
use crate::mechanics::solvers::spatial_vectors::Wrench;
use crate::{Expression, Graph, Rational, Symbol};

/// The derivatives of M q̈ − f, column by column: along the links of a mechanism, unless there are few coordinates and
/// the general derivatives cost less beside other expressions of the same program.
pub(crate) fn cheapest_derivatives(
    graph: &mut Graph,
    links: Option<&LinkEquations>,
    residuals: &[Expression],
    symbols: &[Symbol],
    beside: &[Expression],
) -> Vec<Vec<Expression>> {
    // The links know no inputs.
    let are_inputs = symbols.iter().all(|x| matches!(x, Symbol::Input(_)));
    let Some(links) = links.filter(|_| !are_inputs) else {
        return graph.jacobian(residuals, symbols);
    };
    let along_links = links.derivatives(graph, symbols);
    if residuals.len() > MAX_DIFFERENTIATED_BOTH_WAYS {
        return along_links;
    }
    let columns = graph.jacobian(residuals, symbols);
    let cost = |columns: &[Vec<Expression>]| graph.cost(&[beside, &columns.concat()].concat());
    if cost(&along_links) < cost(&columns) {
        along_links
    } else {
        columns
    }
}

impl LinkEquations {
    /// The derivatives of M q̈ − f by the symbols, column by column, with the accelerations as symbols.
    fn derivatives(&self, graph: &mut Graph, symbols: &[Symbol]) -> Vec<Vec<Expression>> {
        let others = self.residuals_of_others(graph);
        let mut columns = graph.jacobian(&others, symbols);
        let entries = DerivativesAlongLinks::new(graph, self).entries(graph);
        let mut residuals = None;
        for (column, symbol) in columns.iter_mut().zip(symbols) {
            if !matches!(symbol, Symbol::Coordinate(_) | Symbol::Velocity(_)) {
                let residuals = residuals.get_or_insert_with(|| self.inverse_dynamics(graph));
                *column = graph.derivatives(residuals, *symbol);
                continue;
            }
            for (row, value) in column.iter_mut().enumerate() {
                let terms = entries.get(&(*symbol, row)).into_iter().flatten().cloned();
                *value = graph.sum(terms.chain([(*value, Rational::ONE)]));
            }
        }
        columns
    }
}

/// The terms of derivatives by coordinates and velocities, each with its row.
pub(crate) type DerivativeTerms = BTreeMap<(Symbol, usize), Vec<(Expression, Rational)>>;

/// What is carried towards the root.
#[derive(Clone, Default)]
struct Carried {
    rows: Vec<Row>,
    columns: Vec<Column>,
}

/// The power of a change of the wrench on what a coordinate moves, at the rate of this coordinate.
#[derive(Clone)]
struct Row {
    coordinate: usize,
    /// The coefficients of 2 δω.
    of_turning: Vector,
    /// The coefficients of δβ and δa: the momentum at unit rate.
    momentum: Wrench,
}

/// The change of the wrench by a coordinate or a velocity.
#[derive(Clone)]
struct Column {
    symbol: Symbol,
    wrench: Wrench,
}

/// All that is behind a joint.
#[derive(Clone)]
struct Body {
    inertia: Inertia,
    coriolis: CoriolisMatrix,
    /// The wrench on it.
    wrench: Wrench,
}

struct DerivativesAlongLinks<'a> {
    equations: &'a LinkEquations,
    perturbations: JointPerturbations<'a>,
    bodies: Vec<Body>,
    entries: DerivativeTerms,
}

impl<'a> DerivativesAlongLinks<'a> {
    fn new(graph: &mut Graph, equations: &'a LinkEquations) -> Self {
        let perturbations = JointPerturbations::new(graph, equations);
        let wrenches = equations.wrenches(graph, true);
        let links = equations.mechanism.links.iter();
        let all = links.zip(&perturbations.motions).zip(wrenches);
        let bodies = all.map(|((link, motion), wrench)| Body {
            coriolis: CoriolisMatrix::of(graph, &link.inertia, motion.angular_velocity),
            inertia: link.inertia.clone(),
            wrench,
        });
        Self {
            bodies: bodies.collect(),
            perturbations,
            equations,
            entries: DerivativeTerms::new(),
        }
    }

    fn entries(mut self, graph: &mut Graph) -> DerivativeTerms {
        let equations = self.equations;
        let mut all: Vec<Carried> = vec![Carried::default(); self.bodies.len()];
        for (i, link, joint) in equations.inward() {
            let mut carried = core::mem::take(&mut all[i]);
            self.pass(graph, i, JointPart::Turning, &mut carried);
            if link.parent.is_none() && joint.sliding.is_empty() {
                continue;
            }
            self.turn(graph, i, &mut carried);
            self.pass(graph, i, JointPart::Sliding, &mut carried);
            let Some(parent) = link.parent else {
                continue;
            };
            self.shift(graph, i, &mut carried);
            let before = &mut all[parent];
            before.rows.append(&mut carried.rows);
            before.columns.append(&mut carried.columns);
        }
        self.entries
    }

    fn enter(&mut self, symbol: Symbol, row: usize, value: Expression) {
        let terms = self.entries.entry((symbol, row)).or_default();
        terms.push((value, Rational::ONE));
    }

    /// Passes a part of a joint.
    fn pass(&mut self, graph: &mut Graph, index: usize, part: JointPart, carried: &mut Carried) {
        let equations = self.equations;
        let slopes = equations.joints[index].slopes(part);
        let body = self.bodies[index].clone();
        let mut columns = Vec::new();
        for slope in slopes {
            let changes = self.perturbations.at(graph, index, part, *slope);
            for (symbol, change) in symbols(slope.0).into_iter().zip(&changes) {
                for row in &carried.rows {
                    let value = change.times(graph, row.of_turning, &row.momentum);
                    self.enter(symbol, row.coordinate, value);
                }
                columns.push(Column {
                    symbol,
                    wrench: body.coriolis.wrench(graph, &body.inertia, change),
                });
            }
        }
        carried.columns.append(&mut columns);
        for (coordinate, slope) in slopes {
            for column in &carried.columns {
                let value = slope.power(graph, &column.wrench);
                self.enter(column.symbol, *coordinate, value);
            }
            carried.rows.push(Row {
                coordinate: *coordinate,
                of_turning: body.coriolis.power(graph, slope),
                momentum: body.inertia.momentum(graph, slope),
            });
        }
        // Where the direction of a rate depends on the coordinates.
        for (row, slope) in slopes {
            for (coordinate, _) in slopes {
                let [symbol, _] = symbols(*coordinate);
                let change = slope.derivative(graph, symbol);
                let value = change.power(graph, &body.wrench);
                self.enter(symbol, *row, value);
            }
        }
        // What the joint carries along with it.
        for (coordinate, slope) in slopes {
            let own = |column: &&mut Column| column.symbol == symbols(*coordinate)[0];
            if let Some(column) = carried.columns.iter_mut().rev().find(own) {
                let change = slope.rate_of(graph, &body.wrench);
                column.wrench = column.wrench.plus(graph, change);
            }
        }
    }

    /// Along the axes of the link before.
    fn turn(&mut self, graph: &mut Graph, index: usize, carried: &mut Carried) {
        let turn = self.equations.mechanism.links[index].turn;
        for row in &mut carried.rows {
            row.momentum = row.momentum.turned(graph, &turn);
        }
        for column in &mut carried.columns {
            column.wrench = column.wrench.turned(graph, &turn);
        }
        let body = &mut self.bodies[index];
        body.wrench = body.wrench.turned(graph, &turn);
        body.inertia = body.inertia.turned(graph, &turn);
        body.coriolis = body.coriolis.turned(graph, &turn);
        for row in &mut carried.rows {
            row.of_turning = turn.outward(graph, row.of_turning);
        }
    }

    /// About the origin of the link before.
    fn shift(&mut self, graph: &mut Graph, index: usize, carried: &mut Carried) {
        let equations = self.equations;
        let link = &equations.mechanism.links[index];
        let Some(parent) = link.parent else {
            return;
        };
        let speed = self.perturbations.speed(graph, index);
        for row in &mut carried.rows {
            let change = graph.cross(speed, row.momentum.force);
            let before = row.of_turning;
            row.of_turning = [0, 1, 2].map(|i| total(graph, &[before[i], change[i]]));
            row.momentum = row.momentum.moved(graph, link.place);
        }
        for column in &mut carried.columns {
            column.wrench = column.wrench.moved(graph, link.place);
        }
        let Body {
            inertia,
            coriolis,
            wrench,
        } = self.bodies[index].clone();
        let coriolis = coriolis.moved(graph, &inertia, link.place, speed);
        let mut inertia = inertia.moved(graph, link.place);
        inertia.keep(graph);
        let wrench = wrench.moved(graph, link.place);
        let before = &mut self.bodies[parent];
        before.inertia.add(graph, &inertia);
        before.inertia.keep(graph);
        before.coriolis.add(graph, &coriolis);
        before.wrench = before.wrench.plus(graph, wrench);
    }
}
