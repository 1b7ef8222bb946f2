//! The errors of the inverse dynamics of constrained models.

use crate::error_messages::error_messages;
use crate::number_format::Readable;

/// The reason why no inputs give a constrained model accelerations.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum RequiredInputsError {
    /// The state does not meet the constraints.
    InconsistentState {
        /// The constraint that is violated most.
        constraint: &'static str,
        /// Its residual, or the residual of its velocity if the coordinates meet it.
        residual: f64,
    },
    /// The accelerations do not meet the constraints.
    InconsistentAccelerations {
        /// A constraint that they violate.
        constraint: &'static str,
        /// Its residual G q̈ + γ.
        residual: f64,
    },
    /// The weight of an input is not a positive and finite number.
    Weight {
        /// The index of the input.
        input: usize,
        /// Its weight.
        weight: f64,
    },
    /// The inputs do not act on all degrees of freedom, and the motion would need it.
    TooFewInputs {
        /// The coordinate whose acceleration is missed by most.
        coordinate: &'static str,
        /// What is missing of it.
        missing: f64,
        /// The number of independent accelerations on which inputs act.
        inputs: usize,
        /// The number of degrees of freedom.
        freedoms: usize,
    },
}

error_messages! { RequiredInputsError:
    Self::InconsistentState { constraint, residual } =>
        "the state does not meet the constraint `{constraint}`, whose residual is {}; `assemble` finds a state that does",
        Readable(residual);
    Self::InconsistentAccelerations { constraint, residual } =>
        "the accelerations do not meet the constraint `{constraint}`, whose second derivative would be {}",
        Readable(residual);
    Self::Weight { input, weight } =>
        "the weight of the input {input} has to be positive and finite; it is {}",
        Readable(weight);
    Self::TooFewInputs { coordinate, missing, inputs, freedoms } =>
        "no inputs give these accelerations: `{coordinate}` misses {}, and the inputs act on {inputs} of {freedoms} degrees of \
         freedom; add inputs, or ask for a motion that needs fewer",
        Readable(missing);
}
