//! What the derive says of declarations that have an error: each file of `ui/` is compiled, and what
//! the compiler prints is compared with the file beside it.
//!
//! The texts are those of the toolchain in use when they were written, Rust 1.95. After a change of
//! message, or of the toolchain, write them anew with `TRYBUILD=overwrite cargo test -p
//! lagrangian-compile-errors`, and read the difference.

#[test]
fn each_error_stands_at_its_token_and_says_what_to_write() {
    trybuild::TestCases::new().compile_fail("ui/*.rs");
}
