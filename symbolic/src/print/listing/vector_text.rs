//! Vectors of expressions in print.

use crate::mechanics::mechanism::Vector;
use crate::print::names::Letters;
use crate::print::printed::Printed;
use crate::{Expression, Graph, Node, Symbol};

/// Expressions in parentheses.
pub(crate) fn list(graph: &Graph, letters: &Letters, list: &[Expression]) -> Option<Printed> {
    let list = list.iter().map(|x| graph.printed(*x, letters));
    Some(Printed::list(list.collect::<Option<_>>()?))
}

/// A vector: 0, a multiple of a unit vector, multiples of vectors among the parameters, or its components.
pub(crate) fn vector(
    graph: &mut Graph,
    letters: &Letters,
    parameters: &[String],
    vector: Vector,
) -> Option<Printed> {
    let vector = vector.map(|x| graph.arranged(x, letters));
    let nonzero: Vec<_> = (0..3)
        .filter(|axis| !graph.is_zero(vector[*axis]))
        .collect();
    match nonzero.as_slice() {
        [] => Some(Printed::zero()),
        [axis] => {
            let size = graph.printed(vector[*axis], letters)?;
            let unit = ["e_x", "e_y", "e_z"][*axis];
            let unit = Printed::text([unit, unit]);
            Some(if size.is_one() {
                unit
            } else {
                size.times(unit)
            })
        }
        _ => match vector_parameter(graph, parameters, vector) {
            Some(name) => Some(Printed::name(&name, true, Vec::new(), 0)),
            None => list(graph, letters, &vector),
        },
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
