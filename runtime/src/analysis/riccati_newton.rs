//! Newton's method for algebraic Riccati equations, in double-double arithmetic.
//!
//! D. L. Kleinman, *On an iterative technique for Riccati equation computations*, IEEE Trans. Automat. Contr. **13**
//! (1968) 114–115; G. A. Hewer, *An iterative technique for the computation of the steady state gains for the discrete
//! optimal regulator*, IEEE Trans. Automat. Contr. **16** (1971) 382–384. The method converges from any stabilizing
//! gain to the stabilizing solution, and quadratically near it. Its last step is the error of the previous iterate,
//! whatever the conditioning of the equation; a residual does not show this error.

use nalgebra::SMatrix;

use super::eigenvalues::balancing;
use super::lyapunov::{Square, form_in_units, lyapunov, symmetric};
use super::matrix_sign::stabilizing;
use crate::limits::analysis::{RICCATI_CHANGE, RICCATI_NEWTON_STEPS, RICCATI_ROUNDING};
use crate::linalg::{Factorization, largest_or_nan};
use crate::scalar::{DoubleDouble, Scalar};

/// The matrices of a regulator problem.
#[derive(Clone, Copy)]
pub(super) struct Riccati<const D: usize, const U: usize> {
    pub(super) a: Square<D>,
    pub(super) b: SMatrix<DoubleDouble, D, U>,
    pub(super) q: Square<D>,
    pub(super) r: SMatrix<DoubleDouble, U, U>,
    pub(super) is_discrete: bool,
}

/// A solution of a Riccati equation.
#[derive(Clone, Copy)]
pub(super) struct Solution<const D: usize, const U: usize> {
    pub(super) cost: Square<D>,
    pub(super) gain: SMatrix<DoubleDouble, U, D>,
    /// The last step of Newton's method, relative to the cost.
    pub(super) change: f64,
}

impl<const D: usize, const U: usize> Riccati<D, U> {
    /// Returns the gain K of a cost P.
    fn gain(&self, cost: &Square<D>) -> SMatrix<DoubleDouble, U, D> {
        let Self { a, b, r, .. } = self;
        let of_inputs = b.transpose() * cost;
        if self.is_discrete {
            let weight = r + of_inputs * b;
            Factorization::new(weight).solve(&(of_inputs * a))
        } else {
            Factorization::new(*r).solve(&of_inputs)
        }
    }

    /// Returns the closed loop A − B K.
    pub(super) fn closed(&self, gain: &SMatrix<DoubleDouble, U, D>) -> Square<D> {
        self.a - self.b * gain
    }

    /// Returns the stabilizing cost by the sign of a matrix.
    pub(super) fn by_sign(&self) -> Option<Square<D>> {
        let g = self.b * Factorization::new(self.r).solve(&self.b.transpose());
        stabilizing(&self.a, &g, &self.q, self.is_discrete)
    }

    /// Returns the stabilizing solution, starting from a cost whose gain stabilizes the system; `None` if it does not.
    pub(super) fn refined(&self, start: &Square<D>) -> Option<Solution<D, U>> {
        let mut cost = *start;
        let mut last = f64::INFINITY;
        let units = balancing(&self.a.map(Scalar::largest));
        for _ in 0..RICCATI_NEWTON_STEPS {
            let gain = self.gain(&cost);
            let closed = self.closed(&gain);
            let by_inputs = gain.transpose() * self.r * gain;
            let left = if self.is_discrete {
                closed.transpose() * cost * closed - cost
            } else {
                closed.transpose() * cost + cost * closed
            };
            let left = symmetric(&(left + by_inputs + self.q));
            let step = lyapunov(&closed, &left, self.is_discrete)?;
            cost += step;
            let change = relative_change(&cost, &step, &units);
            let is_rounding = last <= RICCATI_CHANGE && change >= last * 0.5;
            if change <= RICCATI_ROUNDING || is_rounding {
                let gain = self.gain(&cost);
                return Some(Solution { cost, gain, change });
            }
            last = change;
        }
        None
    }
}

/// Returns the largest relative change of a cost.
///
/// Each entry Pᵢⱼ is compared with its bound (Pᵢᵢ Pⱼⱼ)^½, so that units do not matter. A cost below the rounding errors
/// of the largest one may vanish, and is compared with those errors, in units in which A is balanced.
fn relative_change<const D: usize>(cost: &Square<D>, step: &Square<D>, units: &[i32; D]) -> f64 {
    let [cost, step] = [cost, step].map(|form| form_in_units(form, units));
    let least = f64::EPSILON * largest_or_nan(&cost);
    let root = |i: usize| libm::sqrt(cost[(i, i)].to_f64().max(least));
    largest_ratio::<D>(|i, j| {
        let step = step[(i, j)].to_f64().abs();
        (step, step / root(i) / root(j))
    })
}

/// Returns the largest ratio of an entry to its size, each given as the entry and the ratio; NaN if one is NaN. 0/0 counts as 0.
pub(super) fn largest_ratio<const D: usize>(
    entry_and_ratio: impl Fn(usize, usize) -> (f64, f64),
) -> f64 {
    let ratios = SMatrix::<f64, D, D>::from_fn(|i, j| {
        let (entry, ratio) = entry_and_ratio(i, j);
        if entry == 0.0 { 0.0 } else { ratio }
    });
    largest_or_nan(&ratios)
}

#[cfg(test)]
mod tests {
    use super::largest_ratio;

    #[test]
    fn a_ratio_that_is_nan_is_not_lost() {
        let first = |i: usize, j: usize| if i + j == 0 { f64::NAN } else { 1.0 };
        assert!(largest_ratio::<2>(|i, j| (1.0, first(i, j))).is_nan());
        let without_entry = |i: usize, j: usize| if i + j == 0 { 0.0 } else { 1.0 };
        let found = largest_ratio::<2>(|i, j| (without_entry(i, j), first(i, j)));
        assert!((found - 1.0).abs() < f64::EPSILON);
    }
}
