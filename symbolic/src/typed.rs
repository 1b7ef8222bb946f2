//! The typed graph of a declaration: scalars, vectors and matrices as operations, above the expressions of their components.
//!
//! A declaration is translated into one typed graph, in which each value knows the operation by which it was declared. The
//! components of all values are computed as they are declared; what else is asked of a declaration is the same
//! graph, evaluated by other rules: its energies with vectors that are resolved last, its positions at rest, and its
//! constraints where something is displaced.

pub(crate) mod components;
pub(crate) mod operation;
pub(crate) mod array_function;
pub(crate) mod graph;
pub(crate) mod evaluation;
pub(crate) mod declared_system;
pub(crate) mod at_rest;
pub(crate) mod rest;
pub(crate) mod virtual_work;
