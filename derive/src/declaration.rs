//! The user's words: a struct of parameters and its `#[lagrangian(…)]` attributes.
//!
//! Comes in: the tokens of a struct. Goes out: a [`Declaration`] that is grammatical, every part with
//! its span. What the words mean is not looked at here.

use proc_macro2::{Ident, Span, TokenTree};
use syn::ext::IdentExt;
use syn::parse::ParseStream;
use syn::parse::discouraged::Speculative;
use syn::punctuated::Punctuated;
use syn::{
    Attribute, Data, DeriveInput, Expr, Fields, Generics, LitInt, MacroDelimiter, Meta, Token,
    Type, Visibility, token,
};

use crate::diagnostics::{Diagnostics, similar};
use crate::field::{Field, Role};
use crate::function::Function;
use crate::root::Root;

/// A struct with its energies.
pub(crate) struct Declaration {
    pub(crate) name: Ident,
    pub(crate) visibility: Visibility,
    pub(crate) generics: Generics,
    pub(crate) fields: Vec<Field>,
    /// Whether it is a struct whose fields have names, so that an unknown name may be meant for one.
    pub(crate) names_fields: bool,
    pub(crate) clauses: Clauses,
    /// Where the emitted code finds the crate `lagrangian`.
    pub(crate) root: Root,
}

/// All that stands in the struct's `#[lagrangian(…)]` attributes.
#[derive(Default)]
pub(crate) struct Clauses {
    pub(crate) coordinates: Vec<Coordinate>,
    pub(crate) functions: Vec<Function>,
    pub(crate) definitions: Vec<Named>,
    pub(crate) kinetic: Vec<Clause>,
    pub(crate) potential: Vec<Clause>,
    pub(crate) lagrangian: Vec<Clause>,
    pub(crate) dissipation: Vec<Clause>,
    /// The forces of each clause: those of one clause act on different coordinates, several clauses add up.
    pub(crate) forces: Vec<Vec<Named>>,
    pub(crate) outputs: Vec<Named>,
    /// What `scalar = …` says.
    pub(crate) scalar: Option<Type>,
    /// What `crate = …` says.
    root: Option<Root>,
    /// Whether something could not be read, so that what seems to be missing may stand there.
    pub(crate) unreadable: bool,
    /// Whether functions could not be read, so that an unknown one may stand there.
    pub(crate) functions_unreadable: bool,
    /// Whether coordinates or definitions could not be read, so that an unknown name may stand there.
    pub(crate) names_unreadable: bool,
}

/// A generalized coordinate, or several under one name.
pub(crate) struct Coordinate {
    pub(crate) name: Ident,
    /// How many there are of a family, `theta[5]`.
    pub(crate) length: Option<usize>,
}

/// `keyword = expression`.
pub(crate) struct Clause {
    pub(crate) keyword: Ident,
    pub(crate) expression: Expr,
}

/// `name = expression` in a list, or `name[i] = expression for i in 0..5`.
pub(crate) struct Named {
    pub(crate) name: Ident,
    pub(crate) indices: Vec<Expr>,
    pub(crate) expression: Expr,
    pub(crate) iterations: Vec<Iteration>,
}

/// `for index in range`.
pub(crate) struct Iteration {
    pub(crate) index: Ident,
    pub(crate) range: Expr,
}

const KEYWORDS: [&str; 10] = [
    "coordinates",
    "function",
    "define",
    "kinetic",
    "potential",
    "lagrangian",
    "dissipation",
    "force",
    "output",
    "scalar",
];

