//! The length of a step of the Taylor series method.

use super::TaylorCoefficients;
use super::coefficients::{number, power};
use super::interpolant::TaylorInterpolant;
use crate::integrate::binary_logarithm::{EXPONENT, exp2, log2};
use crate::integrate::component_name::ComponentName;
use crate::integrate::dynamics::Dynamics;
use crate::integrate::error::IntegrationError;
use crate::integrate::projected::allow_least;
use crate::integrate::singularity::Singularity;
use crate::integrate::tolerance::Tolerance;
use crate::limits::taylor::NEGLIGIBLE_TERM;
use crate::linalg::{ErrorTolerance, VectorSpace};
use crate::scalar::Scalar;

/// Returns the reciprocal tolerances of the components, for the sizes that they reach within a step of this length.
#[inline]
pub(super) fn weights<S, D, const HALF: usize>(
    polynomial: &TaylorInterpolant<D::State, HALF>,
    dynamics: &D,
    tolerance: &ErrorTolerance<S>,
    length: f64,
) -> D::State
where
    S: Scalar,
    D: Dynamics<S> + ?Sized,
{
    let tau = S::from_f64(length / polynomial.unit);
    let reached = reached(polynomial.from.value(), &polynomial.coefficients, tau);
    let mut allowed = dynamics.allowed_error(&reached, tolerance);
    let here = (S::from_f64(polynomial.time), polynomial.from.value());
    allow_least(dynamics, here, &reached, &mut allowed);
    Tolerance::weights(&allowed)
}

/// Returns the sizes that the components reach up to τ.
#[inline]
pub(super) fn reached<S: Scalar, X: VectorSpace<S>, const HALF: usize>(
    from: &X,
    coefficients: &TaylorCoefficients<X, HALF>,
    tau: S,
) -> X {
    let mut power = S::one();
    let mut reached = from.map(Scalar::abs);
    for coefficient in coefficients.higher().iter().take(2) {
        power *= tau;
        reached.add_scaled(power, &coefficient.map(Scalar::abs));
    }
    reached
}

/// Returns the binary logarithm of the ratio of the last two terms, of orders p − 1 and p, of a series that decreases
/// geometrically from the size of a component to its allowed error at order p − 1: of ε^{1/(p − 1)} for a relative tolerance ε.
///
/// With the last term multiplied by the inverse of this ratio, both terms estimate the same step. Without it nearly every step
/// follows from the term of order p − 1 alone, and is too long where that term passes zero.
#[inline]
pub(super) fn decrease(tolerance: Tolerance, order: usize) -> f64 {
    let part = tolerance.relative_or_absolute();
    log2(part.clamp(f64::MIN_POSITIVE, 1.0)) / number(order - 1)
}

/// 2⁻⁵⁰⁰.
const MIN_UNIT: f64 = f64::from_bits((1023 - 500) << 52);

/// 3² · 5 · 7 · 11 · 13 over a power of two.
const DIVISIBLE: f64 = 45_045.0 / 32_768.0;

/// Returns a unit of time near a positive number, within a factor of 1.5 and a range of exponents that leaves room for
/// squares.
///
/// The coefficients of order k are the coefficients of order k − 1 of the rates times unit/k. This factor is exact for
/// k up to 16, since the unit is a power of two times the least common multiple of these k. If the unit were a power of
/// two, unit/k would be rounded in the same way in every step, and the energy would drift in proportion to the time
/// instead of its square root (E. Hairer et al., *Achieving Brouwer's law with implicit Runge–Kutta methods*, BIT
/// **48** (2008) 231–243, on the rounding of the coefficients of a method). Terms of higher orders are too small to
/// matter.
pub(super) fn unit_near(x: f64) -> f64 {
    if x.is_normal() {
        return near_normal(x);
    }
    DIVISIBLE * libm::ldexp(1.0, libm::ilogb(x).clamp(-500, 500))
}

/// [`unit_near`] of a normal number.
#[inline]
pub(super) fn near_normal(x: f64) -> f64 {
    DIVISIBLE * f64::from_bits(x.to_bits() & EXPONENT).clamp(MIN_UNIT, 1.0 / MIN_UNIT)
}

