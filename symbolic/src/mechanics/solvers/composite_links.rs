//! The mass matrix of a mechanism by composite bodies (Walker and Orin, Efficient dynamic computer simulation of robotic
//! mechanisms, 1982).
//!
//! What a joint carries is one rigid body: all links behind it. The momentum that a unit rate of the joint gives to this
//! body goes towards the root, turned and moved link by link, and its power at the rate of each joint on the way is an
//! entry of M.

use crate::mechanics::mechanism::{Inertia, kept};
use crate::mechanics::solvers::link_equations::LinkEquations;
use crate::mechanics::solvers::spatial_vectors::{Twist, Wrench};
use crate::{Expression, Graph, Rational};

impl LinkEquations {
    /// The part of M that links have, row by row.
    pub(crate) fn mass_matrix(&self, graph: &mut Graph) -> Vec<Vec<Expression>> {
        let coordinates = self.forces.len();
        let links = &self.mechanism.links;
        let mut entries = vec![vec![Vec::new(); coordinates]; coordinates];
        let mut composites: Vec<Inertia> = links.iter().map(|link| link.inertia.clone()).collect();
        let mut columns: Vec<Vec<Column>> = vec![Vec::new(); links.len()];
        for (i, link, joint) in self.inward() {
            let composite = composites[i].clone();
            let mut carried = core::mem::take(&mut columns[i]);
            pass(
                graph,
                &composite,
                &joint.turning,
                &mut carried,
                &mut entries,
            );
            if link.parent.is_none() && joint.sliding.is_empty() {
                continue;
            }
            let composite = composite.turned(graph, &link.turn);
            for (_, momentum) in &mut carried {
                *momentum = momentum.turned(graph, &link.turn);
            }
            pass(
                graph,
                &composite,
                &joint.sliding,
                &mut carried,
                &mut entries,
            );
            let Some(parent) = link.parent else {
                continue;
            };
            let mut moved = composite.moved(graph, link.place);
            moved.keep(graph);
            composites[parent].add(graph, &moved);
            composites[parent].keep(graph);
            for (_, momentum) in &mut carried {
                *momentum = momentum.moved(graph, link.place);
            }
            columns[parent].extend(carried);
        }
        let sums = entries.into_iter().map(|row| {
            let sums = row.into_iter().map(|terms| {
                let sum = graph.sum(terms);
                kept(graph, sum)
            });
            sums.collect()
        });
        sums.collect()
    }
}

/// The momentum that a unit rate of a coordinate gives to what is behind its joint.
type Column = (usize, Wrench);

/// The terms of the entries of M.
type Entries = Vec<Vec<Vec<(Expression, Rational)>>>;

/// Passes a part of a joint: its columns are added to those that are carried, and the power of each at its rates is entered
/// on both sides of the diagonal; of its own column, once.
fn pass(
    graph: &mut Graph,
    composite: &Inertia,
    slopes: &[(usize, Twist)],
    carried: &mut Vec<Column>,
    entries: &mut Entries,
) {
    for (coordinate, slope) in slopes {
        let momentum = composite.momentum(graph, slope);
        for (other, before) in carried.iter() {
            let power = slope.power(graph, before);
            entries[*coordinate][*other].push((power, Rational::ONE));
            entries[*other][*coordinate].push((power, Rational::ONE));
        }
        let power = slope.power(graph, &momentum);
        entries[*coordinate][*coordinate].push((power, Rational::ONE));
        carried.push((*coordinate, momentum));
    }
}
