//! Expressions: how they are built, simplified, decided, differentiated, and evaluated over the range of numbers.

mod circular;
mod derivatives;
mod determinants;
mod expansion;
mod exponential_towers;
mod functions;
mod identities;
mod matrices;
mod normal_form;
mod powers_at_zero;
mod range;
mod rationals;
mod rotations;
