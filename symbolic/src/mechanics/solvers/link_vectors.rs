//! Vectors in the unknowns of an elimination along links: forces, which go towards the root, and accelerations, which come
//! back (Featherstone, The calculation of robot dynamics using articulated-body inertias, 1983).

use std::collections::BTreeMap;

use crate::mechanics::mechanism::{Turn, Vector, difference, kept, total};
use crate::mechanics::solvers::spatial_vectors::Wrench;
use crate::mechanics::solvers::twist_elimination::{
    EliminatedRow, InertiaRow, Slope, Step, Unknown, angular, linear, twist,
};
use crate::{Expression, Graph, Rational};

#[derive(Clone, Default)]
/// The right-hand side h of ½ xᵀ H x − hᵀ x.
pub(crate) struct RightHandSide(pub(crate) BTreeMap<Unknown, Expression>);

impl RightHandSide {
    pub(crate) fn of(forces: &[Expression]) -> Self {
        let forces = forces.iter().enumerate();
        Self(forces.map(|(i, x)| (Unknown::Coordinate(i), *x)).collect())
    }

    pub(crate) fn get(&self, graph: &Graph, unknown: Unknown) -> Expression {
        self.0.get(&unknown).copied().unwrap_or(graph.zero())
    }

    pub(crate) fn vector(&self, graph: &Graph, unknowns: [Unknown; 3]) -> Vector {
        unknowns.map(|u| self.get(graph, u))
    }

    /// The same with another force at an unknown.
    pub(crate) fn add(&mut self, graph: &mut Graph, unknown: Unknown, force: Expression) {
        let sum = graph.add(self.get(graph, unknown), force);
        self.0.insert(unknown, sum);
    }

    pub(crate) fn add_wrench(&mut self, graph: &mut Graph, link: usize, wrench: &Wrench) {
        for (unknown, force) in twist(link).zip(wrench.components()) {
            self.add(graph, unknown, force);
        }
    }

    /// Adds the forces that accelerations take, by the rows of H at these.
    pub(crate) fn add_products(
        &mut self,
        graph: &mut Graph,
        rows: &[InertiaRow],
        accelerations: &Accelerations,
    ) {
        for (row, acceleration) in rows.iter().zip(accelerations.values.values()) {
            for (unknown, entry) in row {
                let force = graph.multiply(*entry, *acceleration);
                self.add(graph, *unknown, force);
            }
        }
    }

    /// Makes each force an intermediate result.
    pub(crate) fn keep(&mut self, graph: &mut Graph) {
        for force in self.0.values_mut() {
            *force = kept(graph, *force);
        }
    }

    /// The power at rates, or the same products of accelerations.
    pub(crate) fn power(&self, graph: &mut Graph, rates: &Accelerations) -> Expression {
        let pairs = self.0.iter().filter_map(|(unknown, force)| {
            let rate = rates.values.get(unknown)?;
            Some((*force, *rate))
        });
        let pairs: Vec<_> = pairs.collect();
        graph.sum_of_products(pairs)
    }

    /// Takes out the force at an eliminated coordinate, which gives way; its shares by the others' ratios go to these.
    pub(crate) fn give_way(&mut self, graph: &mut Graph, row: &EliminatedRow) -> Expression {
        let own = self.0.remove(&Unknown::Coordinate(row.coordinate));
        let own = own.unwrap_or(graph.zero());
        let force = kept(graph, own);
        for (unknown, entry, ratio) in &row.others {
            let change = if *entry == row.pivot {
                own
            } else {
                graph.multiply(*ratio, force)
            };
            let change = difference(graph, self.get(graph, *unknown), change);
            self.0.insert(*unknown, change);
        }
        force
    }

    fn set(&mut self, unknowns: [Unknown; 3], values: Vector) {
        self.0.extend(unknowns.into_iter().zip(values));
    }

    pub(crate) fn split_off(&mut self, graph: &mut Graph, slope: &Slope) {
        let pairs = slope.along.iter();
        let pairs: Vec<_> = pairs.map(|(u, e)| (*e, self.get(graph, *u))).collect();
        let change = graph.sum_of_products(pairs);
        self.add(graph, Unknown::Coordinate(slope.coordinate), change);
    }

    /// The right-hand side over the pivot.
    pub(crate) fn eliminate(&mut self, graph: &mut Graph, row: &EliminatedRow) -> Expression {
        let own = self.0.remove(&Unknown::Coordinate(row.coordinate));
        let own = own.unwrap_or(graph.zero());
        let force = kept(graph, own);
        let quotient = graph.multiply(force, row.reciprocal);
        let quotient = kept(graph, quotient);
        for (v, entry, _) in &row.others {
            let change = if *entry == row.pivot {
                own
            } else {
                graph.multiply(*entry, quotient)
            };
            let change = difference(graph, self.get(graph, *v), change);
            self.0.insert(*v, change);
        }
        quotient
    }

