//! The comparison of declared derivatives with numerical derivatives.
//!
//! The points form an additive recurrence with powers of the generalized golden ratio: M. Roberts, *The Unreasonable
//! Effectiveness of Quasirandom Sequences* (2018), extremelearning.com.au.

use core::ops::RangeInclusive;

use super::derivative_error::{ArgumentValues, DerivativeError};
use super::numerical_derivative::NumericalDerivative;
use crate::limits::derivative_checks::{
    ERROR_ESTIMATES, MAX_RELATIVE_ERROR, POINTS, RATIO_ITERATIONS,
};
use crate::model::{ExternalFunctions, FunctionSignature};
use crate::scalar::Scalar;

/// Compares the derivatives of a function with numerical derivatives of its values, at points spread over a region.
///
/// `derivatives` returns the derivatives by all arguments. They are compared with extrapolated difference quotients,
/// and must agree within the error of these, or within the square root of the machine epsilon relative to the
/// derivative. The function is evaluated only within the region, so the region may end where the function has a kink or
/// ceases to be defined. An argument whose range is a single point is constant, and its derivative is not checked.
///
/// ```
/// use lagrangian::check_derivatives;
///
/// // Friction that falls from its value at rest to that of sliding.
/// let friction = |[v]: [f64; 1]| (0.4 + 0.2 * (-v * v).exp()) * (100.0 * v).tanh();
/// let slope = |[v]: [f64; 1]| {
///     let steep = 100.0 * (100.0 * v).cosh().powi(-2);
///     let falling = -0.4 * v * (-v * v).exp();
///     [falling * (100.0 * v).tanh() + (0.4 + 0.2 * (-v * v).exp()) * steep]
/// };
/// check_derivatives(friction, slope, [-3.0..=3.0])?;
/// # Ok::<(), lagrangian::DerivativeError>(())
/// ```
///
/// # Errors
///
/// The [`DerivativeError`] that was found, if there is one.
pub fn check_derivatives<const K: usize>(
    value: impl Fn([f64; K]) -> f64,
    derivatives: impl Fn([f64; K]) -> [f64; K],
    region: [RangeInclusive<f64>; K],
) -> Result<(), DerivativeError> {
    let check = Check {
        signature: FunctionSignature {
            name: "f",
            arguments: NUMBERED.get(..K).unwrap_or(NUMBERED),
        },
        value,
        derivative: |argument: usize, point| Some(derivatives(point)[argument]),
        epsilon: f64::EPSILON,
        region,
    };
    check.run()
}

/// The default names of arguments.
const NUMBERED: &[&str] = &["x₁", "x₂", "x₃", "x₄", "x₅", "x₆", "x₇", "x₈"];

