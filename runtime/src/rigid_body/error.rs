//! The errors of rigid bodies.

use core::fmt;

use crate::error_messages::error_messages;
use crate::number_format::Readable;

/// The reason why a body does not exist.
#[derive(Clone, Copy, PartialEq)]
#[non_exhaustive]
pub enum BodyError {
    /// A number is infinite or NaN.
    NotFinite {
        /// The name of the quantity, such as "the mass".
        quantity: &'static str,
        /// The value of the quantity.
        value: f64,
    },
    /// A mass, a size or a density is zero or negative.
    NotPositive {
        /// The name of the quantity, such as "the radius".
        quantity: &'static str,
        /// The value of the quantity.
        value: f64,
    },
    /// A size of a solid has to be less than another one.
    TooLarge {
        /// The name of the size, such as "the inner radius".
        quantity: &'static str,
        /// Its value.
        value: f64,
        /// The name of the size that it has to be less than.
        limit: &'static str,
        /// The value of that size.
        limit_value: f64,
    },
    /// An inertia tensor is not symmetric.
    NotSymmetric {
        /// The row, counted from 0, of the first of two entries that should be equal.
        row: usize,
        /// Its column.
        column: usize,
        /// Its value.
        entry: f64,
        /// The value of the other entry.
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
    /// The third axis of a body is not an axis of symmetry.
    NotSymmetricAboutAxis {
        /// The name of the quantity that has to be zero, such as "the product of inertia xz".
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
    /// Derivative parts of dual numbers perturb a steady rotation, so that its closed form does not apply to them.
    NotDifferentiable {
        /// The derivative of the moment **ω** × \[I\] **ω**, which itself is zero.
        value: f64,
    },
}

/// The reason why the moments of a real body may look wrong.
const CAUSES: &str =
    "the signs of the products of inertia or the point to which the tensor refers may be wrong";

error_messages! { BodyError:
    Self::NotFinite { quantity, value } => "{quantity} is {value}";
    Self::NotPositive { quantity, value } =>
        "{quantity} is {}, but has to be positive",
        Readable(value);
    Self::TooLarge { quantity, value, limit, limit_value } =>
        "{quantity} is {}, but has to be less than {limit}, {}",
        Readable(value), Readable(limit_value);
    Self::NotSymmetric { row, column, entry, opposite } =>
        "the inertia tensor is not symmetric: its entry ({row}, {column}) is {}, and ({column}, {row}) is {}",
        Readable(entry), Readable(opposite);
    Self::NegativeMoment { moments } =>
        "a principal moment of inertia about the centre of gravity is negative: {}; {CAUSES}",
        Moments(moments);
    Self::TriangleInequality { moments, excess } =>
        "the largest principal moment of inertia about the centre of gravity exceeds the sum of the others by {}: \
         {}; {CAUSES}",
        Readable(excess), Moments(moments);
    Self::NotSymmetricAboutAxis { quantity, value } =>
        "the third axis of the body is no axis of symmetry: {quantity} is {}, and has to be zero",
        Readable(value);
    Self::NoDirection { length } =>
        "a line needs a direction, but the vector along it has length {}",
        Readable(length);
    Self::NoParts => "a composition needs at least one part";
    Self::NoInertia { moments } =>
        "a principal moment of inertia is zero or nearly so: {}; rotation about its axis has no momentum",
        Moments(moments);
    Self::NotDifferentiable { value } =>
        "the closed form of a steady rotation has no derivatives: those of ω × [I] ω are up to {}; integrate Euler's \
         equations instead",
        Readable(value);
}

/// Three principal moments in a message.
struct Moments([f64; 3]);

impl fmt::Display for Moments {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [first, second, third] = self.0.map(Readable);
        write!(f, "I₁ = {first}, I₂ = {second}, I₃ = {third}")
    }
}
