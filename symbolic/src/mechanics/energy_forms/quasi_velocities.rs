//! The kinetic energy as a quadratic form ½ wᵀ W w in quasi-velocities w = E(q, t) q̇ + b(q, t), linear forms of the
//! velocities (Hamel, Theoretische Mechanik, 1949).
//!
//! A kinetic energy ½ (I₁ω₁² + I₂ω₂² + I₃ω₃²) says more than its mass matrix: M = Eᵀ W E can be solved factor by
//! factor, which costs less and does not square the condition number of E. Input: a Lagrangian. Output: the forms,
//! their inertia W, and the rest. The forms are read off the [declaration](crate::mechanics::energy_forms::declared),
//! or recovered from the [mass matrix](crate::mechanics::energy_forms::recovered).

use crate::{Expression, Graph, Rational, Symbol};

/// A Lagrangian L = ½ Σ Wₖₗ wₖ wₗ + rest.
#[derive(Clone, Debug)]
pub(crate) struct QuasiVelocities {
    /// The quasi-velocities w, each at most linear in the velocities.
    pub(crate) forms: Vec<Expression>,
    /// W, symmetric; constant in the state and in time.
    pub(crate) inertia: Vec<Vec<Expression>>,
    /// The rest of L, at most linear in the velocities.
    pub(crate) rest: Expression,
}

impl QuasiVelocities {
    /// Whether the quasi-velocities vanish with the velocities.
    pub(crate) fn is_homogeneous(&self, graph: &mut Graph, coordinates: u32) -> bool {
        let offsets = self.offsets(graph, coordinates);
        offsets.iter().all(|offset| graph.is_zero(*offset))
    }

    /// The offsets b: the quasi-velocities where all velocities vanish.
    pub(crate) fn offsets(&self, graph: &mut Graph, coordinates: u32) -> Vec<Expression> {
        let velocities: Vec<_> = (0..coordinates).map(Symbol::Velocity).collect();
        graph.at_zero(&self.forms, &velocities)
    }

    /// The same energy with each form primitive and [with a positive leading coefficient](positive_leading), constant
    /// factors moved into the inertia, and the forms of fewer velocities first.
    pub(crate) fn sorted(&self, graph: &mut Graph, coordinates: u32) -> Self {
        let matrix = self.kinematics(graph, coordinates);
        let offsets = self.offsets(graph, coordinates);
        let mut forms = Vec::with_capacity(matrix.len());
        for ((k, row), offset) in matrix.iter().enumerate().zip(offsets) {
            let length = row.iter().filter(|entry| !graph.is_zero(**entry)).count();
            let primitive = primitive(graph, row, offset);
            let (factor, form) = positive_leading(graph, row, primitive);
            forms.push((length, k, factor, form));
        }
        forms.sort_by_key(|(length, k, ..)| (*length, *k));
        let entry = |graph: &mut Graph, i: usize, j: usize| {
            let (_, k, factor, _) = forms[i];
            let (_, l, other, _) = forms[j];
            graph.product([
                (self.inertia[k][l], Rational::ONE),
                (factor, Rational::ONE),
                (other, Rational::ONE),
            ])
        };
        let indices = 0..forms.len();
        let inertia = indices
            .clone()
            .map(|i| indices.clone().map(|j| entry(graph, i, j)).collect())
            .collect();
        Self {
            inertia,
            rest: self.rest,
            forms: forms.into_iter().map(|(.., form)| form).collect(),
        }
    }

    /// Whether there are no products of inertia.
    pub(crate) fn is_diagonal(&self, graph: &Graph) -> bool {
        let rows = self.inertia.iter().enumerate();
        let mut others =
            rows.flat_map(|(i, row)| row.iter().enumerate().filter(move |(j, _)| i != *j));
        others.all(|(_, entry)| graph.is_zero(*entry))
    }

    /// The matrix E = ∂w/∂q̇, row by row.
    pub(crate) fn kinematics(&self, graph: &mut Graph, coordinates: u32) -> Vec<Vec<Expression>> {
        let velocities: Vec<_> = (0..coordinates).map(Symbol::Velocity).collect();
        let columns = graph.jacobian(&self.forms, &velocities);
        (0..self.forms.len())
            .map(|k| columns.iter().map(|column| column[k]).collect())
            .collect()
    }
}

/// The form Σ e q̇ + offset as a constant factor and a form without one.
fn primitive(
    graph: &mut Graph,
    row: &[Expression],
    offset: Expression,
) -> (Expression, Expression) {
    let mut terms = vec![(offset, Rational::ONE)];
    for (i, coefficient) in (0..).zip(row) {
        let velocity = graph.symbol(Symbol::Velocity(i));
        terms.push((graph.multiply(*coefficient, velocity), Rational::ONE));
    }
    let sum = graph.sum(terms);
    let Some(split) = graph.split(sum) else {
        return (graph.one(), sum);
    };
    let (mut constant, mut varying) = (Vec::new(), vec![(split.rest, Rational::ONE)]);
    for (x, k) in split.common {
        if is_constant(graph, x) {
            constant.push((x, k));
        } else {
            varying.push((x, k));
        }
    }
    let factor = graph.product(constant);
    let factor = graph.scale(factor, &split.number);
    (factor, graph.product(varying))
}

/// A primitive form of a row, or its opposite: the one whose first coefficient has no minus sign, so that forms
/// that differ little have the same sign, however they were written.
fn positive_leading(
    graph: &mut Graph,
    row: &[Expression],
    (factor, form): (Expression, Expression),
) -> (Expression, Expression) {
    let first = row.iter().find(|entry| !graph.is_zero(**entry)).copied();
    let Some(first) = first else {
        return (factor, form);
    };
    let coefficient = graph.divide(first, factor);
    if graph.has_minus(coefficient) {
        (graph.negate(factor), graph.negate(form))
    } else {
        (factor, form)
    }
}

/// Whether an expression depends on parameters alone.
pub(crate) fn is_constant(graph: &Graph, expression: Expression) -> bool {
    !graph.contents(expression).varies()
}
