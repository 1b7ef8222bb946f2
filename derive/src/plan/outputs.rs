//! What the outputs of a program are.
//!
//! A program computes groups of outputs, one after the other. The position of each quantity in them is noted here
//! while the groups are put together, so that the writer of a method asks for a quantity by its name.

use core::ops::Range;

use lagrangian_symbolic::{Expression, Kinetics, LinearSystem, Operand, Program};

use crate::syntax::shape::Shape;

/// Consecutive outputs of one group.
#[derive(Clone, Debug)]
pub(crate) struct OutputSlice {
    group: usize,
    range: Range<usize>,
}

impl OutputSlice {
    /// All outputs of a group.
    pub(crate) fn of_group(program: &Program, group: usize) -> Self {
        let outputs = program.groups.get(group).map(|group| group.outputs.len());
        Self {
            group,
            range: 0..outputs.unwrap_or(0),
        }
    }

    /// All outputs of the last group.
    pub(crate) fn of_last_group(program: &Program) -> Self {
        Self::of_group(program, program.groups.len().saturating_sub(1))
    }

    /// The group that computes them.
    pub(crate) const fn group(&self) -> usize {
        self.group
    }

    pub(crate) fn len(&self) -> usize {
        self.range.len()
    }

    /// The index among them of the output of a group at a position.
    pub(crate) fn index_of(&self, group: usize, position: usize) -> Option<usize> {
        let is_among = self.group == group && self.range.contains(&position);
        is_among.then(|| position - self.range.start)
    }

    /// These among the outputs of each group.
    pub(crate) fn of<'a, T>(&self, outputs: &'a [Vec<T>]) -> &'a [T] {
        let outputs = outputs.get(self.group);
        let slice = outputs.and_then(|outputs| outputs.get(self.range.clone()));
        slice.unwrap_or_default()
    }

    /// What a program returns for them.
    pub(crate) fn operands<'a>(&self, program: &'a Program) -> &'a [Operand] {
        let group = program.groups.get(self.group);
        let slice = group.and_then(|group| group.outputs.get(self.range.clone()));
        slice.unwrap_or_default()
    }
}

/// The lower triangle of the mass matrix.
#[derive(Clone, Debug)]
pub(crate) struct LowerTriangle(pub(crate) OutputSlice);

impl LowerTriangle {
    /// The position of an entry on or below the diagonal: entries stand row by row.
    pub(crate) const fn position(row: usize, column: usize) -> usize {
        row * (row + 1) / 2 + column
    }
}

/// The columns of the derivatives of one quantity for each coordinate by q, q̇ and t.
#[derive(Clone, Debug)]
pub(crate) struct StateJacobian {
    pub(crate) position: OutputSlice,
    pub(crate) velocity: OutputSlice,
    pub(crate) time: OutputSlice,
}

/// What a program for q̈ returns.
#[derive(Clone, Debug)]
pub(crate) enum AccelerationOutputs {
    /// q̈, with the multipliers behind, was solved for symbolically, which holds where all pivots are positive.
    Symbolic {
        pivots: OutputSlice,
        accelerations: OutputSlice,
    },
    /// M and f, up to a common factor: M q̈ = f is solved numerically. In a constrained model they are the matrix and the
    /// right-hand side of the saddle point problem for q̈ and the multipliers.
    Numerical {
        mass: LowerTriangle,
        forcing: OutputSlice,
    },
}

impl AccelerationOutputs {
    /// Adds what q̈ is found from.
    pub(crate) fn add_to(layout: &mut ProgramLayout, kinetics: &Kinetics) -> Self {
        if let Some(solution) = &kinetics.solution {
            return Self::Symbolic {
                pivots: layout.add(&solution.pivots),
                accelerations: layout.add(&solution.accelerations),
            };
        }
        Self::add_system_to(layout, kinetics)
    }

    /// Adds the system for numerical solution.
    pub(crate) fn add_system_to(layout: &mut ProgramLayout, kinetics: &Kinetics) -> Self {
        Self::Numerical {
            mass: layout.add_mass(&kinetics.system),
            forcing: layout.add(&kinetics.system.forcing),
        }
    }

    /// Whether q̈ is solved for numerically.
    pub(crate) const fn is_numerical(&self) -> bool {
        matches!(self, Self::Numerical { .. })
    }
}

/// What a program for derivatives of q̈ returns, where these columns stand.
#[derive(Clone, Debug)]
pub(crate) enum DerivativeOutputs<C> {
    /// They were solved for symbolically, which holds where all pivots are positive.
    Symbolic {
        pivots: OutputSlice,
        /// None where no column contains them.
        accelerations: Option<OutputSlice>,
        derivatives: C,
        /// The derivatives of M q̈ − f, where there are pivots that can fail.
        residuals: Option<Residuals<C>>,
    },
    /// M, f and the derivatives of M q̈ − f, up to a common factor.
    Numerical {
        mass: LowerTriangle,
        /// None where no column contains accelerations.
        forcing: Option<OutputSlice>,
        residuals: C,
    },
}

