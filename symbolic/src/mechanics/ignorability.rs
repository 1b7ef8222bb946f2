//! On which coordinates the equations of motion depend.
//!
//! This is the one place that decides it, and it decides by what expressions mean: an angle that cancels in L, as ψ does
//! in the three squares of a symmetric top, is ignorable though it is written. The decisions are exact, by polynomial
//! identity testing.

use std::collections::BTreeSet;

use crate::mechanics::conservation::independent_of;
use crate::mechanics::constraints::ConstraintEquations;
use crate::{Expression, Model, Symbol};

/// For each coordinate, what depends on it and whether a force acts on it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Ignorability {
    /// Neither L nor a generalized force nor the velocities that constraints allow depend on the coordinate: the motion is the
    /// same wherever it begins.
    pub(crate) is_ignorable: Vec<bool>,
    /// L does not depend on the coordinate, and neither a generalized force nor a constraint acts on it: its momentum is constant (4.8).
    pub(crate) has_constant_momentum: Vec<bool>,
}

impl Ignorability {
    pub(crate) fn of(
        model: &Model,
        lagrangian: Expression,
        generalized_forces: &[Expression],
        constraints: &ConstraintEquations,
    ) -> Self {
        let coordinates = model.coordinate_symbols();
        let absent = independent_of(model, lagrangian, &coordinates);
        let graph = &model.graph;
        let forces = absent.iter().zip(generalized_forces).enumerate();
        let has_constant_momentum = forces.map(|(i, (absent, force))| {
            let mut acting = constraints.column(i);
            acting.push(*force);
            *absent && graph.vanishes(&acting)
        });
        let has_constant_momentum = has_constant_momentum.collect();
        let acting_on_motion = [generalized_forces, &constraints.velocities].concat();
        // Most coordinates are decided by L, or by being written nowhere.
        let written = graph.symbols(&acting_on_motion);
        let candidates = coordinates.iter().zip(&absent);
        let candidates = candidates.filter(|(symbol, absent)| **absent && written.contains(symbol));
        let candidates: Vec<Symbol> = candidates.map(|(symbol, _)| *symbol).collect();
        let mut acting = BTreeSet::new();
        if !candidates.is_empty() {
            for force in acting_on_motion {
                let independent = independent_of(model, force, &candidates);
                let dependent = candidates.iter().zip(independent);
                acting.extend(
                    dependent
                        .filter(|(_, independent)| !independent)
                        .map(|x| *x.0),
                );
            }
        }
        let ignorable = coordinates.iter().zip(absent);
        let is_ignorable = ignorable.map(|(symbol, absent)| absent && !acting.contains(symbol));
        Self {
            is_ignorable: is_ignorable.collect(),
            has_constant_momentum,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::testing::systems::{euler_rates, kinetic};
    use crate::testing::{Draft, Quantity};
    use crate::{Equations, Unary};

    /// Which coordinates are ignorable, which have constant momenta, and which are angles.
    fn found(mut model: Model) -> [Vec<bool>; 3] {
        let equations = Equations::derive(&mut model).unwrap();
        let properties = equations.coordinate_properties;
        let momenta = equations.conservation.momenta;
        [properties.ignorable, momenta, properties.angles]
    }

    #[test]
    fn an_angle_that_is_written_and_cancels_is_ignorable() {
        let draft = Draft::new(3);
        let w = euler_rates(&draft);
        let top = kinetic(&draft, &w, &[0, 0, 1]);
        let [ignorable, momenta, angles] = found(draft.natural(top, draft.q(1).cos()));
        assert_eq!(ignorable, [true, false, true]);
        assert_eq!(momenta, ignorable);
        assert_eq!(angles, [false, true, false]);
        // With three different moments of inertia it does not cancel.
        let draft = Draft::new(3);
        let w = euler_rates(&draft);
        let body = kinetic(&draft, &w, &[0, 1, 2]);
        let [ignorable, momenta, angles] = found(draft.natural(body, draft.q(1).cos()));
        assert_eq!(ignorable, [true, false, false]);
        assert_eq!(momenta, ignorable);
        assert_eq!(angles, [false, true, true]);
    }

    /// Functions of x and y that do not depend on x, though no rule of the algebra says so.
    fn written<'d>(draft: &'d Draft, x: Quantity<'d>, y: Quantity<'d>) -> Vec<Quantity<'d>> {
        let call =
            |function, x: Quantity<'d>| draft.make(|graph| graph.unary(function, x.expression()));
        let [exp, opposite] = [x, -x].map(|x| call(Unary::Exp, x));
        let [cosh, sinh] = [Unary::Cosh, Unary::Sinh].map(|function| call(function, x));
        vec![
            (x + y).squared() - x.squared() - 2 * x * y,
            (x + y).sin() * x.cos() - (x + y).cos() * x.sin(),
            exp * opposite * y,
            (cosh * cosh - sinh * sinh) * y.cos(),
            (x + 1) * (-x + 1) + x.squared() + y,
            (x + y) * (x - y) - x.squared(),
        ]
    }

    #[test]
    fn what_cancels_in_energies_and_forces_does_not_matter() {
        for case in 0..6 {
            for place in 0..3 {
                let draft = Draft::new(2);
                let [x, y] = draft.qs();
                let function = written(&draft, x, y)[case];
                let rates = draft.v(0).squared() + draft.v(1).squared();
                let constant = draft.zero();
                let mut model = match place {
                    0 => draft.natural(rates / 2 * (function.cos() + 3), constant),
                    1 => draft.natural(rates / 2, function),
                    _ => {
                        let forces = [constant, function].map(Into::into);
                        let mut model = draft.natural(rates / 2, constant);
                        model.forces = forces.to_vec();
                        model
                    }
                };
                let [ignorable, momenta, angles] = found(model.clone());
                assert!(ignorable[0], "{case} {place}");
                assert!(momenta[0], "{case} {place}");
                assert!(!angles[0], "{case} {place}");
                assert!(!ignorable[1], "{case} {place}");
                // A force that acts on it, and does not depend on it.
                let velocity = model.graph.symbol(Symbol::Velocity(0));
                model.forces.resize(2, model.graph.zero());
                model.forces[0] = model.graph.negate(velocity);
                let [ignorable, momenta, _] = found(model);
                assert_eq!([ignorable[0], momenta[0]], [true, false], "{case} {place}");
            }
        }
    }
}
