//! Conservation laws (Goldstein, Poole and Safko, Classical Mechanics, 3rd edition 2002, sections 2.6 and 2.7): the momenta
//! of ignorable coordinates, and the energy function.
//!
//! dpᵢ/dt = ∂L/∂qᵢ + Qᵢ + (Gᵀ λ)ᵢ and dh/dt = Q·q̇ − ∂L/∂t + λᵀ G q̇. Whether a right-hand side vanishes identically is
//! decided exactly, by polynomial identity testing: an angle that cancels in L, as ψ does in the three squares of a
//! symmetric top, is ignorable though it is written.

use crate::identity::identity_testing::IdentityTest;
use crate::identity::tested_value::TestedValue;
use crate::mechanics::constraints::ConstraintEquations;
use crate::{Expression, Model, Rational, Symbol};

/// Which functions of the state are constants of motion.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Conservation {
    /// For each coordinate, whether it is ignorable (cyclic): L does not depend on it, and neither a generalized force nor a
    /// constraint acts on it.
    /// Then its momentum ∂L/∂q̇ᵢ is constant (4.8).
    pub momenta: Vec<bool>,
    /// Whether the energy function is constant: L depends neither on the time nor on inputs, and the generalized forces
    /// and the constraints do no work.
    pub energy: bool,
}

impl Conservation {
    /// The constants of motion, where it is known which momenta are constant.
    pub(crate) fn of(
        model: &mut Model,
        lagrangian: Expression,
        (generalized_forces, constraints): (&[Expression], &ConstraintEquations),
        momenta: Vec<bool>,
    ) -> Self {
        Self {
            momenta,
            energy: conserves_energy(model, lagrangian, generalized_forces)
                && do_no_work(model, constraints),
        }
    }

    /// The ignorable coordinates, in order.
    pub fn ignorable(&self) -> impl Iterator<Item = usize> + '_ {
        let numbered = self.momenta.iter().enumerate();
        numbered.filter(|(_, constant)| **constant).map(|(i, _)| i)
    }
}

/// Of which symbols an expression is independent, though they may occur in it.
pub(crate) fn independent_of(
    model: &Model,
    expression: Expression,
    symbols: &[Symbol],
) -> Vec<bool> {
    let graph = &model.graph;
    let roots = [expression];
    let test = IdentityTest::of(graph, &roots);
    test.independent(graph, &roots, symbols, TestedValue::First)
}

/// Whether the power −λᵀ a of the constraints vanishes.
fn do_no_work(model: &mut Model, constraints: &ConstraintEquations) -> bool {
    let rheonomic = constraints.rheonomic(model);
    model.graph.vanishes(&rheonomic)
}

fn conserves_energy(model: &mut Model, lagrangian: Expression, forces: &[Expression]) -> bool {
    let mut varied = model.input_symbols();
    varied.push(Symbol::Time);
    if independent_of(model, lagrangian, &varied).contains(&false) {
        return false;
    }
    let mut power = Vec::with_capacity(forces.len());
    for (force, velocity) in forces.iter().zip(model.velocity_symbols()) {
        let velocity = model.graph.symbol(velocity);
        power.push((model.graph.multiply(*force, velocity), Rational::ONE));
    }
    let power = model.graph.sum(power);
    model.graph.vanishes(&[power])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::Equations;
    use crate::testing::systems::{euler_rates, kinetic};
    use crate::testing::{Draft, Quantity};

    fn conservation(mut model: Model) -> Conservation {
        Equations::derive(&mut model).unwrap().conservation
    }

    /// A symmetric top as three squares (4.5), one inertia twice.
    fn symmetric_top(draft: &Draft) -> [Quantity<'_>; 2] {
        let w = euler_rates(draft);
        [kinetic(draft, &w, &[0, 0, 1]), draft.q(1).cos()]
    }

    #[test]
    fn an_angle_that_cancels_in_the_lagrangian_is_ignorable() {
        let draft = Draft::new(3);
        let [kinetic, potential] = symmetric_top(&draft);
        let found = conservation(draft.natural(kinetic, potential));
        assert_eq!(found.momenta, [true, false, true]);
        assert!(found.energy);
        assert_eq!(found.ignorable().collect::<Vec<_>>(), [0, 2]);
    }

    #[test]
    fn a_coordinate_on_which_a_force_acts_is_not_ignorable() {
        let draft = Draft::new(3);
        let [kinetic, potential] = symmetric_top(&draft);
        let dissipation = (draft.v(2).squared() / 2).into();
        let mut model = draft.natural(kinetic, potential);
        model.dissipation = dissipation;
        let found = conservation(model);
        assert_eq!(found.momenta, [true, false, false]);
        assert!(!found.energy);
    }

    #[test]
    fn gyroscopic_forces_do_no_work() {
        // Q = c (ẏ, −ẋ), of which neither component vanishes.
        for (sign, conserved) in [(-1, true), (1, false)] {
            let draft = Draft::new(2);
            let ([u, v], c) = (draft.vs(), draft.p(0));
            let forces = [c * v, draft.number(sign) * c * u].map(Into::into);
            let mut model = draft.natural(u * u / 2 + v * v / 2, draft.zero());
            model.forces = forces.to_vec();
            let found = conservation(model);
            assert_eq!(found.momenta, [false, false]);
            assert_eq!(found.energy, conserved);
        }
    }

    #[test]
    fn what_depends_on_the_time_or_on_an_input_conserves_no_energy() {
        for symbol in [Symbol::Time, Symbol::Input(0)] {
            let draft = Draft::new(1);
            let mut model = draft.natural(draft.v(0).squared() / 2, draft.zero());
            model.inputs = 1;
            let symbol = model.graph.symbol(symbol);
            let place = model.graph.symbol(Symbol::Coordinate(0));
            let potential = model.graph.multiply(symbol, place);
            if let crate::Energies::Natural {
                potential: zero, ..
            } = &mut model.energies
            {
                *zero = potential;
            }
            let found = conservation(model);
            assert_eq!(found.momenta, [false]);
            assert!(!found.energy);
        }
    }
}
