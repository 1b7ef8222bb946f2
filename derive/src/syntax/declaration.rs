//! A declaration: a struct of parameters and its `#[lagrangian(…)]` attributes.
//!
//! Comes in: the tokens of a struct. Goes out: a [`Declaration`] that is grammatical, every part with
//! its span. Names are not resolved here.

use proc_macro2::Ident;
use syn::punctuated::Punctuated;
use syn::{Attribute, Data, DeriveInput, Fields, Generics, Token, Visibility};

use crate::diagnostics::Diagnostics;
use crate::syntax::clauses::Clauses;
use crate::syntax::field::{Field, Role, documentation};
use crate::syntax::grammar::own;
use crate::syntax::root::Root;

/// A struct with its energies.
pub(crate) struct Declaration {
    pub(crate) name: Ident,
    /// The documentation of the struct, line by line.
    pub(crate) documentation: String,
    pub(crate) visibility: Visibility,
    pub(crate) generics: Generics,
    pub(crate) fields: Vec<Field>,
    /// Whether it is a struct whose fields have names, one of which an unresolved name may be misspelled for.
    pub(crate) names_fields: bool,
    pub(crate) clauses: Clauses,
    /// Where the emitted code finds the crate `lagrangian`.
    pub(crate) root: Root,
    /// The attributes `#[allow(…)]` of the struct.
    pub(crate) allowed: Vec<Attribute>,
}

impl Declaration {
    /// Parses a declaration, with recovery: what can be parsed is kept.
    pub(crate) fn parse(input: DeriveInput, diagnostics: &mut Diagnostics) -> Self {
        let fields = named_fields(input.data, diagnostics);
        let names_fields = fields.is_some();
        let fields = fields
            .into_iter()
            .flatten()
            .filter_map(|field| Field::read(field, diagnostics))
            .collect();
        let mut clauses = Clauses::default();
        for attribute in own(&input.attrs) {
            clauses.read(attribute, diagnostics);
        }
        clauses.add_bodies();
        let documentation = documentation(&input.attrs);
        let allowed = input.attrs.into_iter();
        let allowed = allowed.filter(|attribute| attribute.path().is_ident("allow"));
        Self {
            allowed: allowed.collect(),
            name: input.ident,
            documentation,
            visibility: input.vis,
            generics: input.generics,
            fields,
            names_fields,
            root: clauses.root.take().unwrap_or_default(),
            clauses,
        }
    }

    /// The fields with this role, in order.
    pub(crate) fn fields_with(&self, role: Role) -> impl Iterator<Item = &Field> {
        self.fields.iter().filter(move |field| field.role == role)
    }
}

/// The fields of a struct; `None`, with an error, for anything whose fields have no names.
fn named_fields(
    data: Data,
    diagnostics: &mut Diagnostics,
) -> Option<Punctuated<syn::Field, Token![,]>> {
    let not_a_struct = "`Lagrangian` is derived for a struct whose fields are the parameters of the system: \
                        write `struct Pendulum { m: f64, l: f64 }`";
    match data {
        Data::Struct(data) => match data.fields {
            Fields::Named(fields) => return Some(fields.named),
            Fields::Unit => return Some(Punctuated::new()),
            Fields::Unnamed(fields) => diagnostics.error(
                fields,
                "`Lagrangian` needs named fields, for the declaration to speak of: \
                 write `struct Pendulum { m: f64, l: f64 }`",
            ),
        },
        Data::Enum(data) => diagnostics.error(data.enum_token, not_a_struct),
        Data::Union(data) => diagnostics.error(data.union_token, not_a_struct),
    }
    None
}