impl Declaration {
    /// Reads a declaration. What can be read is kept even where errors are found.
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
        Self {
            name: input.ident,
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

/// The attributes that are ours.
pub(crate) fn own(attributes: &[Attribute]) -> impl Iterator<Item = &Attribute> {
    attributes
        .iter()
        .filter(|attribute| attribute.path().is_ident("lagrangian"))
}

impl Clauses {
    fn read(&mut self, attribute: &Attribute, diagnostics: &mut Diagnostics) {
        let clauses = |input: ParseStream<'_>| {
            separated(input, "a comma between clauses, or an operator,", |input| {
                if input.peek(Token![crate]) {
                    return self.read_root(input);
                }
                let keyword = word(input, &no_clause())?;
                self.read_clause(keyword, input)
            })
        };
        let read = match &attribute.meta {
            Meta::List(list) if matches!(list.delimiter, MacroDelimiter::Paren(_)) => {
                attribute.parse_args_with(clauses)
            }
            meta => Err(syn::Error::new_spanned(
                meta,
                "write `#[lagrangian(coordinates(theta), kinetic = …)]`",
            )),
        };
        if let Err(error) = read {
            self.unreadable = true;
            diagnostics.add(error);
        }
    }

    fn read_root(&mut self, input: ParseStream<'_>) -> syn::Result<()> {
        let (keyword, root) = Root::read(input)?;
        if self.root.is_some() {
            let message = "the crate is named already: keep one `crate = …`";
            return Err(syn::Error::new(keyword.span(), message));
        }
        self.root = Some(root);
        Ok(())
    }

    fn read_scalar(&mut self, keyword: &Ident, input: ParseStream<'_>) -> syn::Result<()> {
        let message = "write `scalar = f64`, with the type on which the model is evaluated";
        if !input.peek(Token![=]) {
            return Err(syn::Error::new(position(keyword, input), message));
        }
        let equals = input.parse::<Token![=]>()?;
        if input.is_empty() || input.peek(Token![,]) {
            return Err(syn::Error::new_spanned(equals, message));
        }
        let scalar: Type = input
            .parse()
            .map_err(|error| syn::Error::new(error.span(), message))?;
        if self.scalar.is_some() {
            let message = "the scalar is named already: keep one `scalar = …`";
            return Err(syn::Error::new(keyword.span(), message));
        }
        self.scalar = Some(scalar);
        Ok(())
    }

    fn read_clause(&mut self, keyword: Ident, input: ParseStream<'_>) -> syn::Result<()> {
        match keyword.to_string().as_str() {
            "coordinates" => {
                let read = coordinates(&keyword, input, &mut self.coordinates);
                self.names_unreadable |= read.is_err();
                read?;
            }
            "function" => {
                let read = Function::read(&keyword, input, &mut self.functions);
                self.functions_unreadable |= read.is_err();
                read?;
            }
            "define" => {
                let read = named(&keyword, input, &mut self.definitions);
                self.names_unreadable |= read.is_err();
                read?;
            }
            "force" => {
                self.forces.push(Vec::new());
                if let Some(forces) = self.forces.last_mut() {
                    named(&keyword, input, forces)?;
                }
            }
            "output" => named(&keyword, input, &mut self.outputs)?,
            "kinetic" => self.kinetic.push(Clause::read(keyword, input)?),
            "potential" => self.potential.push(Clause::read(keyword, input)?),
            "lagrangian" => self.lagrangian.push(Clause::read(keyword, input)?),
            "dissipation" => self.dissipation.push(Clause::read(keyword, input)?),
            "scalar" => self.read_scalar(&keyword, input)?,
            written => {
                // Functions stand in parentheses, and friction is a word of mechanics.
                let fits = |meant: &&str| *meant != "function" || input.peek(token::Paren);
                let meant = similar(written, KEYWORDS).filter(fits);
                let hint = match meant {
                    Some(meant) => format!("did you mean `{meant}`?"),
                    None => no_clause(),
                };
                let message = format!("unknown clause `{written}`: {hint}");
                let mut error = syn::Error::new(keyword.span(), message);
                if let Some(meant) = meant {
                    // Read as what was meant, it leaves nothing missing.
                    let read = self.read_clause(Ident::new(meant, keyword.span()), input);
                    read.unwrap_or_else(|more| error.combine(more));
                }
                return Err(error);
            }
        }
        Ok(())
    }
}

impl Clause {
    fn read(keyword: Ident, input: ParseStream<'_>) -> syn::Result<Self> {
        let expression = equated(&keyword, input)?;
        Ok(Self {
            keyword,
            expression,
        })
    }
}

/// `= expression` after a word.
fn equated(word: &Ident, input: ParseStream<'_>) -> syn::Result<Expr> {
    expression(word, &format!("write `{word} = expression`"), input)
}

/// `= expression` after a word, or an error that says how to write it.
pub(crate) fn expression(word: &Ident, message: &str, input: ParseStream<'_>) -> syn::Result<Expr> {
    if !input.peek(Token![=]) {
        return Err(syn::Error::new(position(word, input), message));
    }
    let equals = input.parse::<Token![=]>()?;
    if input.is_empty() || input.peek(Token![,]) {
        return Err(syn::Error::new_spanned(equals, message));
    }
    input.parse()
}

/// `(name, name, …)` after the keyword.
fn coordinates(
    keyword: &Ident,
    input: ParseStream<'_>,
    names: &mut Vec<Coordinate>,
) -> syn::Result<()> {
    list(keyword, input, "a comma between coordinates", |input| {
        names.push(coordinate(input)?);
        Ok(())
    })
}

fn coordinate(input: ParseStream<'_>) -> syn::Result<Coordinate> {
    let name = word(
        input,
        "coordinates are names: write `coordinates(theta, phi)`",
    )?;
    let length = if input.peek(token::Bracket) {
        Some(family_length(&name, input)?)
    } else {
        None
    };
    if input.peek(Token![:]) {
        return Err(input.error("coordinates have no types: write the name alone"));
    }
    Ok(Coordinate { name, length })
}

/// How many coordinates a family may have.
const LARGEST_FAMILY: usize = 1000;

/// `[5]` behind the name of a family of coordinates.
fn family_length(name: &Ident, input: ParseStream<'_>) -> syn::Result<usize> {
    let content;
    let bracket = syn::bracketed!(content in input);
    let message =
        format!("the size of a family is a number from 1 to {LARGEST_FAMILY}: write `{name}[5]`");
    let length: LitInt = content.parse().map_err(|error| {
        let span = if content.is_empty() {
            bracket.span.join()
        } else {
            error.span()
        };
        syn::Error::new(span, &message)
    })?;
    if !content.is_empty() {
        return Err(content.error(message));
    }
    match length.base10_parse() {
        Ok(number @ 1..=LARGEST_FAMILY) if length.suffix().is_empty() => Ok(number),
        _ => Err(syn::Error::new(length.span(), message)),
    }
}

/// A name, or an error that says what the name is for.
pub(crate) fn word(input: ParseStream<'_>, message: &str) -> syn::Result<Ident> {
    if input.peek(syn::Ident) || !input.peek(syn::Ident::peek_any) {
        return input
            .parse()
            .map_err(|error| syn::Error::new(error.span(), message));
    }
    let keyword = input.call(Ident::parse_any)?;
    let message = match keyword.to_string().as_str() {
        "self" | "Self" | "super" | "crate" | "_" => message.to_owned(),
        word => format!("`{word}` is a keyword of Rust: write `r#{word}`, or choose another name"),
    };
    Err(syn::Error::new(keyword.span(), message))
}

/// `(name = expression, …)` after a keyword.
fn named(keyword: &Ident, input: ParseStream<'_>, items: &mut Vec<Named>) -> syn::Result<()> {
    list(keyword, input, "a comma, or an operator,", |input| {
        items.push(Named::read(keyword, input)?);
        Ok(())
    })
}

impl Named {
    fn read(keyword: &Ident, input: ParseStream<'_>) -> syn::Result<Self> {
        let name = word(input, &format!("write `{keyword}(name = expression, …)`"))?;
        let mut indices = Vec::new();
        while input.peek(token::Bracket) {
            let content;
            let bracket = syn::bracketed!(content in input);
            let message =
                format!("write one index in brackets, as in `{name}[i] = … for i in 0..5`");
            if content.is_empty() {
                return Err(syn::Error::new(bracket.span.join(), message));
            }
            indices.push(content.parse()?);
            if !content.is_empty() {
                return Err(content.error(message));
            }
        }
        let expression = equated(&name, input)?;
        let mut iterations = Vec::new();
        while let Some(word) = input.parse::<Option<Token![for]>>()? {
            iterations.push(Iteration::read(word, input)?);
        }
        Ok(Self {
            name,
            indices,
            expression,
            iterations,
        })
    }
}

impl Iteration {
    /// `i in 0..5` behind `for`.
    fn read(keyword: Token![for], input: ParseStream<'_>) -> syn::Result<Self> {
        let message = "write `for i in 0..5`";
        let here = |input: ParseStream<'_>, before: Span| {
            let nothing = input.is_empty() || input.peek(Token![,]);
            syn::Error::new(if nothing { before } else { input.span() }, message)
        };
        let index: Ident = input.parse().map_err(|_| here(input, keyword.span))?;
        let between: Token![in] = input.parse().map_err(|_| here(input, index.span()))?;
        if input.is_empty() || input.peek(Token![,]) {
            return Err(here(input, between.span));
        }
        let range = input.parse()?;
        Ok(Self { index, range })
    }
}

