//! Normal modes: K φ = ω² M φ.
//!
//! The method reduces the problem by the Cholesky factor of M and applies Jacobi's method: G. H. Golub and C. F. Van
//! Loan, *Matrix Computations*, 4th edition (2013), 8.7.1. Frequencies of rigid motions are set to zero: rounding
//! errors of the entries of K change ω² by at most ε Σ |φᵢ| |Kᵢⱼ| |φⱼ|, to first order (8.1).

use nalgebra::{SMatrix, SVector};

use super::exceeds;
use super::members::Members;
use super::oscillation_error::OscillationError;
use super::small_oscillations::{SmallOscillations, negligible};
use super::symmetric_eigenvalues::symmetric_eigenvalues;
use crate::integrate::SingleNumber;
use crate::linalg::largest;
use crate::scalar::Scalar;

/// The normal modes of a conservative system without gyroscopic forces, K φ = ω² M φ, by ascending ω².
///
/// Shapes are normalized by φᵀ M φ = 1, and their largest component is positive; of components that are equal up to
/// rounding, the first counts.
///
/// ```
/// use lagrangian::analysis::NormalModes;
/// use lagrangian::nalgebra::Matrix2;
///
/// // Two equal masses between three equal springs.
/// let modes = NormalModes::of(&Matrix2::identity(), &Matrix2::new(2.0, -1.0, -1.0, 2.0))?;
/// assert!((modes.squared_frequency(0) - 1.0_f64).abs() < 1e-15);
/// assert!((modes.squared_frequency(1) - 3.0).abs() < 1e-15);
/// assert!((modes.shape(1)[0] + modes.shape(1)[1]).abs() < 1e-15);
/// # Ok::<(), lagrangian::analysis::OscillationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NormalModes<S: Scalar, const N: usize> {
    squared_frequencies: SVector<S, N>,
    shapes: SMatrix<S, N, N>,
    count: usize,
}

impl<S: SingleNumber, const N: usize> NormalModes<S, N> {
    /// Computes the normal modes of a mass matrix M, whose lower triangle is read, and a stiffness matrix K; both are
    /// symmetric.
    ///
    /// # Errors
    ///
    /// If M is not positive definite, or if K is not symmetric to half of the digits.
    pub fn of(
        mass: &SMatrix<S, N, N>,
        stiffness: &SMatrix<S, N, N>,
    ) -> Result<Self, OscillationError> {
        Self::of_variables(mass, stiffness, &Members::of(0..N))
    }

    /// Computes the normal modes of some coordinates.
    fn of_variables(
        mass: &SMatrix<S, N, N>,
        stiffness: &SMatrix<S, N, N>,
        coordinates: &Members<N>,
    ) -> Result<Self, OscillationError> {
        let asymmetry = largest(&(stiffness - stiffness.transpose()));
        // A NaN counts as asymmetry.
        if exceeds(asymmetry, negligible::<S>() * largest(stiffness)) {
            return Err(OscillationError::NotConservative { asymmetry });
        }
        let half = S::from_f64(0.5);
        let count = coordinates.len();
        let lower = cholesky(&coordinates.block(mass), count).map_err(|(i, pivot)| {
            let coordinate = coordinates[i];
            OscillationError::NoPositiveMass { coordinate, pivot }
        })?;
        let symmetric = (stiffness + stiffness.transpose()) * half;
        // L⁻¹ K L⁻ᵀ.
        let once = forward(&lower, coordinates.block(&symmetric), count);
        let reduced = forward(&lower, once.transpose(), count);
        let (squared_frequencies, vectors) = symmetric_eigenvalues(&reduced, count);
        let compact = backward(&lower, vectors, count);
        let mut shapes = SMatrix::zeros();
        for mode in 0..count {
            for i in 0..count {
                shapes[(coordinates[i], mode)] = compact[(i, mode)];
            }
            if largest_component(&shapes, mode).largest() < 0.0 {
                for i in 0..N {
                    shapes[(i, mode)] = -shapes[(i, mode)];
                }
            }
        }
        let squared_frequencies = SVector::from_fn(|mode, _| {
            let square: S = squared_frequencies[mode];
            let is_rounding = square.abs().largest() <= rounding(&symmetric, &shapes, mode);
            if is_rounding { S::zero() } else { square }
        });
        Ok(Self {
            squared_frequencies,
            shapes,
            count,
        })
    }

    /// Returns the number of modes.
    #[must_use]
    #[allow(clippy::len_without_is_empty)] // Nobody asks whether there are none.
    pub fn len(&self) -> usize {
        self.count
    }

    /// Returns ω² of a mode: negative if it is unstable, 0 for a rigid motion, and NaN if there is no such mode.
    #[must_use]
    pub fn squared_frequency(&self, mode: usize) -> S {
        if mode < self.count {
            self.squared_frequencies[mode]
        } else {
            S::from_f64(f64::NAN)
        }
    }

