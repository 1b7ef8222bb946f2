//! The energies and definitions of a declaration in print, with their vectors and their sums.
//!
//! Where something has no customary notation, nothing is printed.

mod calls;
mod formula;

use std::collections::BTreeSet;

use lagrangian_symbolic::{AsDeclared, DeclaredLine, Printed, Range};

use crate::emit::as_declared::formula::{FormulaPrinter, values};
use crate::emit::printed_names::{BodyNames, vectors};
use crate::lower::Lowered;
use crate::syntax::clauses::Clause;
use crate::syntax::declaration::Declaration;
use crate::syntax::named::{ForClause, NamedExpression};
use crate::syntax::names::unraw;

/// The energies and the definitions in print.
pub(super) fn as_declared(declaration: &Declaration, lowered: &Lowered) -> AsDeclared {
    let clauses = &declaration.clauses;
    // What a model is reduced to has energies that nobody declared.
    if [&clauses.lagrangian, &clauses.kinetic, &clauses.potential]
        .iter()
        .all(|energies| energies.is_empty())
    {
        return AsDeclared::default();
    }
    let vectors = vectors(declaration, lowered);
    let mut printer = FormulaPrinter::new(declaration, BodyNames::of(lowered), vectors);
    let energies: &[(&str, &[Clause])] = if clauses.lagrangian.is_empty() {
        &[("T", &clauses.kinetic), ("V", &clauses.potential)]
    } else {
        &[("L", &clauses.lagrangian)]
    };
    let energies = energies.iter().map(|(letter, clauses)| {
        let right = printer.total(clauses)?;
        Some(DeclaredLine {
            name: (*letter).to_owned(),
            // The page has its own letter for it.
            left: Printed::text([letter, letter]),
            right,
            mentions: printer.take_mentioned(),
        })
    });
    let Some(energies) = energies.collect::<Option<Vec<_>>>() else {
        return AsDeclared::default();
    };
    let definitions = clauses.definitions.iter();
    let definitions: Vec<_> = definitions
        .map(|definition| printer.line(definition))
        .collect();
    // A definition that has no notation leaves the others without meaning.
    let unprinted = clauses.definitions.iter().zip(&definitions);
    let unprinted = unprinted.filter(|(_, line)| line.is_none());
    let unprinted: BTreeSet<_> = unprinted.map(|(named, _)| unraw(&named.name)).collect();
    let lines: Vec<_> = definitions.into_iter().flatten().collect();
    let all = lines.iter().chain(&energies);
    if all
        .into_iter()
        .any(|line| !line.mentions.is_disjoint(&unprinted))
    {
        return AsDeclared::default();
    }
    AsDeclared {
        energies,
        definitions: lines,
    }
}

impl FormulaPrinter<'_> {
    /// The sum of clauses with one keyword.
    fn total(&mut self, clauses: &[Clause]) -> Option<Printed> {
        let terms = clauses.iter().map(|clause| self.print(&clause.expression));
        let terms: Vec<_> = terms.collect::<Option<_>>()?;
        Some(Printed::sum(terms))
    }

    /// A definition, for all values of its indices.
    fn line(&mut self, definition: &NamedExpression) -> Option<DeclaredLine> {
        let name = unraw(&definition.name);
        let left = self.member(&definition.name, &definition.indices, &[], 0)?;
        let right = self.print(&definition.expression)?;
        let ranges: Option<Vec<_>> = definition.iterations.iter().map(range).collect();
        let mut variables = definition.iterations.iter();
        if !variables.all(|iteration| self.is_free(&iteration.index)) {
            return None;
        }
        Some(DeclaredLine {
            name,
            left,
            right: right.for_all(ranges?),
            mentions: self.take_mentioned(),
        })
    }
}

/// The values of an index.
fn range(iteration: &ForClause) -> Option<Range> {
    values(&iteration.index, &iteration.range)
}
