//! Definitions that are made of themselves, as a closed loop of frames is: they are found where the first of them is used
//! before it is there.

use std::collections::BTreeSet;

use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::ToTokens;

use super::Lowerer;
use crate::lower::hints;
use crate::syntax::names::unraw;

impl Lowerer<'_> {
    /// The error that a name, which is defined further down, is made of the definition in which it stands.
    pub(super) fn circle(&self, name: &Ident) -> Option<String> {
        let (own, indices) = self.defining.as_ref()?;
        let (name, own) = (unraw(name), unraw(own));
        if name == own {
            return indices.is_empty().then(|| by_itself(&own));
        }
        let mut path = self.path(&name, &own, &mut BTreeSet::new())?;
        path.insert(0, own);
        let (last, others) = path.split_last()?;
        Some(format!(
            "`{}` and `{last}` are made of each other: a definition may use only those before it, so begin with one that is \
             made of coordinates and parameters alone, as the first frame of a chain is",
            others.join("`, `")
        ))
    }

    /// The error that a member of a family is made of itself.
    pub(super) fn own_member(&self, name: &Ident, member: &[i64]) -> Option<String> {
        let (own, indices) = self.defining.as_ref()?;
        let mut indices = indices.iter().map(|i| i64::try_from(*i).ok());
        let is_own = own == name && member.iter().all(|i| indices.next() == Some(Some(*i)));
        let is_own = is_own && indices.next().is_none();
        is_own.then(|| by_itself(&hints::member(name, member)))
    }

    /// The names of definitions from one to another, each of which is mentioned in the one before it, without the last.
    fn path(&self, from: &str, to: &str, seen: &mut BTreeSet<String>) -> Option<Vec<String>> {
        if !seen.insert(from.to_owned()) {
            return None;
        }
        let mut mentioned = BTreeSet::new();
        for definition in self.definitions {
            if unraw(&definition.name) == from {
                mentions(definition.expression.to_token_stream(), &mut mentioned);
            }
        }
        if mentioned.contains(to) {
            return Some(vec![from.to_owned()]);
        }
        let defined = self
            .definitions
            .iter()
            .map(|definition| unraw(&definition.name));
        let next: BTreeSet<String> = defined.filter(|name| mentioned.contains(name)).collect();
        next.into_iter().find_map(|next| {
            let mut path = self.path(&next, to, seen)?;
            path.insert(0, from.to_owned());
            Some(path)
        })
    }
}

fn by_itself(name: &str) -> String {
    format!(
        "`{name}` is made of itself: a definition uses only those before it, so write the name of what comes before, such as the \
         frame from which this one is turned"
    )
}

/// All identifiers.
fn mentions(tokens: TokenStream, names: &mut BTreeSet<String>) {
    for token in tokens {
        match token {
            TokenTree::Group(group) => mentions(group.stream(), names),
            TokenTree::Ident(name) => {
                names.insert(unraw(&name));
            }
            _ => {}
        }
    }
}
