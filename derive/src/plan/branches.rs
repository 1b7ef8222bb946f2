//! The branches of event functions, such as those of |u| and max(u, v): where one ends, so does its Taylor series.

use lagrangian_symbolic::Model;

use crate::syntax::shape::Shape;

/// For each event the indices of the arguments of its branches, counted from the first event. These become outputs of the
/// model behind the events, which are those behind the outputs of these shapes.
pub(crate) fn branches_of_events(model: &mut Model, outputs: &[Shape]) -> Vec<Vec<usize>> {
    let before = outputs.iter().map(|shape| shape.count()).sum();
    let events = model.outputs.get(before..).unwrap_or_default().to_vec();
    let arguments = model.graph.branch_arguments(&events);
    let index = |argument| arguments.iter().position(|other| *other == argument);
    let mut branches = Vec::new();
    for event in &events {
        let own = model.graph.branch_arguments(&[*event]);
        let indices = own.into_iter().filter_map(index);
        branches.push(indices.map(|index| events.len() + index).collect());
    }
    model.outputs.extend(arguments);
    branches
}
