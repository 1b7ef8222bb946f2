//! Which programs a model's methods are, and what each of them returns.

mod methods;
mod derivatives;
mod outputs;
mod table;
mod undeclared;

pub(crate) use methods::{Method, Methods, in_range};
pub(crate) use outputs::{
    AccelerationOutputs, InputJacobianOutputs, LinearizationOutputs, LowerTriangle, MethodOutputs,
    OutputSlice, PivotOutputs, StateJacobian,
};
pub(crate) use table::{
    Argument, EmittedMethod, Interface, MethodRow, PARAMETERS, ResultType, Variant, is_method,
};
