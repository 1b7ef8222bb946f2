//! The names of a declaration and what they stand for.

use std::collections::{BTreeMap, BTreeSet};

use lagrangian_symbolic::{Expression, Graph, Symbol};
use proc_macro2::Ident;

use crate::declaration::{Declaration, Role};
use crate::diagnostics::similar;
use crate::names::{plain, spelled};

/// What a name stands for.
#[derive(Clone, Copy)]
pub(crate) enum Meaning {
    /// A coordinate, parameter or input, or the time.
    Symbol(Symbol),
    /// The number π.
    Pi,
    /// A quantity from `define`.
    Defined(Expression),
    /// A quantity from `define` further down.
    Later,
    /// What has an error that was reported where it stands.
    Broken,
    /// A field that is marked `skip`.
    Skipped,
    /// A quantity from `output`, which only observers use.
    Output,
}

/// Names in their order of declaration, with what they stand for.
pub(crate) struct Scope {
    meanings: BTreeMap<String, Meaning>,
    /// Where a field is first spoken of: the emitted code accesses it with that span.
    uses: BTreeMap<String, Ident>,
    /// Names that stand for nothing, wherever they were written.
    unknown: Vec<Ident>,
    /// Whether all names of the declaration are here. They are not where coordinates or definitions
    /// could not be read, or where one of them is written for another.
    pub(crate) complete: bool,
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
        for (i, field) in (0..).zip(declaration.fields_with(Role::Parameter)) {
            meanings.insert(plain(&field.name), Meaning::Symbol(Symbol::Parameter(i)));
        }
        for (i, field) in (0..).zip(declaration.fields_with(Role::Input)) {
            meanings.insert(plain(&field.name), Meaning::Symbol(Symbol::Input(i)));
        }
        for (i, name) in (0..).zip(&declaration.clauses.coordinates) {
            meanings.insert(plain(name), Meaning::Symbol(Symbol::Coordinate(i)));
        }
        let clauses = &declaration.clauses;
        let names: BTreeSet<String> = clauses.coordinates.iter().map(plain).collect();
        let repeated = names.len() < clauses.coordinates.len();
        let definitions = clauses.definitions.iter().map(|named| &named.name);
        let skipped = declaration
            .fields_with(Role::Skipped)
            .map(|field| &field.name);
        let outputs = clauses.outputs.iter().map(|named| &named.name);
        // A name that is taken keeps its meaning: an output may be called like what it shows.
        let others = definitions
            .map(|name| (name, Meaning::Later))
            .chain(skipped.map(|name| (name, Meaning::Skipped)))
            .chain(outputs.map(|name| (name, Meaning::Output)));
        for (name, meaning) in others {
            meanings.entry(plain(name)).or_insert(meaning);
        }
        Self {
            meanings,
            uses: BTreeMap::new(),
            unknown: Vec::new(),
            complete: !clauses.names_unreadable && !clauses.coordinates.is_empty() && !repeated,
        }
    }

    /// What `name` stands for, if anything.
    pub(crate) fn resolve(&mut self, name: &Ident) -> Option<Meaning> {
        let written = plain(name);
        let meaning = self.meanings.get(&written).copied()?;
        if let Meaning::Symbol(Symbol::Parameter(_) | Symbol::Input(_)) = meaning {
            self.uses.entry(written).or_insert_with(|| name.clone());
        }
        Some(meaning)
    }

    /// Gives the name of a definition its meaning, unless the name is taken.
    pub(crate) fn define(&mut self, name: &Ident, meaning: Meaning) {
        if let Some(later @ Meaning::Later) = self.meanings.get_mut(&plain(name)) {
            *later = meaning;
        }
    }

    /// Says no more of a name that has an error.
    pub(crate) fn silence(&mut self, name: &Ident) {
        self.meanings.insert(plain(name), Meaning::Broken);
    }

    /// The coordinate called `name`.
    pub(crate) fn coordinate(&self, name: &str) -> Option<usize> {
        match self.meanings.get(name)? {
            Meaning::Symbol(Symbol::Coordinate(i)) => Some(*i as usize),
            _ => None,
        }
    }

    /// The quantity other than a field that was probably meant by an unknown name.
    pub(crate) fn suggest(&self, name: &Ident) -> Option<String> {
        let meant = similar(&plain(name), self.meanings.keys().map(String::as_str))?;
        match self.meanings[meant] {
            Meaning::Symbol(Symbol::Parameter(_) | Symbol::Input(_))
            | Meaning::Skipped
            | Meaning::Output => None,
            _ => Some(spelled(meant)),
        }
    }

    /// Notes a name that stands for nothing: the compiler will look for such a field.
    pub(crate) fn note_unknown(&mut self, name: &Ident) {
        self.unknown.push(name.clone());
    }

    /// The names that stand for nothing, wherever they were written.
    pub(crate) fn unknown(&self) -> impl Iterator<Item = &Ident> {
        self.unknown.iter()
    }

    /// Where the field called `name` is first spoken of.
    pub(crate) fn first_use(&self, name: &Ident) -> Option<&Ident> {
        self.uses.get(&plain(name))
    }

    /// The expression that is defined as `name`.
    pub(crate) fn defined(&self, name: &Ident) -> Option<Expression> {
        match self.meanings.get(&plain(name))? {
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
