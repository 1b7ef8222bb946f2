//! The build script's rewriting of expressions.

#[path = "../build/expression.rs"]
#[allow(dead_code, unreachable_pub)]
mod expression;

use expression::{Spelling, renamed};
use serde_json::json;

#[test]
fn powers_become_methods_and_functions_stay() {
    let spellings = json!({ "rust_fn": "-powi(sin(x + powf(a, 0.5)), 2)*powi(y, 3) + 1.0" });
    let written = Spelling::Functions.of(&spellings);
    assert_eq!(
        written,
        "-(sin(x + (a).powf(0.5))).powi(2)*(y).powi(3) + 1.0"
    );
}

#[test]
fn names_are_replaced_and_nothing_else_is() {
    let written = renamed("0.5*t.sin() + sin(t)*tt - t1*t", |name| format!("<{name}>"));
    assert_eq!(written, "0.5*<t>.sin() + sin(<t>)*<tt> - <t1>*<t>");
}
