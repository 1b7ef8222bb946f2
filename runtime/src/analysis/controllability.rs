//! Controllability, by the staircase form.
//!
//! Orthogonal transformations separate the part of the state that the inputs reach from the part that they do not: C.
//! C. Paige, *Properties of numerical algorithms related to computing controllability*, IEEE Trans. Autom. Control
//! **26** (1981) 130–138; P. M. Van Dooren, *The generalized eigenstructure problem in linear system theory*, ibid.,
//! 111–129. The matrix (B, AB, …) is not formed, because its powers hide small singular values. A is balanced first
//! (Parlett and Reinsch), since controllability does not depend on the scales of the variables.

use nalgebra::{Complex, SMatrix};

use super::eigenvalues::{balancing, eigenvalues};
use super::null_vector::null_vector;
use super::spectrum::{Spectrum, modulus};
use crate::limits::analysis::UNREACHED;
use crate::linalg::first_largest;
use crate::scalar::Scalar;

/// The part of the state of a linear system that its inputs reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Controllability<const D: usize> {
    /// The dimension of the controllable subspace; `D` if the system is controllable.
    pub rank: usize,
    /// The basis in which (A, B) has staircase form: the first `rank` columns span the controllable subspace. It is
    /// orthonormal in the units in which A is balanced, which are powers of two.
    pub basis: SMatrix<f64, D, D>,
    /// A in this basis.
    staircase: SMatrix<f64, D, D>,
}

/// A mode that no input reaches.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct UncontrollableMode {
    /// Its eigenvalue.
    pub eigenvalue: Complex<f64>,
    /// The component of the state that participates most in the mode: coordinates come first, then velocities.
    pub component: usize,
}

impl<const D: usize> Controllability<D> {
    /// Computes the controllability of the pair (A, B). In the units in which A is balanced, entries below a few
    /// machine epsilons of the largest entries count as zero.
    #[must_use]
    pub fn of<S: Scalar, const U: usize>(a: &SMatrix<S, D, D>, b: &SMatrix<S, D, U>) -> Self {
        let a = a.map(Scalar::largest);
        let exponents = balancing(&a);
        let unit = |i: usize| libm::ldexp(1.0, exponents[i]);
        let mut form = Form::<D, U> {
            a: SMatrix::from_fn(|i, j| a[(i, j)] / unit(i) * unit(j)),
            b: SMatrix::from_fn(|i, j| b[(i, j)].largest() / unit(i)),
            basis: SMatrix::from_fn(|i, j| if i == j { unit(i) } else { 0.0 }),
        };
        #[allow(clippy::cast_precision_loss)] // A dimension.
        let rounding = UNREACHED * (D as f64) * f64::EPSILON;
        let entries = |size: f64, x: &f64| x.abs().max(size);
        // The scales of the inputs do not matter.
        for mut column in form.b.column_iter_mut() {
            let largest = column.iter().fold(0.0, entries);
            if largest > 0.0 {
                column /= largest;
            }
        }
        let of_state = rounding * form.a.iter().fold(0.0, entries);
        let mut reached = form.compress(None, 0, rounding);
        let mut rank = reached;
        let mut before = 0;
        while reached > 0 && rank < D {
            reached = form.compress(Some(before), rank, of_state);
            before = rank;
            rank += reached;
        }
        Self {
            rank,
            basis: form.basis,
            staircase: form.a,
        }
    }

