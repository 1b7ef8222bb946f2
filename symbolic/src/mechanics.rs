//! From energies to equations of motion, and what is known of them before any number is.

pub(crate) mod model;
pub(crate) mod equations;
pub(crate) mod degrees;
pub(crate) mod multiplied_out;
pub(crate) mod structure;
pub(crate) mod elimination;
pub(crate) mod quasi_velocities;
pub(crate) mod squares;
pub(crate) mod combined_forms;
pub(crate) mod inertias;
pub(crate) mod kinematics;
pub(crate) mod structure_constants;
pub(crate) mod boltzmann_hamel;
pub(crate) mod kinematic_tree;
pub(crate) mod articulation;
pub(crate) mod solution;
pub(crate) mod kinetics;
