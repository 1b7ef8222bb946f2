//! What is derived for clauses that ask for it, compared with Lagrange's equations.

use crate::identity::real_point::RealPoint;
use crate::validation::comparison::Comparisons;
use crate::validation::lagrange::{Lagrange, Values, Variation};
use crate::validation::linearization_check::{LinearizationCheck, LinearizationOutputs};
use crate::validation::perturbation::Perturbation;
use crate::validation::programs::{Method, SensitivityProgram};
use crate::validation::square_matrix::SquareMatrix;
use crate::validation::sum_with_size::SumWithSize;
use crate::validation::tape::{StandIns, Tape};
use crate::{Program, Symbol};

/// The programs of what clauses ask for.
#[derive(Clone, Copy, Default)]
pub struct RequestedPrograms<'a> {
    /// ∂L/∂q + Q.
    pub momentum_rates: Option<&'a Program>,
    /// The velocities that have the momenta, which stand for right-hand sides.
    pub velocities: Option<&'a Program>,
    /// Q·q̇ − ∂L/∂t.
    pub energy_rate: Option<&'a Program>,
    /// The derivatives of q̈ by parameters.
    pub sensitivities: Option<SensitivityProgram<'a>>,
    /// The columns of Y, then what is known, r, and the base parameters: M q̈ − f = Y π + r.
    pub regressor: Option<[&'a Program; 3]>,
}

/// The same as tapes.
pub(crate) struct RequestedTapes {
    momentum_rates: Option<Tape>,
    velocities: Option<Tape>,
    energy_rate: Option<Tape>,
    sensitivities: Option<Sensitivities>,
    regressor: Option<[Tape; 3]>,
}

struct Sensitivities {
    tape: Tape,
    outputs: LinearizationOutputs,
    parameters: Vec<Symbol>,
}

impl RequestedTapes {
    pub(crate) fn new(programs: &RequestedPrograms<'_>, stand_ins: &StandIns) -> Self {
        let tape = |program: &Program| {
            let mut tape = Tape::of_program(program);
            tape.use_stand_ins(stand_ins);
            tape
        };
        let sensitivities = programs.sensitivities.as_ref();
        Self {
            momentum_rates: programs.momentum_rates.map(tape),
            velocities: programs.velocities.map(tape),
            energy_rate: programs.energy_rate.map(tape),
            sensitivities: sensitivities.map(|program| Sensitivities {
                tape: tape(program.program),
                outputs: match program.pivots {
                    Some(pivots) => LinearizationOutputs::Solved(pivots),
                    None => LinearizationOutputs::System,
                },
                parameters: program.parameters.to_vec(),
            }),
            regressor: programs.regressor.map(|all| all.map(tape)),
        }
    }

    /// The rates of the momenta and of the energy.
    pub(crate) fn compare_rates(
        &self,
        at: impl Fn(&Tape) -> Vec<f64>,
        values: &Values,
        comparisons: &mut Comparisons,
    ) {
        if let Some(tape) = &self.momentum_rates {
            comparisons.balances(Method::MomentumRates, &at(tape), &values.momentum_rates);
        }
        if let Some(tape) = &self.energy_rate {
            comparisons.balances(Method::EnergyRate, &at(tape), &[values.energy_rate]);
        }
    }

    /// M (v − q̇) = p − p(q, q̇, t) for the velocities v that have the momenta p which are given.
    pub(crate) fn compare_velocities(
        &self,
        at: impl Fn(&Tape) -> Vec<f64>,
        mass: &SquareMatrix,
        (velocities, momenta): (&[f64], &[f64]),
        given: &[f64],
        comparisons: &mut Comparisons,
    ) {
        let Some(tape) = &self.velocities else {
            return;
        };
        // Pivots stand before them.
        let found = at(tape);
        let found = found
            .get(found.len() - velocities.len()..)
            .unwrap_or_default();
        let differences = found.iter().zip(velocities).map(|(v, before)| v - before);
        let mut balances = mass.times(&differences.collect::<Vec<_>>());
        for ((balance, momentum), given) in balances.iter_mut().zip(momenta).zip(given) {
            balance.add(*momentum);
            balance.add(-given);
        }
        comparisons.vanishing(Method::Velocities, &balances);
    }

    /// Y π + r, with M q̈ − f at the same accelerations, behind which the residuals of constraints stand.
    pub(crate) fn compare_regressor(
        &self,
        at: impl Fn(&Tape) -> Vec<f64>,
        residuals: &[SumWithSize],
        comparisons: &mut Comparisons,
    ) {
        let Some([columns, known, base]) = &self.regressor else {
            return;
        };
        let known = at(known);
        let residuals = &residuals[..known.len().min(residuals.len())];
        let mut sums = vec![SumWithSize::default(); residuals.len()];
        for (sum, term) in sums.iter_mut().zip(known) {
            sum.add(term);
        }
        let columns = at(columns);
        for (column, parameter) in columns.chunks(residuals.len().max(1)).zip(at(base)) {
            for (sum, entry) in sums.iter_mut().zip(column) {
                sum.add(entry * parameter);
            }
        }
        for (sum, residual) in sums.iter_mut().zip(residuals) {
            sum.total -= residual.total;
            sum.size += residual.size;
        }
        comparisons.vanishing(Method::Regressor, &sums);
    }

    /// The derivatives of the accelerations by parameters.
    pub(crate) fn compare_sensitivities(
        &self,
        at: impl Fn(&Tape) -> Vec<f64>,
        lagrange: &Lagrange,
        (mass, accelerations): (&SquareMatrix, &[f64]),
        (point, perturbation): (RealPoint, Perturbation),
        comparisons: &mut Comparisons,
    ) {
        let Some(sensitivities) = &self.sensitivities else {
            return;
        };
        let parameters = &sensitivities.parameters;
        let weights: Vec<f64> = (0..parameters.len()).map(|i| point.weight(3, i)).collect();
        let n = lagrange.coordinates;
        let mut variation = Variation {
            state: vec![0.0; 2 * n + 1],
            inputs: vec![0.0; lagrange.inputs],
            velocities: vec![0.0; n],
            parameters: parameters
                .iter()
                .copied()
                .zip(weights.iter().copied())
                .collect(),
        };
        let values = lagrange.values(point, &variation, accelerations, perturbation);
        let Some(values) = values else {
            return;
        };
        let outputs = at(&sensitivities.tape);
        // The columns stand where those by the state do; there are none by inputs.
        (variation.state, variation.inputs) = (weights, Vec::new());
        let check = LinearizationCheck {
            inputs: outputs.clone(),
            state: outputs,
            linearization_outputs: sensitivities.outputs,
        };
        let balances = check.balances(mass, accelerations, &values.variations, &variation);
        comparisons.vanishing(Method::Sensitivities, &balances);
    }
}
