//! The Taylor series of a motion.

use lagrangian_symbolic::{
    Equations, FirstOrderEquations, Graph, ImplicitEquations, Model, NoSeries, Program,
    SeriesCheck, SeriesOutputs, TaylorProgram,
};

use super::method::Method;
use super::methods::Methods;
use super::outputs::{AccelerationOutputs, MethodOutputs, OutputSlice, ProgramLayout};
use crate::limits::in_range;

/// The programs for the Taylor coefficients of a motion.
pub(crate) struct TaylorMethod {
    /// Order 0, and the invariants of the recurrence.
    pub(crate) initial: Method,
    pub(crate) rates: Rates,
    pub(crate) invariants: OutputSlice,
    pub(crate) program: TaylorProgram,
}

/// The rates of order 0.
pub(crate) enum Rates {
    /// Of velocities.
    Accelerations(AccelerationOutputs),
    /// Of quasi-velocities.
    QuasiVelocities(OutputSlice),
}

/// Why a model has no Taylor series.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum NoTaylorSeries {
    /// The accelerations depend on an external function that has none.
    ExternalFunction(NoSeries),
    /// The recurrence does not give the derivatives of the accelerations, which is a defect of this crate.
    Wrong,
}

impl Methods {
    /// The Taylor series of the motion: that of q̇ and q̈ by the program for q̈ or by implicit equations, or that of
    /// quasi-velocities and their rates, whichever recurrence takes fewest operations. What is prepared serves both.
    pub(crate) fn taylor_method(
        &mut self,
        model: &mut Model,
        equations: &Equations,
    ) -> Result<TaylorMethod, NoTaylorSeries> {
        let choices = if self.kinetics.needs_pivoting(&mut model.graph) {
            self.series_with_pivoting(model)
        } else {
            self.series_without_pivoting(model, equations)
        };
        let mut choices = choices?;
        choices.sort_by_key(|(_, method)| method.program.cost());
        let unknowns = self.kinetics.system.forcing.len();
        for (preparation, method) in choices {
            let accelerations = &self.accelerations;
            let accelerations = (&accelerations.program, accelerations.outputs.pivots());
            let (graph, program) = (&model.graph, &method.program);
            let is_numerical = match &method.rates {
                Rates::Accelerations(outputs) => outputs.is_numerical(),
                Rates::QuasiVelocities(_) => false,
            };
            let solution = (unknowns, is_numerical);
            let check = SeriesCheck::new(graph, &preparation, accelerations, program, solution);
            if check.agrees() {
                self.prepare = Method::preparation(preparation);
                return Ok(method);
            }
        }
        Err(NoTaylorSeries::Wrong)
    }

    /// The series by all ways in which no pivot has to be chosen.
    fn series_without_pivoting(
        &self,
        model: &mut Model,
        equations: &Equations,
    ) -> Result<Vec<(Program, TaylorMethod)>, NoTaylorSeries> {
        let accelerations = self.series_of_accelerations(&model.graph)?;
        let mut choices = vec![(self.prepare.program.clone(), accelerations)];
        for choice in self.kinetics.first_order_equations(model, equations) {
            choices.extend(self.series_of_first_order(model, &choice));
        }
        for choice in self.kinetics.implicit_equations(model, equations) {
            choices.extend(self.series_of_implicit_equations(model, &choice));
        }
        Ok(choices)
    }

    /// The series by the numerical solution of the saddle point problem of dependent constraints.
    fn series_with_pivoting(
        &self,
        model: &Model,
    ) -> Result<Vec<(Program, TaylorMethod)>, NoTaylorSeries> {
        // Whether there is a series at all is said by the simplest.
        self.series_of_accelerations(&model.graph)?;
        let system = ImplicitEquations {
            residuals: self.kinetics.system.inverse_dynamics.clone(),
            solution: Vec::new(),
        };
        let implicit = self.series_of_implicit_equations(model, &system);
        implicit
            .map(|choice| vec![choice])
            .ok_or(NoTaylorSeries::Wrong)
    }

    /// The series from the program for q̈.
    fn series_of_accelerations(&self, graph: &Graph) -> Result<TaylorMethod, NoTaylorSeries> {
        let method = &self.accelerations;
        let program = &method.program;
        let MethodOutputs::Accelerations(outputs) = &method.outputs else {
            return Err(NoTaylorSeries::Wrong);
        };
        let operands = match outputs {
            AccelerationOutputs::Symbolic { accelerations, .. } => {
                SeriesOutputs::Accelerations(accelerations.operands(program))
            }
            AccelerationOutputs::Numerical { mass, forcing } => {
                SeriesOutputs::System(mass.0.operands(program), forcing.operands(program))
            }
        };
        let taylor = TaylorProgram::of(graph, program, operands);
        let taylor = taylor.map_err(NoTaylorSeries::ExternalFunction)?;
        Ok(TaylorMethod::of_accelerations(taylor, outputs.clone()))
    }

