//! The models whose trajectories are listed, where the declaration language can express them.

use std::fmt::Write as _;

use serde_json::{Map, Value};

use crate::{
    declaration::Declaration,
    expression::{Spelling, renamed},
};

/// A struct for every system without constraints, and the macro `trajectories!` that lists them.
///
/// A system whose inputs are functions of time is declared twice: with inputs that a law sets, and
/// with the law written into its forces.
///
/// # Panics
///
/// If the document is of another form.
#[must_use]
pub fn source(document: &Value) -> String {
    let references = document["references"]
        .as_array()
        .expect("a list of references");
    let mut structs = String::new();
    let mut rows = String::new();
    for system in references
        .iter()
        .filter(|system| system["scenario"] == 0 && is_unconstrained(system))
    {
        let id = system["id"].as_str().expect("a system has an id");
        let title = format!("The system `{id}`");
        let mut declaration = Declaration::new(type_name(id), title, system, Spelling::Methods);
        let laws = system["inputs"].as_object().expect("inputs by name");
        let observations = Observations::of(&mut declaration);
        let check = if laws.is_empty() { "free" } else { "driven" };
        let mut list = |check: &str, declaration: &Declaration| {
            let path = format!("$crate::trajectory::{}", declaration.name);
            writeln!(
                rows,
                "        ({id:?}, ${check}::<{path}, {}>),",
                declaration.sizes()
            )
            .expect("strings accept everything");
            write!(structs, "{declaration}{}", observations.source(declaration))
                .expect("strings accept everything");
        };
        list(check, &declaration);
        if !laws.is_empty() {
            list("free", &in_time(&declaration, laws));
            structs += &law_source(&declaration, laws);
        }
    }
    format!(
        "{structs}
/// The systems: the identifier, and the function `free::<Model, N>` or, of a model whose inputs
/// follow a law, `driven::<Model, N, U>`.
#[macro_export]
macro_rules! trajectories {{
    ($free:ident, $driven:ident) => {{[
{rows}    ]}};
}}
"
    )
}

fn is_unconstrained(system: &Value) -> bool {
    ["holonomic", "nonholonomic"]
        .iter()
        .all(|kind| system[kind].as_array().is_none_or(Vec::is_empty))
}

/// `kepler_polar` as `KeplerPolar`.
fn type_name(id: &str) -> String {
    let capitalized = |word: &str| word[..1].to_uppercase() + &word[1..];
    id.split('_').map(capitalized).collect()
}

/// The same model with the laws of its inputs written into its forces.
fn in_time(declaration: &Declaration, laws: &Map<String, Value>) -> Declaration {
    let substituted = |force: &str| {
        renamed(force, |name| match laws.get(name) {
            Some(law) => format!("({})", Spelling::Methods.of(law)),
            None => name.to_owned(),
        })
    };
    let forces = declaration
        .forces
        .iter()
        .map(|(name, force)| (name.clone(), substituted(force)));
    Declaration {
        title: format!("{}; the inputs are functions of time", declaration.title),
        name: format!("{}InTime", declaration.name),
        inputs: Vec::new(),
        forces: forces.collect(),
        ..declaration.clone()
    }
}

/// The impl that evaluates the laws of a model's inputs.
fn law_source(declaration: &Declaration, laws: &Map<String, Value>) -> String {
    let of_self = |name: &str| match name {
        "t" => name.to_owned(),
        parameter => format!("self.{parameter}"),
    };
    let values: Vec<String> = laws
        .values()
        .map(|law| renamed(&Spelling::Methods.of(law), of_self))
        .collect();
    let (model, inputs) = (&declaration.name, laws.len());
    let values = values.join(", ");
    format!(
        "
impl Law<{inputs}> for {model} {{
    fn inputs_at(&self, t: f64) -> [f64; {inputs}] {{
        [{values}]
    }}
}}
"
    )
}

/// The quantities that the data list for a system besides the usual ones.
struct Observations {
    /// The names in the data, and those of the outputs.
    names: Vec<(String, String)>,
}

impl Observations {
    /// Renames a declaration's outputs: `L_X` is no name of a field, and `E` might be a
    /// parameter's.
    fn of(declaration: &mut Declaration) -> Self {
        let mut names = Vec::new();
        for (name, _) in &mut declaration.outputs {
            let output = format!("observed_{}", name.to_lowercase());
            names.push((std::mem::replace(name, output.clone()), output));
        }
        Self { names }
    }

    /// The impl that gives them by the names of the data.
    fn source(&self, declaration: &Declaration) -> String {
        let model = &declaration.name;
        let dimensions = declaration.coordinates.len();
        if self.names.is_empty() {
            return format!("\nimpl Observed<{dimensions}> for {model} {{}}\n");
        }
        let mut pairs = String::new();
        for (name, output) in &self.names {
            write!(pairs, "({name:?}, outputs.{output}), ").expect("strings accept everything");
        }
        format!(
            "
impl Observed<{dimensions}> for {model} {{
    fn observed(&self, state: &State<f64, {dimensions}>) -> Vec<(&'static str, f64)> {{
        let outputs = self.outputs(state);
        vec![{pairs}]
    }}
}}
"
        )
    }
}
