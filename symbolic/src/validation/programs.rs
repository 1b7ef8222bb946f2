//! The programs of a model that are validated.

use crate::identity::real_point::RealPoint;
use crate::validation::linearization_check::LinearizationOutputs;
use crate::validation::perturbation::Perturbation;
use crate::validation::requested_check::{RequestedPrograms, RequestedTapes};
use crate::validation::square_matrix::SquareMatrix;
use crate::validation::tape::{StandIns, Tape};
use crate::{Program, Symbol};

/// A validated method: one or more programs that are accepted or rejected together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Method {
    /// L.
    Lagrangian,
    /// T and V.
    Energies,
    /// The energy function.
    Energy,
    /// p.
    Momenta,
    /// M.
    MassMatrix,
    /// f.
    Forcing,
    /// Q.
    GeneralizedForces,
    /// M q̈ − f.
    InverseDynamics,
    /// q̈, and its derivatives.
    Accelerations,
    /// The derivatives of q̈ alone.
    Linearization,
    /// Quantities for observers.
    Outputs,
    /// ∂L/∂q + Q.
    MomentumRates,
    /// q̇ from p.
    Velocities,
    /// Q·q̇ − ∂L/∂t.
    EnergyRate,
    /// g, w, G and γ of the constraints.
    Constraints,
    /// The derivatives of q̈ by parameters.
    Sensitivities,
    /// Y, r and π in M q̈ − f = Y π + r.
    Regressor,
}

impl Method {
    /// Whether the method takes no higher derivatives of the energies than the first.
    pub(crate) const fn takes_first_derivatives(self) -> bool {
        match self {
            Self::Lagrangian
            | Self::Energies
            | Self::Energy
            | Self::Momenta
            | Self::GeneralizedForces
            | Self::Outputs
            | Self::MomentumRates
            | Self::Constraints
            | Self::EnergyRate => true,
            Self::MassMatrix
            | Self::Forcing
            | Self::InverseDynamics
            | Self::Accelerations
            | Self::Linearization
            | Self::Velocities
            | Self::Sensitivities
            | Self::Regressor => false,
        }
    }
}

/// The program for q̈.
#[derive(Clone, Copy)]
pub enum AccelerationProgram<'a> {
    /// As many pivots, then q̈.
    Solved(&'a Program, usize),
    /// The lower triangle of M, row by row, then f, up to a common factor.
    System(&'a Program),
}

/// The programs for derivatives of q̈ by q, q̇ and t, and by the inputs.
#[derive(Clone, Copy)]
pub enum LinearizationProgram<'a> {
    /// As many pivots and q̈, the columns of ∂q̈/∂x, and those of ∂(M q̈ − f)/∂x if there are pivots; by the
    /// inputs the same without q̈.
    Solved {
        /// By q, q̇ and t.
        state: &'a Program,
        /// By the inputs.
        inputs: &'a Program,
        /// The number of pivots.
        pivots: usize,
        /// Whether `state` computes δ(M q̈ − f) along a [variation](Symbol::Variation) in place of the columns of ∂(M q̈ − f)/∂x.
        is_along_variation: bool,
    },
    /// The lower triangle of M and f, and the columns of ∂(M q̈ − f)/∂x, up to a common factor; by the inputs
    /// the same without f.
    System {
        /// By q, q̇ and t.
        state: &'a Program,
        /// By the inputs.
        inputs: &'a Program,
    },
}

/// The program for derivatives of q̈ by parameters.
#[derive(Clone, Copy)]
pub struct SensitivityProgram<'a> {
    /// What a [`LinearizationProgram`] computes by the state, here by parameters.
    pub program: &'a Program,
    /// The number of pivots, if q̈ is solved for symbolically.
    pub pivots: Option<usize>,
    /// The parameters, in the order of the columns.
    pub parameters: &'a [Symbol],
}

