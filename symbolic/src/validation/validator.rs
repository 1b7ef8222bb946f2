//! Whether programs agree with Lagrange's equations numerically.
//!
//! Where two numbers differ by more than 2⁻³⁰ relative to the terms that they are sums of, both sides are computed
//! again with every intermediate result perturbed by 2⁻³⁶ (Monte Carlo arithmetic: Parker, 1997). The observed change
//! measures the conditioning, and bounds the differences that rounding explains. It explains no wrong term.

use std::collections::BTreeSet;

use crate::identity::real_point::RealPoint;
use crate::limits::{
    ENOUGH_NEARBY_POINTS, NEARBY_ATTEMPTS, PERTURBATION_MARGIN, PERTURBED_RUNS, VALIDATED_POINTS,
    VALIDATION_ATTEMPTS,
};
use crate::validation::comparison::{Comparison, Comparisons};
use crate::validation::lagrange::{Lagrange, Values, Variation};
use crate::validation::linearization_check::LinearizationCheck;
use crate::validation::mixed_derivatives::MixedDerivatives;
use crate::validation::perturbation::Perturbation;
use crate::validation::programs::{Method, Programs, Tapes};
use crate::validation::square_matrix::SquareMatrix;
use crate::validation::sum_with_size::SumWithSize;
use crate::validation::tape::{StandIns, Tape};
use crate::{Energies, Model, Node, Symbol};

/// Lagrange's equations of a model, the reference of all comparisons.
pub struct Validator {
    lagrange: Lagrange,
    stand_ins: StandIns,
    /// Whether the declared derivatives of external functions in the energies leave it open that mixed ones depend on
    /// their order.
    has_unequal_derivatives: bool,
}

impl Validator {
    /// The reference for `model`, made before anything is derived from it.
    #[must_use]
    pub fn new(model: &Model) -> Self {
        let multipliers = model.constraints.len();
        if multipliers == 0 {
            return Self::of(model, 0);
        }
        Self::of(&model.with_multiplier_coordinates(), multipliers)
    }

    /// The reference for a model whose last coordinates stand for so many multipliers.
    fn of(model: &Model, multipliers: usize) -> Self {
        let graph = &model.graph;
        let mut energies = match model.energies {
            Energies::Natural { kinetic, potential } => vec![kinetic, potential],
            Energies::General(lagrangian) => vec![lagrangian],
        };
        energies.push(model.dissipation);
        let mut parts = graph.descendants(&energies).into_iter();
        let has_several_arguments = parts.any(|part| match graph.node(part) {
            Node::Application(_, arguments) => arguments.len() > 1,
            _ => false,
        });
        if !has_several_arguments {
            let stand_ins = StandIns::default();
            return Self {
                lagrange: Lagrange::new(model, graph, multipliers, &stand_ins),
                stand_ins,
                has_unequal_derivatives: false,
            };
        }
        let mixed = MixedDerivatives::of(graph, &energies);
        Self {
            lagrange: Lagrange::new(model, &mixed.graph, multipliers, &mixed.stand_ins),
            stand_ins: mixed.stand_ins,
            has_unequal_derivatives: !mixed.are_equal,
        }
    }

    /// The methods whose programs do not compute what the equations say; none where no random point is in the
    /// domain, and none that takes second derivatives where the declared ones of an external function may depend on
    /// their order.
    #[must_use]
    pub fn disagreements(&self, programs: Programs<'_>) -> BTreeSet<Method> {
        let mut found = BTreeSet::new();
        let tapes = Tapes::new(&programs, &self.stand_ins);
        let mut points = 0;
        let mut undefined = Vec::new();
        for number in 0..VALIDATION_ATTEMPTS {
            if number >= NEARBY_ATTEMPTS && points >= ENOUGH_NEARBY_POINTS {
                break;
            }
            let point = if number < NEARBY_ATTEMPTS {
                RealPoint::new(number)
            } else {
                RealPoint::spread(number)
            };
            let Some(comparisons) = self.compare(&tapes, point, Perturbation(None)) else {
                continue;
            };
            points += 1;
            let missing = comparisons.iter();
            let missing = missing.filter(|comparison| !comparison.difference.is_finite());
            undefined.extend(
                missing
                    .map(|comparison| comparison.method)
                    .collect::<BTreeSet<_>>(),
            );
            let compare = |perturbation| self.compare(&tapes, point, perturbation);
            if comparisons
                .iter()
                .any(|x| x.is_significant() && !found.contains(&x.method))
            {
                found.extend(unexplained(&comparisons, &compare));
            }
            if points == VALIDATED_POINTS {
                break;
            }
        }
        // Methods that are undefined at most points where the equations are defined.
        for method in undefined.iter().copied() {
            let count = undefined.iter().filter(|other| **other == method).count();
            if 2 * count > points {
                found.insert(method);
            }
        }
        if self.has_unequal_derivatives {
            found.retain(|method| method.takes_first_derivatives());
        }
        found
    }

