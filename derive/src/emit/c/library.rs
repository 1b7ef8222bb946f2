//! The functions of the runtime that C has not, in C, line for line.

use super::body::mentions;

/// A part of the library.
struct Part {
    /// What is mentioned where the part is needed.
    name: &'static str,
    text: &'static str,
}

macro_rules! part {
    ($name:literal, $file:literal) => {
        Part {
            name: concat!("$_", $name),
            text: include_str!(concat!("library/", $file, ".c")),
        }
    };
}

/// What methods call, each behind those that it calls.
const PARTS: [Part; 11] = [
    part!("mul_add", "mul_add"),
    part!("sin_cos", "sine_cosine"),
    part!("sin", "sin"),
    part!("cos", "cos"),
    part!("signum", "signum"),
    part!("common_scale", "common_scale"),
    part!("sech", "sech"),
    part!("logistic", "logistic"),
    part!("softplus", "softplus"),
    part!("log_cosh", "log_cosh"),
    part!("elimination", "elimination"),
];

/// The factors of a free model, and of one with constraints.
const FACTORS: [Part; 2] = [
    part!("factors", "factorization"),
    part!("factors", "saddle_point"),
];

/// What calls the functions of methods, each behind those that call it.
const AROUND_METHODS: [Part; 5] = [
    part!("state_matrix_at", "state_matrix"),
    part!("input_matrix_at", "input_matrix"),
    part!("end_step", "end_of_step"),
    part!("project_at", "projection"),
    part!("increments", "step"),
];

/// The parts that functions call, directly or not.
pub(super) fn library(functions: &str, is_constrained: bool) -> String {
    let mut text = String::new();
    let factors = &FACTORS[usize::from(is_constrained)];
    for part in [factors].into_iter().chain(PARTS.iter().rev()) {
        if mentions(functions, part.name) || mentions(&text, part.name) {
            text = format!("{}\n{text}", part.text);
        }
    }
    text
}

/// The names and texts of what calls the functions of methods.
pub(super) fn around_methods() -> impl Iterator<Item = (String, String)> {
    let parts = AROUND_METHODS.iter();
    parts.map(|part| (part.name.to_owned(), part.text.to_owned()))
}