/// The programs of the constraints of a model.
#[derive(Clone, Copy)]
pub struct ConstraintPrograms<'a> {
    /// How many of them are holonomic.
    pub holonomic: usize,
    /// Whether the gradients are independent at almost all states; otherwise only states that fulfil the constraints have
    /// accelerations.
    pub are_independent: bool,
    /// g of the holonomic constraints, which are the first ones, and 0 for the others.
    pub positions: &'a Program,
    /// w = G q̇ + a.
    pub velocities: &'a Program,
    /// G, column by column.
    pub jacobian: &'a Program,
    /// γ in G q̈ + γ = 0.
    pub rates: &'a Program,
}

/// The programs of a model.
#[derive(Clone, Copy)]
pub struct Programs<'a> {
    /// L.
    pub lagrangian: &'a Program,
    /// T and V, where they were declared.
    pub energies: Option<[&'a Program; 2]>,
    /// The energy function.
    pub energy: &'a Program,
    /// p.
    pub momenta: &'a Program,
    /// M, row by row; none where its columns are the momenta at unit velocities.
    pub mass_matrix: Option<&'a Program>,
    /// f.
    pub forcing: &'a Program,
    /// Q.
    pub generalized_forces: &'a Program,
    /// M q̈ − f.
    pub inverse_dynamics: &'a Program,
    /// The setup program of q̈ and M q̈ − f, which computes the invariants.
    pub preparation: &'a Program,
    /// q̈, and behind it the multipliers of the constraints.
    pub accelerations: AccelerationProgram<'a>,
    /// Those of the constraints, if there are some.
    pub constraints: Option<ConstraintPrograms<'a>>,
    /// Derivatives of q̈; none where they are those of the inverse dynamics on dual numbers, and with constraints.
    pub linearization: Option<LinearizationProgram<'a>>,
    /// The derivatives of q̈ and the multipliers by the inputs, and the number of pivots if they were solved for
    /// symbolically; of models with constraints.
    pub input_jacobian: Option<(&'a Program, Option<usize>)>,
    /// Quantities for observers, as one program or one after the other.
    pub outputs: &'a [&'a Program],
    /// What clauses ask for.
    pub requested: RequestedPrograms<'a>,
}

/// The programs of the constraints as tapes.
pub(crate) struct ConstraintTapes {
    pub(crate) holonomic: usize,
    pub(crate) are_independent: bool,
    pub(crate) positions: Tape,
    pub(crate) velocities: Tape,
    pub(crate) jacobian: Tape,
    pub(crate) rates: Tape,
}

/// The same as tapes.
pub(crate) struct Tapes {
    pub(crate) lagrangian: Tape,
    /// T and V; nothing where they were not declared.
    pub(crate) energies: Tape,
    pub(crate) energy: Tape,
    pub(crate) momenta: Tape,
    /// None where the momenta give M.
    pub(crate) mass_matrix: Option<Tape>,
    pub(crate) forcing: Tape,
    pub(crate) generalized_forces: Tape,
    pub(crate) inverse_dynamics: Tape,
    pub(crate) outputs: Tape,
    /// By the state and by the inputs, with what they compute.
    pub(crate) linearization: Option<([Tape; 2], LinearizationOutputs)>,
    pub(crate) constraints: Option<ConstraintTapes>,
    pub(crate) input_jacobian: Option<(Tape, Option<usize>)>,
    pub(crate) requested: RequestedTapes,
    preparation: Tape,
    accelerations: Tape,
    /// The number of pivots before q̈, unless M and f are computed.
    pivots: Option<usize>,
}

