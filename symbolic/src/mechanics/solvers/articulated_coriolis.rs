//! The articulated-body counterpart of the [Coriolis matrix](crate::mechanics::solvers::coriolis_matrix): the wrench that a
//! change 2 δω of all angular velocities behind a joint takes, where the joints behind it give way (Featherstone, The
//! calculation of robot dynamics using articulated-body inertias, 1983; Jain and Rodriguez, Linearization of manipulator
//! dynamics using spatial operators, 1993).
//!
//! The change δω passes joints as that of a rigid body does. Where a coordinate is eliminated, the matrix is changed as a
//! force is; its acceleration then has a share of 2 δω.

use std::collections::{BTreeMap, BTreeSet};

use crate::mechanics::mechanism::{Turn, Vector, total};
use crate::mechanics::solvers::coriolis_matrix::CoriolisMatrix;
use crate::mechanics::solvers::link_vectors::RightHandSide;
use crate::mechanics::solvers::twist_elimination::{
    EliminatedRow, InertiaRow, Slope, Unknown, angular, linear, twist,
};
use crate::{Expression, Graph};

/// The forces that each component of 2 δω takes, along the axes of a link.
#[derive(Clone, Default)]
pub(crate) struct ArticulatedCoriolis([RightHandSide; 3]);

impl ArticulatedCoriolis {
    /// The coefficients of 2 δω in the force at an unknown.
    fn row(&self, graph: &Graph, unknown: Unknown) -> Vector {
        [0, 1, 2].map(|axis| self.0[axis].get(graph, unknown))
    }

    fn set_row(&mut self, unknown: Unknown, row: Vector) {
        for (column, force) in self.0.iter_mut().zip(row) {
            column.0.insert(unknown, force);
        }
    }

    fn increase(&mut self, graph: &mut Graph, unknown: Unknown, change: Vector) {
        let before = self.row(graph, unknown);
        let sum = [0, 1, 2].map(|i| total(graph, &[before[i], change[i]]));
        self.set_row(unknown, sum);
    }

    fn rows(&self, graph: &Graph) -> Vec<(Unknown, Vector)> {
        let unknowns = self.0[0].0.keys();
        unknowns.map(|u| (*u, self.row(graph, *u))).collect()
    }

    /// Adds the matrix of what a link itself carries.
    pub(crate) fn add_link(&mut self, graph: &mut Graph, link: usize, own: &CoriolisMatrix) {
        let rows = own.rows(graph);
        for (unknown, row) in twist(link).zip(rows.into_iter().flatten()) {
            self.increase(graph, unknown, row);
        }
    }

    /// Adds the matrix of a link behind, about the origin and along the axes of this one.
    pub(crate) fn add(&mut self, graph: &mut Graph, other: &Self, [link, parent]: [usize; 2]) {
        for (unknown, row) in other.rows(graph) {
            self.increase(graph, unknown.moved(link, parent), row);
        }
    }

    /// The forces that a change 2 δω takes.
    pub(crate) fn forces(
        &self,
        graph: &mut Graph,
        turning: Vector,
    ) -> BTreeMap<Unknown, Expression> {
        let rows = self.rows(graph).into_iter();
        let forces = rows.map(|(u, row)| (u, graph.sum_of_products(row.into_iter().zip(turning))));
        forces.collect()
    }

    /// x := x + e q̈.
    pub(crate) fn split_off(&mut self, graph: &mut Graph, slope: &Slope) {
        for column in &mut self.0 {
            column.split_off(graph, slope);
        }
    }

    /// Eliminates a coordinate; the negative share of 2 δω in its acceleration.
    pub(crate) fn eliminate(&mut self, graph: &mut Graph, row: &EliminatedRow) -> Vector {
        self.0.each_mut().map(|column| column.eliminate(graph, row))
    }

    /// Along the axes of the link before.
    pub(crate) fn turn(&mut self, graph: &mut Graph, link: usize, turn: &Turn) {
        for (unknown, row) in self.rows(graph) {
            if matches!(unknown, Unknown::Coordinate(_)) {
                let row = turn.outward(graph, row);
                self.set_row(unknown, row);
            }
        }
        for unknowns in [angular(link), linear(link)] {
            let block = unknowns.map(|u| self.row(graph, u));
            let block = turn.outward_block(graph, block, false);
            for (unknown, row) in unknowns.into_iter().zip(block) {
                self.set_row(unknown, row);
            }
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
        let zero = graph.zero();
        let unknowns: BTreeSet<_> = masses.iter().flat_map(|row| row.keys()).collect();
        for unknown in unknowns {
            let column = masses.each_ref().map(|row| row.get(unknown).copied());
            let change = graph.cross(speed, column.map(|entry| entry.unwrap_or(zero)));
            self.increase(graph, *unknown, change);
        }
        for column in &mut self.0 {
            let force = column.vector(graph, linear(link));
            let lever = graph.cross(place, force);
            for (unknown, change) in angular(link).into_iter().zip(lever) {
                let sum = total(graph, &[column.get(graph, unknown), change]);
                column.0.insert(unknown, sum);
            }
        }
    }
}
