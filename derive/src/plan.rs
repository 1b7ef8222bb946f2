//! Which programs a model's methods are, and what each of them returns.

mod methods;
mod method;
mod constraint_methods;
mod derivatives;
mod outputs;
mod by_columns;
mod variation;
mod requested;
mod table;
mod taylor_method;
mod value_series;
mod series_methods;
mod reduced_methods;
mod prepared_array;
mod branches;
mod undeclared;
mod validation;
pub(crate) mod constants;

pub(crate) use branches::branches_of_events;
pub(crate) use method::Method;
pub(crate) use methods::Methods;
pub(crate) use outputs::{
    AccelerationOutputs, Columns, DerivativeOutputs, LowerTriangle, MethodOutputs, OutputSlice,
    PivotOutputs, Residuals, StateJacobian,
};
pub(crate) use prepared_array::PreparedArray;
pub(crate) use reduced_methods::ReducedMethods;
pub(crate) use requested::Requested;
pub(crate) use series_methods::SeriesMethods;
pub(crate) use table::{
    Argument, EmittedMethod, Interface, MethodRow, PARAMETERS, ParameterSource, ResultType,
    is_method,
};
pub(crate) use taylor_method::{NoTaylorSeries, Rates, TaylorMethod};
pub(crate) use value_series::{BranchSeries, EventSeries, ValueSeries};