    /// Returns whether the inputs reach every state.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        self.rank == D
    }

    /// Returns the eigenvalues of the modes that no input reaches, or `None` if they are not found.
    #[must_use]
    pub fn uncontrollable(&self) -> Option<Spectrum<D>> {
        let order = D - self.rank;
        let mut entries = [[0.0; D]; D];
        for (i, row) in entries.iter_mut().take(order).enumerate() {
            for (j, entry) in row.iter_mut().take(order).enumerate() {
                *entry = self.staircase[(self.rank + i, self.rank + j)];
            }
        }
        let mut found = [[Complex::new(0.0, 0.0); D]; 2];
        let flat = found.as_flattened_mut();
        let converged = eigenvalues(entries.as_flattened_mut(), D, order, flat);
        converged.then(|| Spectrum::new(found, order))
    }

    /// Returns the mode that belongs to an uncontrollable eigenvalue.
    pub(super) fn mode(&self, eigenvalue: Complex<f64>) -> UncontrollableMode {
        let unit = SMatrix::<Complex<f64>, D, D>::identity();
        let left = SMatrix::<Complex<f64>, D, D>::from_fn(|i, j| {
            if i >= self.rank && j >= self.rank {
                Complex::new(self.staircase[(j, i)], 0.0) - eigenvalue * unit[(i, j)]
            } else {
                unit[(i, j)]
            }
        });
        let vector = null_vector(&left, core::iter::empty());
        let share = |i: usize| {
            let terms = (self.rank..D).map(|j| vector[j] * self.basis[(i, j)]);
            // A left vector in the units of the state: the rows of the basis have the lengths of the units.
            let squares: f64 = self.basis.row(i).iter().map(|x| x * x).sum();
            modulus(terms.sum()) / squares
        };
        let component = (0..D).fold(0, |most, i| if share(i) > share(most) { i } else { most });
        UncontrollableMode {
            eigenvalue,
            component,
        }
    }
}

/// The pair (A, B) in a basis that is being built.
struct Form<const D: usize, const U: usize> {
    a: SMatrix<f64, D, D>,
    b: SMatrix<f64, D, U>,
    basis: SMatrix<f64, D, D>,
}

impl<const D: usize, const U: usize> Form<D, U> {
    /// Compresses the rows from `start` on of B, or of the columns `before..start` of A, and returns the number of
    /// nonzero rows that remain.
    fn compress(&mut self, before: Option<usize>, start: usize, zero: f64) -> usize {
        let columns = before.map_or(U, |before| start - before);
        let mut rank = 0;
        while start + rank < D {
            let first = start + rank;
            let entry = |form: &Self, i: usize, j: usize| match before {
                None => form.b[(i, j)],
                Some(before) => form.a[(i, before + j)],
            };
            let length = |form: &Self, j: usize| {
                let squares = (first..D).map(|i| entry(form, i, j) * entry(form, i, j));
                libm::sqrt(squares.sum())
            };
            let (column, length) = first_largest((0..columns).map(|j| length(self, j)));
            if length.is_nan() || length <= zero {
                break;
            }
            let mut v = [0.0; D];
            for (i, x) in v.iter_mut().enumerate().skip(first) {
                *x = entry(self, i, column);
            }
            v[first] += libm::copysign(length, v[first]);
            self.reflect(&v, first);
            rank += 1;
        }
        rank
    }

    /// Applies the Householder reflection in the hyperplane orthogonal to v, whose components below `first` are zero.
    fn reflect(&mut self, v: &[f64; D], first: usize) {
        let v = || v.iter().copied().enumerate().skip(first);
        let factor = 2.0 / v().map(|(_, x)| x * x).sum::<f64>();
        let product = |entry: &dyn Fn(usize) -> f64| {
            let products = v().map(|(i, x)| x * entry(i));
            factor * products.sum::<f64>()
        };
        for j in 0..U {
            let product = product(&|i| self.b[(i, j)]);
            for (i, x) in v() {
                self.b[(i, j)] -= product * x;
            }
        }
        for j in 0..D {
            let product = product(&|i| self.a[(i, j)]);
            for (i, x) in v() {
                self.a[(i, j)] -= product * x;
            }
        }
        for i in 0..D {
            let of_state = product(&|j| self.a[(i, j)]);
            let of_basis = product(&|j| self.basis[(i, j)]);
            for (j, x) in v() {
                self.a[(i, j)] -= of_state * x;
                self.basis[(i, j)] -= of_basis * x;
            }
        }
    }
}
