//! What a class is made of: the names of a model, and how its objects are created.

use lagrangian::quantities::{FieldDescription, FieldElement, InvalidNumbers};

use crate::arrays::shape;
use crate::evaluator::Evaluator;

/// A model as a class.
#[derive(Clone, Copy, Debug)]
pub struct Description {
    /// The name of the class.
    pub name: &'static str,
    /// The documentation of the struct.
    pub documentation: &'static str,
    /// The fields.
    pub fields: &'static [FieldDescription],
    /// The outputs.
    pub outputs: &'static [FieldDescription],
    /// The coordinates.
    pub coordinates: &'static [&'static str],
    /// The inputs, component by component.
    pub inputs: &'static [&'static str],
    /// The events.
    pub events: &'static [&'static str],
    /// The constraints, component by component.
    pub constraints: &'static [&'static str],
    /// The equations in Unicode.
    pub equations: &'static str,
    /// The equations in LaTeX.
    pub latex: &'static str,
    /// Whether there are Taylor series.
    pub has_taylor: bool,
    /// Creates a model from the numbers of its fields.
    pub build: Build,
}

/// Creates a model from the numbers of its fields.
pub(crate) type Build = fn(&[f64]) -> Result<Box<dyn Evaluator>, InvalidNumbers>;

impl Description {
    /// The text that `help` shows, in the sections of numpy's docstrings.
    pub(crate) fn docstring(&self) -> String {
        let mut text = self.documentation.trim().to_owned();
        let mut section = |title: &str, lines: &[String]| {
            if !lines.is_empty() {
                let line = "-".repeat(title.len());
                text += &["\n\n", title, "\n", &line, "\n", &lines.join("\n")].concat();
            }
        };
        let fields: Vec<_> = self.fields.iter().map(described).collect();
        section("Parameters", &fields);
        section("Coordinates", &[self.coordinates.join(", ")]);
        let outputs: Vec<_> = self.outputs.iter().map(described).collect();
        section("Outputs", &outputs);
        let listed = |names: &[&str]| {
            if names.is_empty() {
                vec![]
            } else {
                vec![names.join(", ")]
            }
        };
        section("Inputs", &listed(self.inputs));
        section("Events", &listed(self.events));
        section("Constraints", &listed(self.constraints));
        section("Equations", &[self.equations.trim().to_owned()]);
        text
    }

    /// The place of a field and of its first number.
    pub(crate) fn field(&self, name: &str) -> Option<(&'static FieldDescription, usize)> {
        let mut first = 0;
        for field in self.fields {
            if field.name == name {
                return Some((field, first));
            }
            first += field.count();
        }
        None
    }

    /// The names of the fields, as a sentence has them.
    pub(crate) fn parameters(&self) -> String {
        let names: Vec<_> = self.fields.iter().map(|field| field.name).collect();
        Self::listed(&names)
    }

    /// How many numbers all fields consist of.
    pub(crate) fn numbers(&self) -> usize {
        self.fields.iter().map(FieldDescription::count).sum()
    }

    /// The names in a list, as a sentence has them.
    pub(crate) fn listed(names: &[&str]) -> String {
        if names.is_empty() {
            "none".to_owned()
        } else {
            names.join(", ")
        }
    }
}

/// `name : type`, and below it the documentation.
fn described(field: &FieldDescription) -> String {
    let FieldDescription {
        name,
        documentation,
        lengths,
        element,
        ..
    } = field;
    let of_one = match element {
        FieldElement::RigidBody => "(mass, centre of gravity, inertia tensor about it)",
        FieldElement::PrincipalBody => "(mass, principal moments)",
        FieldElement::SymmetricBody => "(mass, height, transverse moment, axial moment)",
        _ => "float",
    };
    let shape = shape(lengths);
    let ty = if lengths.is_empty() {
        of_one.to_owned()
    } else {
        format!("{of_one}, shape {shape}")
    };
    let mut text = format!("{name} : {ty}");
    for line in documentation.trim().lines() {
        text += "\n    ";
        text += line;
    }
    text
}
