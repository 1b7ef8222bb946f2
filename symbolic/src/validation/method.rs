//! The methods that are validated.

/// A validated method: one or more programs that are accepted or rejected together.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Debug)]
pub enum Method {
    /// L.
    Lagrangian,
    /// T and V.
    Energies,
    /// The energy function.
    Energy,
    /// p.
    Momenta,
    /// M.
    MassMatrix,
    /// f.
    Forcing,
    /// Q.
    GeneralizedForces,
    /// M q̈ − f.
    InverseDynamics,
    /// q̈, and its derivatives.
    Accelerations,
    /// The derivatives of q̈ alone.
    Linearization,
    /// Quantities for observers.
    Outputs,
    /// ∂L/∂q + Q.
    MomentumRates,
    /// q̇ from p.
    Velocities,
    /// Q·q̇ − ∂L/∂t.
    EnergyRate,
    /// g, w, G and γ of the constraints.
    Constraints,
    /// The derivatives of q̈ by parameters.
    Sensitivities,
    /// Y, r and π in M q̈ − f = Y π + r.
    Regressor,
}

impl Method {
    /// Whether the method takes no higher derivatives of the energies than the first.
    pub(crate) const fn takes_first_derivatives(self) -> bool {
        match self {
            Self::Lagrangian
            | Self::Energies
            | Self::Energy
            | Self::Momenta
            | Self::GeneralizedForces
            | Self::Outputs
            | Self::MomentumRates
            | Self::Constraints
            | Self::EnergyRate => true,
            Self::MassMatrix
            | Self::Forcing
            | Self::InverseDynamics
            | Self::Accelerations
            | Self::Linearization
            | Self::Velocities
            | Self::Sensitivities
            | Self::Regressor => false,
        }
    }
}
