//! The Taylor series of the accelerations.

use lagrangian_symbolic::{
    AccelerationOperands, SeriesCheck, Symbol, TaylorProgram, ValueSeriesCheck,
};

use super::method::Method;
use super::methods::Methods;
use super::outputs::{AccelerationOutputs, MethodOutputs, OutputSlice};

/// The programs for the Taylor coefficients of a motion.
pub(crate) struct TaylorMethod {
    /// The accelerations of order 0, and the invariants of the recurrence.
    pub(crate) initial: Method,
    pub(crate) accelerations: AccelerationOutputs,
    pub(crate) invariants: OutputSlice,
    pub(crate) program: TaylorProgram,
}

/// Why a model has no Taylor series.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum NoTaylorSeries {
    /// The accelerations depend on external functions.
    ExternalFunctions,
    /// The recurrence does not give the derivatives of the accelerations, which is a defect of this crate.
    Wrong,
}

impl Methods {
    /// The Taylor series of the accelerations.
    pub(crate) fn taylor_method(&self, coordinates: usize) -> Result<TaylorMethod, NoTaylorSeries> {
        let method = &self.accelerations;
        let program = &method.program;
        let MethodOutputs::Accelerations(outputs) = &method.outputs else {
            return Err(NoTaylorSeries::Wrong);
        };
        let operands = match outputs {
            AccelerationOutputs::Symbolic { accelerations, .. } => {
                AccelerationOperands::Solved(accelerations.operands(program))
            }
            AccelerationOutputs::Numerical { mass, forcing } => {
                AccelerationOperands::System(mass.0.operands(program), forcing.operands(program))
            }
        };
        let taylor =
            TaylorProgram::of(program, operands).ok_or(NoTaylorSeries::ExternalFunctions)?;
        let programs = self.programs(&[]);
        let preparation = programs.preparation;
        let check = SeriesCheck::new(preparation, programs.accelerations, &taylor, coordinates);
        if !check.agrees() {
            return Err(NoTaylorSeries::Wrong);
        }
        let last = taylor.initial.groups.len().saturating_sub(1);
        Ok(TaylorMethod {
            accelerations: outputs.clone(),
            invariants: OutputSlice::of_group(&taylor.initial, last),
            initial: Method {
                count: taylor.initial.count(),
                program: taylor.initial.clone(),
                outputs: method.outputs.clone(),
            },
            program: taylor,
        })
    }
}

/// The program for the Taylor coefficients of the event functions along a motion.
pub(crate) struct EventSeries {
    /// The values, and the invariants of the recurrence.
    pub(crate) initial: Method,
    pub(crate) values: OutputSlice,
    pub(crate) invariants: OutputSlice,
    pub(crate) program: TaylorProgram,
}

impl Methods {
    /// The Taylor series of the event functions; none where there are no events, or where they apply external functions or
    /// read inputs, whose series the motion's coefficients do not contain.
    pub(crate) fn event_series(&self) -> Result<Option<EventSeries>, NoTaylorSeries> {
        let Some(method) = &self.event_functions else {
            return Ok(None);
        };
        let MethodOutputs::Events(values) = &method.outputs else {
            return Err(NoTaylorSeries::Wrong);
        };
        let program = &method.program;
        let is_input = |symbol: &Symbol| matches!(symbol, Symbol::Input(_));
        if program.symbols().iter().any(is_input) {
            return Ok(None);
        }
        let operands = AccelerationOperands::Solved(values.operands(program));
        let Some(taylor) = TaylorProgram::of(program, operands) else {
            return Ok(None);
        };
        if !ValueSeriesCheck::new(program, &taylor).agrees() {
            return Err(NoTaylorSeries::Wrong);
        }
        let last = taylor.initial.groups.len().saturating_sub(1);
        Ok(Some(EventSeries {
            values: values.clone(),
            invariants: OutputSlice::of_group(&taylor.initial, last),
            initial: Method {
                count: taylor.initial.count(),
                program: taylor.initial.clone(),
                outputs: method.outputs.clone(),
            },
            program: taylor,
        }))
    }
}
