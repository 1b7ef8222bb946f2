//! Vectors of expressions in Unicode and in LaTeX.

use crate::mechanics::mechanism::Vector;
use crate::print::names::Letters;
use crate::print::notation::Notation;
use crate::print::spelling::Spelling;
use crate::{Expression, Graph, Node, Symbol};

/// An expression as it is, in Unicode and in LaTeX.
pub(crate) fn plain_text(graph: &Graph, letters: &Letters, x: Expression) -> [String; 2] {
    let formula = graph.display_in(x, letters);
    [formula.to_string(), formula.in_latex().to_string()]
}

/// Expressions in parentheses.
pub(crate) fn list_text(
    graph: &Graph,
    letters: &Letters,
    expressions: &[Expression],
) -> [String; 2] {
    let texts: Vec<_> = expressions
        .iter()
        .map(|x| plain_text(graph, letters, *x))
        .collect();
    let both = [0, 1].map(|notation| {
        let texts: Vec<_> = texts.iter().map(|text| &*text[notation]).collect();
        texts.join(", ")
    });
    [
        format!("({})", both[0]),
        format!("\\left({}\\right)", both[1]),
    ]
}

/// The name of a parameter with marks around its index.
pub(crate) fn name_texts(letters: &Letters, name: &str) -> [String; 2] {
    let spelling = Spelling::of_parameter(name);
    [Notation::Unicode, Notation::Latex].map(|notation| letters.print(&spelling, 0, notation))
}

/// A vector: 0, a multiple of a unit vector, multiples of vectors among the parameters, or its components.
pub(crate) fn vector_text(
    graph: &mut Graph,
    letters: &Letters,
    parameters: &[String],
    vector: Vector,
) -> [String; 2] {
    let vector = vector.map(|x| graph.arranged(x, letters));
    let nonzero: Vec<_> = (0..3)
        .filter(|axis| !graph.is_zero(vector[*axis]))
        .collect();
    match nonzero.as_slice() {
        [] => ["0", "0"].map(String::from),
        [axis] => along_axis(graph, letters, vector[*axis], *axis),
        _ => {
            let own = vector_parameter(graph, parameters, vector);
            let name = own.map(|name| name_texts(letters, &name));
            name.unwrap_or_else(|| list_text(graph, letters, &vector))
        }
    }
}

/// A multiple of a unit vector.
fn along_axis(graph: &Graph, letters: &Letters, size: Expression, axis: usize) -> [String; 2] {
    let [text, latex] = plain_text(graph, letters, size);
    let axis = ["x", "y", "z"][axis];
    let is_sum = matches!(graph.node(size), Node::Sum(terms) if terms.len() > 1);
    if size == graph.one() {
        [format!("e_{axis}"), format!("e_{axis}")]
    } else if is_sum {
        [
            format!("({text}) e_{axis}"),
            format!("\\left({latex}\\right) e_{axis}"),
        ]
    } else {
        [format!("{text} e_{axis}"), format!("{latex} e_{axis}")]
    }
}

/// The vector among the parameters whose components these are.
fn vector_parameter(graph: &Graph, parameters: &[String], vector: Vector) -> Option<String> {
    let names = vector.map(|x| match graph.node(x) {
        Node::Symbol(Symbol::Parameter(k)) => parameters.get(*k as usize),
        _ => None,
    });
    let suffixes = [[".x", ".y", ".z"], ["[0]", "[1]", "[2]"]];
    suffixes.into_iter().find_map(|suffixes| {
        let stem = names[0]?.strip_suffix(suffixes[0])?;
        let mut components = names.iter().zip(suffixes);
        let are_all = components
            .all(|(name, suffix)| name.is_some_and(|name| *name == format!("{stem}{suffix}")));
        are_all.then(|| stem.to_owned())
    })
}
