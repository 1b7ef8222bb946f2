//! One method, whose body is one program.

use lagrangian_symbolic::{Expression, Model, OperationCount, Program};

use super::outputs::{MethodOutputs, OutputSlice, ProgramLayout};

/// A method whose body is one program.
pub(crate) struct Method {
    pub(crate) program: Program,
    pub(crate) outputs: MethodOutputs,
    pub(crate) count: OperationCount,
}

impl Method {
    pub(super) fn schedule(model: &Model, layout: &ProgramLayout, outputs: MethodOutputs) -> Self {
        let program = Program::schedule(&model.graph, &layout.phases());
        Self {
            count: program.count(),
            program,
            outputs,
        }
    }

    /// A method that returns all that its program computes.
    pub(super) fn single(
        model: &Model,
        expressions: &[Expression],
        outputs: fn(OutputSlice) -> MethodOutputs,
    ) -> Self {
        let mut layout = ProgramLayout::new();
        let outputs = outputs(layout.add(expressions));
        Self::schedule(model, &layout, outputs)
    }

    /// Counts the factorization of M with `n` rows, and the solution for several right-hand sides.
    pub(super) fn with_solution(mut self, n: usize, right_hand_sides: usize) -> Self {
        let below = n * n.saturating_sub(1) / 2;
        let eliminations = below + n * n.saturating_sub(1) * n.saturating_sub(2) / 6;
        let substitutions = 2 * below * right_hand_sides;
        self.count.additions += eliminations + substitutions;
        self.count.multiplications += eliminations + below + substitutions + n * right_hand_sides;
        self.count.divisions += n;
        self
    }
}
