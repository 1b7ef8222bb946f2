//! The functions that the programs call, in C: those of the runtime that C has not, line for line.

use super::body::mentions;

/// A part of the library, by a name that tells whether it is needed.
struct Part {
    name: &'static str,
    text: &'static str,
}

macro_rules! parts {
    ($($name:literal in $file:literal)*) => {
        [$(Part { name: concat!("$_", $name), text: include_str!(concat!("library/", $file, ".c")) }),*]
    };
}

/// Each behind those that it calls.
const PARTS: [Part; 13] = parts! {
    "mul_add" in "mul_add"
    "sin_cos" in "sine_cosine"
    "sin" in "sin"
    "cos" in "cos"
    "signum" in "signum"
    "common_scale" in "common_scale"
    "sech" in "sech"
    "logistic" in "logistic"
    "softplus" in "softplus"
    "log_cosh" in "log_cosh"
    "elimination" in "elimination"
    "factors" in "factorization"
    "factors" in "saddle_point"
};

/// The parts that functions call, directly or not.
pub(super) fn library(functions: &str, is_constrained: bool) -> String {
    let mut text = String::new();
    for part in PARTS.iter().rev() {
        let is_of_others = match part.name {
            "$_factors" => part.text.contains("saddle point") != is_constrained,
            _ => false,
        };
        if !is_of_others && (mentions(functions, part.name) || mentions(&text, part.name)) {
            text = format!("{}\n{text}", part.text);
        }
    }
    text
}
