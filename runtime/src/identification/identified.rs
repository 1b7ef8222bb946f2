//! Identified parameters.

use nalgebra::{SMatrix, SVector};

use crate::scalar::Scalar;

/// Base parameters that were identified from measurements, with their accuracy.
#[derive(Clone, Copy, PartialEq, Debug)]
pub struct Identified<const B: usize> {
    /// The estimate of the base parameters π.
    pub parameters: SVector<f64, B>,
    /// The estimate of its covariance, σ² (YᵀY)⁻¹.
    pub covariance: SMatrix<f64, B, B>,
    /// The estimate of the variance σ² of the equations: the sum of the squares of their residuals, divided by the
    /// number of equations minus the number of parameters. If the equations were divided by the standard deviations of
    /// their forces, it is near 1 provided that the standard deviations and the model are right.
    pub variance: f64,
    /// The condition number of the regressor with columns normalized to length 1: the factor by which relative errors
    /// of the measurements may be amplified. Values below 100 are good (Gautier and Khalil, Exciting trajectories for
    /// the identification of base inertial parameters of robots, 1992).
    pub condition_number: f64,
    /// The number of equations.
    pub equations: usize,
}

impl<const B: usize> Identified<B> {
    /// Returns the standard deviations of the parameters.
    #[must_use]
    pub fn standard_deviations(&self) -> SVector<f64, B> {
        self.covariance.diagonal().map(Scalar::sqrt)
    }
}
