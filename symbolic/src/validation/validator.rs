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
use crate::validation::lagrange::{Lagrange, Variation};
use crate::validation::method::Method;
use crate::validation::mixed_derivatives::MixedDerivatives;
use crate::validation::perturbation::Perturbation;
use crate::validation::reference::Reference;
use crate::validation::square_matrix::SquareMatrix;
use crate::validation::tape::{StandIns, Tape};
use crate::validation::tapes::Tapes;
use crate::{Model, Node, Program};

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
        let (mut energies, _) = model.energies.weighted();
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

    /// The tape of programs, one after the other.
    pub fn tape<'a>(&self, programs: impl IntoIterator<Item = &'a Program>) -> Tape {
        let mut tape = Tape::of_programs(programs);
        tape.use_stand_ins(&self.stand_ins);
        tape
    }

    /// The methods whose programs do not compute what the equations say; none where no random point is in the
    /// domain, and none that takes second derivatives where the declared ones of an external function may depend on
    /// their order.
    #[must_use]
    pub fn disagreements(&self, tapes: &Tapes) -> BTreeSet<Method> {
        let mut found = BTreeSet::new();
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
            let Some(comparisons) = self.compare(tapes, point, Perturbation(None)) else {
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
            let compare = |perturbation| self.compare(tapes, point, perturbation);
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
            tapes,
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
        reference.compare_values(&mut comparisons);
        let expected = reference.forcing(&mass);
        comparisons.balances(Method::Forcing, &forcing, &expected);
        reference.compare_velocities(&mass, &mut comparisons);
        reference.compare_inverse_dynamics(&mass, &expected, &mut comparisons);
        if solved.is_some() {
            reference.compare_accelerations(&mass, &expected, &mut comparisons);
        } else if !uses_pivoting {
            reference.compare_without_solution(mass, &expected, &mut comparisons);
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