/// Checks the declared derivatives of a model's external functions; implemented for every model that has such
/// functions.
///
/// ```
/// # use lagrangian::{CheckDerivatives, DerivativeError, ExternalFunctions, FunctionSignature};
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
pub trait CheckDerivatives: ExternalFunctions {
    /// Compares the declared derivatives of a function with numerical derivatives of its values, where each argument is
    /// within its range; see [`check_derivatives`](crate::check_derivatives()).
    ///
    /// # Errors
    ///
    /// The [`DerivativeError`] that was found, if there is one.
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

impl<M: ExternalFunctions + ?Sized> CheckDerivatives for M {}

/// A function, its derivatives, and the region in which they are compared.
pub(crate) struct Check<V, D, const K: usize> {
    pub(crate) signature: FunctionSignature,
    pub(crate) value: V,
    /// The derivative by an argument, if it is declared.
    pub(crate) derivative: D,
    /// The machine epsilon of the scalar on which the function is evaluated.
    pub(crate) epsilon: f64,
    pub(crate) region: [RangeInclusive<f64>; K],
}

impl<V, D, const K: usize> Check<V, D, K>
where
    V: Fn([f64; K]) -> f64,
    D: Fn(usize, [f64; K]) -> Option<f64>,
{
    pub(crate) fn run(&self) -> Result<(), DerivativeError> {
        self.check_region()?;
        let span = self.span()?;
        let mut declared = false;
        for (argument, range) in self.region.iter().enumerate() {
            let width = range.end() - range.start();
            declared |= self.check_argument(argument, span / width)?;
        }
        if declared {
            return Ok(());
        }
        let function = self.signature.name;
        Err(DerivativeError::NotDeclared { function })
    }

    /// Returns an error unless there is a valid range for each argument.
    fn check_region(&self) -> Result<(), DerivativeError> {
        let FunctionSignature { name, arguments } = self.signature;
        let function = name;
        // A function with default names has as many arguments as there are ranges.
        if arguments.len() != K && arguments != NUMBERED {
            let expected = arguments.len();
            return Err(DerivativeError::ArgumentCount {
                function,
                expected,
                found: K,
            });
        }
        let is_range = |range: &RangeInclusive<f64>| {
            range.start().is_finite() && range.end().is_finite() && range.start() <= range.end()
        };
        match self.region.iter().position(|range| !is_range(range)) {
            Some(argument) => {
                let argument = self.argument(argument);
                Err(DerivativeError::InvalidRange { function, argument })
            }
            None => Ok(()),
        }
    }

    /// Returns the spread of the values over the region, or the spread due to rounding errors if it is larger.
    fn span(&self) -> Result<f64, DerivativeError> {
        let (mut least, mut greatest) = (f64::INFINITY, f64::NEG_INFINITY);
        for point in self.points() {
            let value = (self.value)(point);
            if !value.is_finite() {
                return Err(DerivativeError::NonFiniteValue {
                    function: self.signature.name,
                    point: self.at(point),
                    value,
                });
            }
            least = value.min(least);
            greatest = value.max(greatest);
        }
        let size = greatest.abs().max(least.abs());
        Ok(greatest - least + libm::sqrt(self.epsilon) * size)
    }

    /// Compares the derivatives by one argument, whose typical magnitude is `scale`; returns whether any are declared.
    fn check_argument(&self, argument: usize, scale: f64) -> Result<bool, DerivativeError> {
        let range = &self.region[argument];
        let declared = |point| (self.derivative)(argument, point);
        if range.start() >= range.end() {
            return Ok(self.points().any(|point| declared(point).is_some()));
        }
        let mut worst: Option<(f64, DerivativeError)> = None;
        let (mut any, mut any_accurate) = (false, false);
        for point in self.points() {
            let Some(declared) = declared(point) else {
                continue;
            };
            any = true;
            let Some(numerical) = self.numerical_derivative(argument, point) else {
                continue;
            };
            // A declared value that is not finite has an infinite distance from the numerical one.
            let (size, distance) = if declared.is_finite() {
                let size = declared.abs().max(numerical.value.abs());
                (size, (declared - numerical.value).abs())
            } else {
                (numerical.value.abs(), f64::INFINITY)
            };
            any_accurate |= numerical.error <= MAX_RELATIVE_ERROR * size.max(scale);
            let tolerance = ERROR_ESTIMATES * numerical.error + libm::sqrt(self.epsilon) * size;
            if distance > tolerance && worst.is_none_or(|(known, _)| distance > known) {
                let error = DerivativeError::Wrong {
                    function: self.signature.name,
                    argument: self.argument(argument),
                    point: self.at(point),
                    declared,
                    measured: numerical.value,
                    uncertainty: numerical.error,
                };
                worst = Some((distance, error));
            }
        }
        match worst {
            Some((_, error)) => Err(error),
            None if any && !any_accurate => Err(DerivativeError::NoNumericalDerivative {
                function: self.signature.name,
                argument: self.argument(argument),
            }),
            None => Ok(any),
        }
    }

    /// Returns the numerical derivative by one argument, from values within the region.
    fn numerical_derivative(
        &self,
        argument: usize,
        point: [f64; K],
    ) -> Option<NumericalDerivative> {
        let range = &self.region[argument];
        let x = point[argument];
        let along = |x: f64| {
            let mut point = point;
            point[argument] = x;
            (self.value)(point)
        };
        let reach = (x - range.start()).min(range.end() - x);
        NumericalDerivative::central(along, self.epsilon, x, reach)
    }

    /// Returns points of low discrepancy in the region (Roberts, 2018): multiples, modulo 1, of powers of 1/x, where x
    /// is the generalized golden ratio, the root of xᴷ⁺¹ = x + 1.
    fn points(&self) -> impl Iterator<Item = [f64; K]> {
        let dimension = self.region.iter().fold(0.0, |count, _| count + 1.0);
        let root =
            (0..RATIO_ITERATIONS).fold(2.0, |x, _| libm::pow(1.0 + x, 1.0 / (dimension + 1.0)));
        // The points avoid the middle of the region, where many functions have a kink.
        (1..=POINTS).map(move |n| {
            let mut share = 1.0;
            self.region.each_ref().map(|range| {
                share /= root;
                let position = 0.5 + f64::from(n) * share;
                let position = position - libm::floor(position);
                range.start() + position * (range.end() - range.start())
            })
        })
    }

    fn argument(&self, position: usize) -> &'static str {
        self.signature
            .arguments
            .get(position)
            .copied()
            .unwrap_or("x")
    }

    fn at(&self, point: [f64; K]) -> ArgumentValues {
        ArgumentValues::new(self.signature.arguments, &point)
    }
}