    /// Returns the squares ω² of all modes.
    pub fn squared_frequencies(&self) -> impl Iterator<Item = S> + '_ {
        self.squared_frequencies.iter().take(self.count).copied()
    }

    /// Returns the angular frequencies ω in rad over time; `None` for an unstable mode.
    pub fn frequencies(&self) -> impl Iterator<Item = Option<S>> + '_ {
        let squares = self.squared_frequencies();
        squares.map(|square| (square.largest() >= 0.0).then(|| square.sqrt()))
    }

    /// Returns the shape φ of a mode; zero if there is no such mode.
    #[must_use]
    pub fn shape(&self, mode: usize) -> SVector<S, N> {
        SVector::from_fn(|i, _| {
            if mode < self.count {
                self.shapes[(i, mode)]
            } else {
                S::zero()
            }
        })
    }
}

impl<S: SingleNumber, const N: usize> SmallOscillations<S, N> {
    /// Computes the normal modes of the oscillating coordinates.
    ///
    /// # Errors
    ///
    /// If there are gyroscopic or damping forces, if forces are not conservative, or if the mass matrix is not positive
    /// definite. [`damped_modes`](Self::damped_modes) returns the modes in these cases, too.
    pub fn normal_modes(&self) -> Result<NormalModes<S, N>, OscillationError> {
        let forces = largest(&self.velocity_forces());
        let stiffness = self.stiffness();
        // At a frequency ω, the coefficients have the sizes of M ω and K/ω.
        let typical = (largest(&self.mass) * largest(&stiffness)).max(0.0);
        if exceeds(forces, negligible::<S>() * libm::sqrt(typical)) {
            return Err(OscillationError::VelocityForces { largest: forces });
        }
        let coordinates = Members::of(self.coordinates());
        NormalModes::of_variables(&self.mass, &stiffness, &coordinates)
    }
}

/// Returns a bound on the rounding error of ω² of a mode with φᵀ M φ = 1.
fn rounding<S: SingleNumber, const N: usize>(
    stiffness: &SMatrix<S, N, N>,
    shapes: &SMatrix<S, N, N>,
    mode: usize,
) -> f64 {
    let size = |x: S| x.abs().largest();
    let forces = (0..N).map(|i| {
        let terms = (0..N).map(|j| size(stiffness[(i, j)]) * size(shapes[(j, mode)]));
        size(shapes[(i, mode)]) * terms.sum::<f64>()
    });
    #[allow(clippy::cast_precision_loss)] // A number of coordinates.
    let room = 4.0 * N as f64;
    room * S::machine_epsilon() * forces.sum::<f64>()
}

/// Returns L of M = L Lᵀ in the leading block of some order, or the index and the value of the first pivot that is not
/// positive.
fn cholesky<S: SingleNumber, const N: usize>(
    matrix: &SMatrix<S, N, N>,
    order: usize,
) -> Result<SMatrix<S, N, N>, (usize, f64)> {
    let mut lower = SMatrix::zeros();
    for j in 0..order {
        let squares = (0..j).fold(S::zero(), |sum, k| sum + lower[(j, k)] * lower[(j, k)]);
        let pivot: S = matrix[(j, j)] - squares;
        let value = pivot.largest();
        if value.is_nan() || value <= 0.0 {
            return Err((j, value));
        }
        lower[(j, j)] = pivot.sqrt();
        for i in j + 1..order {
            let products = (0..j).fold(S::zero(), |sum, k| sum + lower[(i, k)] * lower[(j, k)]);
            lower[(i, j)] = (matrix[(i, j)] - products) / lower[(j, j)];
        }
    }
    Ok(lower)
}

/// Returns L⁻¹ B.
fn forward<S: SingleNumber, const N: usize>(
    lower: &SMatrix<S, N, N>,
    right: SMatrix<S, N, N>,
    order: usize,
) -> SMatrix<S, N, N> {
    let mut x = right;
    for column in 0..order {
        for i in 0..order {
            let known = (0..i).fold(S::zero(), |sum, k| sum + lower[(i, k)] * x[(k, column)]);
            x[(i, column)] = (x[(i, column)] - known) / lower[(i, i)];
        }
    }
    x
}

/// Returns L⁻ᵀ B.
fn backward<S: SingleNumber, const N: usize>(
    lower: &SMatrix<S, N, N>,
    right: SMatrix<S, N, N>,
    order: usize,
) -> SMatrix<S, N, N> {
    let mut x = right;
    for column in 0..order {
        for i in (0..order).rev() {
            let later = i + 1..order;
            let known = later.fold(S::zero(), |sum, k| sum + lower[(k, i)] * x[(k, column)]);
            x[(i, column)] = (x[(i, column)] - known) / lower[(i, i)];
        }
    }
    x
}

/// Returns the component of the largest magnitude in a column; of components that are equal up to rounding, the first.
fn largest_component<S: SingleNumber, const N: usize>(shapes: &SMatrix<S, N, N>, mode: usize) -> S {
    let shape = shapes.column(mode);
    let near = largest(shape) * (1.0 - negligible::<S>());
    let found = shape.iter().find(|x| x.abs().largest() >= near);
    found.copied().unwrap_or(S::zero())
}
