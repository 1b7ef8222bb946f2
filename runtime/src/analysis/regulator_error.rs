//! The errors of the linear-quadratic regulator.

use core::fmt;

use super::controllability::UncontrollableMode;
use crate::error_debug::debug_by_message;
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

impl fmt::Display for RegulatorError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFinite => f.write_str("an entry of A, B or Q is not finite"),
            Self::NotSymmetric {
                matrix,
                row,
                column,
                difference,
            } => write!(
                f,
                "{matrix} is not symmetric: its entries ({row}, {column}) and ({column}, {row}) differ by {}",
                Readable(difference)
            ),
            Self::NotPositive {
                matrix,
                eigenvalue,
                zero_is_allowed,
            } => {
                let required = if zero_is_allowed {
                    "must not be negative"
                } else {
                    "have to be positive"
                };
                let eigenvalue = Readable(eigenvalue);
                write!(f, "the eigenvalues of {matrix} {required}, and one is {eigenvalue}")
            }
            Self::NotStabilizable { mode } => {
                f.write_str("no input reaches the mode")?;
                write_mode(f, &mode)?;
                f.write_str(", which is not stable")
            }
            Self::NoCost { mode } => {
                f.write_str("the mode")?;
                write_mode(f, &mode)?;
                f.write_str(" neither grows nor decays and has no cost: give it a weight in Q")
            }
            Self::NoConvergence => f.write_str(
                "the Riccati equation was not solved: eigenvalues of the closed loop are too near the border of stability",
            ),
            Self::Inaccurate { change } => write!(
                f,
                "the solution of the Riccati equation is not accurate, with a relative error of about {}: choose units in which the \
                 entries of A, B and of the weights are of similar size",
                Readable(change)
            ),
        }
    }
}

fn write_mode(f: &mut fmt::Formatter<'_>, mode: &UncontrollableMode) -> fmt::Result {
    let value = mode.eigenvalue;
    write!(f, " with the eigenvalue {}", Readable(value.re))?;
    if value.im.abs() > 0.0 {
        write!(f, " ± {} i", Readable(value.im.abs()))?;
    }
    write!(
        f,
        ", which is mostly in component {} of the state",
        mode.component
    )
}

debug_by_message!(RegulatorError);

impl core::error::Error for RegulatorError {}
