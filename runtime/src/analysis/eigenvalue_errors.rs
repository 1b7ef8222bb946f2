//! Error bounds for the eigenvalues of the linearized motion, each by its own condition number.
//!
//! Let x and y be the right and left null vectors of Q(λ) = λ² − λ ∂q̈/∂q̇ − ∂q̈/∂q. If the entries have relative
//! errors ε, a simple eigenvalue moves by at most ε |y|ᵀ (|λ|² + |λ| |∂q̈/∂q̇| + |∂q̈/∂q|) |x| / |yᴴ Q'(λ) x|, to first
//! order: F. Tisseur, *Backward error and condition of polynomial eigenvalue problems*, Linear Algebra Appl. **309**
//! (2000) 339–361, by entries, as D. J. Higham and N. J. Higham, *Structured backward error and condition of
//! generalized eigenvalue problems*, SIAM J. Matrix Anal. Appl. **20** (1998) 493–512. The denominator vanishes where
//! an eigenvalue is defective (J. H. Wilkinson, *The Algebraic Eigenvalue Problem*, 1965, 2.7 to 2.9). The uncertainty
//! of the entries that results from the uncertain position of the equilibrium is added.

use nalgebra::{Complex, SMatrix, SVector};

use super::null_vector::null_vector;
use super::small_oscillations::SmallOscillations;
use super::spectrum::modulus;
use crate::integrate::SingleNumber;
use crate::limits::analysis::{DEFECTIVE, EIGENVALUE_ERRORS, VARIATION_ERRORS};

type C = Complex<f64>;

/// An eigenvalue, a bound on its error, and the label of its component.
#[derive(Clone, Copy)]
pub(super) struct Located {
    pub(super) value: C,
    pub(super) error: f64,
    pub(super) component: usize,
}

impl Located {
    /// Returns whether the exact eigenvalue may equal another one.
    pub(super) fn may_equal(&self, other: &Self) -> bool {
        self.component == other.component
            && modulus(self.value - other.value) <= self.error + other.error
    }
}

impl<S: SingleNumber, const N: usize> SmallOscillations<S, N> {
    /// Returns a bound on the error of a computed eigenvalue of a component; `radius` is the modulus of the component's
    /// largest eigenvalue.
    pub(super) fn eigenvalue_error(
        &self,
        value: C,
        radius: f64,
        is_member: &dyn Fn(usize) -> bool,
    ) -> f64 {
        let epsilon = S::machine_epsilon().max(f64::EPSILON);
        let terms = |i: usize, j: usize| self.terms(i, j, modulus(value));
        // Scales of the rows by the sizes of their terms, so that no row vanishes beside another; rows of other
        // components have scale 1.
        let scale: [f64; N] = core::array::from_fn(|i| {
            let members = (0..N).filter(|j| is_member(*j));
            let most = members.map(|j| terms(i, j)).fold(0.0, f64::max);
            if is_member(i) && most > 0.0 {
                most
            } else {
                1.0
            }
        });
        let unit = |i: usize, j: usize| C::new(if i == j { 1.0 } else { 0.0 }, 0.0);
        let whole = self.quadratic(value);
        let matrix = SMatrix::<C, N, N>::from_fn(|i, j| {
            if is_member(i) && is_member(j) {
                whole[(i, j)] / scale[i]
            } else {
                unit(i, j)
            }
        });
        let right = null_vector(&matrix, core::iter::empty());
        let left = null_vector(&matrix.adjoint(), core::iter::empty());
        let pairs = || {
            let members = (0..N).filter(|i| is_member(*i));
            members.flat_map(|i| (0..N).filter(|j| is_member(*j)).map(move |j| (i, j)))
        };
        let sum = |entry: &dyn Fn(usize, usize) -> C| -> C {
            let terms = pairs().map(|(i, j)| left[i].conj() * entry(i, j) * right[j] / scale[i]);
            terms.sum()
        };
        let slope = modulus(sum(&|i, j| {
            let [_, c1, c2] = self.coefficients(i, j);
            value * (2.0 * c2) + c1
        }));
        let size = |x: &SVector<C, N>, i: usize| modulus(x[i]);
        let bounds =
            pairs().map(|(i, j)| size(&left, i) * terms(i, j) * size(&right, j) / scale[i]);
        let bound = EIGENVALUE_ERRORS * epsilon * bounds.sum::<f64>();
        // The residual that the QR algorithm has left, by one step of Newton's method.
        let residual = 2.0 * modulus(sum(&|i, j| whole[(i, j)]));
        let most = libm::pow(epsilon, DEFECTIVE) * radius;
        let error = (bound + residual) / slope;
        // The uncertainty due to the position of the equilibrium, to first order; for a double eigenvalue, the square
        // root.
        let [of_position, of_velocity] = &self.errors;
        let undetermined = pairs().map(|(i, j)| {
            let entry =
                of_position[(i, j)].largest() + modulus(value) * of_velocity[(i, j)].largest();
            size(&left, i) * entry * size(&right, j) / scale[i]
        });
        let undetermined = VARIATION_ERRORS * undetermined.sum::<f64>();
        let curvature = modulus(sum(&|i, j| C::new(self.coefficients(i, j)[2], 0.0)));
        let of_place = (2.0 * undetermined / slope).min(2.0 * libm::sqrt(undetermined / curvature));
        let of_place = if of_place.is_nan() { 0.0 } else { of_place };
        // At a double zero, 0/0 is NaN.
        (if error <= most { error } else { most }) + of_place
    }
}
