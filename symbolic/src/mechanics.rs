//! From energies to equations of motion, and to the accelerations.

pub(crate) mod model;
pub(crate) mod equations;
pub(crate) mod degrees;
pub(crate) mod multiplied_out;
pub(crate) mod coordinate_properties;
pub(crate) mod ldlt;
pub(crate) mod quasi_velocities;
pub(crate) mod squares;
pub(crate) mod combined_forms;
pub(crate) mod inertias;
pub(crate) mod block_triangular;
pub(crate) mod structure_constants;
pub(crate) mod boltzmann_hamel;
pub(crate) mod kinematic_tree;
pub(crate) mod articulated_bodies;
pub(crate) mod solution;
pub(crate) mod kinetics;
