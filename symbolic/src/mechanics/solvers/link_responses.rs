//! How the links of a mechanism respond to forces: their accelerations and those of coordinates under unit forces at links and
//! at coordinates (Kreutz-Delgado, Jain and Rodriguez, Recursive formulation of operational space control, 1992: the
//! extended operational-space inertia, its inverse computed from the root to the leaves).
//!
//! The responses at a link are a symmetric matrix, which goes from link to link by the steps of the elimination, undone; so
//! does the response to a force at a coordinate, one row of it, from where this coordinate was eliminated.

use std::collections::{BTreeMap, BTreeSet};

use crate::mechanics::mechanism::{Turn, Vector, kept, total};
use crate::mechanics::solvers::link_vectors::{Accelerations, RightHandSide};
use crate::mechanics::solvers::twist_elimination::{
    EliminatedRow, InertiaRow, Slope, Step, Unknown, angular, linear,
};
use crate::{Expression, Graph, Rational};

/// The responses at one link.
#[derive(Clone, Default)]
pub(crate) struct LinkResponses {
    /// To unit forces at the unknowns themselves.
    matrix: BTreeMap<Unknown, InertiaRow>,
    /// To a unit force at each coordinate that is not behind the link.
    pub(crate) to_coordinates: BTreeMap<usize, Accelerations>,
}

impl LinkResponses {
    fn entry(&self, graph: &Graph, u: Unknown, v: Unknown) -> Expression {
        let entry = self.matrix.get(&u).and_then(|row| row.get(&v));
        entry.copied().unwrap_or(graph.zero())
    }

    fn set(&mut self, u: Unknown, v: Unknown, value: Expression) {
        for (x, y) in [(u, v), (v, u)] {
            self.matrix.entry(x).or_default().insert(y, value);
        }
    }

    fn block(&self, graph: &Graph, rows: [Unknown; 3], columns: [Unknown; 3]) -> [Vector; 3] {
        rows.map(|u| columns.map(|v| self.entry(graph, u, v)))
    }

    fn coordinates(&self) -> Vec<Unknown> {
        let is_coordinate = |u: &Unknown| matches!(u, Unknown::Coordinate(_));
        self.matrix.keys().copied().filter(is_coordinate).collect()
    }

    /// The response to forces.
    pub(crate) fn to_forces(
        &self,
        graph: &mut Graph,
        forces: &BTreeMap<Unknown, Expression>,
    ) -> BTreeMap<Unknown, Expression> {
        let mut response = BTreeMap::new();
        for (unknown, row) in &self.matrix {
            let pairs = forces
                .iter()
                .filter_map(|(v, force)| Some((*row.get(v)?, *force)));
            let sum = graph.sum_of_products(pairs);
            response.insert(*unknown, kept(graph, sum));
        }
        response
    }

    /// The response to a unit force at a coordinate behind the link, from which this comes here with the opposite sign.
    pub(crate) fn begin_behind(
        &mut self,
        graph: &mut Graph,
        coordinate: usize,
        forces: &RightHandSide,
    ) {
        let mut values = self.to_forces(graph, &forces.0);
        for value in values.values_mut() {
            *value = graph.negate(*value);
        }
        self.to_coordinates
            .insert(coordinate, Accelerations { values });
    }

    /// The same without unknowns that no link behind needs.
    pub(crate) fn retain(&mut self, link: usize, coordinates: &BTreeSet<usize>) {
        let is_needed = |unknown: &Unknown| match unknown {
            Unknown::Coordinate(i) => coordinates.contains(i),
            Unknown::Twist(i, _) => *i == link,
        };
        self.matrix.retain(|unknown, row| {
            row.retain(|other, _| is_needed(other));
            is_needed(unknown)
        });
        for response in self.to_coordinates.values_mut() {
            response.values.retain(|unknown, _| is_needed(unknown));
        }
    }

    /// Undoes a step of the elimination.
    pub(crate) fn undo(&mut self, graph: &mut Graph, step: &Step) {
        let none = BTreeMap::new();
        for response in self.to_coordinates.values_mut() {
            response.substitute(graph, step, &none);
        }
        match step {
            Step::SplitOff(slope) => self.undo_split(graph, slope),
            Step::Eliminate(row) => self.undo_elimination(graph, row),
            Step::Turn(link, turn) => self.undo_turn(graph, *link, turn),
            Step::Shift(link, parent, place) => match parent {
                Some(parent) => self.undo_shift(graph, *link, *parent, *place),
                None => self.matrix.clear(),
            },
        }
    }

    /// x := x + e q̈.
    fn undo_split(&mut self, graph: &mut Graph, slope: &Slope) {
        let own = Unknown::Coordinate(slope.coordinate);
        let moves = |v: &Unknown| slope.along.iter().any(|(u, _)| u == v);
        let others: Vec<_> = self.matrix.keys().copied().filter(|v| !moves(v)).collect();
        let square = self.entry(graph, own, own);
        let along = slope.along.iter();
        let along: Vec<_> = along
            .map(|(u, e)| (*u, *e, self.entry(graph, own, *u)))
            .collect();
        for v in others {
            let rate = self.entry(graph, own, v);
            for (u, e, _) in &along {
                let change = graph.multiply(*e, rate);
                let sum = graph.add(self.entry(graph, *u, v), change);
                let sum = if v == own { sum } else { kept(graph, sum) };
                self.set(*u, v, sum);
            }
        }
        for (i, (u, e, across)) in along.iter().enumerate() {
            for (v, other, other_across) in &along[i..] {
                let squared = graph.multiply(*e, *other);
                let changes = [
                    self.entry(graph, *u, *v),
                    graph.multiply(*e, *other_across),
                    graph.multiply(*other, *across),
                    graph.multiply(squared, square),
                ];
                self.set(*u, *v, total(graph, &changes));
            }
        }
    }

