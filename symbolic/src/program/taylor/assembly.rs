//! The Taylor program of a recurrence that is complete.

use super::builder::Builder;
use super::linear_forms::Recurrence;
use super::series::ZERO;
use super::{TaylorProgram, implicit};
use crate::program::liveness::LiveValues;
use crate::program::straight_line::{Operand, OutputGroup, Program};

impl Builder<'_> {
    /// The program, with the coefficients of the accelerations as its results.
    pub(super) fn finish(self, program: &Program, coefficients: Vec<Operand>) -> TaylorProgram {
        let factors = self.factors.into_iter();
        let factors = factors.map(|factor| factor.unwrap_or(ZERO)).collect();
        let recurrence = Recurrence {
            instructions: self.recurrence.list,
            invariants: self.invariants.items,
            outputs: [coefficients, factors],
        };
        let mut in_initial = self.initial;
        let Recurrence {
            instructions,
            invariants,
            outputs: [coefficients, factors],
        } = recurrence.balanced(&mut in_initial);
        let live = LiveValues::of(invariants.iter(), in_initial.list.iter());
        in_initial
            .list
            .retain(|instruction| live.contain(instruction));
        let mut initial = program.clone();
        initial.groups.push(OutputGroup {
            instructions: in_initial.list,
            outputs: invariants,
        });
        initial.renumber();
        TaylorProgram {
            initial,
            recurrence: implicit::in_two_groups(instructions, coefficients, factors),
            convolutions: self.convolutions.items,
            quasi_velocities: None,
        }
    }
}
