//! The elimination of the velocities of ignorable coordinates from a Lagrangian, with the formulas of
//! [Routh's reduction](super).

use super::elimination::Elimination;
use crate::matrix::rows::{differences, sums};
use crate::{Energies, Expression, Graph, Rational, Symbol};

/// The full model without ignorable coordinates, in its own numbers.
pub(super) struct System {
    pub(super) kinetic_and_potential: Option<[Expression; 2]>,
    pub(super) lagrangian: Expression,
    pub(super) forces: Vec<Expression>,
    pub(super) velocities: Vec<Symbol>,
    pub(super) ignorable: Vec<Symbol>,
    /// p of the ignorable coordinates where their velocities are 0, β = B q̇ + b.
    pub(super) offsets: Vec<Expression>,
    pub(super) elimination: Elimination,
    pub(super) constants: Vec<Expression>,
}

/// What comes out, still in the numbers of the full model.
pub(super) struct Reduced {
    pub(super) energies: Energies,
    pub(super) effective_potential: Expression,
    pub(super) velocities: Vec<Expression>,
}

impl System {
    /// Factors A, the inertia of the ignorable coordinates; the position of one in whose velocity L is not quadratic.
    pub(super) fn eliminate(&mut self, graph: &mut Graph) -> Result<(), usize> {
        let momenta = graph.jacobian(&[self.lagrangian], &self.ignorable).concat();
        let columns = graph.jacobian(&momenta, &self.ignorable);
        self.offsets = graph.at_zero(&momenta, &self.ignorable);
        let mut inertia = vec![Vec::new(); momenta.len()];
        for column in &columns {
            let column = graph.at_zero(column, &self.ignorable);
            for (row, entry) in inertia.iter_mut().zip(column) {
                row.push(graph.simplest(entry));
            }
        }
        for (position, momentum) in momenta.iter().enumerate() {
            let mut terms = vec![
                (*momentum, Rational::ONE),
                (self.offsets[position], Rational::MINUS_ONE),
            ];
            for (entry, symbol) in inertia[position].iter().zip(&self.ignorable) {
                let rate = graph.symbol(*symbol);
                terms.push((graph.multiply(*entry, rate), Rational::MINUS_ONE));
            }
            let rest = graph.sum(terms);
            if !graph.vanishes(&[rest]) {
                return Err(position);
            }
        }
        self.elimination = Elimination::of(graph, &inertia)?;
        Ok(())
    }

    /// The reduction of an L of degree two in all velocities; none for others.
    pub(super) fn of_degree_two(&self, graph: &mut Graph) -> Option<Reduced> {
        if graph.velocity_degree(self.lagrangian)? != 2 {
            return None;
        }
        let resting = graph.at_zero(&[self.lagrangian], &self.velocities)[0];
        let slopes = graph
            .jacobian(&[self.lagrangian], &self.velocities)
            .concat();
        let linear = graph.at_zero(&slopes, &self.velocities);
        let bias = graph.at_zero(&self.offsets, &self.velocities);
        let moved = simplest_differences(graph, &bias, &self.offsets);
        let excess = simplest_differences(graph, &self.constants, &bias);
        let [moved, excess] = [moved, excess].map(|right| self.elimination.forward(graph, right));
        let driven = self.elimination.backward(graph, &moved);
        let constant = self.elimination.backward(graph, &excess);
        let quadratic = self.quadratic_part(graph, resting, &linear)?;
        let driven_rates = self.ignorable.iter().copied().zip(driven.iter().copied());
        let kinetic = graph.substitute(&[quadratic], &driven_rates.collect())[0];
        let kinetic = graph.simplest(kinetic);
        let centrifugal = self.elimination.product(graph, &excess, &excess);
        let centrifugal = graph.scale(centrifugal, &Rational::HALF);
        let effective_potential = graph.subtract(centrifugal, resting);
        let mut gyroscopic = vec![(
            self.elimination.product(graph, &excess, &moved),
            Rational::ONE,
        )];
        for (symbol, slope) in self.velocities.iter().zip(linear) {
            if !self.ignorable.contains(symbol) {
                let rate = graph.symbol(*symbol);
                gyroscopic.push((graph.multiply(slope, rate), Rational::MINUS_ONE));
            }
        }
        let gyroscopic = graph.sum(gyroscopic);
        let gyroscopic = graph.simplest(gyroscopic);
        Some(Reduced {
            energies: Energies::Natural {
                kinetic,
                potential: graph.add(effective_potential, gyroscopic),
            },
            effective_potential,
            velocities: sums(graph, &constant, &driven),
        })
    }

