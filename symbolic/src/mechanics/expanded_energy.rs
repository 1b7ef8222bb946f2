//! The equations of L with its mass matrix expanded.
//!
//! Squares of velocities contain terms that cancel in their sum: the angle φ of a position on a sphere, where
//! sin²φ + cos²φ remains in M, and both halves of ω · Iω where two inertias are equal. Momenta and forcing derived
//! from the squares keep these terms. Those derived from ½ q̇ᵀ M q̇, each entry of M in its cheapest form, are free
//! of them, and taken where they cost less. For many coordinates the expanded M swells, and is tried only if an ignorable
//! coordinate is written, which cancels: the angle of a wheel that spins fast would shorten the steps of a Taylor series.

use std::collections::BTreeMap;

use crate::limits::MAX_EXPANDED_COORDINATES;
use crate::mechanics::coordinate_properties::CoordinateProperties;
use crate::{Expression, Graph, Model, Pass, Rational, Symbol};

/// The quantities derived from a Lagrangian function: M, f, and the momenta.
#[derive(Clone, Debug)]
pub(crate) struct LagrangeTerms {
    /// p = ∂L/∂q̇.
    pub(crate) momenta: Vec<Expression>,
    /// M = ∂p/∂q̇, row by row.
    pub(crate) mass: Vec<Vec<Expression>>,
    /// f.
    pub(crate) forcing: Vec<Expression>,
}

impl LagrangeTerms {
    /// The cheaper of these terms and the terms of the expanded L.
    pub(crate) fn cheapest(
        self,
        model: &mut Model,
        lagrangian: Expression,
        generalized_forces: &[Expression],
        properties: &CoordinateProperties,
    ) -> Self {
        let are_many = model.coordinates > MAX_EXPANDED_COORDINATES;
        if are_many && !properties.has_ignorable(&model.graph, &self.expressions()) {
            return self;
        }
        match self.expanded(model, lagrangian, generalized_forces) {
            Some(other) if other.cost(&model.graph) < self.cost(&model.graph) => other,
            _ => self,
        }
    }

    /// These terms, derived from the expanded L; `None` if L is not quadratic in the velocities.
    fn expanded(
        &self,
        model: &mut Model,
        lagrangian: Expression,
        generalized_forces: &[Expression],
    ) -> Option<Self> {
        let graph = &mut model.graph;
        if !graph.passes.has(Pass::Expansion) || !is_quadratic(graph, lagrangian) {
            return None;
        }
        let mut mass = self.mass.clone();
        // M is symmetric.
        let mut simplest = BTreeMap::new();
        for entry in mass.iter_mut().flatten() {
            *entry = *simplest
                .entry(*entry)
                .or_insert_with(|| graph.simplest(*entry));
        }
        let rest = linear_part(graph, lagrangian, &self.momenta);
        let lagrangian = quadratic(graph, &mass, rest);
        let velocities: Vec<_> = (0..model.coordinates).map(Symbol::Velocity).collect();
        let momenta = graph.jacobian(&[lagrangian], &velocities).concat();
        let forcing = model.forcing(lagrangian, &momenta, generalized_forces);
        Some(Self {
            momenta,
            mass,
            forcing,
        })
    }

    fn cost(&self, graph: &Graph) -> usize {
        graph.cost(&self.expressions())
    }

    fn expressions(&self) -> Vec<Expression> {
        [&*self.momenta, &self.mass.concat(), &self.forcing].concat()
    }
}

/// Whether L is a polynomial of second degree in the velocities. That M is free of them does not suffice: a
/// piecewise linear term, such as |ẋ|, does not show in M.
pub(crate) fn is_quadratic(graph: &Graph, lagrangian: Expression) -> bool {
    graph
        .velocity_degree(lagrangian)
        .is_some_and(|degree| degree <= 2)
}

/// ½ q̇ᵀ M q̇ and the rest of L.
fn quadratic(graph: &mut Graph, mass: &[Vec<Expression>], rest: Expression) -> Expression {
    let mut terms = vec![(rest, Rational::ONE)];
    for (i, row) in (0..).zip(mass) {
        for (j, entry) in (0..=i).zip(row) {
            let velocities = [i, j].map(|k| graph.symbol(Symbol::Velocity(k)));
            let square = graph.multiply(velocities[0], velocities[1]);
            let factor = if i == j {
                Rational::HALF
            } else {
                Rational::ONE
            };
            terms.push((graph.multiply(*entry, square), factor));
        }
    }
    graph.sum(terms)
}

