//! How the links of a mechanism respond to forces: their accelerations and those of coordinates under unit forces at links and
//! at coordinates (Kreutz-Delgado, Jain and Rodriguez, Recursive formulation of operational space control, 1992: the
//! extended operational-space inertia, its inverse computed from the root to the leaves).
//!
//! The responses at a link are a symmetric matrix, which goes from link to link by the steps of the elimination, undone; so
//! does the response to a force at a coordinate, one row of it, from where this coordinate was eliminated.

use std::collections::{BTreeMap, BTreeSet};

use crate::matrix::symmetric_elimination::SymmetricElimination;
use crate::mechanics::mechanism::{inner, kept, total};
use crate::mechanics::solvers::link_vectors::{Accelerations, RightHandSide};
use crate::mechanics::solvers::twist_elimination::{
    EliminatedRow, Slope, Step, Unknown, angular, linear,
};
use crate::{Expression, Graph, Rational};

/// The responses at one link.
#[derive(Clone, Default)]
pub(crate) struct LinkResponses {
    /// To unit forces at the unknowns themselves.
    matrix: SymmetricElimination<Unknown>,
    /// To a unit force at each coordinate that is not behind the link.
    pub(crate) to_coordinates: BTreeMap<usize, Accelerations>,
}

impl LinkResponses {
    /// The response to forces.
    pub(crate) fn to_forces(
        &self,
        graph: &mut Graph,
        forces: &BTreeMap<Unknown, Expression>,
    ) -> BTreeMap<Unknown, Expression> {
        let mut response = BTreeMap::new();
        for (unknown, row) in self.matrix.rows() {
            let pairs = forces
                .iter()
                .filter_map(|(v, force)| Some((*row.get(v)?, *force)));
            response.insert(*unknown, inner(graph, pairs));
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
        let is_needed = |unknown: Unknown| match unknown {
            Unknown::Coordinate(i) => coordinates.contains(&i),
            Unknown::Twist(i, _) => i == link,
        };
        let needed = |unknown| is_needed(unknown).then_some(unknown);
        self.matrix = self.matrix.renamed(needed);
        for response in self.to_coordinates.values_mut() {
            response.values.retain(|unknown, _| is_needed(*unknown));
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
            Step::Turn(link, turn) => self.matrix.turn(graph, *link, &turn.inverse()),
            Step::Shift(link, Some(parent), place) => {
                let next = |unknown: Unknown| Some(unknown.moved(*parent, *link));
                self.matrix = self.matrix.renamed(next);
                let parts = [angular(*link), linear(*link)];
                self.matrix
                    .add_levers(graph, parts, |graph, turning| graph.cross(turning, *place));
            }
            Step::Shift(_, None, _) => self.matrix = SymmetricElimination::default(),
        }
    }

    /// x := x + e q̈.
    fn undo_split(&mut self, graph: &mut Graph, slope: &Slope) {
        let own = Unknown::Coordinate(slope.coordinate);
        let moves = |v: &Unknown| slope.along.iter().any(|(u, _)| u == v);
        let others: Vec<_> = self.matrix.unknowns().filter(|v| !moves(v)).collect();
        let square = self.matrix.entry(graph, own, own);
        let along = slope.along.iter();
        let along: Vec<_> = along
            .map(|(u, e)| (*u, *e, self.matrix.entry(graph, own, *u)))
            .collect();
        for v in others {
            let rate = self.matrix.entry(graph, own, v);
            for (u, e, _) in &along {
                let change = graph.multiply(*e, rate);
                let sum = graph.add(self.matrix.entry(graph, *u, v), change);
                let sum = if v == own { sum } else { kept(graph, sum) };
                self.matrix.set(graph, *u, v, sum);
            }
        }
        for (i, (u, e, across)) in along.iter().enumerate() {
            for (v, other, other_across) in &along[i..] {
                let squared = graph.multiply(*e, *other);
                let changes = [
                    self.matrix.entry(graph, *u, *v),
                    graph.multiply(*e, *other_across),
                    graph.multiply(*other, *across),
                    graph.multiply(squared, square),
                ];
                let sum = total(graph, &changes);
                self.matrix.set(graph, *u, *v, sum);
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
        for v in self.matrix.unknowns().collect::<Vec<_>>() {
            let pairs = others
                .iter()
                .map(|(u, _, ratio)| (*ratio, self.matrix.entry(graph, *u, v)));
            let pairs: Vec<_> = pairs.collect();
            let sum = inner(graph, pairs);
            sums.insert(v, sum);
            let mut terms = vec![(sum, Rational::MINUS_ONE)];
            for (u, ..) in &units {
                terms.push((self.matrix.entry(graph, *u, v), Rational::MINUS_ONE));
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
                terms.push((self.matrix.entry(graph, *u, *v), Rational::ONE));
            }
        }
        let square = graph.sum(terms);
        values.insert(own, square);
        for (v, value) in &values {
            self.matrix.set(graph, own, *v, *value);
        }
        self.to_coordinates
            .insert(row.coordinate, Accelerations { values });
    }
}
