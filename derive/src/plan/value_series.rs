//! The Taylor series of values along a motion.

use lagrangian_symbolic::{
    Equations, Expression, Graph, Model, Program, SeriesOutputs, Symbol, TaylorProgram,
    ValueSeriesCheck,
};

use super::method::Method;
use super::methods::Methods;
use super::outputs::{MethodOutputs, OutputSlice, ProgramLayout};
use super::taylor_method::NoTaylorSeries;

/// The program for the Taylor coefficients of the event functions along a motion.
pub(crate) struct EventSeries {
    pub(crate) series: ValueSeries,
    /// For each event the indices of the values at whose zeros it has another branch.
    pub(crate) branches: Vec<Vec<usize>>,
}

/// The program for the Taylor coefficients of the switching functions of the equations of motion.
pub(crate) struct BranchSeries {
    pub(crate) series: ValueSeries,
    pub(crate) functions: Vec<Expression>,
    /// Whether each is one of another one, too.
    pub(crate) are_inner: Vec<bool>,
}

/// The program for the Taylor coefficients of values along a motion.
pub(crate) struct ValueSeries {
    /// The values, and the invariants of the recurrence.
    pub(crate) initial: Method,
    pub(crate) values: OutputSlice,
    pub(crate) invariants: OutputSlice,
    pub(crate) program: TaylorProgram,
}

impl Methods {
    /// The Taylor series of the event functions; none where there are no events, where they apply external functions
    /// without series, or contain reactions.
    pub(crate) fn event_series(
        &self,
        graph: &Graph,
        branches: Vec<Vec<usize>>,
    ) -> Result<Option<EventSeries>, NoTaylorSeries> {
        let Some(method) = &self.event_functions else {
            return Ok(None);
        };
        let MethodOutputs::Events(values) = &method.outputs else {
            return Err(NoTaylorSeries::Wrong);
        };
        let has_reaction = |symbol: &Symbol| matches!(symbol, Symbol::Acceleration(_));
        if method.program.symbols().iter().any(has_reaction) {
            return Ok(None);
        }
        let series = ValueSeries::if_possible(graph, &method.program, values)?;
        Ok(series.map(|series| EventSeries { series, branches }))
    }
}

impl ValueSeries {
    /// The series of the values of a program.
    pub(super) fn of(
        graph: &Graph,
        program: &Program,
        values: &OutputSlice,
    ) -> Result<Self, NoTaylorSeries> {
        let operands = SeriesOutputs::Values(values.operands(program));
        let taylor = TaylorProgram::of(graph, program, operands);
        let taylor = taylor.map_err(NoTaylorSeries::ExternalFunction)?;
        if !ValueSeriesCheck::new(graph, program, &taylor).agrees() {
            return Err(NoTaylorSeries::Wrong);
        }
        Ok(Self {
            values: values.clone(),
            invariants: OutputSlice::of_last_group(&taylor.initial),
            initial: Method::initial(&taylor, MethodOutputs::Vector(values.clone())),
            program: taylor,
        })
    }

    /// The Taylor series of these values; none where the program applies external functions without series.
    fn if_possible(
        graph: &Graph,
        program: &Program,
        values: &OutputSlice,
    ) -> Result<Option<Self>, NoTaylorSeries> {
        match Self::of(graph, program, values) {
            Err(NoTaylorSeries::ExternalFunction(_)) => Ok(None),
            series => series.map(Some),
        }
    }
}

impl BranchSeries {
    /// The series of the arguments whose signs distinguish branches of the equations of motion; none where there are no
    /// branches.
    pub(crate) fn derive(
        model: &mut Model,
        equations: &Equations,
    ) -> Result<Option<Self>, NoTaylorSeries> {
        let mass = equations.mass.iter().flatten();
        let constraints = &equations.constraints;
        let of_constraints = constraints
            .jacobian
            .iter()
            .flatten()
            .chain(&constraints.rates);
        let of_equations = mass.chain(&equations.forcing).chain(of_constraints);
        let of_equations: Vec<_> = of_equations.copied().collect();
        let mut roots = vec![equations.lagrangian, model.dissipation];
        roots.extend(model.forces.iter().chain(&of_equations));
        let functions = model.graph.branch_arguments(&roots);
        if functions.is_empty() {
            return Ok(None);
        }
        let mut layout = ProgramLayout::new();
        let values = layout.add(&functions);
        let program = Program::schedule(&model.graph, &layout.groups());
        let series = ValueSeries::if_possible(&model.graph, &program, &values)?;
        let of_functions = model.graph.branch_arguments(&functions);
        let are_inner = functions
            .iter()
            .map(|function| of_functions.contains(function))
            .collect();
        Ok(series.map(|series| Self {
            series,
            functions,
            are_inner,
        }))
    }
}
