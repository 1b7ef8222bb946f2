//! The errors of the identification of parameters.

use core::fmt;

use nalgebra::SVector;

use crate::error_messages::error_messages;

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

error_messages! { [const B: usize] IdentificationError<B>:
    Self::TooFewEquations { equations } =>
        "{B} base parameters need more than {B} equations, and there are {equations}: add further instants";
    Self::NotFinite { equation } => "equation {equation} contains a number that is not finite";
    Self::PoorExcitation { direction, names, condition_number } =>
        "the motion does not excite the combination of base parameters{} (condition number {condition_number:.1e}): \
         measure a richer motion, or take one of these parameters as known",
        Combination(direction, names);
}

/// A combination of base parameters in a message, without those of small weights.
struct Combination<const B: usize>(SVector<f64, B>, [&'static str; B]);

impl<const B: usize> fmt::Display for Combination<B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(weights, names) = self;
        let mut pairs = weights.iter().zip(names);
        pairs.try_for_each(|(weight, name)| {
            if weight.abs() > 0.01 {
                write!(f, " {weight:+.2} ({name})")?;
            }
            Ok(())
        })
    }
}