    /// All differences at a point; none outside of the domain.
    fn compare(
        &self,
        tapes: &Tapes,
        point: RealPoint,
        perturbation: Perturbation,
    ) -> Option<Vec<Comparison>> {
        let n = self.lagrange.coordinates;
        let multipliers = self.lagrange.multipliers;
        let variation = Variation::at(point, n, self.lagrange.inputs);
        let variation = variation.without_multipliers(multipliers);
        let uses_pivoting = tapes.uses_pivoting(point);
        let solved = if uses_pivoting {
            None
        } else {
            tapes.accelerations(point, n, perturbation)
        };
        // Methods other than the accelerations are compared at any accelerations.
        let accelerations = solved.as_ref().unwrap_or(&variation.velocities);
        let lagrange = &self.lagrange;
        let values = lagrange.values(point, &variation, accelerations, perturbation)?;
        let mut reference = Reference {
            lagrange,
            values,
            variation: &variation,
            accelerations,
            point,
            perturbation,
        };
        let mut comparisons = Comparisons::default();
        let free = n - multipliers;
        let mut mass = match &tapes.mass_matrix {
            Some(tape) => SquareMatrix::new(reference.at(tape), free),
            None => reference.mass_matrix_of(&tapes.momenta),
        };
        let mut forcing = reference.at(&tapes.forcing);
        if let Some(constraints) = &tapes.constraints {
            let jacobian = reference.at(&constraints.jacobian);
            mass = mass.with_constraints(&jacobian, multipliers);
            forcing.extend(reference.at(&constraints.rates));
            let velocities = reference.at(&constraints.velocities);
            reference.add_power(&jacobian, &velocities);
            reference.compare_constraints(constraints, &mut comparisons);
        }
        reference.compare_values(tapes, &mut comparisons);
        let expected = reference.forcing(&mass);
        comparisons.balances(Method::Forcing, &forcing, &expected);
        reference.compare_velocities(tapes, &mass, &mut comparisons);
        reference.compare_inverse_dynamics(tapes, &mass, &expected, &mut comparisons);
        if solved.is_some() {
            reference.compare_accelerations(tapes, &mass, &expected, &mut comparisons);
            tapes.requested.compare_sensitivities(
                |tape| reference.at(tape),
                lagrange,
                (&mass, accelerations),
                (point, perturbation),
                &mut comparisons,
            );
        } else if tapes
            .constraints
            .as_ref()
            .is_some_and(|x| !x.are_independent)
        {
            reference.compare_system(tapes, &mass, &mut comparisons);
        } else if !uses_pivoting {
            // Where M is singular there are none.
            let right: Vec<f64> = expected.iter().map(|force| force.total).collect();
            let solution = mass.solve(&right);
            if solution.is_some_and(|x| x.iter().all(|x| x.is_finite())) {
                comparisons.undefined(Method::Accelerations);
            }
        }
        comparisons.forgive_overflow(reference.values.largest);
        Some(comparisons.0)
    }
}

/// The methods with differences that conditioning does not explain, where `compare` makes the comparisons once more with
/// a perturbation.
pub(crate) fn unexplained(
    comparisons: &[Comparison],
    compare: &dyn Fn(Perturbation) -> Option<Vec<Comparison>>,
) -> BTreeSet<Method> {
    if !comparisons.iter().any(Comparison::is_significant) {
        return BTreeSet::new();
    }
    let mut explained = vec![0.0_f64; comparisons.len()];
    for seed in 1..=PERTURBED_RUNS {
        let Some(perturbed) = compare(Perturbation(Some(seed))) else {
            return BTreeSet::new();
        };
        for ((most, before), after) in explained.iter_mut().zip(comparisons).zip(&perturbed) {
            let change = (after.difference - before.difference).abs();
            *most = if change.is_finite() {
                most.max(change)
            } else {
                f64::INFINITY
            };
        }
    }
    let differences = comparisons.iter().zip(explained);
    let differences = differences.filter(|(comparison, explained)| {
        comparison.is_significant() && comparison.difference.abs() > PERTURBATION_MARGIN * explained
    });
    differences
        .map(|(comparison, _)| comparison.method)
        .collect()
}

