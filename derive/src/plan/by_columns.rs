//! The matrices of models with many coordinates, which are computed column by column in loops at run time.
//!
//! As one program, M takes operations in proportion to the square of their number, and so do the derivatives of the
//! accelerations: more than compilers survive. What the columns are computed from are programs that are emitted anyhow: the
//! momenta, and the inverse dynamics on dual numbers.

use lagrangian_symbolic::{Kinetics, Model, OperationCount, Program};

use super::method::Method;
use super::outputs::{Columns, MethodOutputs};
use super::requested::Requested;
use crate::limits::DIRECTIONS_AT_ONCE;

/// Which matrices are computed column by column.
pub(super) struct ByColumns {
    pub(super) mass: bool,
    /// The derivatives of the accelerations by q, q̇, t and the inputs.
    pub(super) derivatives: bool,
}

impl ByColumns {
    /// Those of a model: derivatives only if the model is one on dual numbers, on which external functions have derivatives
    /// that may not be the declared ones; M unless velocities change it.
    pub(super) fn of(model: &Model, kinetics: &Kinetics, requested: &Requested) -> Self {
        let (graph, limits) = (&model.graph, requested.limits);
        let mass = kinetics.mass.concat();
        let is_constant = |entry| !graph.contents(entry).has_velocity();
        let columns = 2 * model.coordinates as usize + 1;
        Self {
            mass: graph.cost(&mass) > limits.costliest_mass_matrix
                && mass.iter().all(|entry| is_constant(*entry)),
            derivatives: requested.is_on_every_scalar
                && kinetics.constraints.is_empty()
                && graph.functions().next().is_none()
                && columns.saturating_mul(graph.cost(&kinetics.inverse_dynamics))
                    > limits.costliest_derivatives,
        }
    }
}

impl Method {
    fn by_columns(columns: Columns, count: OperationCount) -> Self {
        Self {
            program: Program::default(),
            outputs: MethodOutputs::ByColumns(columns),
            count,
        }
    }

    /// M, whose columns are the momenta at unit velocities less those at rest.
    pub(super) fn mass_matrix_by_columns(model: &Model, momenta: &Self) -> Self {
        let n = model.coordinates as usize;
        let mut count = times(n + 1, &momenta.count);
        count.additions += n * n;
        Self::by_columns(Columns::MassMatrix, count)
    }

    /// The derivatives of the accelerations by the state and by the inputs, from the inverse dynamics; with what is computed
    /// once: what is prepared, the accelerations and M.
    pub(super) fn derivatives_by_columns(
        model: &Model,
        inverse_dynamics: &Self,
        [prepare, accelerations, mass_matrix]: [&Self; 3],
    ) -> [Self; 2] {
        let n = model.coordinates as usize;
        let method = |columns, directions: usize, accelerations: &OperationCount| {
            let evaluations = directions.div_ceil(DIRECTIONS_AT_ONCE);
            let counts = [
                times(evaluations, &on_duals(&inverse_dynamics.count)),
                on_duals(&prepare.count),
                *accelerations,
                mass_matrix.count,
            ];
            let count = counts.iter().fold(OperationCount::default(), sum);
            let columns_solved = evaluations * DIRECTIONS_AT_ONCE;
            Self::by_columns(columns, count).with_solution(n, columns_solved)
        };
        let accelerations = sum(prepare.count, &accelerations.count);
        [
            method(Columns::Linearization, 2 * n + 1, &accelerations),
            method(
                Columns::InputJacobian,
                model.inputs as usize,
                &OperationCount::default(),
            ),
        ]
    }
}

fn sum(first: OperationCount, other: &OperationCount) -> OperationCount {
    OperationCount {
        additions: first.additions + other.additions,
        multiplications: first.multiplications + other.multiplications,
        divisions: first.divisions + other.divisions,
        square_roots: first.square_roots + other.square_roots,
        sines_and_cosines: first.sines_and_cosines + other.sines_and_cosines,
        functions: first.functions + other.functions,
    }
}

fn times(factor: usize, count: &OperationCount) -> OperationCount {
    OperationCount {
        additions: factor * count.additions,
        multiplications: factor * count.multiplications,
        divisions: factor * count.divisions,
        square_roots: factor * count.square_roots,
        sines_and_cosines: factor * count.sines_and_cosines,
        functions: factor * count.functions,
    }
}

/// What a program takes on dual numbers of several directions: of a product, the derivative in each has two products and a
/// sum, and so on; that of a function takes another one, once.
fn on_duals(count: &OperationCount) -> OperationCount {
    let d = DIRECTIONS_AT_ONCE;
    let OperationCount {
        additions,
        multiplications,
        divisions,
        square_roots,
        sines_and_cosines,
        functions,
    } = *count;
    OperationCount {
        additions: (1 + d) * additions
            + d * (multiplications + divisions)
            + 2 * square_roots
            + sines_and_cosines,
        multiplications: (1 + 2 * d) * multiplications
            + d * divisions
            + 2 * d * sines_and_cosines
            + d * functions,
        divisions: (1 + d) * divisions + d * square_roots,
        square_roots,
        sines_and_cosines,
        functions: 2 * functions,
    }
}
