//! Modes of small oscillations with damping and gyroscopic forces.
//!
//! The modes solve the quadratic eigenvalue problem (λ² − λ ∂q̈/∂q̇ − ∂q̈/∂q) φ = 0: F. Tisseur and K. Meerbergen, *The
//! quadratic eigenvalue problem*, SIAM Review **43** (2001) 235–286. The eigenvalues are computed from the first-order
//! system; a mode shape is a null vector of the matrix at its eigenvalue.

use nalgebra::{Complex, SMatrix, SVector};

use super::null_vector::null_vector;
use super::oscillation_error::OscillationError;
use super::reduced_equations::Part;
use super::small_oscillations::{SmallOscillations, negligible};
use super::spectrum::modulus;
use crate::integrate::SingleNumber;
use crate::limits::analysis::ROOM_FOR_SHAPES as ROOM;

type C = Complex<f64>;

/// A mode δq = Re(φ exp(λt)); of a conjugate pair, the mode with Im λ > 0.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampedMode<const N: usize> {
    /// λ, in rad over time: the real part is the rate of growth, the imaginary part the damped frequency.
    pub eigenvalue: Complex<f64>,
    /// The shape φ, complex since the coordinates are out of phase. The largest component is 1. The components of
    /// eliminated coordinates follow from their constant momenta; these coordinates drift if λ is 0, and their
    /// components are 0 then. A double eigenvalue may have only one shape, as at critical damping: both of its modes
    /// have this shape then.
    pub shape: SVector<Complex<f64>, N>,
}

impl<const N: usize> DampedMode<N> {
    /// Returns the natural frequency |λ| in rad over time.
    #[must_use]
    pub fn natural_frequency(&self) -> f64 {
        modulus(self.eigenvalue)
    }

    /// Returns the damping ratio −Re λ/|λ|.
    ///
    /// It is 0 without damping, 1 for a mode that does not oscillate, negative for a growing mode, and NaN for λ = 0.
    #[must_use]
    pub fn damping_ratio(&self) -> f64 {
        -self.eigenvalue.re / modulus(self.eigenvalue)
    }
}

/// The modes of small oscillations, by ascending natural frequency; dereferences to a slice of them.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DampedModes<const N: usize> {
    modes: [[DampedMode<N>; N]; 2],
    count: usize,
}

impl<const N: usize> core::ops::Deref for DampedModes<N> {
    type Target = [DampedMode<N>];

    fn deref(&self) -> &[DampedMode<N>] {
        &self.modes.as_flattened()[..self.count]
    }
}

impl<S: SingleNumber, const N: usize> SmallOscillations<S, N> {
    /// Computes the modes, whatever the forces: one for each real eigenvalue and for each conjugate pair. Eigenvalues
    /// of rigid motions are 0.
    ///
    /// # Errors
    ///
    /// If the eigenvalues are not found.
    pub fn damped_modes(&self) -> Result<DampedModes<N>, OscillationError> {
        let spectrum = self.spectrum()?;
        let zero = SVector::repeat(C::new(0.0, 0.0));
        let mut found = DampedModes {
            modes: [[DampedMode {
                eigenvalue: C::new(0.0, 0.0),
                shape: zero,
            }; N]; 2],
            count: 0,
        };
        let mut vectors = [[zero; N]; 2];
        let near = negligible::<S>().max(negligible::<f64>()) * spectrum.radius();
        let has_rigid_motion = self.has_rigid_motion();
        for eigenvalue in spectrum.iter() {
            let is_rigid = has_rigid_motion && modulus(*eigenvalue) <= near;
            let eigenvalue = if is_rigid {
                C::new(0.0, 0.0)
            } else {
                *eigenvalue
            };
            if eigenvalue.im < 0.0 {
                continue;
            }
            let vectors = vectors.as_flattened_mut();
            let pairs = found.iter().zip(vectors.iter());
            let equal = pairs.filter(|(mode, _)| modulus(mode.eigenvalue - eigenvalue) <= near);
            let vector = self.amplitudes(eigenvalue, equal.map(|(_, x)| *x));
            if let Some(mode) = found.modes.as_flattened_mut().get_mut(found.count) {
                mode.eigenvalue = eigenvalue;
                mode.shape = normalized(self.of_coordinates(&vector, eigenvalue));
                vectors[found.count] = vector;
                found.count += 1;
            }
        }
        Ok(found)
    }

    /// Returns a null vector of the matrix at an eigenvalue, orthogonal to the known null vectors if there is one.
    fn amplitudes(
        &self,
        eigenvalue: C,
        known: impl Iterator<Item = SVector<C, N>> + Clone,
    ) -> SVector<C, N> {
        let matrix = self.quadratic(eigenvalue);
        let alone = null_vector(&matrix, core::iter::empty());
        if known.clone().next().is_none() {
            return alone;
        }
        let other = null_vector(&matrix, known);
        let least = self.backward_error(eigenvalue, &alone);
        if self.backward_error(eigenvalue, &other) <= ROOM * least.max(negligible::<f64>()) {
            other
        } else {
            alone
        }
    }

