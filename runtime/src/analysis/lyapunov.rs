//! Lyapunov and Stein equations, in double-double arithmetic.
//!
//! By doubling: R. A. Smith, *Matrix equation XA + BX = C*, SIAM J. Appl. Math. **16** (1968) 198–201. The powers of A
//! vanish if and only if all eigenvalues are within the unit circle. The solution therefore also decides stability,
//! with more digits than eigenvalues in `f64` have. A Lyapunov equation becomes a Stein equation by the Cayley
//! transform (A + γ)(A − γ)⁻¹, which takes the left half plane to the unit disc.

use nalgebra::SMatrix;

use super::eigenvalues::balancing;
use crate::limits::analysis::{DOUBLINGS, VANISHED_POWER};
use crate::linalg::largest_or_nan;
use crate::linalg::pivoting::PivotedLu;
use crate::scalar::{DoubleDouble, Scalar};

pub(super) type Square<const D: usize> = SMatrix<DoubleDouble, D, D>;

pub(super) fn symmetric<const D: usize>(matrix: &Square<D>) -> Square<D> {
    (matrix + matrix.transpose()) * DoubleDouble::from(0.5)
}

/// Returns the matrix of a quadratic form in units 2^nᵢ of the variables: Mᵢⱼ 2^(nᵢ + nⱼ).
pub(super) fn form_in_units<const D: usize>(form: &Square<D>, exponents: &[i32; D]) -> Square<D> {
    let unit = |i: usize| DoubleDouble::from(libm::ldexp(1.0, exponents[i]));
    SMatrix::from_fn(|i, j| form[(i, j)] * unit(i) * unit(j))
}

/// Returns the matrix of a linear map in other units: Mᵢⱼ 2^(nⱼ − nᵢ).
pub(super) fn map_in_units<const D: usize>(map: &Square<D>, exponents: &[i32; D]) -> Square<D> {
    let power = |n: i32| DoubleDouble::from(libm::ldexp(1.0, n));
    SMatrix::from_fn(|i, j| map[(i, j)] * power(exponents[j] - exponents[i]))
}

/// Returns the solution X of Aᵀ X + X A + W = 0, or of X = Aᵀ X A + W in discrete time, for a symmetric W; `None` if A
/// is not stable.
pub(super) fn lyapunov<const D: usize>(
    a: &Square<D>,
    w: &Square<D>,
    is_discrete: bool,
) -> Option<Square<D>> {
    let exponents = balancing(&a.map(Scalar::largest));
    let a = map_in_units(a, &exponents);
    let w = form_in_units(w, &exponents);
    let solution = if is_discrete {
        stein(a, w)?
    } else {
        let (a, w) = transformed(&a, &w)?;
        stein(a, w)?
    };
    Some(form_in_units(&solution, &exponents.map(|n| -n)))
}

/// Returns the Stein equation that has the solution of a Lyapunov equation, with γ between the largest and the least
/// eigenvalue.
fn transformed<const D: usize>(a: &Square<D>, w: &Square<D>) -> Option<(Square<D>, Square<D>)> {
    let identity = Square::<D>::identity();
    let of_inverse = largest_or_nan(&PivotedLu::new(*a).solve(&identity));
    let rate = libm::sqrt(largest_or_nan(a)) / libm::sqrt(of_inverse);
    if !(rate > 0.0 && rate.is_finite()) {
        return None;
    }
    let rate = DoubleDouble::from(rate);
    let inverse = PivotedLu::new(a - identity * rate).solve(&identity);
    let power = identity + inverse * (rate + rate);
    let right = symmetric(&(inverse.transpose() * w * inverse)) * (rate + rate);
    Some((power, right))
}

/// Solves X = Aᵀ X A + W by the iteration X ← X + Aᵀ X A, A ← A².
fn stein<const D: usize>(mut a: Square<D>, w: Square<D>) -> Option<Square<D>> {
    let mut x = w;
    for _ in 0..DOUBLINGS {
        x += symmetric(&(a.transpose() * x * a));
        a *= a;
        let [size, power] = [&x, &a].map(largest_or_nan);
        if !(size.is_finite() && power.is_finite()) {
            return None;
        }
        // The remaining error is smaller by the square of this power.
        if power <= VANISHED_POWER {
            return Some(x);
        }
    }
    None
}