    /// q̈ = h/D − Σ entries/D · x. What has the coefficient 1 is subtracted from a kept sum, so that it cancels where q̈ is added
    /// to it.
    fn undo_elimination(&mut self, graph: &mut Graph, row: &EliminatedRow) {
        let own = Unknown::Coordinate(row.coordinate);
        let (units, others): (Vec<_>, Vec<_>) = row
            .others
            .iter()
            .partition(|(_, entry, _)| *entry == row.pivot);
        let mut values = BTreeMap::new();
        let mut sums = BTreeMap::new();
        for v in self.matrix.keys().copied().collect::<Vec<_>>() {
            let pairs = others
                .iter()
                .map(|(u, _, ratio)| (*ratio, self.entry(graph, *u, v)));
            let pairs: Vec<_> = pairs.collect();
            let sum = graph.sum_of_products(pairs);
            let sum = kept(graph, sum);
            sums.insert(v, sum);
            let mut terms = vec![(sum, Rational::MINUS_ONE)];
            for (u, ..) in &units {
                terms.push((self.entry(graph, *u, v), Rational::MINUS_ONE));
            }
            values.insert(v, graph.sum(terms));
        }
        let zero = graph.zero();
        let sum_at = |u: &Unknown| sums.get(u).copied().unwrap_or(zero);
        let pairs: Vec<_> = others
            .iter()
            .map(|(u, _, ratio)| (*ratio, sum_at(u)))
            .collect();
        let products = graph.sum_of_products(pairs);
        let square = graph.add(row.reciprocal, products);
        let mut terms = vec![(kept(graph, square), Rational::ONE)];
        for (u, ..) in &units {
            terms.push((sum_at(u), Rational::integer(2)));
            for (v, ..) in &units {
                terms.push((self.entry(graph, *u, *v), Rational::ONE));
            }
        }
        let square = graph.sum(terms);
        values.insert(own, square);
        for (v, value) in &values {
            self.set(own, *v, *value);
        }
        self.to_coordinates
            .insert(row.coordinate, Accelerations { values });
    }

    fn undo_turn(&mut self, graph: &mut Graph, link: usize, turn: &Turn) {
        let (angular, linear) = (angular(link), linear(link));
        for other in self.coordinates() {
            for unknowns in [angular, linear] {
                let vector = unknowns.map(|u| self.entry(graph, u, other));
                let vector = turn.inward(graph, vector);
                for (u, value) in unknowns.into_iter().zip(vector) {
                    self.set(u, other, value);
                }
            }
        }
        let back = turn.inverse();
        for [rows, columns] in [[angular, angular], [linear, linear], [angular, linear]] {
            let block = self.block(graph, rows, columns);
            let block = back.outward_block(graph, block, rows == columns);
            for (u, row) in rows.into_iter().zip(block) {
                for (v, value) in columns.into_iter().zip(row) {
                    self.set(u, v, value);
                }
            }
        }
    }

    /// The acceleration of the origin is that of the origin before, and α × place.
    fn undo_shift(&mut self, graph: &mut Graph, link: usize, parent: usize, place: Vector) {
        let renamed = core::mem::take(&mut self.matrix)
            .into_iter()
            .map(|(u, row)| {
                let row = row.into_iter().map(|(v, x)| (v.moved(parent, link), x));
                (u.moved(parent, link), row.collect())
            });
        self.matrix = renamed.collect();
        let (angular, linear) = (angular(link), linear(link));
        for other in self.coordinates() {
            let turning = angular.map(|u| self.entry(graph, u, other));
            let lever = graph.cross(turning, place);
            for (u, change) in linear.into_iter().zip(lever) {
                let sum = graph.add(self.entry(graph, u, other), change);
                let sum = kept(graph, sum);
                self.set(u, other, sum);
            }
        }
        let turning = self.block(graph, angular, angular);
        let before = self.block(graph, angular, linear);
        let mut after = before;
        for i in 0..3 {
            let lever = graph.cross(turning[i], place);
            after[i] = [0, 1, 2].map(|j| {
                let sum = graph.add(before[i][j], lever[j]);
                kept(graph, sum)
            });
        }
        for i in 0..3 {
            let first = graph.cross(before.map(|row| row[i]), place);
            for j in i..3 {
                // The origin before along i, moved along j, and moved along i with the origin behind along j.
                let moved = graph.cross(after.map(|row| row[j]), place)[i];
                let terms = [self.entry(graph, linear[i], linear[j]), first[j], moved];
                let sum = graph.sum(terms.map(|x| (x, Rational::ONE)));
                let sum = kept(graph, sum);
                self.set(linear[i], linear[j], sum);
            }
        }
        for i in 0..3 {
            for j in 0..3 {
                self.set(angular[i], linear[j], after[i][j]);
            }
        }
    }
}