    /// Returns whether there are amplitudes that no force opposes, up to rounding errors. In this case 0 is an
    /// eigenvalue, which is found as about ±√ε if it is double.
    fn has_rigid_motion(&self) -> bool {
        let zero = C::new(0.0, 0.0);
        let still = null_vector(&self.quadratic(zero), core::iter::empty());
        let epsilon = S::machine_epsilon().max(f64::EPSILON);
        #[allow(clippy::cast_precision_loss)] // A number of coordinates.
        let room = 4.0 * N as f64;
        self.backward_error(zero, &still) <= room * epsilon
    }

    /// Returns the largest residual of the product with a vector over all rows, each relative to the sizes of its
    /// terms: F. Tisseur, *Backward error and condition of polynomial eigenvalue problems*, Linear Algebra Appl.
    /// **309** (2000) 339–361, by rows.
    fn backward_error(&self, eigenvalue: C, vector: &SVector<C, N>) -> f64 {
        let most = vector.iter().fold(0.0, |most, x| modulus(*x).max(most));
        let left = self.quadratic(eigenvalue) * vector;
        let size = modulus(eigenvalue);
        let errors = (0..N).map(|i| {
            let terms = (0..N).map(|j| self.terms(i, j, size));
            let scale = most * terms.sum::<f64>();
            if scale > 0.0 {
                modulus(left[i]) / scale
            } else {
                0.0
            }
        });
        errors.fold(0.0, f64::max)
    }

    /// Returns the sum of the magnitudes of the terms in an entry of the quadratic matrix at an eigenvalue of this size.
    pub(super) fn terms(&self, i: usize, j: usize, size: f64) -> f64 {
        let [c0, c1, c2] = self.coefficients(i, j).map(f64::abs);
        c0 + size * (c1 + size * c2)
    }

    /// Returns the matrix λ² − λ ∂q̈/∂q̇ − ∂q̈/∂q of the oscillating coordinates. Where only a velocity remains, the
    /// column is taken from λ − ∂q̈/∂q̇; eliminated coordinates have 1 on the diagonal.
    pub(super) fn quadratic(&self, eigenvalue: C) -> SMatrix<C, N, N> {
        SMatrix::from_fn(|i, j| {
            let [c0, c1, c2] = self.coefficients(i, j);
            (eigenvalue * c2 + c1) * eigenvalue + c0
        })
    }

    /// Returns an entry of [`quadratic`](Self::quadratic): its coefficients of 1, λ and λ².
    pub(super) fn coefficients(&self, i: usize, j: usize) -> [f64; 3] {
        let unit = if i == j { 1.0 } else { 0.0 };
        let by_velocity = -self.velocity[(i, j)].largest();
        match (self.parts[i], self.parts[j]) {
            (Part::Eliminated, _) | (_, Part::Eliminated) => [unit, 0.0, 0.0],
            (_, Part::Moving) => [by_velocity, unit, 0.0],
            (_, Part::Oscillating) => [-self.position[(i, j)].largest(), by_velocity, unit],
        }
    }

    /// Returns the amplitudes of all coordinates, given the amplitudes of the oscillating coordinates and of the
    /// remaining velocities.
    fn of_coordinates(&self, vector: &SVector<C, N>, eigenvalue: C) -> SVector<C, N> {
        let [by_position, by_velocity] = &self.eliminated;
        let oscillates = |i: usize| self.parts[i] == Part::Oscillating;
        let drifts = modulus(eigenvalue) <= 0.0;
        SVector::from_fn(|i, _| {
            if oscillates(i) {
                return vector[i];
            }
            if drifts {
                return C::new(0.0, 0.0);
            }
            // Sums the contributions of all velocities to an eliminated velocity. A remaining velocity is its own
            // amplitude; the velocity of an oscillating coordinate is λ times its amplitude.
            let sum = (0..N).fold(C::new(0.0, 0.0), |sum, j| {
                let velocity = if oscillates(j) {
                    eigenvalue * vector[j]
                } else {
                    vector[j]
                };
                let [of_position, of_velocity] =
                    [by_position, by_velocity].map(|matrix| matrix[(i, j)].largest());
                sum + vector[j] * of_position + velocity * of_velocity
            });
            sum / eigenvalue
        })
    }
}

/// Returns a multiple of the shape whose largest component is 1; of components that are equal up to rounding, the
/// first.
fn normalized<const N: usize>(shape: SVector<C, N>) -> SVector<C, N> {
    let most = shape.iter().fold(0.0, |most, x| modulus(*x).max(most));
    let near = most * (1.0 - negligible::<f64>());
    match shape.iter().find(|x| modulus(**x) >= near) {
        Some(component) if most > 0.0 => {
            let component = *component;
            shape.map(|x| x / component)
        }
        _ => shape,
    }
}
