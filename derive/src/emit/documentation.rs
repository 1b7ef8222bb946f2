//! The documentation of the emitted impl: the equations as they were derived, and the operation counts.

use std::collections::BTreeSet;
use std::fmt::Write as _;

use lagrangian_symbolic::{Energies, Expression, Letters, Names, OperationCount};

use super::emitter::Emitter;
use super::events::names;
use crate::limits::LONGEST_FORMULA;
use crate::lower::Lowered;
use crate::lower::quantities::Component;
use crate::syntax::names::unraw;

/// The documentation of the model's impl: coordinates, energies, mass matrix, equations of motion.
pub(crate) fn of(emitter: &Emitter<'_>, equations: &str) -> String {
    let mut text = String::from(
        "# The equations of motion\n\nM q̈ = f, by d/dt (∂L/∂q̇) − ∂L/∂q = Q (4.6), with\n\n```text\n",
    );
    text.push_str(equations);
    text.push_str("```\n\n# Operations\n\n");
    text.push_str(
        "| method | + − | × | ÷ | √ | sin, cos | others |\n|---|---|---|---|---|---|---|\n",
    );
    for (name, method) in emitter.methods.counted() {
        let OperationCount {
            additions,
            multiplications,
            divisions,
            square_roots,
            sines_and_cosines,
            functions,
        } = method.count;
        // Writing to a `String` does not fail.
        let _ = writeln!(
            text,
            "| `{name}` | {additions} | {multiplications} | {divisions} | {square_roots} | \
             {sines_and_cosines} | {functions} |"
        );
    }
    text
}

/// Definitions, energies, momenta, M, Q, f and the functions of events as text, one formula a line.
pub(crate) fn equations(emitter: &Emitter<'_>) -> String {
    let mut page = Page::new(emitter);
    page.coordinates();
    page.definitions();
    page.energies();
    page.momenta();
    page.mass_matrix();
    page.forces();
    page.events();
    page.text
}

/// Formulas under names, one below the other.
struct Page<'a> {
    emitter: &'a Emitter<'a>,
    letters: Letters,
    coordinates: Vec<String>,
    text: String,
}

impl<'a> Page<'a> {
    fn new(emitter: &'a Emitter<'a>) -> Self {
        let Lowered {
            scope, quantities, ..
        } = emitter.lowered;
        let all = |components: &[Component]| -> Vec<String> {
            let labels = components.iter().map(|component| &component.label);
            labels.map(ToString::to_string).collect()
        };
        let coordinates = quantities.coordinates.iter();
        let definitions = scope.definitions(&emitter.model.graph);
        let names = Names {
            coordinates: coordinates.map(ToString::to_string).collect(),
            parameters: all(&quantities.parameters),
            inputs: all(&quantities.inputs),
            definitions: definitions
                .map(|(label, expression)| (expression, label.to_string()))
                .collect(),
        };
        let letters = Letters::new(&names);
        let coordinates = emitter.model.coordinate_symbols();
        Self {
            emitter,
            coordinates: coordinates
                .into_iter()
                .map(|symbol| letters.print_symbol(symbol))
                .collect(),
            letters,
            text: String::new(),
        }
    }

    fn line(&mut self, name: &str, expression: Expression) {
        let graph = &self.emitter.model.graph;
        let formula = graph
            .display_in(expression, &self.letters)
            .limit(LONGEST_FORMULA);
        // Writing to a `String` does not fail.
        let _ = writeln!(self.text, "{name} = {formula}");
    }

    fn coordinates(&mut self) {
        let _ = writeln!(self.text, "q = ({})", self.coordinates.join(", "));
    }

    fn definitions(&mut self) {
        let scope = &self.emitter.lowered.scope;
        let mut seen = BTreeSet::new();
        for definition in &self.emitter.declaration.clauses.definitions {
            let name = unraw(&definition.name);
            let components = scope.defined(&name);
            if !seen.insert(name) {
                continue;
            }
            for (_, expression) in components {
                if let Some(name) = self.letters.print_definition(expression) {
                    self.line(&name, expression);
                }
            }
        }
    }

    fn energies(&mut self) {
        match self.emitter.model.energies {
            Energies::Natural { kinetic, potential } => {
                self.line("T", kinetic);
                self.line("V", potential);
            }
            Energies::General(lagrangian) => self.line("L", lagrangian),
        }
    }

    fn momenta(&mut self) {
        let momenta = self.emitter.equations.momenta.clone();
        for (i, momentum) in momenta.into_iter().enumerate() {
            let name = format!("p[{}]", self.coordinates[i]);
            self.line(&name, momentum);
        }
    }

    fn mass_matrix(&mut self) {
        let mass = self.emitter.equations.mass.clone();
        for (i, row) in mass.iter().enumerate() {
            for (j, entry) in row.iter().enumerate().take(i + 1) {
                if !self.emitter.model.graph.is_zero(*entry) {
                    let name = format!("M[{}, {}]", self.coordinates[i], self.coordinates[j]);
                    self.line(&name, *entry);
                }
            }
        }
    }

    fn events(&mut self) {
        let lowered = self.emitter.lowered;
        let before = lowered.outputs.iter().map(|shape| shape.count()).sum();
        let functions = self.emitter.model.outputs.iter().skip(before);
        let names = names(self.emitter.declaration, &lowered.events);
        for (name, function) in names.zip(functions) {
            self.line(&format!("g[{name}]"), *function);
        }
    }

    fn forces(&mut self) {
        let equations = self.emitter.equations;
        let forces = [
            ("Q", equations.generalized_forces.clone()),
            ("f", equations.forcing.clone()),
        ];
        for (letter, forces) in forces {
            for (i, force) in forces.into_iter().enumerate() {
                let zero = self.emitter.model.graph.is_zero(force);
                if letter == "f" || !zero {
                    let name = format!("{letter}[{}]", self.coordinates[i]);
                    self.line(&name, force);
                }
            }
        }
    }
}
