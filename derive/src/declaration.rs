//! The user's words: a struct of parameters and its `#[lagrangian(…)]` attributes.
//!
//! Comes in: the tokens of a struct. Goes out: a [`Declaration`] that is grammatical, every part with
//! its span. What the words mean is not looked at here.

use proc_macro2::{Ident, Span};
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Attribute, Data, DeriveInput, Expr, Fields, Generics, Token, Type, Visibility, token};

use crate::diagnostics::{Diagnostics, similar};

/// A struct with its energies.
pub(crate) struct Declaration {
    pub(crate) name: Ident,
    pub(crate) visibility: Visibility,
    pub(crate) generics: Generics,
    pub(crate) fields: Vec<Field>,
    pub(crate) clauses: Clauses,
}

/// A named field of the struct.
pub(crate) struct Field {
    pub(crate) name: Ident,
    pub(crate) ty: Type,
    pub(crate) role: Role,
}

/// What a field is to the model.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Role {
    /// Constant in time.
    Parameter,
    /// Set from outside: `#[lagrangian(input)]`.
    Input,
    /// None of the model's business: `#[lagrangian(skip)]`.
    Skipped,
}

/// All that stands in the struct's `#[lagrangian(…)]` attributes.
#[derive(Default)]
pub(crate) struct Clauses {
    pub(crate) coordinates: Vec<Ident>,
    pub(crate) definitions: Vec<Named>,
    pub(crate) kinetic: Vec<Clause>,
    pub(crate) potential: Vec<Clause>,
    pub(crate) lagrangian: Vec<Clause>,
    pub(crate) dissipation: Vec<Clause>,
    pub(crate) forces: Vec<Named>,
    pub(crate) outputs: Vec<Named>,
}

/// `keyword = expression`.
pub(crate) struct Clause {
    pub(crate) keyword: Ident,
    pub(crate) expression: Expr,
}

/// `name = expression` in a list.
pub(crate) struct Named {
    pub(crate) name: Ident,
    pub(crate) expression: Expr,
}

const KEYWORDS: [&str; 8] = [
    "coordinates",
    "define",
    "kinetic",
    "potential",
    "lagrangian",
    "dissipation",
    "force",
    "output",
];

impl Declaration {
    /// Reads a declaration. What can be read is kept even where errors are found.
    pub(crate) fn parse(input: DeriveInput, diagnostics: &mut Diagnostics) -> Self {
        let fields = match input.data {
            Data::Struct(data) => match data.fields {
                Fields::Named(fields) => fields.named.into_iter().collect(),
                Fields::Unit => Vec::new(),
                Fields::Unnamed(fields) => {
                    diagnostics.error(
                        fields,
                        "`Lagrangian` needs named fields, for the declaration to speak of: \
                         write `struct Pendulum { m: f64, l: f64 }`",
                    );
                    Vec::new()
                }
            },
            Data::Enum(data) => {
                diagnostics.error(data.enum_token, NOT_A_STRUCT);
                Vec::new()
            }
            Data::Union(data) => {
                diagnostics.error(data.union_token, NOT_A_STRUCT);
                Vec::new()
            }
        };
        let fields = fields
            .into_iter()
            .filter_map(|field| Field::read(field, diagnostics))
            .collect();
        let mut clauses = Clauses::default();
        for attribute in own(&input.attrs) {
            let read = attribute.parse_args_with(|input: ParseStream<'_>| clauses.read(input));
            if let Err(error) = read {
                diagnostics.add(error);
            }
        }
        Self {
            name: input.ident,
            visibility: input.vis,
            generics: input.generics,
            fields,
            clauses,
        }
    }

    /// The fields with this role, in order.
    pub(crate) fn fields_with(&self, role: Role) -> impl Iterator<Item = &Field> {
        self.fields.iter().filter(move |field| field.role == role)
    }
}

const NOT_A_STRUCT: &str = "`Lagrangian` is derived for a struct whose fields are the parameters of the system: \
     write `struct Pendulum { m: f64, l: f64 }`";

fn own(attributes: &[Attribute]) -> impl Iterator<Item = &Attribute> {
    attributes
        .iter()
        .filter(|attribute| attribute.path().is_ident("lagrangian"))
}

impl Field {
    fn read(field: syn::Field, diagnostics: &mut Diagnostics) -> Option<Self> {
        let mut role = Role::Parameter;
        for attribute in own(&field.attrs) {
            match attribute.parse_args::<Ident>() {
                Ok(word) if word == "input" && role != Role::Skipped => role = Role::Input,
                Ok(word) if word == "skip" && role != Role::Input => role = Role::Skipped,
                Ok(word) if word == "input" || word == "skip" => diagnostics.error(
                    word,
                    "a field is an input or it is skipped: keep one of `input` and `skip`",
                ),
                Ok(word) => diagnostics.error(
                    &word,
                    format!("unknown field attribute `{word}`: write `input` or `skip`"),
                ),
                Err(error) => diagnostics.error_at(
                    error.span(),
                    "write `#[lagrangian(input)]` or `#[lagrangian(skip)]` on a field",
                ),
            }
        }
        Some(Self {
            name: field.ident?,
            ty: field.ty,
            role,
        })
    }
}

impl Clauses {
    fn read(&mut self, input: ParseStream<'_>) -> syn::Result<()> {
        while !input.is_empty() {
            let keyword: Ident = input.parse()?;
            self.read_clause(keyword, input)?;
            if !input.is_empty() {
                input.parse::<Token![,]>()?;
            }
        }
        Ok(())
    }

