//! Kinetic energies as quadratic forms in quasi-velocities: as declared, combined, or recovered from the mass matrix.

pub(crate) mod quasi_velocities;
pub(crate) mod declared;
pub(crate) mod combined;
pub(crate) mod recovered;
