//! The header: what the numbers mean, the structs and the prototypes.

use std::fmt::Write as _;

use lagrangian_symbolic::Symbol;

use super::structs::Field;
use super::{Export, WIDTH};
use crate::emit::events::names;
use crate::syntax::label::Label;
use crate::syntax::names::unraw;

impl Export<'_> {
    pub(super) fn header(&self) -> String {
        let guard = self.prefix.to_uppercase() + "_H";
        let mut text = self.about();
        let cpp = "#ifdef __cplusplus\n";
        let _ = write!(
            text,
            "#ifndef {guard}\n#define {guard}\n\n{cpp}extern \"C\" {{\n#endif\n\n"
        );
        text.push_str(&self.numbers());
        if self.parameters.have_bodies() {
            text.push_str(
                &self.filled(
                    "/* A body: its mass, its centre of gravity, and the upper triangle of its inertia tensor about that. */\n\
                     typedef struct {\n    double mass;\n    double center[3];\n    double inertia[3][3];\n} $_body;\n\n",
                ),
            );
        }
        let structs = [
            ("The parameters.", "parameters", &self.parameters.fields),
            ("The outputs.", "outputs", &self.outputs),
        ];
        for (about, name, fields) in structs {
            if !fields.is_empty() {
                text.push_str(&self.structure(about, name, fields));
            }
        }
        for function in self.functions() {
            text.push_str(&comment(&self.filled(&function.documentation)));
            text.push_str(&self.filled(&self.prototype(&function)));
            text.push_str(";\n\n");
        }
        let _ = write!(text, "{cpp}}}\n#endif\n\n#endif\n");
        text
    }

    /// The comment at the beginning.
    fn about(&self) -> String {
        let quantities = &self.emitter.lowered.quantities;
        let mut about = format!(
            "The model {} in C99, generated from a declaration of the Rust crate `lagrangian`.\n\n",
            unraw(&self.emitter.declaration.name)
        );
        about.push_str(
            "The functions do what the methods of the model in Rust do, by the same operations in the same order. Where only sums, \
             products, quotients, square roots, sines and cosines occur, results are the same to the bit if no compiler fuses \
             products with sums: with -ffp-contract=off, and for the same instructions of fused multiply-add or without any. They \
             allocate nothing and keep nothing between calls.\n\n",
        );
        let constraints = &self.emitter.lowered.constraints;
        let events = &self.emitter.lowered.events;
        let lists: [(&str, Vec<String>); 5] = [
            (
                "q[i], coordinates, and v[i], their velocities",
                printed(&quantities.coordinates),
            ),
            ("u[i], inputs", self.inputs()),
            (
                "multipliers[i], of the constraints",
                printed(&constraints.labels()),
            ),
            (
                "sensitivities[j], of a coordinate, by parameters",
                self.names_of_sensitive_parameters(),
            ),
            (
                "values[i], event functions",
                names(self.emitter.declaration, events).collect(),
            ),
        ];
        for (title, list) in lists {
            if !list.is_empty() {
                let _ = writeln!(about, "{title}:");
                for (i, name) in list.iter().enumerate() {
                    let _ = writeln!(about, "    {i}: {name}");
                }
                about.push('\n');
            }
        }
        about.push_str("Equations of motion:\n\n");
        about.push_str(&self.emitter.listing.unicode);
        comment(&about)
    }

    /// The names of the inputs, with what the declaration says of them.
    fn inputs(&self) -> Vec<String> {
        let declaration = self.emitter.declaration;
        let inputs = self.emitter.lowered.quantities.inputs.iter();
        let inputs = inputs.map(|input| {
            let mut fields = declaration.fields.iter();
            let field = fields.find(|field| unraw(&field.name) == unraw(&input.field));
            let documentation = field.map(|field| in_a_line(&field.documentation));
            match documentation.filter(|text| !text.is_empty()) {
                Some(text) => format!("{}: {text}", input.label),
                None => input.label.to_string(),
            }
        });
        inputs.collect()
    }

    fn names_of_sensitive_parameters(&self) -> Vec<String> {
        let components = &self.emitter.lowered.quantities.parameters;
        let parameters = self.sensitive_parameters().iter();
        let parameters = parameters.filter_map(|symbol| match symbol {
            Symbol::Parameter(i) => components.get(*i as usize),
            _ => None,
        });
        parameters
            .map(|component| component.label.to_string())
            .collect()
    }

    /// The numbers of coordinates, inputs and constraints.
    fn numbers(&self) -> String {
        let prefix = self.prefix.to_uppercase();
        let mut text = String::new();
        let numbers = [
            ("COORDINATES", self.emitter.coordinates()),
            ("INPUTS", self.emitter.model.inputs as usize),
            ("CONSTRAINTS", self.emitter.constraint_count()),
        ];
        for (name, number) in numbers {
            let _ = writeln!(text, "#define {prefix}_{name} {number}");
        }
        text.push('\n');
        text
    }

    fn structure(&self, about: &str, name: &str, fields: &[Field]) -> String {
        let mut text = format!("/* {about} */\ntypedef struct {{\n");
        for field in fields {
            let mut about = in_a_line(&field.documentation);
            if field.name != field.declared {
                let _ = write!(about, " `{}` in the declaration.", field.declared);
            }
            if !about.is_empty() {
                let _ = writeln!(text, "    /* {} */", inner(about.trim()));
            }
            let _ = writeln!(text, "    {}", self.filled(&field.declaration()));
        }
        let _ = write!(text, "}} {}_{name};\n\n", self.prefix);
        text
    }
}

fn printed(labels: &[Label]) -> Vec<String> {
    labels.iter().map(ToString::to_string).collect()
}

/// A text in one line.
fn in_a_line(text: &str) -> String {
    let words: Vec<&str> = text.split_whitespace().collect();
    words.join(" ")
}

/// What may stand in a comment.
fn inner(text: &str) -> String {
    text.replace("*/", "* /").replace("/*", "/ *")
}

/// A comment whose paragraphs are broken into lines; indented lines stay as they are.
fn comment(text: &str) -> String {
    let text = inner(text.trim_end());
    let mut lines: Vec<String> = Vec::new();
    for paragraph in text.lines() {
        let indent: String = paragraph.chars().take_while(|c| *c == ' ').collect();
        let mut line = indent.clone();
        if paragraph.chars().count() <= WIDTH || !indent.is_empty() {
            lines.push(paragraph.to_owned());
            continue;
        }
        for word in paragraph.split_whitespace() {
            let is_begun = line.len() > indent.len();
            if is_begun && line.chars().count() + 1 + word.chars().count() > WIDTH {
                lines.push(core::mem::replace(&mut line, indent.clone()));
            } else if is_begun {
                line.push(' ');
            }
            line.push_str(word);
        }
        lines.push(line);
    }
    match lines.as_slice() {
        [line] => format!("/* {line} */\n"),
        lines => {
            let mut text = String::from("/*\n");
            for line in lines {
                let _ = writeln!(text, "{}", format!(" * {line}").trim_end());
            }
            text + " */\n"
        }
    }
}
