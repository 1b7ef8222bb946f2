//! The syntax of declarations: what they consist of, and how they are parsed.

pub(crate) mod body_quantity;
pub(crate) mod body_type;
pub(crate) mod clauses;
pub(crate) mod coordinate;
pub(crate) mod declaration;
pub(crate) mod external_function;
pub(crate) mod field;
pub(crate) mod field_type;
mod grammar;
pub(crate) mod label;
pub(crate) mod named;
pub(crate) mod names;
mod other_clauses;
pub(crate) mod other_notation;
pub(crate) mod parameter_list;
pub(crate) mod placed_body;
pub(crate) mod root;
pub(crate) mod routhian;
pub(crate) mod scalar;
pub(crate) mod shape;
pub(crate) mod size;
