//! Algebraic Riccati equations, by structure-preserving doubling.
//!
//! Discrete equations: E. K.-W. Chu, H.-Y. Fan, W.-W. Lin and C.-S. Wang, *Structure-preserving algorithms for periodic
//! discrete-time algebraic Riccati equations*, Int. J. Control **77** (2004) 767–788. Continuous equations, after a
//! Cayley transform: E. K.-W. Chu, H.-Y. Fan and W.-W. Lin, *A structure-preserving doubling algorithm for
//! continuous-time algebraic Riccati equations*, Linear Algebra Appl. **396** (2005) 55–80. The iteration converges
//! quadratically unless eigenvalues of the closed loop are on the border of stability.

use nalgebra::{Complex, SMatrix};

use super::eigenvalues::eigenvalues;
use super::spectrum::modulus;
use crate::limits::analysis::{CAYLEY_SHIFTS, DOUBLINGS};
use crate::linalg::pivoting::PivotedLu;

type Square<const D: usize> = SMatrix<f64, D, D>;

fn symmetric<const D: usize>(matrix: &Square<D>) -> Square<D> {
    (matrix + matrix.transpose()) * 0.5
}

/// Returns the stabilizing solution X of X = Aᵀ X (1 + G X)⁻¹ A + Q, if the iteration finds it.
pub(super) fn discrete<const D: usize>(
    a: &Square<D>,
    g: &Square<D>,
    q: &Square<D>,
) -> Option<Square<D>> {
    let (mut a, mut g, mut x) = (*a, *g, *q);
    for _ in 0..DOUBLINGS {
        let factored = PivotedLu::new(Square::identity() + g * x);
        let first = factored.solve(&a);
        let second = factored.solve(&g);
        let change = symmetric(&(a.transpose() * x * first));
        g += symmetric(&(a * second * a.transpose()));
        a *= first;
        x += change;
        let [size, step] = [&x, &change].map(SMatrix::norm);
        if !size.is_finite() {
            return None;
        }
        if step <= f64::EPSILON * size {
            return Some(x);
        }
    }
    None
}

/// Returns the stabilizing solution X of Aᵀ X + X A − X G X + Q = 0, if the iteration finds it.
pub(super) fn continuous<const D: usize>(
    a: &Square<D>,
    g: &Square<D>,
    q: &Square<D>,
) -> Option<Square<D>> {
    let shift = cayley_shift(a, g, q)?;
    let identity = Square::<D>::identity();
    let shifted = a - identity * shift;
    let factored = PivotedLu::new(shifted);
    let of_g = factored.solve(g);
    let of_q = PivotedLu::new(shifted.transpose()).solve(q);
    let first = shifted + g * of_q;
    let second = PivotedLu::new(shifted.transpose() + q * of_g);
    let inverse = factored.solve(&identity);
    let doubled = 2.0 * shift;
    let a = identity + PivotedLu::new(first).solve(&identity) * doubled;
    let g = symmetric(&(of_g * second.solve(&identity) * doubled));
    let q = symmetric(&(second.solve(&(q * inverse)) * doubled));
    discrete(&a, &g, &q)
}

/// Returns the parameter γ of the Cayley transform, which takes λ to (λ + γ)/(λ − γ).
///
/// It lies between the least and the largest eigenvalue of the Hamiltonian matrix (A, −G; −Q, −Aᵀ), far from all of
/// them and from the eigenvalues of A. Returns `None` if eigenvalues are not found or on the imaginary axis.
fn cayley_shift<const D: usize>(a: &Square<D>, g: &Square<D>, q: &Square<D>) -> Option<f64> {
    let mut entries = [[[[0.0; D]; 2]; D]; 2];
    let flat = entries.as_flattened_mut().as_flattened_mut();
    let flat = flat.as_flattened_mut();
    for i in 0..D {
        for j in 0..D {
            flat[i * 2 * D + j] = a[(i, j)];
            flat[i * 2 * D + D + j] = -g[(i, j)];
            flat[(D + i) * 2 * D + j] = -q[(i, j)];
            flat[(D + i) * 2 * D + D + j] = -a[(j, i)];
        }
    }
    let zero = Complex::new(0.0, 0.0);
    let mut hamiltonian = [[zero; D]; 2];
    if !eigenvalues(flat, 2 * D, 2 * D, hamiltonian.as_flattened_mut()) {
        return None;
    }
    let mut open = [zero; D];
    let mut copy: [[f64; D]; D] = (*a).into();
    if !eigenvalues(copy.as_flattened_mut(), D, D, &mut open) {
        return None;
    }
    let sizes = || hamiltonian.as_flattened().iter().map(|x| modulus(*x));
    let [least, most] = [
        sizes().fold(f64::INFINITY, f64::min),
        sizes().fold(0.0, f64::max),
    ];
    if !(least > 0.0 && most.is_finite()) {
        return None;
    }
    let middle = libm::sqrt(least) * libm::sqrt(most);
    let distance = |shift: f64| {
        let all = hamiltonian.as_flattened().iter().chain(&open);
        let distances = all.map(|x| modulus(x - shift) / shift);
        distances.fold(f64::INFINITY, f64::min)
    };
    let shifts = CAYLEY_SHIFTS.map(|factor| factor * middle);
    shifts
        .into_iter()
        .max_by(|x, y| distance(*x).total_cmp(&distance(*y)))
}