/// What of L is at most linear in the velocities.
pub(crate) fn linear_part(
    graph: &mut Graph,
    lagrangian: Expression,
    momenta: &[Expression],
) -> Expression {
    let velocities = (0..).map(Symbol::Velocity).take(momenta.len());
    let velocities: Vec<_> = velocities.collect();
    let mut roots = vec![lagrangian];
    roots.extend(momenta);
    let at_rest = graph.at_zero(&roots, &velocities);
    let mut terms = vec![(at_rest[0], Rational::ONE)];
    for (symbol, momentum) in velocities.into_iter().zip(&at_rest[1..]) {
        let velocity = graph.symbol(symbol);
        terms.push((graph.multiply(*momentum, velocity), Rational::ONE));
    }
    graph.sum(terms)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Equations;
    use crate::testing::systems::{euler_rates, kinetic};
    use crate::testing::{Draft, Quantity};

    /// ½ (d/dt (sin θ cos φ))² + ½ (d/dt (sin θ sin φ))² + ½ (d/dt cos θ)² + ½ φ̇² with (φ, θ, x).
    fn arm_with_a_ball(draft: &Draft) -> Quantity<'_> {
        let [phi, theta] = draft.qs();
        let place = [
            theta.sin() * phi.cos(),
            theta.sin() * phi.sin(),
            theta.cos(),
        ];
        let rates = place.into_iter().chain([phi]).map(Quantity::dot);
        draft.sum(rates.map(|rate| rate * rate / 2))
    }

    /// The arm, and a body at x that adds ẋᵏ / (k (k − 1)) to L, so that its mass is ẋᵏ⁻².
    fn with_a_body(power: i64) -> (Model, Equations) {
        let draft = Draft::new(3);
        let body = draft.v(2).powi(power) / (power * (power - 1));
        let mut model = draft.natural(arm_with_a_ball(&draft) + body, draft.zero());
        let equations = Equations::derive(&mut model).unwrap();
        (model, equations)
    }

    #[test]
    fn an_angle_that_cancels_in_the_mass_is_gone() {
        let (model, equations) = with_a_body(2);
        let (momenta, forcing) = (&equations.momenta, &equations.forcing);
        let is_phi = |symbol| symbol == Symbol::Coordinate(0);
        assert!(!model.graph.contains(momenta, is_phi));
        assert!(!model.graph.contains(forcing, is_phi));
        assert!(model.graph.contains(&[equations.lagrangian], is_phi));
    }

    #[test]
    fn the_size_of_a_velocity_is_part_of_the_momentum() {
        // L = ½ ẋ² + c |ẋ|: p = ẋ + c signum ẋ, though M = 1.
        let draft = Draft::new(1);
        let (v, c) = (draft.v(0), draft.p(0));
        let mut model = draft.general(v * v / 2 + c * v.abs());
        let equations = Equations::derive(&mut model).unwrap();
        let draft = Draft::of(model.graph, 1);
        let (v, c) = (draft.v(0), draft.p(0));
        assert_eq!(equations.momenta, [v + c * v.signum()]);
    }

    /// ½ (A (ω₁² + ω₂²) + C ω₃²) of a symmetric body in Euler's angles, and bodies on lines, of which the last is on a spring
    /// to the angle ψ if that is not to be ignorable.
    fn spinning_body(is_free: bool) -> (Model, Equations) {
        let draft = Draft::new(6);
        let rotation = kinetic(&draft, &euler_rates(&draft), &[0, 0, 1]);
        let others = (3..6).map(|i| draft.v(i).squared() / 2);
        let spring = if is_free {
            draft.zero()
        } else {
            (draft.q(2) - draft.q(5)).squared() / 2
        };
        let mut model = draft.natural(rotation + draft.sum(others), spring);
        let equations = Equations::derive(&mut model).unwrap();
        (model, equations)
    }

    #[test]
    fn an_ignorable_angle_is_gone_among_many_coordinates() {
        for is_free in [true, false] {
            let (model, equations) = spinning_body(is_free);
            let is_psi = |symbol| symbol == Symbol::Coordinate(2);
            assert_eq!(model.graph.contains(&equations.momenta, is_psi), !is_free);
            assert!(model.graph.contains(&[equations.lagrangian], is_psi));
        }
    }

    #[test]
    fn what_is_not_quadratic_in_the_velocities_stays() {
        let (mut model, equations) = with_a_body(4);
        let x_dot = model.graph.symbol(Symbol::Velocity(2));
        let third = Rational::integer(3).reciprocal().unwrap();
        let cube = model.graph.power(x_dot, &Rational::integer(3));
        assert_eq!(equations.momenta[2], model.graph.scale(cube, &third));
    }
}
