//! The kinematic tree of quasi-velocities, wₖ = wₚ + Σ eₖᵢ q̇ᵢ + …, and recursions along it (Featherstone, Rigid Body
//! Dynamics Algorithms, 2008, chapters 4 and 5).
//!
//! The velocity of a body in a chain is that of the body before it plus a relative velocity. Which form is the
//! parent of which is found from the forms themselves: it is the one that differs in the fewest velocities, however
//! the declaration was written. A recursion takes as many steps as the tree has edges, where the mass matrix has
//! an entry for each pair of coordinates.

use crate::matrix::rows::{differences, product};
use crate::mechanics::energy_forms::quasi_velocities::QuasiVelocities;
use crate::{Expression, Graph, Model, Pass, Rational, Symbol};

/// A linear form of the velocities, relative to its parent.
#[derive(Clone, Debug)]
pub(crate) struct RelativeForm {
    /// The parent; it stands earlier in the tree.
    pub(crate) parent: Option<usize>,
    /// The coefficients eₖᵢ of the velocities that are added, with i.
    pub(crate) local: Vec<(usize, Expression)>,
    /// The relative velocity-product acceleration: the time derivative of the addition at constant velocities.
    pub(crate) velocity_product: Expression,
}

/// The equations of motion Eᵀ W ẇ = r along a tree of quasi-velocities.
#[derive(Clone, Debug)]
pub(crate) struct KinematicTree {
    /// Parents before children.
    pub(crate) forms: Vec<RelativeForm>,
    /// The inertia W.
    pub(crate) inertia: Vec<Vec<Expression>>,
    /// r, for each coordinate: all forces but those of velocity-product accelerations.
    pub(crate) right: Vec<Expression>,
    /// The unit of inertia by which W and r have been divided.
    pub(crate) unit: Expression,
}

impl KinematicTree {
    /// The tree of `quasi_velocities`, under the generalized forces Q.
    pub(crate) fn new(
        model: &mut Model,
        quasi_velocities: &QuasiVelocities,
        forces: &[Expression],
    ) -> Self {
        let coordinates = model.coordinates;
        let graph = &mut model.graph;
        let sorted = quasi_velocities.sorted(graph, coordinates);
        let matrix = sorted.kinematics(graph, coordinates);
        let offsets = sorted.offsets(graph, coordinates);
        let mut forms = Vec::with_capacity(matrix.len());
        let mut additions = Vec::with_capacity(matrix.len());
        for k in 0..matrix.len() {
            let parent = parent(graph, &matrix, k);
            let local = changes(&matrix, parent, k, graph.zero());
            let mut terms = vec![(offsets[k], Rational::ONE)];
            if let Some(parent) = parent {
                terms.push((offsets[parent], Rational::MINUS_ONE));
            }
            let local: Vec<_> = local
                .into_iter()
                .map(|(i, before, after)| (i, graph.subtract(after, before)))
                .collect();
            for (i, coefficient) in &local {
                let velocity = graph.symbol(velocity(*i));
                terms.push((graph.multiply(*coefficient, velocity), Rational::ONE));
            }
            additions.push(graph.sum(terms));
            forms.push(RelativeForm {
                parent,
                local,
                velocity_product: graph.zero(),
            });
        }
        let direction = graph.constant_velocity_direction(coordinates);
        let velocity_products = graph.directional_derivatives(&additions, &direction);
        for (form, velocity_product) in forms.iter_mut().zip(velocity_products) {
            form.velocity_product = velocity_product;
        }
        let mut tree = Self {
            forms,
            inertia: sorted.inertia,
            right: forces.to_vec(),
            unit: graph.one(),
        };
        tree.add_forces(graph, sorted.rest, &additions, coordinates);
        tree
    }

    /// The same equations divided by an inertia of which all others are numerical multiples, if there is one: a
    /// chain of equal bodies is then solved in ratios of inertias.
    pub(crate) fn divided_by_unit(&self, graph: &mut Graph) -> Self {
        if !graph.passes.has(Pass::InertiaScaling) {
            return self.clone();
        }
        let unit = self.inertia.first().map_or(graph.one(), |row| row[0]);
        if graph.is_zero(unit) {
            return self.clone();
        }
        let mut scaled = self.clone();
        for entry in scaled.inertia.iter_mut().flatten() {
            *entry = graph.divide(*entry, unit);
            if graph.as_constant(*entry).is_none() {
                return self.clone();
            }
        }
        for entry in &mut scaled.right {
            *entry = graph.divide(*entry, unit);
        }
        scaled.unit = unit;
        scaled
    }

    /// r = Q − 𝓛(rest) − Σₖ Pₖ 𝓛(addition of form k), where Pₖ is the momentum of form k and its descendants.
    fn add_forces(
        &mut self,
        graph: &mut Graph,
        rest: Expression,
        additions: &[Expression],
        coordinates: u32,
    ) {
        let gradient = graph.lagrange_derivatives(&[rest], coordinates);
        let gyroscopic = gyroscopic_terms(graph, additions, coordinates);
        let momenta = if gyroscopic.is_empty() {
            Vec::new()
        } else {
            self.momenta(graph, additions)
        };
        let momenta = self.sums_from_leaves(graph, &momenta);
        for (i, (right, slope)) in self.right.iter_mut().zip(&gradient[0]).enumerate() {
            let mut terms = vec![(*right, Rational::ONE), (*slope, Rational::MINUS_ONE)];
            for (k, _, term) in gyroscopic
                .iter()
                .filter(|(_, coordinate, _)| *coordinate == i)
            {
                terms.push((graph.multiply(momenta[*k], *term), Rational::MINUS_ONE));
            }
            *right = graph.sum(terms);
        }
    }

