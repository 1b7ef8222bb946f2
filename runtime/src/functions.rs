//! Functions from outside that a declaration uses.

use core::ops::RangeInclusive;

use crate::derivative_check::Check;
use crate::{DerivativeError, Scalar};

/// The name of a function and those of its arguments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FunctionSignature {
    /// The name of the function.
    pub name: &'static str,
    /// The names of its arguments, in order.
    pub arguments: &'static [&'static str],
}

/// A model whose declaration has `function(name(argument, …) = …)`.
///
/// `#[derive(Lagrangian)]` implements it. What it is for is a test that the declared derivatives are
/// those of the functions:
///
/// ```
/// # use lagrangian::{DerivativeError, ExternalFunctions, FunctionSignature};
/// # struct Slider;
/// # impl ExternalFunctions for Slider {
/// #     type Scalar = f64;
/// #     const FUNCTIONS: &'static [FunctionSignature] = &[FunctionSignature { name: "friction", arguments: &["v"] }];
/// #     fn function(&self, _: usize, x: &[f64]) -> f64 { x[0].tanh() }
/// #     fn derivative(&self, _: usize, _: usize, x: &[f64]) -> Option<f64> { Some(x[0].cosh().powi(-2)) }
/// # }
/// # let slider = Slider;
/// slider.check_derivatives("friction", [-3.0..=3.0])?;
/// # Ok::<(), DerivativeError>(())
/// ```
pub trait ExternalFunctions {
    /// What the functions are evaluated on.
    type Scalar: Scalar;

    /// The functions, in the order of declaration.
    const FUNCTIONS: &'static [FunctionSignature];

    /// The value of a function, by its position; not a number unless there is one of so many arguments.
    fn function(&self, function: usize, arguments: &[Self::Scalar]) -> Self::Scalar;

    /// The declared derivative of a function by one of its arguments, by their positions; none where none
    /// is declared.
    fn derivative(
        &self,
        function: usize,
        argument: usize,
        arguments: &[Self::Scalar],
    ) -> Option<Self::Scalar>;

    /// Compares the declared derivatives of a function with those of its values, where each argument is
    /// within its range; see [`check_derivatives`](crate::check_derivatives()).
    ///
    /// # Errors
    ///
    /// The [`DerivativeError`] found, if there is one.
    fn check_derivatives<const K: usize>(
        &self,
        function: &str,
        region: [RangeInclusive<f64>; K],
    ) -> Result<(), DerivativeError> {
        let mut functions = Self::FUNCTIONS.iter();
        let Some(position) = functions.position(|known| known.name == function) else {
            let known = Self::FUNCTIONS;
            return Err(DerivativeError::UnknownFunction { known });
        };
        let on = |point: [f64; K]| point.map(Self::Scalar::from_f64);
        let check = Check {
            signature: Self::FUNCTIONS[position],
            value: |point| self.function(position, &on(point)).smallest(),
            derivative: |argument: usize, point| {
                let derivative = self.derivative(position, argument, &on(point));
                derivative.map(Scalar::smallest)
            },
            epsilon: Self::Scalar::machine_epsilon(),
            region,
        };
        check.run()
    }
}
