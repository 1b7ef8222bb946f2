//! The energies and definitions of a declaration in print, with their vectors and their sums.
//!
//! Where something has no customary notation, nothing is printed.

mod calls;
mod formula;
mod notation;

use std::collections::BTreeSet;

use lagrangian_symbolic::{AsDeclared, DeclaredLine, print_range};

use crate::emit::as_declared::formula::{FormulaPrinter, bounds};
use crate::emit::as_declared::notation::Notation;
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
            left: Default::default(),
            right: right.texts,
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
    fn total(&mut self, clauses: &[Clause]) -> Option<Notation> {
        let terms = clauses.iter().map(|clause| self.print(&clause.expression));
        let terms: Vec<_> = terms.collect::<Option<_>>()?;
        Some(Notation::sum(terms))
    }

    /// A definition, for all values of its indices.
    fn line(&mut self, definition: &NamedExpression) -> Option<DeclaredLine> {
        let name = unraw(&definition.name);
        let left = self.member(&definition.name, &definition.indices, &[], 0)?;
        let right = self.print(&definition.expression)?;
        let mut right = right.texts;
        let ranges: Option<Vec<_>> = definition.iterations.iter().map(range).collect();
        let ranges = ranges?;
        let mut variables = definition.iterations.iter();
        if !variables.all(|iteration| self.is_free(&iteration.index)) {
            return None;
        }
        if !ranges.is_empty() {
            let ranges = [0, 1].map(|notation| {
                let texts: Vec<_> = ranges.iter().map(|texts| &*texts[notation]).collect();
                texts.join("; ")
            });
            right[0].extend(["  (", &ranges[0], ")"]);
            right[1].extend([" \\quad (", &ranges[1], ")"]);
        }
        Some(DeclaredLine {
            name,
            left: left.texts,
            right,
            mentions: self.take_mentioned(),
        })
    }
}

/// The values of an index.
fn range(iteration: &ForClause) -> Option<[String; 2]> {
    let (first, last) = bounds(&iteration.range)?;
    Some(print_range(&unraw(&iteration.index), &first, &last))
}