/// `(item, item, …)` after a keyword.
fn list(
    keyword: &Ident,
    input: ParseStream<'_>,
    separator: &str,
    read: impl FnMut(ParseStream<'_>) -> syn::Result<()>,
) -> syn::Result<()> {
    if !input.peek(token::Paren) {
        let message = match keyword.to_string().as_str() {
            "coordinates" => "write `coordinates(theta, phi)`".to_owned(),
            word => format!("write `{word}(name = expression, …)`"),
        };
        return Err(syn::Error::new(position(keyword, input), message));
    }
    let content;
    syn::parenthesized!(content in input);
    separated(&content, separator, read)
}

/// Reads what commas separate, up to the end. Where an item cannot be read, reading goes on behind the
/// next comma, so that one look shows all errors; they are returned together.
pub(crate) fn separated(
    input: ParseStream<'_>,
    separator: &str,
    mut read: impl FnMut(ParseStream<'_>) -> syn::Result<()>,
) -> syn::Result<()> {
    let mut errors: Option<syn::Error> = None;
    while !input.is_empty() {
        // What is read halfway is read again as mere tokens, which cannot fail.
        let item = input.fork();
        let result = read(&item).and_then(|()| {
            if item.is_empty() || item.peek(Token![,]) {
                Ok(())
            } else {
                Err(item.error(format!("write {separator} before this")))
            }
        });
        match (result, &mut errors) {
            (Ok(()), _) => input.advance_to(&item),
            (Err(error), Some(errors)) => errors.combine(error),
            (Err(error), None) => errors = Some(error),
        }
        while !input.is_empty() && !input.peek(Token![,]) {
            input.parse::<TokenTree>()?;
        }
        input.parse::<Option<Token![,]>>()?;
    }
    errors.map_or(Ok(()), Err)
}

/// Where an error about what follows `word` is shown: there, or at the word if nothing follows.
pub(crate) fn position(word: &Ident, input: ParseStream<'_>) -> Span {
    if input.is_empty() || input.peek(Token![,]) {
        word.span()
    } else {
        input.span()
    }
}

fn no_clause() -> String {
    format!("write a clause: one of `{}`", KEYWORDS.join("`, `"))
}
