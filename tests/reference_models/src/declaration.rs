//! A model in the declaration language, and the Rust that declares it.

use std::fmt::{self, Display, Formatter};

use serde_json::Value;

use crate::expression::{Spelling, renamed};

/// What a struct with `#[derive(Lagrangian)]` is written from.
#[derive(Clone)]
pub(crate) struct Declaration {
    pub(crate) title: String,
    pub(crate) name: String,
    pub(crate) coordinates: Vec<String>,
    pub(crate) parameters: Vec<String>,
    pub(crate) inputs: Vec<String>,
    pub(crate) kinetic: String,
    pub(crate) potential: String,
    pub(crate) dissipation: Option<String>,
    pub(crate) forces: Vec<(String, String)>,
    pub(crate) outputs: Vec<(String, String)>,
}

impl Declaration {
    /// The declaration of a system of the data, its functions spelled one way throughout.
    pub(crate) fn new(name: String, title: String, system: &Value, spelling: Spelling) -> Self {
        let coordinates = names(&system["coords"]);
        let language = |spellings: &Value| in_language(&spelling.of(spellings), &coordinates);
        let table = |key: &str| match &system[key] {
            Value::Object(entries) => entries
                .iter()
                .map(|(name, value)| (name.clone(), language(value)))
                .collect(),
            _ => Vec::new(),
        };
        let rayleigh = &system["rayleigh"];
        let declaration = Self {
            title,
            name,
            parameters: names(&system["params"]),
            inputs: names(&system["inputs"]),
            kinetic: language(&system["T"]),
            potential: language(&system["V"]),
            dissipation: (!rayleigh.is_null()).then(|| language(rayleigh)),
            forces: table("Q_declared"),
            outputs: [table("invariants"), table("observables")].concat(),
            coordinates,
        };
        declaration.check_names();
        declaration
    }

    /// The type arguments after the model in `check::<Model, …>`: N, and U where there are inputs.
    pub(crate) fn sizes(&self) -> String {
        match self.inputs.len() {
            0 => self.coordinates.len().to_string(),
            inputs => format!("{}, {inputs}", self.coordinates.len()),
        }
    }

    /// A name that the language reserves would have to be changed before it is written.
    fn check_names(&self) {
        const RESERVED: [&str; 16] = [
            "as", "box", "do", "dot", "fn", "if", "in", "let", "loop", "mod", "move", "mut", "ref",
            "t", "type", "PI",
        ];
        for name in self
            .coordinates
            .iter()
            .chain(&self.parameters)
            .chain(&self.inputs)
        {
            assert!(
                !RESERVED.contains(&name.as_str()),
                "{}: `{name}` is reserved",
                self.name
            );
        }
    }

    fn write_attribute(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "#[lagrangian(")?;
        writeln!(f, "    taylor,")?;
        writeln!(f, "    coordinates({}),", self.coordinates.join(", "))?;
        writeln!(f, "    kinetic = {},", self.kinetic)?;
        // Leaving a vanishing potential out is part of the language.
        if self.potential != "0.0" {
            writeln!(f, "    potential = {},", self.potential)?;
        }
        if let Some(dissipation) = &self.dissipation {
            writeln!(f, "    dissipation = {dissipation},")?;
        }
        write_table(f, "force", &self.forces)?;
        write_table(f, "output", &self.outputs)?;
        writeln!(f, ")]")
    }
}

impl Display for Declaration {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        writeln!(f, "\n/// {}.", self.title)?;
        writeln!(f, "#[derive(Lagrangian, Clone, Debug)]")?;
        self.write_attribute(f)?;
        writeln!(f, "pub struct {} {{", self.name)?;
        for parameter in &self.parameters {
            writeln!(f, "    /// A parameter.\n    pub {parameter}: f64,")?;
        }
        for input in &self.inputs {
            writeln!(
                f,
                "    /// An input.\n    #[lagrangian(input)]\n    pub {input}: f64,"
            )?;
        }
        writeln!(f, "}}\n\nimpl Parametrized for {} {{", self.name)?;
        writeln!(
            f,
            "    fn with(value: &dyn Fn(&str) -> f64) -> Self {{\n        Self {{"
        )?;
        for field in self.parameters.iter().chain(&self.inputs) {
            writeln!(f, "            {field}: value({field:?}),")?;
        }
        writeln!(f, "        }}\n    }}\n}}")
    }
}

fn write_table(f: &mut Formatter<'_>, keyword: &str, entries: &[(String, String)]) -> fmt::Result {
    if entries.is_empty() {
        return Ok(());
    }
    writeln!(f, "    {keyword}(")?;
    for (name, expression) in entries {
        writeln!(f, "        {name} = {expression},")?;
    }
    writeln!(f, "    ),")
}

/// The strings of a list, or the keys of an object.
fn names(value: &Value) -> Vec<String> {
    match value {
        Value::Array(names) => names
            .iter()
            .map(|name| name.as_str().expect("a name").to_owned())
            .collect(),
        Value::Object(entries) => entries.keys().cloned().collect(),
        _ => panic!("expected names, found {value}"),
    }
}

/// The data write velocities `theta_dot`, the language `dot(theta)`.
fn in_language(expression: &str, coordinates: &[String]) -> String {
    renamed(expression, |name| match name.strip_suffix("_dot") {
        Some(coordinate) if coordinates.iter().any(|known| known == coordinate) => {
            format!("dot({coordinate})")
        }
        _ => name.to_owned(),
    })
}
