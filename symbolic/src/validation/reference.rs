//! Comparisons of programs with Lagrange's equations at one point.

use crate::Symbol;
use crate::identity::real_point::RealPoint;
use crate::validation::comparison::Comparisons;
use crate::validation::lagrange::{Lagrange, Values, Variation};
use crate::validation::method::Method;
use crate::validation::perturbation::Perturbation;
use crate::validation::square_matrix::SquareMatrix;
use crate::validation::sum_with_size::{SumWithSize, add_each};
use crate::validation::tape::Tape;
use crate::validation::tapes::Tapes;

/// Lagrange's equations at one point.
pub(super) struct Reference<'a> {
    pub(super) tapes: &'a Tapes,
    pub(super) lagrange: &'a Lagrange,
    pub(super) values: Values,
    pub(super) variation: &'a Variation,
    pub(super) accelerations: &'a [f64],
    pub(super) point: RealPoint,
    pub(super) perturbation: Perturbation,
}

impl Reference<'_> {
    /// The outputs of a tape.
    pub(super) fn at(&self, tape: &Tape) -> Vec<f64> {
        self.evaluate(self.accelerations, tape)
    }

    /// The outputs of a tape at other accelerations.
    pub(super) fn evaluate(&self, accelerations: &[f64], tape: &Tape) -> Vec<f64> {
        tape.evaluate(&self.value(accelerations), self.perturbation)
    }

    /// The values of symbols at other accelerations.
    fn value(&self, accelerations: &[f64]) -> impl Fn(Symbol) -> f64 {
        move |symbol| match symbol {
            Symbol::Acceleration(i) => accelerations[i as usize],
            Symbol::Variation(i) => self.variation.state[i as usize],
            _ => self.point.value(symbol),
        }
    }

    /// M, whose columns are what the momenta at unit velocities have more than at rest.
    pub(super) fn mass_matrix_of(&self, momenta: &Tape) -> SquareMatrix {
        let at = |moving: Option<usize>| {
            let value = |symbol| match symbol {
                Symbol::Velocity(i) => f64::from(u8::from(moving == Some(i as usize))),
                _ => self.point.value(symbol),
            };
            momenta.evaluate(&value, self.perturbation)
        };
        let at_rest = at(None);
        let n = at_rest.len();
        let mut elements = vec![0.0; n * n];
        for j in 0..n {
            for (i, (momentum, other)) in at(Some(j)).iter().zip(&at_rest).enumerate() {
                elements[i * n + j] = momentum - other;
            }
        }
        SquareMatrix::new(elements, n)
    }

    /// The energies, momenta, forces and outputs.
    pub(super) fn compare_values(&self, comparisons: &mut Comparisons) {
        let (tapes, values) = (self.tapes, &self.values);
        let energy = energy(values, |symbol| self.lagrange.at(self.point, symbol));
        comparisons.balances(Method::Energy, &self.at(&tapes.energy), &[energy]);
        let forces = &values.generalized_forces;
        for (method, tape, expected) in [
            (
                Method::Lagrangian,
                &tapes.lagrangian,
                &[values.lagrangian][..],
            ),
            (Method::Energies, &tapes.energies, &values.energies),
            (Method::Momenta, &tapes.momenta, &values.momenta),
            (Method::GeneralizedForces, &tapes.generalized_forces, forces),
            (Method::Outputs, &tapes.outputs, &values.outputs),
        ] {
            comparisons.values(method, &self.at(tape), expected);
        }
        self.compare_rates(comparisons);
    }

    /// f = M q̈ − (M q̈ − f).
    pub(super) fn forcing(&self, mass: &SquareMatrix) -> Vec<SumWithSize> {
        let mut forcing = mass.times(self.accelerations);
        add_each(&mut forcing, -1.0, &self.values.residuals);
        forcing
    }

    /// M and M q̈ − f, at other accelerations.
    pub(super) fn compare_inverse_dynamics(
        &self,
        mass: &SquareMatrix,
        forcing: &[SumWithSize],
        comparisons: &mut Comparisons,
    ) {
        let velocities = &self.variation.velocities;
        let mut residuals = mass.times(velocities);
        comparisons.against(Method::MassMatrix, &residuals, &self.values.mass_products);
        add_each(&mut residuals, -1.0, forcing);
        let value = self.value(velocities);
        let tapes = self.tapes;
        let found = tapes.prepared(&tapes.inverse_dynamics, value, self.perturbation);
        comparisons.balances(Method::InverseDynamics, &found, &residuals);
        self.compare_regressor((velocities, &residuals), comparisons);
    }

    /// What is solved for the accelerations where the programs find none.
    pub(super) fn compare_without_solution(
        &self,
        mass: SquareMatrix,
        forcing: &[SumWithSize],
        comparisons: &mut Comparisons,
    ) {
        let constraints = self.tapes.constraints.as_ref();
        if constraints.is_some_and(|constraints| !constraints.are_independent) {
            return self.compare_system(&mass, comparisons);
        }
        // Where M is singular there are none.
        let right: Vec<f64> = forcing.iter().map(|force| force.total).collect();
        let solution = mass.solve(&right);
        if solution.is_some_and(|x| x.iter().all(|x| x.is_finite())) {
            comparisons.undefined(Method::Accelerations);
        }
    }

    /// The matrix and the right-hand side of a system that has no solution, as the residuals at any accelerations.
    fn compare_system(&self, mass: &SquareMatrix, comparisons: &mut Comparisons) {
        let count = self.accelerations.len();
        let Some((matrix, forcing)) = self.tapes.system(self.point, count, self.perturbation)
        else {
            return comparisons.undefined(Method::Accelerations);
        };
        let products = matrix.times(self.accelerations);
        let residuals = products.iter().zip(&forcing);
        let residuals: Vec<_> = residuals
            .map(|(product, force)| product.total - force)
            .collect();
        comparisons.balances(Method::Accelerations, &residuals, &self.values.residuals);
        self.compare_derivatives(mass, comparisons);
    }

    /// The accelerations and their derivatives. What should vanish is M q̈ − f, where dp/dt is one number: its terms are
    /// those of the product.
    pub(super) fn compare_accelerations(
        &self,
        mass: &SquareMatrix,
        forcing: &[SumWithSize],
        comparisons: &mut Comparisons,
    ) {
        let residuals = self.values.residuals.iter().zip(forcing);
        let residuals = residuals.map(|(residual, force)| SumWithSize {
            total: residual.total,
            size: if force.size.is_finite() {
                force.size
            } else {
                residual.size
            },
        });
        let residuals: Vec<_> = residuals.collect();
        comparisons.vanishing(Method::Accelerations, &residuals);
        self.compare_sensitivities(mass, comparisons);
        self.compare_derivatives(mass, comparisons);
    }
}

/// The energy function Σ pᵢ q̇ᵢ − L.
fn energy(values: &Values, value: impl Fn(Symbol) -> f64) -> SumWithSize {
    let mut energy = SumWithSize::default();
    energy.add(-values.lagrangian);
    for (i, momentum) in (0..).zip(&values.momenta) {
        energy.add(momentum * value(Symbol::Velocity(i)));
    }
    energy
}