    /// The relative velocity-product acceleration of each form.
    pub(crate) fn velocity_products(&self) -> Vec<Expression> {
        let forms = self.forms.iter();
        forms.map(|form| form.velocity_product).collect()
    }

    /// W w, or the forces W ẇ, of sums from the root.
    fn momenta(&self, graph: &mut Graph, additions: &[Expression]) -> Vec<Expression> {
        let values = self.sums_from_root(graph, additions);
        product(graph, &self.inertia, &values)
    }

    /// Sums from the root: that of the parent plus an addition.
    pub(crate) fn sums_from_root(
        &self,
        graph: &mut Graph,
        additions: &[Expression],
    ) -> Vec<Expression> {
        let mut values: Vec<Expression> = Vec::with_capacity(additions.len());
        for (form, addition) in self.forms.iter().zip(additions) {
            let value = match form.parent {
                Some(parent) => {
                    let above = graph.opaque(values[parent]);
                    graph.add(above, *addition)
                }
                None => *addition,
            };
            values.push(value);
        }
        values
    }

    /// Sums from the leaves: each value plus those of all descendants.
    pub(crate) fn sums_from_leaves(
        &self,
        graph: &mut Graph,
        values: &[Expression],
    ) -> Vec<Expression> {
        let mut totals = values.to_vec();
        for k in (0..totals.len()).rev() {
            if let Some(parent) = self.forms[k].parent {
                let total = graph.opaque(totals[k]);
                totals[parent] = graph.add(totals[parent], total);
            }
        }
        totals
    }

    /// Eᵀ x.
    pub(crate) fn transpose_product(
        &self,
        graph: &mut Graph,
        values: &[Expression],
    ) -> Vec<Expression> {
        let totals = self.sums_from_leaves(graph, values);
        let mut terms = vec![Vec::new(); self.right.len()];
        for (form, total) in self.forms.iter().zip(totals) {
            for (i, coefficient) in &form.local {
                terms[*i].push((graph.multiply(*coefficient, total), Rational::ONE));
            }
        }
        terms.into_iter().map(|terms| graph.sum(terms)).collect()
    }

    /// The forcing f = r − Eᵀ W D w in M q̈ = f.
    pub(crate) fn forcing(&self, graph: &mut Graph) -> Vec<Expression> {
        let forces = self.momenta(graph, &self.velocity_products());
        let forces = self.transpose_product(graph, &forces);
        differences(graph, &self.right, &forces)
    }

    /// M q̈ − f = Eᵀ W ẇ − r with the accelerations as symbols.
    pub(crate) fn inverse_dynamics(&self, graph: &mut Graph) -> Vec<Expression> {
        let mut rates = Vec::with_capacity(self.forms.len());
        for form in &self.forms {
            let mut terms = vec![(form.velocity_product, Rational::ONE)];
            for (i, coefficient) in &form.local {
                let acceleration = graph.symbol(acceleration(*i));
                terms.push((graph.multiply(*coefficient, acceleration), Rational::ONE));
            }
            rates.push(graph.sum(terms));
        }
        let forces = self.momenta(graph, &rates);
        let forces = self.transpose_product(graph, &forces);
        differences(graph, &forces, &self.right)
    }
}

/// The earlier form from which form k differs in the fewest velocities, if that is fewer than it has.
fn parent(graph: &Graph, matrix: &[Vec<Expression>], k: usize) -> Option<usize> {
    let own = matrix[k]
        .iter()
        .filter(|entry| !graph.is_zero(**entry))
        .count();
    let distance = |p: &usize| {
        matrix[*p]
            .iter()
            .zip(&matrix[k])
            .filter(|(a, b)| a != b)
            .count()
    };
    let nearest = (0..k).min_by_key(|p| (distance(p), core::cmp::Reverse(*p)))?;
    (distance(&nearest) < own).then_some(nearest)
}

/// Where form k differs from its parent: the index, the parent's coefficient and its own.
fn changes(
    matrix: &[Vec<Expression>],
    parent: Option<usize>,
    k: usize,
    zero: Expression,
) -> Vec<(usize, Expression, Expression)> {
    let before = |i: usize| parent.map_or(zero, |parent| matrix[parent][i]);
    let pairs = matrix[k]
        .iter()
        .enumerate()
        .map(|(i, after)| (i, before(i), *after));
    pairs.filter(|(_, before, after)| before != after).collect()
}

/// The gyroscopic terms: the Lagrange derivatives 𝓛ᵢ of the additions that do not vanish, as (form, i, value). For
/// the velocity of a point, which is the derivative of its position, all of them vanish.
fn gyroscopic_terms(
    graph: &mut Graph,
    additions: &[Expression],
    coordinates: u32,
) -> Vec<(usize, usize, Expression)> {
    let mut gyroscopic = Vec::new();
    let derivatives = graph.lagrange_derivatives(additions, coordinates);
    for (k, row) in derivatives.into_iter().enumerate() {
        for (i, term) in row.into_iter().enumerate() {
            if !graph.is_zero(term) && !graph.vanishes(&[term]) {
                gyroscopic.push((k, i, term));
            }
        }
    }
    gyroscopic
}

fn velocity(i: usize) -> Symbol {
    Symbol::Velocity(u32::try_from(i).unwrap_or(u32::MAX))
}

fn acceleration(i: usize) -> Symbol {
    Symbol::Acceleration(u32::try_from(i).unwrap_or(u32::MAX))
}

#[cfg(test)]
mod tests;
