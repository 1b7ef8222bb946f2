//! Dual numbers: forward-mode automatic differentiation.
//!
//! A. Griewank & A. Walther, *Evaluating Derivatives*, 2nd ed., 2008, chapter 3. Nested, they are the hyper-dual
//! numbers of J. A. Fike & J. J. Alonso, *The Development of Hyper-Dual Numbers for Exact Second-Derivative
//! Calculations*, AIAA 2011-886.
//!
//! Emitted code computes derivatives of models with many coordinates on them: one evaluation of the inverse dynamics
//! gives as many columns as a number has derivatives. The operations are inlined. As separate functions with results in
//! memory, LLVM 22 took two minutes to move the results for a chain of 100 links from one place on the stack to
//! another.

mod arithmetic;
mod functions;
#[cfg(test)]
mod tests;

use core::array::from_fn;
use core::cmp::Ordering;
use core::fmt;

use num_traits::Zero;

use super::Scalar;

/// A number and its derivatives by `N` variables.
///
/// Computations on dual numbers propagate exact derivatives, by the chain rule, along with the values (Griewank &
/// Walther, *Evaluating Derivatives*, 2008, chapter 3). For one variable, the type is `Dual`:
///
/// ```
/// use lagrangian::{Dual, Scalar};
///
/// fn f<S: Scalar>(x: S) -> S {
///     x * x.sin()
/// }
///
/// let [x] = Dual::variables([0.5]);
/// let found = f(x);
/// assert_eq!(found.value, f(0.5));
/// let slope = 0.5_f64.sin() + 0.5 * 0.5_f64.cos();
/// assert!((found.derivative[0] - slope).abs() < 1e-15);
/// ```
///
/// The gradient by several variables:
///
/// ```
/// use lagrangian::Dual;
///
/// let [x, y] = Dual::variables([3.0, 5.0]);
/// let found = x * x * y * 0.5;
/// assert_eq!(found.value, 22.5);
/// assert_eq!(found.derivative, [15.0, 4.5]);
/// assert_eq!(found.to_string(), "22.5 + [15, 4.5]ε");
/// ```
///
/// The number of variables is usually inferred. Otherwise, write `Dual::<f64, 2>::constant(1.0)`, or
/// `<Dual>::constant(1.0)` for one variable. The right operand of `+ - * /` may be an `f64`.
///
/// A dual number is a [`Scalar`], and may be built on any scalar: models with parameters or states of dual numbers are
/// evaluated and integrated like others. For the derivatives of a motion by all initial values, see
/// [`StateTransition`](crate::StateTransition).
///
/// # Second derivatives
///
/// A dual number of dual numbers has second derivatives, like hyper-dual numbers (Fike & Alonso 2011). Each level
/// differentiates by its own variables:
///
/// ```
/// use lagrangian::{Dual, Scalar};
///
/// let [x] = Dual::variables(Dual::variables([0.5]));
/// assert_eq!(x.exp().derivative[0].derivative[0], 0.5_f64.exp());
///
/// // The Hessian of x² y.
/// let [x, y] = Dual::variables(Dual::variables([3.0, 5.0]));
/// let hessian = (x * x * y).derivative.map(|row| row.derivative);
/// assert_eq!(hessian, [[10.0, 6.0], [6.0, 0.0]]);
/// ```
///
/// # Where functions have no derivative
///
/// As in emitted derivatives, |x| at 0 and the jumps of `signum` and `floor` have the
/// derivative 0, and `min` and `max` of equal numbers have the mean of both derivatives. At 0, the derivative of √x is
/// zero if the derivative of x is zero, and otherwise about as large as numbers can be. The same holds for arc
/// functions at the ends of their domains, and for powers at 0.
///
/// # Comparisons
///
/// `==` and `<` compare only values, so that a program takes the branch that it takes on plain numbers. Only
/// [`is_zero`](num_traits::Zero::is_zero) considers derivatives, too.
#[derive(Clone, Copy, Debug)]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(bound(
        serialize = "S: serde::Serialize",
        deserialize = "S: serde::Deserialize<'de> + Clone"
    ))
)]
pub struct Dual<S = f64, const N: usize = 1> {
    /// The value.
    pub value: S,
    /// The derivatives by the variables, in order.
    #[cfg_attr(feature = "serde", serde(with = "crate::array_as_tuple"))]
    pub derivative: [S; N],
}

impl<S: Scalar, const N: usize> Dual<S, N> {
    /// Creates a number with given derivatives.
    #[inline]
    #[must_use]
    pub const fn new(value: S, derivative: [S; N]) -> Self {
        Self { value, derivative }
    }

    /// Creates a number that does not depend on any variable.
    #[inline]
    #[must_use]
    pub fn constant(value: S) -> Self {
        Self {
            value,
            derivative: from_fn(|_| S::zero()),
        }
    }

    /// Creates the variable with an index: its derivative by itself is 1. With an index of `N` or more it is not one of
    /// the variables, and thus a [constant](Self::constant).
    #[inline]
    #[must_use]
    pub fn variable(value: S, index: usize) -> Self {
        let derivative = |k| if k == index { S::one() } else { S::zero() };
        Self {
            value,
            derivative: from_fn(derivative),
        }
    }

    /// Creates all variables, at these values.
    #[inline]
    #[must_use]
    pub fn variables(values: [S; N]) -> [Self; N] {
        from_fn(|index| Self::variable(values[index], index))
    }

    /// Returns whether all derivatives are zero.
    #[inline]
    fn is_constant(self) -> bool {
        self.derivative.iter().all(Zero::is_zero)
    }
}

impl<S: Scalar, const N: usize> From<f64> for Dual<S, N> {
    #[inline]
    fn from(value: f64) -> Self {
        Self::from_f64(value)
    }
}

impl<S: PartialEq, const N: usize> PartialEq for Dual<S, N> {
    #[inline]
    fn eq(&self, other: &Self) -> bool {
        self.value == other.value
    }
}

impl<S: PartialOrd, const N: usize> PartialOrd for Dual<S, N> {
    #[inline]
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        self.value.partial_cmp(&other.value)
    }
}

/// Formats like `2 + 1ε` and `2 + [1, 0]ε`, in the format of the numbers.
impl<S: fmt::Display, const N: usize> fmt::Display for Dual<S, N> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.value.fmt(f)?;
        f.write_str(" + ")?;
        if let [derivative] = self.derivative.as_slice() {
            derivative.fmt(f)?;
            return f.write_str("ε");
        }
        f.write_str("[")?;
        for (index, derivative) in self.derivative.iter().enumerate() {
            if index > 0 {
                f.write_str(", ")?;
            }
            derivative.fmt(f)?;
        }
        f.write_str("]ε")
    }
}
