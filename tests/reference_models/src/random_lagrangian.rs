//! The models of the random Lagrangians.

use std::fmt::Write as _;

use serde_json::Value;

use crate::{declaration::Declaration, expression::Spelling};

/// A struct for every case of which the position is a multiple of `stride`, and the macro `public_cases!` that lists them.
///
/// # Panics
///
/// If the document is of another form.
#[must_use]
pub fn source(document: &Value, stride: usize) -> String {
    let cases = document["cases"].as_array().expect("a list of cases");
    let mut structs = String::new();
    let mut rows = String::new();
    for (index, case) in cases.iter().enumerate().step_by(stride) {
        let id = case["id"].as_str().expect("a case has an id");
        // Both spellings of functions are covered: one by the even cases, one by the odd.
        let spelling = if index % 2 == 0 {
            Spelling::Methods
        } else {
            Spelling::Functions
        };
        let kind = case["kind"].as_str().expect("a case has a kind");
        let title = format!("Random Lagrangian `{id}` (`{kind}`)");
        let declaration = Declaration::new(type_name(id), title, case, spelling);
        let check = if declaration.inputs.is_empty() {
            "free"
        } else {
            "driven"
        };
        let (name, sizes) = (&declaration.name, declaration.sizes());
        let path = format!("$crate::public_case::{name}");
        write!(structs, "{declaration}").expect("strings accept everything");
        writeln!(rows, "        ({id:?}, ${check}::<{path}, {sizes}>),")
            .expect("strings accept everything");
    }
    format!(
        "{structs}
/// Of so many cases one is here.
pub const STRIDE: usize = {stride};

/// The cases in order: the identifier, and the function `free::<Model, N>` or, of a model with
/// inputs, `driven::<Model, N, U>`.
#[macro_export]
macro_rules! public_cases {{
    ($free:ident, $driven:ident) => {{[
{rows}    ]}};
}}
"
    )
}

/// `public-A-007` as `PublicA007`.
fn type_name(id: &str) -> String {
    id.replace("public-", "Public").replace('-', "")
}
