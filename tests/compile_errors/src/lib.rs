//! Declarations that have an error, in `ui/`, and what the compiler says of each; see
//! `tests/compile_errors.rs`. They are a package of their own so that no model is compiled for them.
