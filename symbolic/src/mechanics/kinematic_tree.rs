//! Quasi-velocities as they build on each other: wₖ = wₚ + Σ eₖᵢ q̇ᵢ + …
//!
//! The velocity of a body in a chain is that of the body before it and a little more. Which form builds
//! on which is found from the forms themselves: the parent of a form is the one from which it differs in
//! the fewest velocities, so that it does not matter how the declaration was spelt. What is computed along
//! the tree takes as long as it has edges, where the mass matrix has an entry for each pair of coordinates.

use crate::mechanics::quasi_velocities::{QuasiVelocities, weighted};
use crate::mechanics::structure;
use crate::{Expression, Graph, Model, Pass, Rational, Symbol};

/// A form and what it adds to its parent.
#[derive(Clone, Debug)]
pub(crate) struct Form {
    /// The form that this one builds on; it stands earlier in the tree.
    pub(crate) parent: Option<usize>,
    /// The coefficients eₖᵢ of the velocities that are added, with i.
    pub(crate) local: Vec<(usize, Expression)>,
    /// The time derivative, at constant velocities, of what is added.
    pub(crate) drift: Expression,
}

/// The equations of motion Eᵀ W ẇ = r along a tree of quasi-velocities.
#[derive(Clone, Debug)]
pub(crate) struct KinematicTree {
    /// Parents before children.
    pub(crate) forms: Vec<Form>,
    /// The inertia W.
    pub(crate) inertia: Vec<Vec<Expression>>,
    /// r, for each coordinate: all forces but those of drift.
    pub(crate) right: Vec<Expression>,
    /// What W and r have been divided by.
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
            let local = differences(&matrix, parent, k, graph.zero());
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
            forms.push(Form {
                parent,
                local,
                drift: graph.zero(),
            });
        }
        let direction = graph.at_rest_direction(coordinates);
        let drifts = graph.directional_derivatives(&additions, &direction);
        for (form, drift) in forms.iter_mut().zip(drifts) {
            form.drift = drift;
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

    /// The same equations divided by an inertia of which all others are multiples by numbers, if there is
    /// one: a chain of equal bodies then solves for ratios.
    pub(crate) fn without_unit(&self, graph: &mut Graph) -> Self {
        if !graph.passes.has(Pass::Unit) {
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

    /// r = Q − 𝓛(rest) − Σₖ Pₖ 𝓛(what form k adds), where Pₖ is the momentum of the forms from k on.
    fn add_forces(
        &mut self,
        graph: &mut Graph,
        rest: Expression,
        additions: &[Expression],
        coordinates: u32,
    ) {
        let gradient = graph.lagrange_derivatives(&[rest], coordinates);
        let curls = curls(graph, additions, coordinates);
        let momenta = if curls.is_empty() {
            Vec::new()
        } else {
            self.momenta(graph, additions)
        };
        let momenta = self.accumulated(graph, &momenta);
        for (i, (right, slope)) in self.right.iter_mut().zip(&gradient[0]).enumerate() {
            let mut terms = vec![(*right, Rational::ONE), (*slope, Rational::MINUS_ONE)];
            for (k, _, curl) in curls.iter().filter(|(_, coordinate, _)| *coordinate == i) {
                terms.push((graph.multiply(momenta[*k], *curl), Rational::MINUS_ONE));
            }
            *right = graph.sum(terms);
        }
    }

    /// W w.
    fn momenta(&self, graph: &mut Graph, additions: &[Expression]) -> Vec<Expression> {
        let values = self.along(graph, additions);
        weighted(graph, &self.inertia, &values)
    }

    /// Sums from the root: the parent's and an addition.
    pub(crate) fn along(&self, graph: &mut Graph, additions: &[Expression]) -> Vec<Expression> {
        let mut values: Vec<Expression> = Vec::with_capacity(additions.len());
        for (form, addition) in self.forms.iter().zip(additions) {
            let value = match form.parent {
                Some(parent) => {
                    let above = graph.whole(values[parent]);
                    graph.add(above, *addition)
                }
                None => *addition,
            };
            values.push(value);
        }
        values
    }

    /// Sums from the leaves: each value and those of all forms that build on it.
    pub(crate) fn accumulated(&self, graph: &mut Graph, values: &[Expression]) -> Vec<Expression> {
        let mut totals = values.to_vec();
        for k in (0..totals.len()).rev() {
            if let Some(parent) = self.forms[k].parent {
                let total = graph.whole(totals[k]);
                totals[parent] = graph.add(totals[parent], total);
            }
        }
        totals
    }

    /// Eᵀ x.
    pub(crate) fn projected(&self, graph: &mut Graph, values: &[Expression]) -> Vec<Expression> {
        let totals = self.accumulated(graph, values);
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
        let drifts: Vec<_> = self.forms.iter().map(|form| form.drift).collect();
        let rates = self.along(graph, &drifts);
        let loads = weighted(graph, &self.inertia, &rates);
        let loads = self.projected(graph, &loads);
        let pairs = self.right.iter().zip(loads);
        pairs
            .map(|(right, load)| graph.subtract(*right, load))
            .collect()
    }

    /// M q̈ − f = Eᵀ W ẇ − r with the accelerations as symbols.
    pub(crate) fn inverse_dynamics(&self, graph: &mut Graph) -> Vec<Expression> {
        let mut rates = Vec::with_capacity(self.forms.len());
        for form in &self.forms {
            let mut terms = vec![(form.drift, Rational::ONE)];
            for (i, coefficient) in &form.local {
                let acceleration = graph.symbol(acceleration(*i));
                terms.push((graph.multiply(*coefficient, acceleration), Rational::ONE));
            }
            rates.push(graph.sum(terms));
        }
        let rates = self.along(graph, &rates);
        let loads = weighted(graph, &self.inertia, &rates);
        let loads = self.projected(graph, &loads);
        let pairs = loads.iter().zip(&self.right);
        pairs
            .map(|(load, right)| graph.subtract(*load, *right))
            .collect()
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
fn differences(
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

/// The 𝓛ᵢ of what each form adds that do not vanish, as (form, i, value). None does for the velocity
/// of a point, which is the derivative of its position.
fn curls(
    graph: &mut Graph,
    additions: &[Expression],
    coordinates: u32,
) -> Vec<(usize, usize, Expression)> {
    let mut curls = Vec::new();
    let derivatives = graph.lagrange_derivatives(additions, coordinates);
    for (k, row) in derivatives.into_iter().enumerate() {
        for (i, curl) in row.into_iter().enumerate() {
            if !graph.is_zero(curl) && !structure::vanishes(graph, curl) {
                curls.push((k, i, curl));
            }
        }
    }
    curls
}

fn velocity(i: usize) -> Symbol {
    Symbol::Velocity(u32::try_from(i).unwrap_or(u32::MAX))
}

fn acceleration(i: usize) -> Symbol {
    Symbol::Acceleration(u32::try_from(i).unwrap_or(u32::MAX))
}

#[cfg(test)]
mod tests;
