//! The energy function h = Σ pᵢ q̇ᵢ − L, and how it changes: dh/dt = Q·q̇ − ∂L/∂t (Goldstein, Poole and Safko, Classical
//! Mechanics, 3rd edition 2002, section 2.7).

use crate::print::listing::composer::Composer;
use crate::print::listing::page_letters::Quantity;
use crate::print::listing::section::Section;
use crate::{Energies, Equations, Expression, Rational, Symbol};

impl Composer<'_> {
    /// h, which is T + V where T is of second degree in the velocities and V of none, and whether it is constant.
    pub(crate) fn energy_function(&mut self, equations: &Equations) -> Section {
        let heading = self.page.texts([
            "Energy function {h} = Σ {p} {q}\u{307} − {L}:",
            "Energy function ${h} = \\sum {p} \\dot {q} - {L}$:",
        ]);
        let letter = self.page.letter(Quantity::EnergyFunction);
        let mut section = Section::new(Some(heading), "the method `energy`");
        if self.is_sum_of_energies(equations.energy) {
            let sum = self.page.printed(["{T} + {V}"; 2]);
            self.push_arranged(&mut section, letter, sum);
        } else {
            self.push(&mut section, letter, equations.energy);
        }
        if equations.conservation.energy {
            section.sentence = self.page.texts(["{h} is constant.", "${h}$ is constant."]);
        } else if let Some(rate) = self.rate_of_energy(equations) {
            let left = self.page.printed(["d{h}/dt", "\\frac{d{h}}{dt}"]);
            self.push(&mut section, left, rate);
        }
        self.mention(section)
    }

    fn is_sum_of_energies(&mut self, energy: Expression) -> bool {
        let Energies::Natural { kinetic, potential } = self.energies else {
            return false;
        };
        let graph = &mut self.model.graph;
        let terms = [
            (energy, Rational::ONE),
            (kinetic, Rational::MINUS_ONE),
            (potential, Rational::MINUS_ONE),
        ];
        let difference = graph.sum(terms);
        graph.is_zero(difference) || graph.vanishes(&[difference])
    }

    /// Q·q̇ − ∂L/∂t; none where L depends on inputs, of which it is not known how they change.
    fn rate_of_energy(&mut self, equations: &Equations) -> Option<Expression> {
        let inputs = self.model.input_symbols();
        let velocities = self.model.velocity_symbols();
        let graph = &mut self.model.graph;
        let zero = graph.zero();
        let by_inputs = graph.jacobian(&[equations.lagrangian], &inputs).concat();
        if by_inputs.iter().any(|derivative| *derivative != zero) {
            return None;
        }
        let by_time = graph.jacobian(&[equations.lagrangian], &[Symbol::Time])[0][0];
        let mut terms = vec![(by_time, Rational::MINUS_ONE)];
        for (force, velocity) in equations.generalized_forces.iter().zip(velocities) {
            let velocity = graph.symbol(velocity);
            terms.push((graph.multiply(*force, velocity), Rational::ONE));
        }
        Some(graph.sum(terms))
    }
}
