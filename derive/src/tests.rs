//! Tests of the whole macro: from the tokens of a declaration to those that are emitted.

mod arms;
mod c_sources;
mod derived;
mod editor;
mod families;
mod golden;
mod half_typed;
mod huge_powers;
mod linkages;
mod lowered_once;
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
mod single_quotients;
mod steep;
mod table;
mod timing;
mod validation;
mod velocities;
