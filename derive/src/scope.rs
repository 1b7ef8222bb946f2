//! The names of a declaration and what they stand for.

use std::collections::BTreeMap;

use lagrangian_symbolic::{Expression, Graph, Symbol};
use proc_macro2::Ident;

use crate::declaration::{Declaration, Role};
use crate::diagnostics::similar;

/// What a name stands for.
#[derive(Clone, Copy)]
pub(crate) enum Meaning {
    /// A coordinate, parameter or input, or the time.
    Symbol(Symbol),
    /// The number π.
    Pi,
    /// A quantity from `define`.
    Defined(Expression),
    /// A quantity from `define` whose own declaration has an error, reported there.
    Broken,
    /// A field that is marked `skip`.
    Skipped,
}

/// Names in their order of declaration, with what they stand for.
pub(crate) struct Scope {
    meanings: BTreeMap<String, Meaning>,
    /// Where a field is first spoken of: the emitted code accesses it with that span.
    uses: BTreeMap<String, Ident>,
    /// Names that stand for nothing, where they were first written.
    unknown: BTreeMap<String, Ident>,
}

/// Names that are taken.
pub(crate) const RESERVED: [&str; 3] = ["t", "PI", "dot"];

impl Scope {
    /// The scope of a checked declaration, before its definitions.
    pub(crate) fn new(declaration: &Declaration) -> Self {
        let mut meanings = BTreeMap::from([
            ("t".to_owned(), Meaning::Symbol(Symbol::Time)),
            ("PI".to_owned(), Meaning::Pi),
        ]);
        for field in declaration.fields_with(Role::Skipped) {
            meanings.insert(field.name.to_string(), Meaning::Skipped);
        }
        for (i, field) in (0..).zip(declaration.fields_with(Role::Parameter)) {
            meanings.insert(
                field.name.to_string(),
                Meaning::Symbol(Symbol::Parameter(i)),
            );
        }
        for (i, field) in (0..).zip(declaration.fields_with(Role::Input)) {
            meanings.insert(field.name.to_string(), Meaning::Symbol(Symbol::Input(i)));
        }
        for (i, name) in (0..).zip(&declaration.clauses.coordinates) {
            meanings.insert(name.to_string(), Meaning::Symbol(Symbol::Coordinate(i)));
        }
        Self {
            meanings,
            uses: BTreeMap::new(),
            unknown: BTreeMap::new(),
        }
    }

    /// What `name` stands for, if anything.
    pub(crate) fn resolve(&mut self, name: &Ident) -> Option<Meaning> {
        let written = name.to_string();
        let meaning = self.meanings.get(&written).copied()?;
        if let Meaning::Symbol(Symbol::Parameter(_) | Symbol::Input(_)) = meaning {
            self.uses.entry(written).or_insert_with(|| name.clone());
        }
        Some(meaning)
    }

    /// Gives `name` a meaning.
    pub(crate) fn define(&mut self, name: &Ident, meaning: Meaning) {
        self.meanings.insert(name.to_string(), meaning);
    }

    /// The coordinate called `name`.
    pub(crate) fn coordinate(&self, name: &Ident) -> Option<usize> {
        match self.meanings.get(&name.to_string())? {
            Meaning::Symbol(Symbol::Coordinate(i)) => Some(*i as usize),
            _ => None,
        }
    }

    /// The quantity other than a field that was probably meant by an unknown name.
    pub(crate) fn suggest(&self, name: &Ident) -> Option<&str> {
        let written = name.to_string();
        let meant = similar(&written, self.meanings.keys().map(String::as_str))?;
        match self.meanings[meant] {
            Meaning::Symbol(Symbol::Parameter(_) | Symbol::Input(_)) | Meaning::Skipped => None,
            _ => Some(meant),
        }
    }

    /// Notes a name that stands for nothing: the compiler will look for such a field.
    pub(crate) fn note_unknown(&mut self, name: &Ident) {
        self.unknown
            .entry(name.to_string())
            .or_insert_with(|| name.clone());
    }

    /// The names that stand for nothing, where they were first written.
    pub(crate) fn unknown(&self) -> impl Iterator<Item = &Ident> {
        self.unknown.values()
    }

    /// Where the field called `name` is first spoken of.
    pub(crate) fn first_use(&self, name: &Ident) -> Option<&Ident> {
        self.uses.get(&name.to_string())
    }

    /// The expression that is defined as `name`.
    pub(crate) fn defined(&self, name: &Ident) -> Option<Expression> {
        match self.meanings.get(&name.to_string())? {
            Meaning::Defined(expression) => Some(*expression),
            _ => None,
        }
    }

    /// The defined quantities by name.
    pub(crate) fn definitions<'a>(
        &'a self,
        graph: &'a Graph,
    ) -> impl Iterator<Item = (&'a str, Expression)> {
        self.meanings
            .iter()
            .filter_map(|(name, meaning)| match meaning {
                Meaning::Defined(expression) if graph.as_constant(*expression).is_none() => {
                    Some((name.as_str(), *expression))
                }
                _ => None,
            })
    }
}