/// Lagrange's equations at one point.
pub(super) struct Reference<'a> {
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
    fn evaluate(&self, accelerations: &[f64], tape: &Tape) -> Vec<f64> {
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
    fn mass_matrix_of(&self, momenta: &Tape) -> SquareMatrix {
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
    fn compare_values(&self, tapes: &Tapes, comparisons: &mut Comparisons) {
        let values = &self.values;
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
        let at = |tape: &Tape| self.at(tape);
        tapes.requested.compare_rates(at, values, comparisons);
    }

    /// f = M q̈ − (M q̈ − f).
    fn forcing(&self, mass: &SquareMatrix) -> Vec<SumWithSize> {
        let mut forcing = mass.times(self.accelerations);
        for (balance, residual) in forcing.iter_mut().zip(&self.values.residuals) {
            balance.total -= residual.total;
            balance.size += residual.size;
        }
        forcing
    }

    /// M and M q̈ − f, at other accelerations.
    fn compare_inverse_dynamics(
        &self,
        tapes: &Tapes,
        mass: &SquareMatrix,
        forcing: &[SumWithSize],
        comparisons: &mut Comparisons,
    ) {
        let velocities = &self.variation.velocities;
        let mut residuals = mass.times(velocities);
        comparisons.against(Method::MassMatrix, &residuals, &self.values.mass_products);
        for (balance, force) in residuals.iter_mut().zip(forcing) {
            balance.total -= force.total;
            balance.size += force.size;
        }
        let value = self.value(velocities);
        let found = tapes.prepared(&tapes.inverse_dynamics, value, self.perturbation);
        comparisons.balances(Method::InverseDynamics, &found, &residuals);
        let at = |tape: &Tape| self.evaluate(velocities, tape);
        tapes
            .requested
            .compare_regressor(at, &residuals, comparisons);
    }

    /// The velocities from momenta.
    fn compare_velocities(
        &self,
        tapes: &Tapes,
        mass: &SquareMatrix,
        comparisons: &mut Comparisons,
    ) {
        let values = |symbol: fn(u32) -> Symbol| -> Vec<f64> {
            let symbols = (0..).map(symbol).take(self.accelerations.len());
            symbols.map(|symbol| self.point.value(symbol)).collect()
        };
        tapes.requested.compare_velocities(
            |tape| self.at(tape),
            mass,
            (&values(Symbol::Velocity), &self.values.momenta),
            &values(Symbol::RightHandSide),
            comparisons,
        );
    }

    /// The matrix and the right-hand side of a system that has no solution, as the residuals at any accelerations.
    fn compare_system(&self, tapes: &Tapes, mass: &SquareMatrix, comparisons: &mut Comparisons) {
        let count = self.accelerations.len();
        let Some((matrix, forcing)) = tapes.system(self.point, count, self.perturbation) else {
            return comparisons.undefined(Method::Accelerations);
        };
        let products = matrix.times(self.accelerations);
        let residuals = products.iter().zip(&forcing);
        let residuals: Vec<_> = residuals
            .map(|(product, force)| product.total - force)
            .collect();
        comparisons.balances(Method::Accelerations, &residuals, &self.values.residuals);
        self.compare_input_jacobian(tapes, mass, comparisons);
    }

    /// The derivatives of the accelerations and of the multipliers by the inputs.
    fn compare_input_jacobian(
        &self,
        tapes: &Tapes,
        mass: &SquareMatrix,
        comparisons: &mut Comparisons,
    ) {
        if let Some((tape, pivots)) = &tapes.input_jacobian {
            let balances = self.input_balances(&self.at(tape), *pivots, mass);
            comparisons.vanishing(Method::Linearization, &balances.unwrap_or_default());
        }
    }

    /// The accelerations and their derivatives. What should vanish is M q̈ − f, where dp/dt is one number: its terms are
    /// those of the product.
    fn compare_accelerations(
        &self,
        tapes: &Tapes,
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
        self.compare_input_jacobian(tapes, mass, comparisons);
        let Some(([state, inputs], outputs)) = &tapes.linearization else {
            return;
        };
        let changes = LinearizationCheck {
            state: self.at(state),
            inputs: self.at(inputs),
            linearization_outputs: *outputs,
        };
        let variations = &self.values.variations;
        let balances = changes.balances(mass, self.accelerations, variations, self.variation);
        comparisons.vanishing(Method::Linearization, &balances);
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
