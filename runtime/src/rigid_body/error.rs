//! What no rigid body has.

use core::fmt;

use crate::error_debug::debug_by_message;
use crate::number_format::Readable;

/// Why there is no such body.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum BodyError {
    /// A number is infinite or not a number.
    NotFinite {
        /// What it is, such as "the mass".
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// A mass, a size or a density is zero or negative.
    NotPositive {
        /// What it is, such as "the radius".
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// One size of a solid has to be less than another one.
    TooLarge {
        /// What it is, such as "the inner radius".
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// What it has to be less than.
        limit: &'static str,
        /// The value of that.
        limit_value: f64,
    },
    /// An inertia tensor is not symmetric.
    NotSymmetric {
        /// The row of the first of two entries that should be equal, from 0.
        row: usize,
        /// Its column.
        column: usize,
        /// Its value.
        entry: f64,
        /// The value of the other one.
        opposite: f64,
    },
    /// A principal moment of inertia about the centre of gravity is negative.
    NegativeMoment {
        /// The principal moments, ascending; the first is negative.
        moments: [f64; 3],
    },
    /// The largest principal moment of inertia about the centre of gravity exceeds the sum of the others.
    TriangleInequality {
        /// The principal moments, ascending.
        moments: [f64; 3],
        /// I₃ − (I₁ + I₂).
        excess: f64,
    },
    /// The third axis of a body is no axis of symmetry.
    NotSymmetricAboutAxis {
        /// What has to be zero, such as "the product of inertia xz".
        quantity: &'static str,
        /// Its value.
        value: f64,
    },
    /// A line has no direction: the vector along it is zero.
    NoDirection {
        /// The length of the vector.
        length: f64,
    },
    /// A composition has no parts.
    NoParts,
    /// A principal moment of inertia is zero, and an angular velocity about its axis has no momentum.
    NoInertia {
        /// The principal moments, ascending; the first is zero or nearly so.
        moments: [f64; 3],
    },
    /// Derivative parts of dual numbers perturb a steady rotation: its closed form is another one beside it.
    NotDifferentiable {
        /// The derivative of the moment **ω** × \[I\] **ω**, which is zero itself.
        value: f64,
    },
}

/// Why the moments of a real body may look wrong.
const CAUSES: &str =
    "the signs of the products of inertia or the point to which the tensor refers may be wrong";

impl fmt::Display for BodyError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotFinite { quantity, value } => write!(f, "{quantity} is {value}"),
            Self::NotPositive { quantity, value } => {
                let value = Readable(value);
                write!(f, "{quantity} is {value}, but has to be positive")
            }
            Self::TooLarge {
                quantity,
                value,
                limit,
                limit_value,
            } => write!(
                f,
                "{quantity} is {}, but has to be less than {limit}, {}",
                Readable(value),
                Readable(limit_value)
            ),
            Self::NotSymmetric {
                row,
                column,
                entry,
                opposite,
            } => write!(
                f,
                "the inertia tensor is not symmetric: its entry ({row}, {column}) is {}, and ({column}, {row}) is {}",
                Readable(entry),
                Readable(opposite)
            ),
            Self::NegativeMoment { moments } => write!(
                f,
                "a principal moment of inertia about the centre of gravity is negative: {}; {CAUSES}",
                Moments(moments)
            ),
            Self::TriangleInequality { moments, excess } => write!(
                f,
                "the largest principal moment of inertia about the centre of gravity exceeds the sum of the others by {}: \
                 {}; {CAUSES}",
                Readable(excess),
                Moments(moments)
            ),
            Self::NotSymmetricAboutAxis { quantity, value } => write!(
                f,
                "the third axis of the body is no axis of symmetry: {quantity} is {}, and has to be zero",
                Readable(value)
            ),
            Self::NoDirection { length } => write!(
                f,
                "a line needs a direction, but the vector along it has length {}",
                Readable(length)
            ),
            Self::NoParts => f.write_str("a composition needs at least one part"),
            Self::NoInertia { moments } => write!(
                f,
                "a principal moment of inertia is zero or nearly so: {}; rotation about its axis has no momentum",
                Moments(moments)
            ),
            Self::NotDifferentiable { value } => write!(
                f,
                "the closed form of a steady rotation has no derivatives: those of ω × [I] ω are up to {}; integrate Euler's \
                 equations instead",
                Readable(value)
            ),
        }
    }
}

debug_by_message!(BodyError);

impl core::error::Error for BodyError {}

/// Three principal moments in a message.
struct Moments([f64; 3]);

impl fmt::Display for Moments {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [first, second, third] = self.0.map(Readable);
        write!(f, "I₁ = {first}, I₂ = {second}, I₃ = {third}")
    }
}
