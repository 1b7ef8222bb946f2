//! The errors of the identification of parameters.

use core::fmt;

use nalgebra::SVector;

use crate::error_debug::debug_by_message;

/// The reason why parameters were not identified.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum IdentificationError<const B: usize> {
    /// There are no more equations than base parameters.
    TooFewEquations {
        /// The number of equations.
        equations: usize,
    },
    /// An equation contains a number that is not finite.
    NotFinite {
        /// The index of the equation, counted from 0.
        equation: usize,
    },
    /// The motion does not determine a combination of base parameters: they can change by any multiple of `direction`
    /// without a change of the forces.
    PoorExcitation {
        /// A change of the base parameters that has no effect, relative to their scales; its largest component is 1.
        direction: SVector<f64, B>,
        /// The names of the base parameters.
        names: [&'static str; B],
        /// The condition number of the scaled regressor.
        condition_number: f64,
    },
}

impl<const B: usize> fmt::Display for IdentificationError<B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::TooFewEquations { equations } => write!(
                f,
                "{B} base parameters need more than {B} equations, and there are {equations}: add further instants"
            ),
            Self::NotFinite { equation } => {
                write!(
                    f,
                    "equation {equation} contains a number that is not finite"
                )
            }
            Self::PoorExcitation {
                direction,
                names,
                condition_number,
            } => {
                f.write_str("the motion does not excite the combination of base parameters")?;
                for (weight, name) in direction.iter().zip(names) {
                    if weight.abs() > 0.01 {
                        write!(f, " {weight:+.2} ({name})")?;
                    }
                }
                write!(
                    f,
                    " (condition number {condition_number:.1e}): measure a richer motion, or take one of these parameters \
                     as known"
                )
            }
        }
    }
}

debug_by_message!(IdentificationError<B>; const B: usize);

impl<const B: usize> core::error::Error for IdentificationError<B> {}
