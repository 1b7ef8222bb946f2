//! The solvers for q̈, except the symbolic factorization (`matrix/ldlt.rs`). [Kinetics](crate::Kinetics) chooses among them.

pub(crate) mod pivots;
pub(crate) mod implicit_equations;
pub(crate) mod kinematic_tree;
pub(crate) mod articulated_bodies;
pub(crate) mod newton_euler;
pub(crate) mod composite_links;
pub(crate) mod link_equations;
pub(crate) mod link_momenta;
pub(crate) mod coriolis_matrix;
pub(crate) mod joint_perturbations;
pub(crate) mod link_derivatives;
pub(crate) mod twist_elimination;
pub(crate) mod link_vectors;
pub(crate) mod articulated_links;
pub(crate) mod articulated_coriolis;
pub(crate) mod perturbation_forces;
pub(crate) mod link_responses;
pub(crate) mod articulated_derivatives;
pub(crate) mod structure_constants;
pub(crate) mod quasi_velocity_equations;
pub(crate) mod first_order_equations;
pub(crate) mod motion_of_cosine;
pub(crate) mod boltzmann_hamel;
pub(crate) mod solution;
pub(crate) mod form;