    /// The series of coordinates and quasi-velocities or other variables, and the setup program with their invariants; none if a constant is
    /// beyond the range of `f64`.
    fn series_of_first_order(
        &self,
        model: &Model,
        equations: &FirstOrderEquations,
    ) -> Option<(Program, TaylorMethod)> {
        let mut layout = ProgramLayout::new();
        let values = layout.add(&equations.values);
        layout.begin_group();
        let velocities = layout.add(&equations.velocities);
        let rates = layout.add(&equations.rates);
        let (preparation, kernel) = self.staged(model, &layout);
        let outputs = SeriesOutputs::QuasiVelocities {
            values: values.operands(&kernel),
            velocities: velocities.operands(&kernel),
            rates: rates.operands(&kernel),
        };
        let taylor = TaylorProgram::of(&model.graph, &kernel, outputs).ok()?;
        let method = TaylorMethod {
            invariants: OutputSlice::of_last_group(&taylor.initial),
            initial: Method::initial(&taylor, MethodOutputs::Vector(rates.clone())),
            rates: Rates::QuasiVelocities(rates),
            program: taylor,
        };
        method.in_range(preparation)
    }

    /// The series of accelerations by implicit equations, and the setup program with their invariants; none if a constant
    /// is beyond the range of `f64`.
    fn series_of_implicit_equations(
        &self,
        model: &Model,
        equations: &ImplicitEquations,
    ) -> Option<(Program, TaylorMethod)> {
        let mut layout = ProgramLayout::new();
        let rates = if equations.solution.is_empty() {
            AccelerationOutputs::add_system_to(&mut layout, &self.kinetics)
        } else {
            AccelerationOutputs::add_to(&mut layout, &self.kinetics)
        };
        layout.begin_group();
        let residuals = layout.add(&equations.residuals);
        let solution = layout.add(&equations.solution);
        let (preparation, kernel) = self.staged(model, &layout);
        let outputs = SeriesOutputs::Implicit {
            accelerations: match &rates {
                AccelerationOutputs::Symbolic { accelerations, .. } => {
                    accelerations.operands(&kernel)
                }
                AccelerationOutputs::Numerical { .. } => &[],
            },
            residuals: residuals.operands(&kernel),
            solution: solution.operands(&kernel),
        };
        let taylor = TaylorProgram::of(&model.graph, &kernel, outputs).ok()?;
        TaylorMethod::of_accelerations(taylor, rates).in_range(preparation)
    }

    /// The setup program with the invariants of what is laid out, too, and the rest.
    fn staged(&self, model: &Model, layout: &ProgramLayout) -> (Program, Program) {
        let whole = Program::schedule_for_staging(&model.graph, &layout.groups());
        let mut preparation = self.prepare.program.clone();
        let staged = whole.staged(model.graph.passes);
        let kernel = staged.with_setup_in(&mut preparation);
        (preparation, kernel)
    }
}

impl TaylorMethod {
    /// The method that finds the accelerations of order 0 so.
    fn of_accelerations(taylor: TaylorProgram, outputs: AccelerationOutputs) -> Self {
        Self {
            invariants: OutputSlice::of_last_group(&taylor.initial),
            initial: Method::initial(&taylor, MethodOutputs::Accelerations(outputs.clone())),
            rates: Rates::Accelerations(outputs),
            program: taylor,
        }
    }

    /// The method with its setup program, unless one has a constant beyond the range of `f64`.
    fn in_range(self, preparation: Program) -> Option<(Program, Self)> {
        let Self { program, .. } = &self;
        let programs = [&preparation, &program.initial, &program.recurrence];
        let is_in_range = programs
            .into_iter()
            .flat_map(Program::constants)
            .all(in_range);
        is_in_range.then_some((preparation, self))
    }
}

impl Method {
    /// The method for the terms of order 0.
    pub(super) fn initial(taylor: &TaylorProgram, outputs: MethodOutputs) -> Self {
        Self {
            count: taylor.initial.count(),
            program: taylor.initial.clone(),
            outputs,
        }
    }
}
