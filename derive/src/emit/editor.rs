//! Support for editors: every mention of fields, coordinates, functions and definitions.
//!
//! An editor resolves a word in an attribute if the word, with its span, occurs in the emitted code. The impls
//! read each field once; here every mention is repeated, in a method that nobody calls: a field as the field, a
//! coordinate as the constant that holds its index, a definition or a function as a variable, and a function's
//! arguments as those of a closure.

use std::collections::BTreeSet;

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use quote::{ToTokens, quote};

use crate::syntax::clauses::Clauses;
use crate::syntax::declaration::Declaration;
use crate::syntax::external_function::FunctionDeclaration;
use crate::syntax::named::NamedExpression;
use crate::syntax::names::{constant_name, hygienic_ident, unraw};

/// The method with all mentions: a tuple for each expression.
pub(crate) fn method(declaration: &Declaration) -> TokenStream {
    let clauses = &declaration.clauses;
    let names = KnownNames::of(declaration);
    let functions = clauses.functions.iter().map(|function| &function.name);
    let definitions = clauses.definitions.iter();
    let definitions = definitions.map(|definition| &definition.name);
    let mut once = BTreeSet::new();
    let variables = functions.chain(definitions);
    let variables = variables.filter(|name| names.is_variable(name) && once.insert(unraw(name)));
    let variables = variables.map(|name| hygienic_ident(&unraw(name), name));
    let variables: Vec<_> = variables.collect();
    let count = variables.len();
    let variables = (count > 0).then(|| quote!(let [#(#variables),*] = [(); #count];));
    let mentions = expressions(clauses).map(|tokens| names.mentions(tokens));
    let mentions = mentions.filter(|mentions| !mentions.is_empty());
    let derivatives = clauses.functions.iter();
    let derivatives = derivatives.map(|function| names.derivatives(function));
    quote! {
        #[doc(hidden)]
        fn __mentions(&self) {
            #variables
            #(let _ = (#mentions);)*
            #(let _ = #derivatives;)*
        }
    }
}

/// All expressions of the declaration, and the names on which forces act.
fn expressions(clauses: &Clauses) -> impl Iterator<Item = TokenStream> {
    let energies = [
        &clauses.kinetic,
        &clauses.potential,
        &clauses.lagrangian,
        &clauses.dissipation,
    ];
    let energies = energies.into_iter().flatten();
    let energies = energies.map(|clause| clause.expression.to_token_stream());
    let lists = [&clauses.definitions, &clauses.outputs];
    let lists = lists.into_iter().chain(&clauses.forces);
    let lists = lists.flatten().flat_map(|named: &NamedExpression| {
        let indices = named.indices.iter().map(ToTokens::to_token_stream);
        let ranges = named.iterations.iter();
        let ranges = ranges.map(|iteration| iteration.range.to_token_stream());
        let expression = named.expression.to_token_stream();
        indices.chain(ranges).chain([expression])
    });
    let forces = clauses.forces.iter().flatten();
    let forces = forces.map(|force| force.name.to_token_stream());
    energies.chain(lists).chain(forces)
}

/// The names that are mentioned.
struct KnownNames {
    fields: BTreeSet<String>,
    coordinates: BTreeSet<String>,
    functions: BTreeSet<String>,
    definitions: BTreeSet<String>,
}

impl KnownNames {
    fn of(declaration: &Declaration) -> Self {
        let Clauses {
            coordinates,
            definitions,
            functions,
            ..
        } = &declaration.clauses;
        let fields: BTreeSet<String> = declaration
            .fields
            .iter()
            .map(|field| unraw(&field.name))
            .collect();
        let coordinates: BTreeSet<String> = coordinates
            .iter()
            .map(|coordinate| unraw(&coordinate.name))
            .filter(|name| !fields.contains(name))
            .collect();
        let functions = functions.iter().map(|function| unraw(&function.name));
        let definitions = definitions
            .iter()
            .map(|definition| unraw(&definition.name))
            .filter(|name| !fields.contains(name) && !coordinates.contains(name))
            .filter(|name| can_be_variable(name))
            .collect();
        Self {
            fields,
            coordinates,
            functions: functions.filter(|name| can_be_variable(name)).collect(),
            definitions,
        }
    }

    /// Whether there is a variable for a definition or a function.
    fn is_variable(&self, name: &Ident) -> bool {
        let name = unraw(name);
        self.definitions.contains(&name) || self.functions.contains(&name)
    }

    /// What the derivatives of a function mention, as closures of its arguments.
    fn derivatives(&self, function: &FunctionDeclaration) -> TokenStream {
        let written = function.arguments.iter().map(unraw).collect();
        let inner = Self {
            fields: &self.fields - &written,
            coordinates: BTreeSet::new(),
            functions: self.functions.clone(),
            definitions: written
                .into_iter()
                .filter(|name| can_be_variable(name))
                .collect(),
        };
        let mut once = BTreeSet::new();
        let arguments = function.arguments.iter();
        let arguments: Vec<_> = arguments
            .filter(|argument| inner.definitions.contains(&unraw(argument)))
            .filter(|argument| once.insert(unraw(argument)))
            .map(|argument| hygienic_ident(&unraw(argument), argument))
            .collect();
        let mut mentions = TokenStream::new();
        for derivative in &function.derivatives {
            mentions.extend(inner.named(&derivative.argument));
            inner.mention(derivative.expression.to_token_stream(), &mut mentions);
        }
        quote!(|#(#arguments: ()),*| (#(#arguments,)* #mentions))
    }

    /// What `tokens` mention.
    fn mentions(&self, tokens: TokenStream) -> TokenStream {
        let mut mentions = TokenStream::new();
        self.mention(tokens, &mut mentions);
        mentions
    }

    /// Adds what `tokens` mention. A word after a dot or before parentheses is that of a function.
    fn mention(&self, tokens: TokenStream, mentions: &mut TokenStream) {
        let mut tokens = tokens.into_iter().peekable();
        let mut after_a_dot = false;
        while let Some(token) = tokens.next() {
            let called = matches!(
                tokens.peek(),
                Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis
            );
            match &token {
                TokenTree::Ident(name) if called && self.functions.contains(&unraw(name)) => {
                    let variable = hygienic_ident(&unraw(name), name);
                    mentions.extend(quote!(#variable,));
                }
                TokenTree::Ident(name) if !(after_a_dot || called) => {
                    mentions.extend(self.named(name));
                }
                TokenTree::Group(group) => self.mention(group.stream(), mentions),
                _ => {}
            }
            // Two dots are a range.
            let dot = matches!(&token, TokenTree::Punct(punct) if punct.as_char() == '.');
            after_a_dot = dot && !after_a_dot;
        }
    }

    /// A mention of what a name refers to, if it refers to something.
    fn named(&self, name: &Ident) -> Option<TokenStream> {
        let written = unraw(name);
        if self.fields.contains(&written) {
            return Some(quote!(&self.#name,));
        }
        if self.coordinates.contains(&written) {
            let constant = hygienic_ident(&constant_name(name), name);
            return Some(quote!(Self::#constant,));
        }
        let variable = hygienic_ident(&written, name);
        let defined = self.definitions.contains(&written);
        defined.then(|| quote!(#variable,))
    }
}

/// A constant or a unit struct of the same name would make a pattern of a variable, and those are written in
/// capitals; a keyword is no variable.
fn can_be_variable(name: &str) -> bool {
    let capital = name.chars().any(char::is_uppercase);
    !capital && syn::parse_str::<Ident>(name).is_ok()
}
