//! The errors of the linear-quadratic regulator.

use core::fmt;

use super::controllability::UncontrollableMode;
use crate::error_messages::error_messages;
use crate::number_format::Readable;

/// The reason why there is no linear-quadratic regulator.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum RegulatorError {
    /// An entry of A, B or Q is infinite or NaN.
    NotFinite,
    /// A weight is not symmetric.
    NotSymmetric {
        /// The name of the weight.
        matrix: &'static str,
        /// The row, counted from 0, of an entry that differs from its transposed entry.
        row: usize,
        /// The column of this entry.
        column: usize,
        /// The difference.
        difference: f64,
    },
    /// A weight has an eigenvalue that is not positive.
    NotPositive {
        /// The name of the weight.
        matrix: &'static str,
        /// The least eigenvalue.
        eigenvalue: f64,
        /// Whether a zero eigenvalue is allowed.
        zero_is_allowed: bool,
    },
    /// No input reaches a mode that is not stable.
    NotStabilizable {
        /// The mode.
        mode: UncontrollableMode,
    },
    /// A mode that neither grows nor decays has no cost, so that no optimal input acts on it.
    NoCost {
        /// The mode; the component is the state with the largest part in it.
        mode: UncontrollableMode,
    },
    /// The Riccati equation was not solved: eigenvalues of the closed loop are too near the border of stability.
    NoConvergence,
    /// The digits of the computed cost are not reliable: the problem is too badly conditioned.
    Inaccurate {
        /// The last step of Newton's method relative to the cost.
        change: f64,
    },
}

error_messages! { RegulatorError:
    Self::NotFinite => "an entry of A, B or Q is not finite";
    Self::NotSymmetric { matrix, row, column, difference } =>
        "{matrix} is not symmetric: its entries ({row}, {column}) and ({column}, {row}) differ by {}",
        Readable(difference);
    Self::NotPositive { matrix, eigenvalue, zero_is_allowed: true } =>
        "the eigenvalues of {matrix} must not be negative, and one is {}",
        Readable(eigenvalue);
    Self::NotPositive { matrix, eigenvalue, zero_is_allowed: false } =>
        "the eigenvalues of {matrix} have to be positive, and one is {}",
        Readable(eigenvalue);
    Self::NotStabilizable { mode } => "no input reaches the mode{}, which is not stable", Mode(mode);
    Self::NoCost { mode } =>
        "the mode{} neither grows nor decays and has no cost: give it a weight in Q",
        Mode(mode);
    Self::NoConvergence =>
        "the Riccati equation was not solved: eigenvalues of the closed loop are too near the border of stability";
    Self::Inaccurate { change } =>
        "the solution of the Riccati equation is not accurate, with a relative error of about {}: choose units in which the \
         entries of A, B and of the weights are of similar size",
        Readable(change);
}

/// What describes a mode in a message.
struct Mode(UncontrollableMode);

impl fmt::Display for Mode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let UncontrollableMode {
            eigenvalue: value,
            component,
        } = self.0;
        write!(f, " with the eigenvalue {}", Readable(value.re))?;
        if value.im.abs() > 0.0 {
            write!(f, " ± {} i", Readable(value.im.abs()))?;
        }
        write!(f, ", which is mostly in component {component} of the state")
    }
}
