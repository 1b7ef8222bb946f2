//! Derivatives of the accelerations.

use nalgebra::{SMatrix, SVector};

use crate::Scalar;

/// The derivatives of the accelerations q̈(q, q̇, t) of a system with `N` degrees of freedom.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Linearization<S: Scalar, const N: usize> {
    /// ∂q̈ᵢ/∂qⱼ in row i, column j.
    pub position: SMatrix<S, N, N>,
    /// ∂q̈ᵢ/∂q̇ⱼ in row i, column j.
    pub velocity: SMatrix<S, N, N>,
    /// ∂q̈ᵢ/∂t.
    pub time: SVector<S, N>,
}
