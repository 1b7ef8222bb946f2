//! Errors in declared derivatives.

use core::fmt;

use crate::error_messages::error_messages;
use crate::limits::derivative_checks::REPORTED_ARGUMENTS;
use crate::model::FunctionSignature;
use crate::number_format::{Readable, write_values};

/// The point at which a function was evaluated: the names and values of its first four arguments.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArgumentValues {
    names: &'static [&'static str],
    values: [f64; REPORTED_ARGUMENTS],
    count: usize,
}

impl ArgumentValues {
    pub(crate) fn new(names: &'static [&'static str], values: &[f64]) -> Self {
        let mut reported = [f64::NAN; REPORTED_ARGUMENTS];
        for (slot, value) in reported.iter_mut().zip(values) {
            *slot = *value;
        }
        Self {
            names,
            values: reported,
            count: values.len(),
        }
    }

    /// Returns the names and the values, in order.
    pub fn iter(&self) -> impl Iterator<Item = (&'static str, f64)> + '_ {
        let names = self.names.iter().copied();
        names.zip(self.values).take(self.count)
    }
}

impl fmt::Display for ArgumentValues {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let left_out = self.count.saturating_sub(REPORTED_ARGUMENTS);
        write_values(f, "=", self.iter(), left_out)
    }
}

/// The reason why declared derivatives are wrong or could not be checked.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum DerivativeError {
    /// A declared derivative differs from the numerical derivative of the values.
    Wrong {
        /// The function.
        function: &'static str,
        /// The argument by which it is differentiated.
        argument: &'static str,
        /// The point at which they differ most.
        point: ArgumentValues,
        /// The declared derivative at this point.
        declared: f64,
        /// The numerical derivative at this point.
        measured: f64,
        /// The estimated error of the numerical derivative.
        uncertainty: f64,
    },
    /// No numerical derivative of the function is accurate enough anywhere in the region.
    NoNumericalDerivative {
        /// The function.
        function: &'static str,
        /// The argument by which it is differentiated.
        argument: &'static str,
    },
    /// A value of the function is not finite.
    NonFiniteValue {
        /// The function.
        function: &'static str,
        /// The point at which it has this value.
        point: ArgumentValues,
        /// The value.
        value: f64,
    },
    /// No derivative of the function is declared.
    NotDeclared {
        /// The function.
        function: &'static str,
    },
    /// The range of an argument is empty or not finite.
    InvalidRange {
        /// The function.
        function: &'static str,
        /// The argument.
        argument: &'static str,
    },
    /// There are more or fewer ranges than the function has arguments.
    ArgumentCount {
        /// The function.
        function: &'static str,
        /// The number of its arguments.
        expected: usize,
        /// The number of ranges.
        found: usize,
    },
    /// The model has no function of this name.
    UnknownFunction {
        /// The functions of the model.
        known: &'static [FunctionSignature],
    },
}

error_messages! { DerivativeError:
    Self::Wrong { function, argument, point, declared, measured, uncertainty } =>
        "the declared derivative ∂{function}/∂{argument} is {} where {point}, but the numerical derivative \
         of `{function}` there is {} within {uncertainty:.1e}",
        Readable(declared), Readable(measured);
    Self::NoNumericalDerivative { function, argument } =>
        "no numerical derivative ∂{function}/∂{argument} is accurate: the values jump or are noisy \
         everywhere in this region";
    Self::NonFiniteValue { function, point, value } =>
        "`{function}` is {value} where {point}: choose a region in which it has values";
    Self::NotDeclared { function } => "no derivative of `{function}` is declared";
    Self::InvalidRange { function, argument } =>
        "the range of `{argument}`, an argument of `{function}`, must be finite and not empty";
    Self::ArgumentCount { function, expected, found } =>
        "`{function}` has {expected} arguments: write a range for each, not {found}";
    Self::UnknownFunction { known } =>
        "there is no function of this name; those of the declaration are{}",
        Names(known);
}

/// The names of functions in a message.
struct Names(&'static [FunctionSignature]);

impl fmt::Display for Names {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (position, signature) in self.0.iter().enumerate() {
            let separator = if position == 0 { " " } else { ", " };
            write!(f, "{separator}`{}`", signature.name)?;
        }
        Ok(())
    }
}