    /// T₂: T as it was declared where it is quadratic, and else the difference or the quadratic form, whichever costs less.
    fn quadratic_part(
        &self,
        graph: &mut Graph,
        resting: Expression,
        linear: &[Expression],
    ) -> Option<Expression> {
        if let Some([kinetic, potential]) = self.kinetic_and_potential {
            let rest = [kinetic, potential].map(|part| graph.velocity_degree(part));
            let slopes = graph.jacobian(&[kinetic], &self.velocities).concat();
            let mut still = graph.at_zero(&slopes, &self.velocities);
            still.extend(graph.at_zero(&[kinetic], &self.velocities));
            let ignored: Vec<Expression> = self.difference_of_energies(graph, kinetic, potential);
            if matches!(rest, [Some(2), Some(0 | 1)])
                && graph.vanishes(&still)
                && graph.vanishes(&ignored)
            {
                return Some(kinetic);
            }
        }
        let mut difference = vec![
            (self.lagrangian, Rational::ONE),
            (resting, Rational::MINUS_ONE),
        ];
        for (symbol, slope) in self.velocities.iter().zip(linear) {
            let rate = graph.symbol(*symbol);
            difference.push((graph.multiply(*slope, rate), Rational::MINUS_ONE));
        }
        let difference = graph.sum(difference);
        let momenta = graph
            .jacobian(&[self.lagrangian], &self.velocities)
            .concat();
        let mass = graph.jacobian(&momenta, &self.velocities);
        let mut form = Vec::new();
        for (symbol, column) in self.velocities.iter().zip(mass) {
            let rate = graph.symbol(*symbol);
            for (other, entry) in self.velocities.iter().zip(column) {
                let other = graph.symbol(*other);
                let product = graph.product([entry, rate, other].map(|x| (x, Rational::ONE)));
                form.push((product, Rational::HALF));
            }
        }
        let form = graph.sum(form);
        let choices = [difference, form].map(|choice| graph.simplest(choice));
        choices
            .into_iter()
            .min_by_key(|choice| graph.cost(&[*choice]))
    }

    /// T − V − L, which vanishes unless the energies depend on an ignorable coordinate that cancels in L.
    fn difference_of_energies(
        &self,
        graph: &mut Graph,
        kinetic: Expression,
        potential: Expression,
    ) -> Vec<Expression> {
        let terms = [(kinetic, 1), (potential, -1), (self.lagrangian, -1)];
        vec![graph.sum(terms.map(|(x, c)| (x, Rational::integer(c))))]
    }

    /// The reduction of an L that is quadratic in the velocities of the ignorable coordinates.
    pub(super) fn quadratic_in_ignorable_velocities(&self, graph: &mut Graph) -> Reduced {
        let still = graph.at_zero(&[self.lagrangian], &self.ignorable)[0];
        let excess = simplest_differences(graph, &self.constants, &self.offsets);
        let excess = self.elimination.forward(graph, excess);
        let velocities = self.elimination.backward(graph, &excess);
        let centrifugal = self.elimination.product(graph, &excess, &excess);
        let centrifugal = graph.scale(centrifugal, &Rational::HALF);
        let lagrangian = graph.subtract(still, centrifugal);
        let resting = graph.at_zero(&[lagrangian], &self.velocities)[0];
        Reduced {
            energies: Energies::General(lagrangian),
            effective_potential: graph.negate(resting),
            velocities,
        }
    }
}

/// x − y, entry by entry, each in its simplest form.
fn simplest_differences(graph: &mut Graph, x: &[Expression], y: &[Expression]) -> Vec<Expression> {
    let differences = differences(graph, x, y).into_iter();
    differences.map(|x| graph.simplest(x)).collect()
}
