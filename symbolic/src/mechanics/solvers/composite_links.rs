//! The mass matrix of a mechanism by composite bodies (Walker and Orin, Efficient dynamic computer simulation of robotic
//! mechanisms, 1982).
//!
//! What a joint carries is one rigid body: all links behind it. The momentum that a unit rate of the joint gives to this
//! body goes towards the root, turned and moved link by link, and its power at the rate of each joint on the way is an
//! entry of M.

use crate::mechanics::mechanism::{Inertia, Vector, kept};
use crate::mechanics::solvers::link_equations::LinkEquations;
use crate::mechanics::solvers::newton_euler::Wrench;
use crate::{Expression, Graph, Rational};

impl LinkEquations {
    /// The part of M that links have, row by row.
    pub(crate) fn mass_matrix(&self, graph: &mut Graph) -> Vec<Vec<Expression>> {
        let coordinates = self.forces.len();
        let links = &self.mechanism.links;
        let mut entries = vec![vec![Vec::new(); coordinates]; coordinates];
        let mut composites: Vec<Inertia> = links.iter().map(|link| link.inertia.clone()).collect();
        let mut columns: Vec<Vec<Column>> = vec![Vec::new(); links.len()];
        for (i, (link, joint)) in links.iter().zip(&self.joints).enumerate().rev() {
            let composite = composites[i].clone();
            let mut carried = core::mem::take(&mut columns[i]);
            for (coordinate, slope) in &joint.turning {
                let momentum = composite.momentum_of_turning(graph, *slope);
                carried.push(Column::new(*coordinate, momentum));
                let last = carried.len() - 1;
                for (position, column) in carried.iter().enumerate() {
                    let power = power(graph, *slope, column.momentum.moment);
                    column.enter(&mut entries, *coordinate, power, position == last);
                }
            }
            if link.parent.is_none() && joint.sliding.is_empty() {
                continue;
            }
            let composite = composite.turned(graph, &link.turn);
            for column in &mut carried {
                column.momentum = column.momentum.turned(graph, &link.turn);
            }
            for (coordinate, slope) in &joint.sliding {
                let momentum = composite.momentum_of_sliding(graph, *slope);
                carried.push(Column::new(*coordinate, momentum));
                let last = carried.len() - 1;
                for (position, column) in carried.iter().enumerate() {
                    let power = power(graph, *slope, column.momentum.force);
                    column.enter(&mut entries, *coordinate, power, position == last);
                }
            }
            let Some(parent) = link.parent else {
                continue;
            };
            let mut moved = composite.moved(graph, link.place);
            moved.keep(graph);
            composites[parent].add(graph, &moved);
            composites[parent].keep(graph);
            for column in &mut carried {
                column.momentum = column.momentum.moved(graph, link.place);
            }
            columns[parent].extend(carried);
        }
        let sums = entries.into_iter().map(|row| {
            let sums = row.into_iter().map(|terms: Vec<(Expression, Rational)>| {
                let sum = graph.sum(terms);
                kept(graph, sum)
            });
            sums.collect()
        });
        sums.collect()
    }
}

/// The momentum that a unit rate of a joint gives to what is behind it.
#[derive(Clone)]
struct Column {
    coordinate: usize,
    momentum: Wrench,
}

impl Column {
    const fn new(coordinate: usize, momentum: Wrench) -> Self {
        Self {
            coordinate,
            momentum,
        }
    }

    /// Enters the power of the momentum at the rate of another joint on both sides of the diagonal; of the joint itself,
    /// once.
    fn enter(
        &self,
        entries: &mut [Vec<Vec<(Expression, Rational)>>],
        coordinate: usize,
        power: Expression,
        is_itself: bool,
    ) {
        entries[coordinate][self.coordinate].push((power, Rational::ONE));
        if !is_itself {
            entries[self.coordinate][coordinate].push((power, Rational::ONE));
        }
    }
}

fn power(graph: &mut Graph, slope: Vector, momentum: Vector) -> Expression {
    graph.sum_of_products(slope.into_iter().zip(momentum))
}

impl Inertia {
    /// The momentum of a unit rate of turning about an axis: (I e, e × h).
    pub(crate) fn momentum_of_turning(&self, graph: &mut Graph, axis: Vector) -> Wrench {
        let tensor = self.tensor(graph);
        let moment = tensor.map(|row| {
            let sum = graph.sum_of_products(row.into_iter().zip(axis));
            kept(graph, sum)
        });
        let force = graph.cross(axis, self.first);
        Wrench {
            moment,
            force: force.map(|x| kept(graph, x)),
        }
    }

    /// The momentum of a unit speed: (h × e, m e).
    pub(crate) fn momentum_of_sliding(&self, graph: &mut Graph, direction: Vector) -> Wrench {
        let moment = graph.cross(self.first, direction);
        let force = direction.map(|x| graph.multiply(self.mass, x));
        Wrench {
            moment: moment.map(|x| kept(graph, x)),
            force: force.map(|x| kept(graph, x)),
        }
    }
}
