//! Rigid bodies: masses and inertias, rotations, Euler's equations.

#[path = "../common/mod.rs"]
mod common;

mod bodies;
mod euler_equations;
mod free_rotation;
mod gyrodynamics;
mod mesh_files;
mod mesh_parts;
mod meshes;
mod momentum;
mod nutation;
mod principal_axes;
mod rotations;
mod slow_polhodes;
mod solids;
mod steady_rotations;