/// The derivatives of M q̈ − f beside those of q̈.
#[derive(Clone, Debug)]
pub(crate) enum Residuals<C> {
    /// Their columns.
    Columns(C),
    /// Their sum along a variation of the state: one column at a time.
    AlongVariation(OutputSlice),
}

/// What the relative pivots of a symbolic solution are computed from.
#[derive(Clone, Debug)]
pub(crate) struct PivotOutputs {
    /// Where one of these is not positive, M is factored numerically.
    pub(crate) positive: OutputSlice,
    /// What q̈ is divided by.
    pub(crate) pivots: OutputSlice,
    /// The magnitudes of their terms.
    pub(crate) magnitudes: OutputSlice,
    /// The diagonal of M, where M is eliminated: then there is one pivot for each coordinate.
    pub(crate) diagonal: OutputSlice,
    /// The positions of the pivots of each coordinate.
    pub(crate) by_coordinate: Vec<Vec<usize>>,
}

/// A matrix that is computed column by column.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Columns {
    /// From the momenta.
    MassMatrix,
    /// From the inverse dynamics.
    Linearization,
    /// From the inverse dynamics.
    InputJacobian,
}

/// What the program of a method returns.
#[derive(Clone, Debug)]
pub(crate) enum MethodOutputs {
    Scalar(OutputSlice),
    Vector(OutputSlice),
    /// Column by column.
    SquareMatrix(OutputSlice),
    /// Column by column, with a row for each constraint.
    ConstraintJacobian(OutputSlice),
    /// The values of the event functions.
    Events(OutputSlice),
    /// The derivatives of each event function by the coordinates and the time.
    EventGradients(OutputSlice),
    /// What depends on the parameters alone.
    Invariants(OutputSlice),
    Accelerations(AccelerationOutputs),
    Linearization(DerivativeOutputs<StateJacobian>),
    InputJacobian(DerivativeOutputs<OutputSlice>),
    Sensitivities(DerivativeOutputs<OutputSlice>),
    /// The velocities that have given momenta, which hold where all pivots are positive.
    Velocities {
        pivots: OutputSlice,
        velocities: OutputSlice,
    },
    RelativePivots(PivotOutputs),
    /// What is positive where a saddle point problem is solved without pivoting.
    Pivots(OutputSlice),
    /// The declared outputs, in their order.
    Declared(Vec<(Shape, OutputSlice)>),
    /// There is no program: a matrix is computed column by column.
    ByColumns(Columns),
}

impl MethodOutputs {
    /// Whether derivatives of M q̈ − f are along a variation, outside of the way that is taken where all pivots are positive.
    pub(crate) fn is_along_variation(&self) -> bool {
        matches!(
            self,
            Self::Linearization(DerivativeOutputs::Symbolic {
                residuals: Some(Residuals::AlongVariation(_)),
                ..
            })
        )
    }

    /// How many pivots there are, if accelerations or their derivatives were solved for symbolically.
    pub(crate) fn pivots(&self) -> Option<usize> {
        match self {
            Self::Accelerations(AccelerationOutputs::Symbolic { pivots, .. })
            | Self::Linearization(DerivativeOutputs::Symbolic { pivots, .. })
            | Self::InputJacobian(DerivativeOutputs::Symbolic { pivots, .. })
            | Self::Sensitivities(DerivativeOutputs::Symbolic { pivots, .. }) => Some(pivots.len()),
            _ => None,
        }
    }
}

/// The outputs of a program that is about to be scheduled, group by group.
pub(crate) struct ProgramLayout {
    groups: Vec<Vec<Expression>>,
}

impl ProgramLayout {
    /// One group without outputs.
    pub(crate) fn new() -> Self {
        Self {
            groups: vec![Vec::new()],
        }
    }

    /// What is added from here on is computed after what was added before.
    pub(crate) fn begin_group(&mut self) {
        self.groups.push(Vec::new());
    }

    /// Adds outputs to the last group, and returns where they are.
    pub(crate) fn add(&mut self, outputs: &[Expression]) -> OutputSlice {
        let group = self.groups.len().saturating_sub(1);
        let mut range = 0..0;
        if let Some(last) = self.groups.last_mut() {
            range.start = last.len();
            last.extend_from_slice(outputs);
            range.end = last.len();
        }
        OutputSlice { group, range }
    }

    /// Adds the lower triangle of M.
    pub(crate) fn add_mass(&mut self, system: &LinearSystem) -> LowerTriangle {
        let rows = system.mass.iter().enumerate();
        let entries = rows.flat_map(|(i, row)| row[..=i].iter().copied());
        let entries: Vec<_> = entries.collect();
        LowerTriangle(self.add(&entries))
    }

    /// Adds the columns of derivatives by `n` coordinates q, by q̇ and t.
    pub(crate) fn add_state_jacobian(&mut self, columns: &[Expression], n: usize) -> StateJacobian {
        let (position, rest) = columns.split_at(n * n);
        let (velocity, time) = rest.split_at(n * n);
        StateJacobian {
            position: self.add(position),
            velocity: self.add(velocity),
            time: self.add(time),
        }
    }

    /// The outputs of each group.
    pub(crate) fn groups(&self) -> Vec<&[Expression]> {
        self.groups.iter().map(Vec::as_slice).collect()
    }
}
