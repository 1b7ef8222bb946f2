//! Tests of the whole macro: from the tokens of a declaration to those that are emitted.

mod arms;
mod c_sources;
mod derived;
mod editor;
mod families;
mod golden;
mod huge_powers;
mod lowered_once;
mod half_typed;
mod linkages;
mod mixed_derivatives;
mod operations;
mod pages;
mod pair_sums;
mod prepared;
mod printed;
mod robustness;
mod roots;
mod scalars;
mod scopes;
mod steep;
mod table;
mod timing;
mod validation;
mod velocities;
mod single_quotients;
