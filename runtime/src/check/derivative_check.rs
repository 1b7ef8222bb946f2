//! Declared derivatives against measured ones.

use core::ops::RangeInclusive;

use super::derivative_error::{ArgumentValues, DerivativeError};
use super::numerical_derivative::Slope;
use crate::limits::derivative_checks::{
    ERROR_ESTIMATES, MAX_RELATIVE_ERROR, POINTS, RATIO_ITERATIONS,
};
use crate::model::{ExternalFunctions, FunctionSignature};
use crate::scalar::Scalar;

/// Compares the derivatives of a function with those of its values, at points spread over a region.
///
/// `derivatives` gives the derivative by each argument. They are compared with difference quotients,
/// extrapolated, and must agree within their error, or within the square root of the machine epsilon,
/// relative to the derivative. Values are asked for within the region only, so that it can end where the
/// function has a kink or no value. An argument whose range is one point stays there, and what the function
/// does along it is not looked at.
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
/// The [`DerivativeError`] found, if there is one.
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

/// The names of arguments that have none.
const NUMBERED: &[&str] = &["x₁", "x₂", "x₃", "x₄", "x₅", "x₆", "x₇", "x₈"];

/// The check of the declared derivatives of a model's external functions; every model that has such functions
/// has it.
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

impl<M: ExternalFunctions + ?Sized> CheckDerivatives for M {}

/// A function, its derivatives, and where they are compared.
pub(crate) struct Check<V, D, const K: usize> {
    pub(crate) signature: FunctionSignature,
    pub(crate) value: V,
    /// The derivative by an argument, if it is declared.
    pub(crate) derivative: D,
    /// The relative distance between the numbers that the function computes with.
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

    /// There is a range for each argument, and all are ranges.
    fn check_region(&self) -> Result<(), DerivativeError> {
        let FunctionSignature { name, arguments } = self.signature;
        let function = name;
        // Arguments without names are as many as there are ranges.
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

    /// How far apart the values are, not less than rounding lets them seem to be.
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

    /// Compares the derivatives by one argument, of which `scale` is the size; says whether there are any.
    fn check_argument(&self, argument: usize, scale: f64) -> Result<bool, DerivativeError> {
        let range = &self.region[argument];
        let declared = |point| (self.derivative)(argument, point);
        if range.start() >= range.end() {
            return Ok(self.points().any(|point| declared(point).is_some()));
        }
        let mut worst: Option<(f64, DerivativeError)> = None;
        let (mut any, mut any_measured) = (false, false);
        for point in self.points() {
            let Some(declared) = declared(point) else {
                continue;
            };
            any = true;
            let Some(slope) = self.slope(argument, point) else {
                continue;
            };
            // What is not finite is no derivative, and is as far from one as can be.
            let (size, distance) = if declared.is_finite() {
                let size = declared.abs().max(slope.value.abs());
                (size, (declared - slope.value).abs())
            } else {
                (slope.value.abs(), f64::INFINITY)
            };
            any_measured |= slope.error <= MAX_RELATIVE_ERROR * size.max(scale);
            let tolerance = ERROR_ESTIMATES * slope.error + libm::sqrt(self.epsilon) * size;
            if distance > tolerance && worst.is_none_or(|(known, _)| distance > known) {
                let error = DerivativeError::Wrong {
                    function: self.signature.name,
                    argument: self.argument(argument),
                    point: self.at(point),
                    declared,
                    measured: slope.value,
                    uncertainty: slope.error,
                };
                worst = Some((distance, error));
            }
        }
        match worst {
            Some((_, error)) => Err(error),
            None if any && !any_measured => Err(DerivativeError::NoNumericalDerivative {
                function: self.signature.name,
                argument: self.argument(argument),
            }),
            None => Ok(any),
        }
    }

    /// The slope along one argument, from values within the region.
    fn slope(&self, argument: usize, point: [f64; K]) -> Option<Slope> {
        let range = &self.region[argument];
        let x = point[argument];
        let along = |x: f64| {
            let mut point = point;
            point[argument] = x;
            (self.value)(point)
        };
        let reach = (x - range.start()).min(range.end() - x);
        Slope::measured(along, self.epsilon, x, reach)
    }

    /// Points that fill the region evenly: multiples of numbers whose multiples are spread as evenly as
    /// possible, powers of the root of xᴷ⁺¹ = x + 1 that generalizes the golden ratio.
    fn points(&self) -> impl Iterator<Item = [f64; K]> {
        let dimension = self.region.iter().fold(0.0, |count, _| count + 1.0);
        let root =
            (0..RATIO_ITERATIONS).fold(2.0, |x, _| libm::pow(1.0 + x, 1.0 / (dimension + 1.0)));
        // The middle of a region is where functions like to have a kink.
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
