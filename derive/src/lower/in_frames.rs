//! The energies of a declaration once more, with vectors that are resolved last.
//!
//! As components along inertial axes, the velocity of each link of an arm contains all rotations before it. In a graph of
//! its own the energies keep whole vectors, from which the solver reads how links follow each other.

use core::mem;

use lagrangian_symbolic::{EnergiesInFrames, Geometry};

use crate::lower::expression::Lowerer;
use crate::lower::scope::Scope;
use crate::syntax::declaration::Declaration;

/// T and V with vectors that are resolved last, of a declaration that is free of errors; none of a declaration of L.
pub(super) fn energies_in_frames(
    lowerer: &mut Lowerer<'_>,
    declaration: &Declaration,
) -> Option<EnergiesInFrames> {
    let clauses = &declaration.clauses;
    if !clauses.lagrangian.is_empty() {
        return None;
    }
    let mut geometry = Geometry::with_unresolved_vectors(lowerer.coordinates);
    geometry.graph.passes = lowerer.geometry.graph.passes;
    let mut scope = Scope::new(declaration, &mut geometry.graph);
    mem::swap(&mut geometry, &mut lowerer.geometry);
    mem::swap(&mut scope, &mut lowerer.scope);
    let before = mem::take(lowerer.diagnostics);
    let repetitions = mem::take(&mut lowerer.repetitions);
    let rotations = mem::take(&mut lowerer.rotations);
    lowerer.declare_functions(&clauses.functions);
    for definition in &clauses.definitions {
        lowerer.define(definition);
    }
    let kinetic = lowerer.total(&clauses.kinetic);
    let potential = lowerer.total(&clauses.potential);
    let is_complete = lowerer.diagnostics.is_empty();
    *lowerer.diagnostics = before;
    lowerer.repetitions = repetitions;
    lowerer.rotations = rotations;
    mem::swap(&mut geometry, &mut lowerer.geometry);
    mem::swap(&mut scope, &mut lowerer.scope);
    Some(EnergiesInFrames {
        geometry,
        kinetic: kinetic?,
        potential: potential?,
    })
    .filter(|_| is_complete)
}
