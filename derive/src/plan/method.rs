//! One method, whose body is one program.

use lagrangian_symbolic::{Expression, Kinetics, Model, OperationCount, Program, Staged};

use super::outputs::{AccelerationOutputs, MethodOutputs, OutputSlice, ProgramLayout};

/// A method whose body is one program.
pub(crate) struct Method {
    pub(crate) program: Program,
    pub(crate) outputs: MethodOutputs,
    pub(crate) count: OperationCount,
}

impl Method {
    pub(super) fn schedule(model: &Model, layout: &ProgramLayout, outputs: MethodOutputs) -> Self {
        let program = Program::schedule(&model.graph, &layout.groups());
        // What is behind pivots that are not positive is not counted.
        let counted = program.groups.len() - usize::from(outputs.is_along_variation());
        Self {
            count: program.count_before(counted),
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

    /// The accelerations in two stages: the invariants, which depend on the parameters alone, and the rest.
    pub(super) fn accelerations(model: &Model, kinetics: &Kinetics) -> [Self; 2] {
        let mut layout = ProgramLayout::new();
        let outputs = AccelerationOutputs::add_to(&mut layout, kinetics);
        let is_numerical = matches!(outputs, AccelerationOutputs::Numerical { .. });
        // Of a solution the layout has the pivots and the accelerations in one group, which may have been scheduled already.
        let whole = match &kinetics.solution {
            Some(solution) => solution.scheduled_for_staging(&model.graph),
            None => Program::schedule_for_staging(&model.graph, &layout.groups()),
        };
        let Staged { setup, kernel } = whole.staged(model.graph.passes);
        let recursion = kinetics.solution.iter();
        let recursion: Vec<_> = recursion
            .flat_map(|solution| &solution.recursion)
            .copied()
            .collect();
        let kernel = kernel.reassociated(model.graph.passes);
        let kernel = kernel.ordered(&model.graph, &recursion);
        let prepare = Self::preparation(setup);
        let accelerations = Self {
            count: kernel.count(),
            outputs: MethodOutputs::Accelerations(outputs),
            program: kernel,
        };
        let accelerations = if is_numerical {
            accelerations.with_solution(kinetics.system.forcing.len(), 1)
        } else {
            accelerations
        };
        [prepare, accelerations]
    }

    /// M q̈ − f, the invariants of which this setup method computes, too.
    pub(super) fn inverse_dynamics(&mut self, model: &Model, kinetics: &Kinetics) -> Self {
        let mut layout = ProgramLayout::new();
        let outputs = MethodOutputs::Vector(layout.add(&kinetics.inverse_dynamics));
        let whole = Program::schedule_for_staging(&model.graph, &layout.groups());
        let staged = whole.staged(model.graph.passes);
        let mut setup = core::mem::take(&mut self.program);
        let mut kernel = staged
            .with_setup_in(&mut setup)
            .reassociated(model.graph.passes);
        // In another order than a recursion's the compiled code of thirty joints loads 830 values, as scheduled 653.
        if !kinetics.recursion.is_empty() {
            kernel = kernel.ordered(&model.graph, &kinetics.recursion);
        }
        *self = Self::preparation(setup);
        Self {
            count: kernel.count(),
            program: kernel,
            outputs,
        }
    }

    /// The method that computes the invariants by a setup program.
    pub(super) fn preparation(setup: Program) -> Self {
        Self {
            count: setup.count(),
            outputs: MethodOutputs::Invariants(OutputSlice::of_group(&setup, 0)),
            program: setup,
        }
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
