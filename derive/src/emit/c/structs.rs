//! The structs of parameters and of outputs.

use std::fmt::Write as _;

use super::identifiers::Namespace;
use crate::emit::emitter::Emitter;
use crate::lower::quantities::Component;
use crate::syntax::label::{Index, Label};
use crate::syntax::names::unraw;
use crate::syntax::shape::Shape;

/// The mass, the centre of gravity and the inertia tensor.
const NUMBERS_OF_BODY: usize = 13;

/// The struct of parameters, which has a field for each of the model.
pub(super) struct Parameters {
    pub(super) fields: Vec<Field>,
    /// How each number is read.
    pub(super) reads: Vec<String>,
}

/// A field of a struct.
pub(super) struct Field {
    pub(super) name: String,
    /// The name in the declaration.
    pub(super) declared: String,
    /// The lengths of the arrays, from the outermost.
    lengths: Vec<usize>,
    /// Whether it holds bodies.
    pub(super) is_body: bool,
    /// What the declaration says of it.
    pub(super) documentation: String,
}

impl Parameters {
    pub(super) fn of(emitter: &Emitter<'_>) -> Self {
        let components = &emitter.lowered.quantities.parameters;
        let mut names = Namespace::default();
        let (mut fields, mut reads) = (Vec::new(), Vec::new());
        for components in components.chunk_by(|x, y| x.field == y.field) {
            let Some(first) = components.first() else {
                continue;
            };
            let declared = unraw(&first.field);
            let declaration = emitter.declaration.fields.iter();
            let mut declaration = declaration.filter(|field| unraw(&field.name) == declared);
            let field = Field {
                name: names.name(&declared),
                lengths: lengths(components),
                is_body: components.iter().any(is_of_body),
                documentation: declaration
                    .next()
                    .map(|field| field.documentation.clone())
                    .unwrap_or_default(),
                declared,
            };
            let numbers = components.iter();
            reads.extend(numbers.map(|component| {
                let index: String = component.label.indices.iter().map(|i| access(*i)).collect();
                format!("p->{}{index}", field.name)
            }));
            fields.push(field);
        }
        Self { fields, reads }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.fields.is_empty()
    }

    /// How many numbers the struct has.
    pub(super) fn numbers(&self) -> usize {
        self.fields.iter().map(Field::numbers).sum()
    }

    /// Whether some fields hold bodies.
    pub(super) fn have_bodies(&self) -> bool {
        self.fields.iter().any(|field| field.is_body)
    }
}

impl Field {
    /// The fields for outputs.
    pub(super) fn of_outputs(emitter: &Emitter<'_>) -> Vec<Self> {
        let mut names = Namespace::default();
        let outputs = emitter.declaration.clauses.outputs.iter();
        let outputs = outputs.zip(&emitter.lowered.outputs);
        outputs
            .map(|(output, shape)| {
                let declared = unraw(&output.name);
                Self {
                    name: names.name(&declared),
                    lengths: shape.lengths(),
                    is_body: false,
                    documentation: String::new(),
                    declared,
                }
            })
            .collect()
    }

    /// How many numbers the field has.
    fn numbers(&self) -> usize {
        let each = if self.is_body { NUMBERS_OF_BODY } else { 1 };
        self.lengths.iter().product::<usize>() * each
    }

    /// The declaration of the field.
    pub(super) fn declaration(&self) -> String {
        let ty = if self.is_body { "$_body" } else { "double" };
        let mut declaration = format!("{ty} {}", self.name);
        for length in &self.lengths {
            // Writing to a `String` does not fail.
            let _ = write!(declaration, "[{length}]");
        }
        declaration + ";"
    }
}

/// The place of a component of an output, which are counted column by column.
pub(super) fn place(shape: Shape, component: usize) -> String {
    shape.index(component).map(access).unwrap_or_default()
}

/// The lengths of the arrays of a field.
fn lengths(components: &[Component]) -> Vec<usize> {
    let mut lengths = Vec::new();
    for component in components {
        for (place, index) in places(&component.label).into_iter().enumerate() {
            if place >= lengths.len() {
                lengths.push(0);
            }
            lengths[place] = lengths[place].max(index + 1);
        }
    }
    lengths
}

/// The indices of a component, up to a number of a body.
fn places(label: &Label) -> Vec<usize> {
    let outer = label.indices.iter();
    let outer = outer.take_while(|index| !matches!(index, Index::Quantity(_)));
    outer
        .flat_map(|index| match *index {
            Index::One(i) | Index::Axis(i) => vec![i],
            Index::Pair { row, column } => vec![row, column],
            Index::Quantity(_) => Vec::new(),
        })
        .collect()
}

fn is_of_body(component: &Component) -> bool {
    let mut indices = component.label.indices.iter();
    indices.any(|index| matches!(index, Index::Quantity(_)))
}

/// An index in C.
fn access(index: Index) -> String {
    match index {
        Index::One(i) | Index::Axis(i) => format!("[{i}]"),
        Index::Pair { row, column } => format!("[{row}][{column}]"),
        Index::Quantity(quantity) => format!(".{}", quantity.name()),
    }
}
