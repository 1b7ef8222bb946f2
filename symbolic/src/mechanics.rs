//! From energies to equations of motion, and to the accelerations.

pub(crate) mod model;
pub(crate) mod defects;
pub(crate) mod constraint;
pub(crate) mod constraints;
pub(crate) mod dependence;
pub(crate) mod saddle_point;
pub(crate) mod lagrange;
pub(crate) mod coordinate_properties;
pub(crate) mod conservation;
pub(crate) mod ignorability;
pub(crate) mod expanded_energy;
pub(crate) mod equations;
pub(crate) mod energy_forms;
pub(crate) mod mechanism;
pub(crate) mod solvers;
pub(crate) mod energy_functions;
pub(crate) mod linear_system;
pub(crate) mod kinetics;
pub(crate) mod regressor;
pub(crate) mod routhian;
