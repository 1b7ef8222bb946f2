//! Taylor series of the values of a program (Moore, Interval Analysis, 1966, chapter 11; Griewank and Walther,
//! Evaluating Derivatives, 2nd edition 2008, section 13.2).
//!
//! Input: a program of coordinates, velocities, inputs and time. Output: the program once more, for the terms of order 0,
//! and a recurrence for those of any order k ≥ 1. In the recurrence a product is
//! wₖ = Σ xᵢ yₖ₋ᵢ = x₀ yₖ + xₖ y₀ + Σ₀﹤ᵢ﹤ₖ xᵢ yₖ₋ᵢ, and every other operation is made of such products. The last
//! sum, over orders below k, is a [convolution](Convolution), which a loop accumulates; what is left is linear in the
//! terms of order k, and short.

mod assembly;
mod builder;
mod series;
mod external_functions;
mod functions;
mod implicit;
mod linear_forms;
mod logistic;
mod quotients;
mod terms;

use crate::limits::COST_OF_CONVOLUTION;
use crate::program::liveness::LiveValues;
use crate::program::straight_line::{Operand, Program};
use crate::{Graph, Symbol};
use builder::Builder;
use quotients::with_quotients;
use series::ZERO;

pub use series::{Convolution, NoSeries};

/// The program for the Taylor coefficients of the outputs of another program.
///
/// Coefficient k of the coordinates, velocities, quasi-velocities, inputs and time is what the
/// [recurrence](Self::recurrence) reads as these symbols.
#[derive(Clone, Debug)]
pub struct TaylorProgram {
    /// Order 0. The first groups are those of the program, where quasi-velocities are read as the values of those; the last
    /// one computes the invariants of the recurrence.
    pub initial: Program,
    /// Order k ≥ 1. The first group computes the coefficients of the values, of the velocities and the rates of the
    /// quasi-velocities or, where accelerations are solved for numerically, of f − Σ₀﹤ᵢ≤ₖ Mᵢ q̈ₖ₋ᵢ; the second one, to
    /// which the accelerations are known, the factors of the convolutions.
    pub recurrence: Program,
    /// The sums of orders below k.
    pub convolutions: Vec<Convolution>,
    /// The number of quasi-velocities, whose rates follow the velocities in the values; none where the values are others.
    pub quasi_velocities: Option<usize>,
}

/// The outputs of a program whose series are wanted.
#[derive(Clone, Copy, Debug)]
pub enum SeriesOutputs<'a> {
    /// q̈, in terms of q and q̇.
    Accelerations(&'a [Operand]),
    /// The lower triangle of M, row by row, and f: q̈ is solved for numerically.
    System(&'a [Operand], &'a [Operand]),
    /// q̈, from the series of M q̈ − f and the solution of M x = r.
    Implicit {
        /// q̈, in a group before the others; none where it is solved for numerically.
        accelerations: &'a [Operand],
        /// M q̈ − f, in terms of q̈.
        residuals: &'a [Operand],
        /// x, in terms of r; empty where q̈ is solved for numerically.
        solution: &'a [Operand],
    },
    /// q̇ and ẇ, in terms of q and w.
    QuasiVelocities {
        /// w, in terms of q and q̇, in a group before the others.
        values: &'a [Operand],
        /// q̇.
        velocities: &'a [Operand],
        /// ẇ.
        rates: &'a [Operand],
    },
    /// Some values along a motion.
    Values(&'a [Operand]),
}

impl SeriesOutputs<'_> {
    /// All but w.
    fn operands(&self) -> impl Iterator<Item = &Operand> {
        let (first, second) = match self {
            Self::Accelerations(operands)
            | Self::Values(operands)
            | Self::Implicit {
                residuals: operands,
                ..
            } => (*operands, &[][..]),
            Self::System(mass, forcing) => (*mass, *forcing),
            Self::QuasiVelocities {
                velocities, rates, ..
            } => (*velocities, *rates),
        };
        first.iter().chain(second)
    }

    /// The velocities and quasi-velocities that are constants of motion, since their rate is 0.
    fn constants_of_motion(&self) -> Vec<Symbol> {
        let (rates, symbol): (_, fn(u32) -> Symbol) = match self {
            Self::Accelerations(accelerations) | Self::Implicit { accelerations, .. } => {
                (*accelerations, Symbol::Velocity)
            }
            Self::QuasiVelocities { rates, .. } => (*rates, Symbol::QuasiVelocity),
            Self::System(..) | Self::Values(_) => (&[][..], Symbol::Velocity),
        };
        let rates = (0..).map(symbol).zip(rates);
        let constant = rates.filter(|(_, rate)| **rate == ZERO);
        constant.map(|(symbol, _)| symbol).collect()
    }
}

impl TaylorProgram {
    /// The number of factors of convolutions.
    #[must_use]
    pub fn factors(&self) -> usize {
        self.recurrence
            .groups
            .last()
            .map_or(0, |group| group.outputs.len())
    }

    /// The cost of a term of the recurrence, in additions.
    #[must_use]
    pub fn cost(&self) -> usize {
        self.recurrence.count().cost() + COST_OF_CONVOLUTION * self.convolutions.len()
    }

    /// The Taylor series of what `program` returns, a program scheduled from `graph`.
    ///
    /// # Errors
    ///
    /// It applies an external function whose derivatives of all orders do not follow from the declared ones.
    pub fn of(
        graph: &Graph,
        program: &Program,
        outputs: SeriesOutputs<'_>,
    ) -> Result<Self, NoSeries> {
        let mut builder = Builder::new(graph, program, outputs.constants_of_motion());
        let instructions = with_quotients(program);
        let live = LiveValues::of(outputs.operands(), instructions.iter());
        for instruction in instructions.iter().filter(|one| live.contain(one)) {
            builder.append(&instruction.operation, instruction.value)?;
        }
        let coefficients = if let SeriesOutputs::System(mass, forcing) = outputs {
            builder.residuals(mass, forcing)
        } else {
            let series = outputs.operands().map(|operand| builder.series(operand));
            series.map(|series| series.coefficient).collect()
        };
        if let SeriesOutputs::Implicit { solution, .. } = outputs {
            return Ok(builder.solved(program, &coefficients, solution));
        }
        let mut taylor = builder.finish(program, coefficients);
        if let SeriesOutputs::QuasiVelocities { values, .. } = outputs {
            taylor.quasi_velocities = Some(values.len());
            taylor.initial.replace_symbols(|symbol| match symbol {
                Symbol::QuasiVelocity(i) => values.get(i as usize).cloned(),
                _ => None,
            });
        }
        Ok(taylor)
    }
}