    fn read_clause(&mut self, keyword: Ident, input: ParseStream<'_>) -> syn::Result<()> {
        match keyword.to_string().as_str() {
            "coordinates" => self
                .coordinates
                .extend(list::<Coordinate>(&keyword, input)?.map(|c| c.0)),
            "define" => self.definitions.extend(list::<Named>(&keyword, input)?),
            "force" => self.forces.extend(list::<Named>(&keyword, input)?),
            "output" => self.outputs.extend(list::<Named>(&keyword, input)?),
            "kinetic" => self.kinetic.push(Clause::read(keyword, input)?),
            "potential" => self.potential.push(Clause::read(keyword, input)?),
            "lagrangian" => self.lagrangian.push(Clause::read(keyword, input)?),
            "dissipation" => self.dissipation.push(Clause::read(keyword, input)?),
            written => {
                let hint = match similar(written, KEYWORDS) {
                    Some(meant) => format!("did you mean `{meant}`?"),
                    None => format!("write one of `{}`", KEYWORDS.join("`, `")),
                };
                return Err(syn::Error::new(
                    keyword.span(),
                    format!("unknown clause `{written}`: {hint}"),
                ));
            }
        }
        Ok(())
    }
}

impl Clause {
    fn read(keyword: Ident, input: ParseStream<'_>) -> syn::Result<Self> {
        if !input.peek(Token![=]) {
            let message = format!("write `{keyword} = expression`");
            return Err(syn::Error::new(position(&keyword, input), message));
        }
        input.parse::<Token![=]>()?;
        let expression = input.parse()?;
        Ok(Self {
            keyword,
            expression,
        })
    }
}

impl Parse for Named {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let name: Ident = input.parse()?;
        if !input.peek(Token![=]) {
            let message = format!("write `{name} = expression`");
            return Err(syn::Error::new(position(&name, input), message));
        }
        input.parse::<Token![=]>()?;
        let expression = input.parse()?;
        Ok(Self { name, expression })
    }
}

struct Coordinate(Ident);

impl Parse for Coordinate {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let name: Ident = input.parse()?;
        if input.peek(token::Bracket) {
            let message = format!("write the coordinates one by one: `{name}1, {name}2, …`");
            return Err(input.error(message));
        }
        Ok(Self(name))
    }
}

/// Where an error about what follows `word` is shown: there, or at the word if nothing follows.
fn position(word: &Ident, input: ParseStream<'_>) -> Span {
    if input.is_empty() {
        word.span()
    } else {
        input.span()
    }
}

/// `(item, item, …)` after a keyword.
fn list<T: Parse>(keyword: &Ident, input: ParseStream<'_>) -> syn::Result<impl Iterator<Item = T>> {
    if !input.peek(token::Paren) {
        let message = match keyword.to_string().as_str() {
            "coordinates" => "write `coordinates(theta, phi)`".to_owned(),
            word => format!("write `{word}(name = expression, …)`"),
        };
        return Err(syn::Error::new(position(keyword, input), message));
    }
    let content;
    syn::parenthesized!(content in input);
    let items = Punctuated::<T, Token![,]>::parse_terminated(&content)?;
    Ok(items.into_iter())
}
