//! The syntax of declarations: what they consist of, and how they are parsed.

pub(crate) mod size;
pub(crate) mod declaration;
pub(crate) mod clauses;
pub(crate) mod coordinate;
pub(crate) mod named;
pub(crate) mod parameter_list;
pub(crate) mod external_function;
pub(crate) mod routhian;
pub(crate) mod field;
pub(crate) mod body_quantity;
pub(crate) mod label;
pub(crate) mod body_type;
pub(crate) mod placed_body;
pub(crate) mod field_type;
pub(crate) mod scalar;
pub(crate) mod root;
pub(crate) mod shape;
pub(crate) mod names;
pub(crate) mod other_notation;
mod other_clauses;
mod grammar;
