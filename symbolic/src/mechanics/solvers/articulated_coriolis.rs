//! The articulated-body counterpart of the [Coriolis matrix](crate::mechanics::solvers::coriolis_matrix): the wrench that a
//! change 2 δω of all angular velocities behind a joint takes, where the joints behind it give way (Featherstone, The
//! calculation of robot dynamics using articulated-body inertias, 1983; Jain and Rodriguez, Linearization of manipulator
//! dynamics using spatial operators, 1993).
//!
//! The change δω passes joints as that of a rigid body does. Where a coordinate is eliminated, the matrix is changed as a
//! force is; its acceleration then has a share of 2 δω.

use std::collections::BTreeMap;

use crate::mechanics::mechanism::{Turn, Vector, kept, total};
use crate::mechanics::solvers::coriolis_matrix::CoriolisMatrix;
use crate::mechanics::solvers::twist_elimination::{
    EliminatedRow, InertiaRow, Slope, Unknown, angular, linear,
};
use crate::{Expression, Graph};

/// The coefficients of 2 δω, along the axes of a link, in the forces at unknowns.
#[derive(Clone, Default)]
pub(crate) struct ArticulatedCoriolis(BTreeMap<Unknown, Vector>);

impl ArticulatedCoriolis {
    fn get(&self, graph: &Graph, unknown: Unknown) -> Vector {
        let row = self.0.get(&unknown);
        row.copied().unwrap_or([graph.zero(); 3])
    }

    fn block(&self, graph: &Graph, unknowns: [Unknown; 3]) -> [Vector; 3] {
        unknowns.map(|u| self.get(graph, u))
    }

    fn set_block(&mut self, unknowns: [Unknown; 3], rows: [Vector; 3]) {
        self.0.extend(unknowns.into_iter().zip(rows));
    }

    fn increase(&mut self, graph: &mut Graph, unknown: Unknown, change: Vector) {
        let before = self.get(graph, unknown);
        let sum = [0, 1, 2].map(|i| total(graph, &[before[i], change[i]]));
        self.0.insert(unknown, sum);
    }

    /// Adds that of what a link itself carries.
    pub(crate) fn add_link(&mut self, graph: &mut Graph, link: usize, own: &CoriolisMatrix) {
        let rows = own.rows(graph);
        for (unknowns, rows) in [angular(link), linear(link)].into_iter().zip(rows) {
            for (unknown, row) in unknowns.into_iter().zip(rows) {
                self.increase(graph, unknown, row);
            }
        }
    }

    /// Adds another one along the same axes.
    pub(crate) fn add(&mut self, graph: &mut Graph, other: Self) {
        for (unknown, row) in other.0 {
            self.increase(graph, unknown, row);
        }
    }

    /// The forces that a change 2 δω takes.
    pub(crate) fn forces(
        &self,
        graph: &mut Graph,
        turning: Vector,
    ) -> BTreeMap<Unknown, Expression> {
        let mut forces = BTreeMap::new();
        for (unknown, row) in &self.0 {
            let force = graph.sum_of_products(row.iter().copied().zip(turning));
            forces.insert(*unknown, force);
        }
        forces
    }

    /// x := x + e q̈.
    pub(crate) fn split_off(&mut self, graph: &mut Graph, slope: &Slope) {
        let rows = slope.along.iter().map(|(u, e)| (*e, self.get(graph, *u)));
        let rows: Vec<_> = rows.collect();
        let change = [0, 1, 2].map(|i| {
            let pairs = rows.iter().map(|(e, row)| (*e, row[i]));
            graph.sum_of_products(pairs)
        });
        let own = Unknown::Coordinate(slope.coordinate);
        let before = self.get(graph, own);
        self.0
            .insert(own, [0, 1, 2].map(|i| graph.add(before[i], change[i])));
    }

    /// Eliminates a coordinate; the negative share of 2 δω in its acceleration.
    pub(crate) fn eliminate(&mut self, graph: &mut Graph, row: &EliminatedRow) -> Vector {
        let own = self.0.remove(&Unknown::Coordinate(row.coordinate));
        let own = own.unwrap_or([graph.zero(); 3]);
        let quotient = own.map(|x| {
            let x = kept(graph, x);
            let quotient = graph.multiply(x, row.reciprocal);
            kept(graph, quotient)
        });
        for (unknown, entry, _) in &row.others {
            let change = if *entry == row.pivot {
                own
            } else {
                quotient.map(|x| graph.multiply(*entry, x))
            };
            let before = self.get(graph, *unknown);
            let after = [0, 1, 2].map(|i| {
                let difference = graph.subtract(before[i], change[i]);
                kept(graph, difference)
            });
            self.0.insert(*unknown, after);
        }
        quotient
    }

    /// Along the axes of the link before.
    pub(crate) fn turn(&mut self, graph: &mut Graph, link: usize, turn: &Turn) {
        for (unknown, row) in &mut self.0 {
            if matches!(unknown, Unknown::Coordinate(_)) {
                *row = turn.outward(graph, *row);
            }
        }
        for unknowns in [angular(link), linear(link)] {
            let block = self.block(graph, unknowns);
            let block = turn.outward_block(graph, block, false);
            self.set_block(unknowns, block);
        }
    }

    /// About the origin of the link before, from which that of a link is at `place`, and relative to which it has the velocity
    /// `speed`; `masses` are the rows of the inertia at the acceleration of the origin.
    pub(crate) fn shift(
        &mut self,
        graph: &mut Graph,
        link: usize,
        place: Vector,
        speed: Vector,
        masses: &[InertiaRow; 3],
    ) {
        let mut unknowns: Vec<_> = masses.iter().flat_map(|row| row.keys()).copied().collect();
        unknowns.sort_unstable();
        unknowns.dedup();
        for unknown in unknowns {
            let column = [0, 1, 2].map(|i| {
                let entry = masses[i].get(&unknown);
                entry.copied().unwrap_or(graph.zero())
            });
            let change = graph.cross(speed, column);
            self.increase(graph, unknown, change);
        }
        let forces = self.block(graph, linear(link));
        for axis in 0..3 {
            let force = forces.map(|row| row[axis]);
            let lever = graph.cross(place, force);
            for (unknown, change) in angular(link).into_iter().zip(lever) {
                let mut row = self.get(graph, unknown);
                row[axis] = total(graph, &[row[axis], change]);
                self.0.insert(unknown, row);
            }
        }
    }

    /// The same at the unknowns of the link before.
    pub(crate) fn at(self, link: usize, parent: usize) -> Self {
        let renamed = self.0.into_iter();
        Self(
            renamed
                .map(|(unknown, row)| (unknown.moved(link, parent), row))
                .collect(),
        )
    }
}