    pub(crate) fn turn(&mut self, graph: &mut Graph, link: usize, turn: &Turn) {
        for unknowns in [angular(link), linear(link)] {
            let vector = self.vector(graph, unknowns);
            let vector = turn.outward(graph, vector);
            self.set(unknowns, vector);
        }
    }

    pub(crate) fn shift(
        &mut self,
        graph: &mut Graph,
        link: usize,
        parent: Option<usize>,
        place: Vector,
    ) {
        let Some(parent) = parent else {
            return;
        };
        let force = self.vector(graph, linear(link));
        let moment = self.vector(graph, angular(link));
        let lever = graph.cross(place, force);
        let before = self.vector(graph, angular(parent));
        let sum = [0, 1, 2].map(|i| total(graph, &[before[i], moment[i], lever[i]]));
        self.set(angular(parent), sum);
        let before = self.vector(graph, linear(parent));
        let sum = [0, 1, 2].map(|i| total(graph, &[before[i], force[i]]));
        self.set(linear(parent), sum);
    }
}

/// The accelerations found so far.
#[derive(Clone, Default)]
pub(crate) struct Accelerations {
    pub(crate) values: BTreeMap<Unknown, Expression>,
}

impl Accelerations {
    pub(crate) fn get(&self, graph: &Graph, unknown: Unknown) -> Expression {
        self.values.get(&unknown).copied().unwrap_or(graph.zero())
    }

    pub(crate) fn vector(&self, graph: &Graph, unknowns: [Unknown; 3]) -> Vector {
        unknowns.map(|u| self.get(graph, u))
    }

    fn set(&mut self, unknowns: [Unknown; 3], values: Vector) {
        self.values.extend(unknowns.into_iter().zip(values));
    }

    /// Undoes a step with the values that are known then.
    pub(crate) fn substitute(
        &mut self,
        graph: &mut Graph,
        step: &Step,
        quotients: &BTreeMap<usize, Expression>,
    ) {
        match step {
            Step::Shift(link, parent, place) => {
                let Some(parent) = parent else {
                    return;
                };
                let turning = self.vector(graph, angular(*parent));
                let before = self.vector(graph, linear(*parent));
                let lever = graph.cross(turning, *place);
                let moved = [0, 1, 2].map(|i| total(graph, &[before[i], lever[i]]));
                self.set(angular(*link), turning);
                self.set(linear(*link), moved);
            }
            Step::Turn(link, turn) => {
                for unknowns in [angular(*link), linear(*link)] {
                    let vector = self.vector(graph, unknowns);
                    let vector = turn.inward(graph, vector);
                    self.set(unknowns, vector);
                }
            }
            Step::Eliminate(row) => self.eliminate(graph, row, quotients),
            Step::SplitOff(slope) => {
                let rate = self.get(graph, Unknown::Coordinate(slope.coordinate));
                for (unknown, e) in &slope.along {
                    let change = graph.multiply(*e, rate);
                    let sum = graph.add(self.get(graph, *unknown), change);
                    self.values.insert(*unknown, kept(graph, sum));
                }
            }
        }
    }

    /// q̈ = h/D − Σ entries/D · x, with what has the coefficient 1 subtracted last: the sum before it is the total
    /// acceleration about the axis.
    pub(crate) fn eliminate(
        &mut self,
        graph: &mut Graph,
        row: &EliminatedRow,
        quotients: &BTreeMap<usize, Expression>,
    ) {
        let zero = graph.zero();
        let value = |u: &Unknown| self.values.get(u).copied().unwrap_or(zero);
        let quotient = quotients.get(&row.coordinate).copied().unwrap_or(zero);
        let mut terms = vec![(quotient, Rational::ONE)];
        let mut units = Vec::new();
        for (u, entry, ratio) in &row.others {
            if *entry == row.pivot {
                units.push((value(u), Rational::MINUS_ONE));
            } else {
                let product = graph.multiply(*ratio, value(u));
                terms.push((product, Rational::MINUS_ONE));
            }
        }
        let sum = graph.sum(terms);
        units.push((kept(graph, sum), Rational::ONE));
        let acceleration = graph.sum(units);
        self.values
            .insert(Unknown::Coordinate(row.coordinate), acceleration);
    }
}