impl Tapes {
    pub(crate) fn new(programs: &Programs<'_>, stand_ins: &StandIns) -> Self {
        let (accelerations, pivots) = match programs.accelerations {
            AccelerationProgram::Solved(program, pivots) => (program, Some(pivots)),
            AccelerationProgram::System(program) => (program, None),
        };
        let linearization = programs.linearization.map(|programs| match programs {
            LinearizationProgram::Solved {
                state,
                inputs,
                pivots,
                is_along_variation,
            } => {
                let outputs = if is_along_variation {
                    LinearizationOutputs::SolvedAlongVariation(pivots)
                } else {
                    LinearizationOutputs::Solved(pivots)
                };
                ([state, inputs], outputs)
            }
            LinearizationProgram::System { state, inputs } => {
                ([state, inputs], LinearizationOutputs::System)
            }
        });
        let energies = programs.energies.iter().flatten();
        let tape_of = |programs: &mut dyn Iterator<Item = &Program>| {
            let mut tape = Tape::of_programs(programs);
            tape.use_stand_ins(stand_ins);
            tape
        };
        let tape = |program: &Program| tape_of(&mut core::iter::once(program));
        Self {
            lagrangian: tape(programs.lagrangian),
            energies: tape_of(&mut energies.copied()),
            energy: tape(programs.energy),
            momenta: tape(programs.momenta),
            mass_matrix: programs.mass_matrix.map(tape),
            forcing: tape(programs.forcing),
            generalized_forces: tape(programs.generalized_forces),
            inverse_dynamics: tape(programs.inverse_dynamics),
            outputs: tape_of(&mut programs.outputs.iter().copied()),
            linearization: linearization.map(|(programs, outputs)| (programs.map(tape), outputs)),
            constraints: programs.constraints.map(|programs| ConstraintTapes {
                holonomic: programs.holonomic,
                are_independent: programs.are_independent,
                positions: tape(programs.positions),
                velocities: tape(programs.velocities),
                jacobian: tape(programs.jacobian),
                rates: tape(programs.rates),
            }),
            input_jacobian: programs
                .input_jacobian
                .map(|(program, pivots)| (tape(program), pivots)),
            requested: RequestedTapes::new(&programs.requested, stand_ins),
            preparation: tape(programs.preparation),
            accelerations: tape(accelerations),
            pivots,
        }
    }

    /// The values of a program that reads the invariants.
    pub(crate) fn prepared(
        &self,
        tape: &Tape,
        value: impl Fn(Symbol) -> f64,
        perturbation: Perturbation,
    ) -> Vec<f64> {
        let invariants = self.preparation.evaluate(&value, perturbation);
        let symbol = |symbol: Symbol| match symbol {
            Symbol::Invariant(index) => invariants[index as usize],
            _ => value(symbol),
        };
        tape.evaluate(&symbol, perturbation)
    }

    /// Whether the accelerations of a constrained model are solved for with pivoting at a point, by code that is not validated.
    pub(crate) fn uses_pivoting(&self, point: RealPoint) -> bool {
        let Some(pivots) = self.pivots.filter(|_| self.constraints.is_some()) else {
            return false;
        };
        let value = |symbol: Symbol| point.value(symbol);
        let outputs = self.prepared(&self.accelerations, value, Perturbation(None));
        let mut pivots = outputs[..pivots].iter();
        pivots.any(|pivot| pivot.is_nan() || *pivot <= 0.0)
    }

    /// The accelerations at a point, if they exist.
    pub(crate) fn accelerations(
        &self,
        point: RealPoint,
        coordinates: usize,
        perturbation: Perturbation,
    ) -> Option<Vec<f64>> {
        if let Some((matrix, forcing)) = self.system(point, coordinates, perturbation) {
            let constraints = self.constraints.as_ref();
            let are_independent = constraints.is_none_or(|tapes| tapes.are_independent);
            let solution = are_independent.then(|| matrix.solve(&forcing)).flatten();
            return solution.filter(|accelerations| accelerations.iter().all(|x| x.is_finite()));
        }
        let value = |symbol: Symbol| point.value(symbol);
        let mut outputs = self.prepared(&self.accelerations, value, perturbation);
        let accelerations = outputs.split_off(self.pivots?);
        let mut all = accelerations.iter();
        all.all(|x| x.is_finite()).then_some(accelerations)
    }

    /// The matrix and the right-hand side at a point, where the accelerations are solved for numerically.
    pub(crate) fn system(
        &self,
        point: RealPoint,
        coordinates: usize,
        perturbation: Perturbation,
    ) -> Option<(SquareMatrix, Vec<f64>)> {
        if self.pivots.is_some() {
            return None;
        }
        let value = |symbol: Symbol| point.value(symbol);
        let mut lower = self.prepared(&self.accelerations, value, perturbation);
        let forcing = lower.split_off(lower.len() - coordinates);
        Some((SquareMatrix::symmetric(&lower, coordinates), forcing))
    }
}
