//! Normal modes: K φ = ω² M φ.
//!
//! Through the Cholesky factors of M and Jacobi's method: G. H. Golub and C. F. Van Loan, *Matrix Computations*, 4th edition
//! (2013), 8.7.1. Frequencies of rigid motions are zero: what rounding of the entries of K makes of ω² is at most
//! ε Σ |φᵢ| |Kᵢⱼ| |φⱼ|, to first order (8.1).

use nalgebra::{SMatrix, SVector};

use super::exceeds;
use super::oscillation_error::OscillationError;
use super::small_oscillations::{SmallOscillations, largest, negligible};
use super::symmetric_eigenvalues::symmetric_eigenvalues;
use crate::integrate::SingleNumber;
use crate::scalar::Scalar;

/// The normal modes of a conservative system without gyroscopic forces, K φ = ω² M φ, by ascending ω².
///
/// Shapes have φᵀ M φ = 1, and their largest component is positive; of components equal to rounding, the first.
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
    /// Those of a mass matrix M, of which the lower triangle is read, and a stiffness matrix K, both symmetric.
    ///
    /// # Errors
    ///
    /// If M is not positive definite, or if K is not symmetric up to half of the digits.
    pub fn of(
        mass: &SMatrix<S, N, N>,
        stiffness: &SMatrix<S, N, N>,
    ) -> Result<Self, OscillationError> {
        let every = core::array::from_fn(|i| i);
        Self::of_variables(mass, stiffness, &every, N)
    }

    /// Those of the first `count` of some coordinates.
    fn of_variables(
        mass: &SMatrix<S, N, N>,
        stiffness: &SMatrix<S, N, N>,
        coordinates: &[usize; N],
        count: usize,
    ) -> Result<Self, OscillationError> {
        let asymmetry = largest(&(stiffness - stiffness.transpose()));
        // NaN is not symmetric.
        if exceeds(asymmetry, negligible::<S>() * largest(stiffness)) {
            return Err(OscillationError::NotConservative { asymmetry });
        }
        let half = S::from_f64(0.5);
        let part = |matrix: &SMatrix<S, N, N>| {
            SMatrix::from_fn(|i, j| {
                if i < count && j < count {
                    matrix[(coordinates[i], coordinates[j])]
                } else {
                    S::zero()
                }
            })
        };
        let lower = cholesky(&part(mass), count).map_err(|(i, pivot)| {
            let coordinate = coordinates[i];
            OscillationError::NoPositiveMass { coordinate, pivot }
        })?;
        let symmetric = (stiffness + stiffness.transpose()) * half;
        // L⁻¹ K L⁻ᵀ.
        let once: SMatrix<S, N, N> = forward(&lower, part(&symmetric), count);
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

    /// How many modes there are.
    #[must_use]
    #[allow(clippy::len_without_is_empty)] // Nobody asks whether there are none.
    pub fn len(&self) -> usize {
        self.count
    }

    /// ω² of a mode, negative if it is unstable, 0 of a rigid motion; NaN if there is no such mode.
    #[must_use]
    pub fn squared_frequency(&self, mode: usize) -> S {
        if mode < self.count {
            self.squared_frequencies[mode]
        } else {
            S::from_f64(f64::NAN)
        }
    }

    /// The squares ω² of all modes.
    pub fn squared_frequencies(&self) -> impl Iterator<Item = S> + '_ {
        self.squared_frequencies.iter().take(self.count).copied()
    }

    /// The angular frequencies ω in rad over time; none for a mode that is unstable.
    pub fn frequencies(&self) -> impl Iterator<Item = Option<S>> + '_ {
        let squares = self.squared_frequencies();
        squares.map(|square| (square.largest() >= 0.0).then(|| square.sqrt()))
    }

    /// The shape φ of a mode; zero if there is no such mode.
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
    /// The normal modes of the coordinates that oscillate.
    ///
    /// # Errors
    ///
    /// If there are gyroscopic or damping forces, if forces are not conservative, or if the mass matrix is not positive definite.
    /// [`damped_modes`](Self::damped_modes) has the modes then.
    pub fn normal_modes(&self) -> Result<NormalModes<S, N>, OscillationError> {
        let forces = largest(&self.velocity_forces());
        let stiffness = self.stiffness();
        // In terms of a frequency ω: coefficients of the size of M ω and K/ω.
        let typical = (largest(&self.mass) * largest(&stiffness)).max(0.0);
        if exceeds(forces, negligible::<S>() * libm::sqrt(typical)) {
            return Err(OscillationError::VelocityForces { largest: forces });
        }
        let (coordinates, [count, _]) = self.variables();
        NormalModes::of_variables(&self.mass, &stiffness, &coordinates, count)
    }
}

/// What rounding makes of ω² of a mode with φᵀ M φ = 1.
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

/// L of M = L Lᵀ in the leading block of some order; or the index and the value of the pivot that is not positive.
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

/// L⁻¹ B.
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

/// L⁻ᵀ B.
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

/// The component of the largest magnitude in a column; of those that are equal to rounding, the first.
fn largest_component<S: SingleNumber, const N: usize>(shapes: &SMatrix<S, N, N>, mode: usize) -> S {
    let most = (0..N).fold(0.0, |most, i| shapes[(i, mode)].abs().largest().max(most));
    let near = most * (1.0 - negligible::<S>());
    let mut column = (0..N).map(|i| shapes[(i, mode)]);
    let found = column.find(|x| x.abs().largest() >= near);
    found.unwrap_or(S::zero())
}