/// Returns the largest ratio of a component to its tolerance.
#[inline]
pub(super) fn weighted_norm<S: Scalar, X: VectorSpace<S>>(vector: &X, weights: &X) -> f64 {
    let ratios = vector.zip_map(weights, |component, weight| component.abs() * weight);
    // Reduces lane by lane first, and across lanes only once.
    ratios.fold(S::zero(), Scalar::max).largest()
}

/// Returns the component with the largest last term over its tolerance, which limits the step; `value` reads a number
/// from a scalar.
#[cold]
pub(super) fn limiting_component<S: Scalar, X: VectorSpace<S>, const HALF: usize>(
    coefficients: &TaylorCoefficients<X, HALF>,
    weights: &X,
    value: impl Fn(S) -> f64,
) -> usize {
    let last = coefficients.higher().last();
    let ratios = last.map(|last| last.zip_map(weights, |term, weight| term.abs() * weight));
    let ratios = ratios.iter().flat_map(VectorSpace::components);
    let largest = ratios.map(value).enumerate().reduce(|largest, next| {
        if next.1 > largest.1 || next.1.is_nan() {
            next
        } else {
            largest
        }
    });
    largest.map_or(0, |(component, _)| component)
}

/// The norm of a term, in which derivative parts are measured relative to the derivative parts of the motion.
struct Norm<'a, S, X, const HALF: usize> {
    coefficients: &'a TaylorCoefficients<X, HALF>,
    weights: &'a X,
    tolerance: &'a ErrorTolerance<S>,
}

impl<S: Scalar, X: VectorSpace<S>, const HALF: usize> Norm<'_, S, X, HALF> {
    #[inline]
    fn of(&self, term: &X) -> f64 {
        let norm = weighted_norm(term, self.weights);
        if S::DERIVATIVES == 0 {
            return norm;
        }
        (0..S::DERIVATIVES).fold(norm, |norm, part| norm.max(self.of_derivative(term, part)))
    }

    /// Returns the norm of the derivative parts with one index. They form a vector that moves with the linearized
    /// motion, and are divided by the tolerance and the size of this vector, both in the units of the weights.
    fn of_derivative(&self, term: &X, part: usize) -> f64 {
        let change = self.size(term, part);
        let coefficients = self.coefficients;
        let lower = coefficients.higher().iter().take(2);
        let lower = lower.fold(self.size(coefficients.initial(), part), |size, term| {
            size.max(self.size(term, part))
        });
        let size = if lower > 0.0 {
            lower
        } else {
            let higher = coefficients.higher().iter();
            higher.fold(0.0, |size, term| self.size(term, part).max(size))
        };
        if change <= 0.0 {
            return 0.0;
        }
        let ratio = change / (self.tolerance.of_derivatives() * size);
        if ratio.is_nan() { f64::INFINITY } else { ratio }
    }

    /// Returns the largest derivative part with an index, in units of the sizes of the components.
    fn size(&self, vector: &X, part: usize) -> f64 {
        let pairs = vector.components().zip(self.weights.components());
        pairs.fold(0.0, |size: f64, (component, weight)| {
            // A component that is zero and has no absolute tolerance is of size 1.
            let weight = match weight.largest() {
                weight if weight > 0.0 => weight * self.tolerance.of_derivatives(),
                _ => 1.0,
            };
            let derivative = component.derivative_part(part).abs() * weight;
            if derivative.is_nan() {
                f64::INFINITY
            } else {
                size.max(derivative)
            }
        })
    }
}

/// The information that the coefficients of a polynomial give about the length of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub(super) struct Proposal {
    /// The step at which the last two terms meet the tolerance, in units (Jorba & Zou 2005, section 3.2), where the last
    /// one is expected to be smaller than the one before. If they are
    /// zero, like every other term of an even motion, the terms before them are used, down to half the order. If these
    /// are zero, too, the motion may be a polynomial, like the motion of a stone, and the step is infinite; whether it
    /// is one is checked at the end of the step. After a rejection, the step that is tried next.
    pub(super) step: f64,
    /// The larger norm of the two terms of about half the order.
    middle: f64,
}

impl Proposal {
    #[inline]
    pub(super) fn of<S: Scalar, X: VectorSpace<S>, const HALF: usize>(
        coefficients: &TaylorCoefficients<X, HALF>,
        weights: &X,
        tolerance: &ErrorTolerance<S>,
    ) -> Self {
        let norm = Norm {
            coefficients,
            weights,
            tolerance,
        };
        let ErrorTolerance {
            relative, absolute, ..
        } = *tolerance;
        let decrease = decrease(Tolerance { relative, absolute }, 2 * HALF);
        let mut logarithm = f64::INFINITY;
        for (position, term) in coefficients.higher().iter().rev().enumerate().take(HALF) {
            let norm = norm.of(term);
            if norm > 0.0 {
                let order = number(2 * HALF - position);
                let least = if position == 0 { decrease } else { 0.0 };
                logarithm = logarithm.min((least - log2(norm)) / order);
            }
            if position > 0 && logarithm < f64::INFINITY {
                break;
            }
        }
        let middle = coefficients.higher().iter().take(HALF).rev().take(2);
        Self {
            step: exp2(logarithm),
            middle: middle.fold(0.0, |most, term| norm.of(term).max(most)),
        }
    }

    /// Whether the terms of half the order are almost negligible at τ, or at the proposed step if it is longer. The
    /// tolerance then says little about the length of the step, and the series may miss changes within it, such as a
    /// pulse.
    #[inline]
    pub(super) fn is_of_low_degree(self, tau: f64, half_order: usize) -> bool {
        let longest = if self.step.is_finite() {
            self.step.max(tau)
        } else {
            tau
        };
        self.middle * power(longest, half_order) < NEGLIGIBLE_TERM
    }
}

/// Returns the error for a step that is too small.
#[cold]
pub(super) fn too_small(
    vanishing_inertia: Option<Singularity>,
    (time, step): (f64, f64),
    component: ComponentName,
    tolerance: Tolerance,
) -> IntegrationError {
    match vanishing_inertia {
        Some(singularity) => IntegrationError::VanishingInertia {
            time,
            step,
            singularity,
        },
        None => IntegrationError::StepTooSmall {
            time,
            step,
            component: Some(component),
            relative_only: tolerance.absolute == 0.0,
        },
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;

    use super::{Proposal, unit_near};
    use crate::integrate::taylor::TaylorCoefficients;
    use crate::linalg::ErrorTolerance;

    /// Returns the step for the terms ρ⁻ᵏ with a relative tolerance; the term of order 11 or 12 is zero if `without` is its order.
    fn step(radius: f64, relative: f64, without: usize) -> f64 {
        let mut series = TaylorCoefficients::<_, 6>::new(SVector::from([1.0_f64]));
        for (i, term) in series.higher_mut().iter_mut().enumerate() {
            let order = i32::try_from(i + 1).unwrap();
            term[0] = if i + 1 == without {
                0.0
            } else {
                radius.powi(-order)
            };
        }
        let tolerance = ErrorTolerance {
            relative,
            absolute: 0.0,
            rate: 0.0,
        };
        Proposal::of(&series, &SVector::from([1.0 / relative]), &tolerance).step
    }

    #[test]
    fn both_terms_of_a_geometric_series_propose_one_step() {
        for radius in [0.01, 1.0, 30.0] {
            for relative in [1e-3_f64, 1e-9, 1e-16] {
                let expected = radius * relative.powf(1.0 / 11.0);
                for without in [0, 11, 12] {
                    let found = step(radius, relative, without);
                    assert!(
                        (found - expected).abs() < 1e-6 * expected,
                        "{found} {expected}"
                    );
                }
            }
        }
    }

    /// Numbers of all sizes.
    fn numbers() -> impl Iterator<Item = f64> {
        (-1070..1020).map(|i| (1.0 + f64::from(i).sin().abs()) * libm::ldexp(1.0, i))
    }

    #[test]
    fn the_unit_is_near() {
        for x in numbers() {
            let power = libm::ldexp(1.0, libm::ilogb(x).clamp(-500, 500));
            let ratio = unit_near(x) / power;
            assert!((1.0..1.5).contains(&ratio), "{x:e}");
        }
    }

    #[test]
    fn the_unit_over_an_order_is_a_number() {
        for order in 1..=16 {
            let part = unit_near(0.3) / f64::from(order);
            // The last 33 bits are zero, so that the product is exact, too.
            assert_eq!(part.to_bits() << 31, 0, "{order}");
            assert!(
                (part * f64::from(order) - unit_near(0.3)).abs() <= 0.0,
                "{order}"
            );
        }
    }
}
