//! Where the declaration speaks of fields, coordinates, functions and definitions, for editors.
//!
//! An editor knows what a word in an attribute means if the word, with its place, stands in the emitted
//! code where the compiler resolves it. The impls read each field once; here every mention stands, in a
//! method that nobody calls: of a field as the field, of a coordinate as the constant that holds its
//! index, of a definition or a function as a variable, and of a function's arguments as those of a closure.

use std::collections::BTreeSet;

use proc_macro2::{Delimiter, Ident, TokenStream, TokenTree};
use quote::{ToTokens, quote};

use crate::clauses::Clauses;
use crate::declaration::Declaration;
use crate::function::Function;
use crate::named::Named;
use crate::names::{constant, placed, plain};

/// The method with all mentions.
pub(crate) fn method(declaration: &Declaration) -> TokenStream {
    let clauses = &declaration.clauses;
    let mut names = Names::of(declaration);
    let functions = clauses.functions.iter().map(|function| &function.name);
    let definitions = clauses.definitions.iter();
    let definitions = definitions.map(|definition| &definition.name);
    let defined: TokenStream = functions
        .chain(definitions)
        .filter(|name| names.is_variable(name) && names.once.insert(plain(name)))
        .map(|name| {
            let name = placed(&plain(name), name);
            quote!(let #name = ();)
        })
        .collect();
    let mut mentions = TokenStream::new();
    for tokens in spoken(clauses) {
        names.mention(tokens, &mut mentions);
    }
    for function in &clauses.functions {
        mentions.extend(names.derivatives(function));
    }
    quote! {
        #[doc(hidden)]
        fn __mentions(&self) {
            #defined
            let _ = (#mentions);
        }
    }
}

/// All expressions of the declaration, and the names on which forces act.
fn spoken(clauses: &Clauses) -> impl Iterator<Item = TokenStream> {
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
    let lists = lists.flatten().flat_map(|named: &Named| {
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
struct Names {
    fields: BTreeSet<String>,
    coordinates: BTreeSet<String>,
    functions: BTreeSet<String>,
    definitions: BTreeSet<String>,
    /// Definitions that are variables already.
    once: BTreeSet<String>,
}

impl Names {
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
            .map(|field| plain(&field.name))
            .collect();
        let coordinates: BTreeSet<String> = coordinates
            .iter()
            .map(|coordinate| plain(&coordinate.name))
            .filter(|name| !fields.contains(name))
            .collect();
        let functions = functions.iter().map(|function| plain(&function.name));
        let definitions = definitions
            .iter()
            .map(|definition| plain(&definition.name))
            .filter(|name| !fields.contains(name) && !coordinates.contains(name))
            .filter(|name| can_be_variable(name))
            .collect();
        Self {
            fields,
            coordinates,
            functions: functions.filter(|name| can_be_variable(name)).collect(),
            definitions,
            once: BTreeSet::new(),
        }
    }

    /// Whether there is a variable for a definition or a function.
    fn is_variable(&self, name: &Ident) -> bool {
        let name = plain(name);
        self.definitions.contains(&name) || self.functions.contains(&name)
    }

    /// What the derivatives of a function mention, as closures of its arguments.
    fn derivatives(&self, function: &Function) -> TokenStream {
        let written = function.arguments.iter().map(plain).collect();
        let inner = Self {
            fields: &self.fields - &written,
            coordinates: BTreeSet::new(),
            functions: self.functions.clone(),
            definitions: written
                .into_iter()
                .filter(|name| can_be_variable(name))
                .collect(),
            once: BTreeSet::new(),
        };
        let mut once = BTreeSet::new();
        let arguments = function.arguments.iter();
        let arguments: Vec<_> = arguments
            .filter(|argument| inner.definitions.contains(&plain(argument)))
            .filter(|argument| once.insert(plain(argument)))
            .map(|argument| placed(&plain(argument), argument))
            .collect();
        let mut mentions = TokenStream::new();
        for derivative in &function.derivatives {
            mentions.extend(inner.named(&derivative.argument));
            inner.mention(derivative.expression.to_token_stream(), &mut mentions);
        }
        quote!(|#(#arguments: ()),*| (#(#arguments,)* #mentions),)
    }

    /// Adds what `tokens` mention. A word behind a point or before parentheses is a function's.
    fn mention(&self, tokens: TokenStream, mentions: &mut TokenStream) {
        let mut tokens = tokens.into_iter().peekable();
        let mut behind_a_point = false;
        while let Some(token) = tokens.next() {
            let called = matches!(
                tokens.peek(),
                Some(TokenTree::Group(group)) if group.delimiter() == Delimiter::Parenthesis
            );
            match &token {
                TokenTree::Ident(name) if called && self.functions.contains(&plain(name)) => {
                    let variable = placed(&plain(name), name);
                    mentions.extend(quote!(#variable,));
                }
                TokenTree::Ident(name) if !(behind_a_point || called) => {
                    mentions.extend(self.named(name));
                }
                TokenTree::Group(group) => self.mention(group.stream(), mentions),
                _ => {}
            }
            // Two points are a range.
            let point = matches!(&token, TokenTree::Punct(punct) if punct.as_char() == '.');
            behind_a_point = point && !behind_a_point;
        }
    }

    /// What speaks of what a name stands for, if it stands for something.
    fn named(&self, name: &Ident) -> Option<TokenStream> {
        let written = plain(name);
        if self.fields.contains(&written) {
            return Some(quote!(&self.#name,));
        }
        if self.coordinates.contains(&written) {
            let constant = placed(&constant(name), name);
            return Some(quote!(Self::#constant,));
        }
        let variable = placed(&written, name);
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

#[cfg(test)]
mod tests {
    use crate::expand::expand;

    /// What is mentioned, in order.
    fn mentions(declaration: &str) -> String {
        let items = expand(declaration.parse().expect("the declaration is of tokens"));
        let items = items.to_string();
        let (_, method) = items
            .split_once("fn __mentions")
            .expect("there is a method");
        let (_, tuple) = method.split_once("let _ = (").expect("there is a tuple");
        let (tuple, _) = tuple.split_once(") ;").expect("the tuple ends");
        tuple.replace(' ', "")
    }

    #[test]
    fn every_word_is_mentioned_where_it_is_spoken_of() {
        let written = mentions(
            "#[lagrangian(
                coordinates(theta[3], x),
                define(h[i] = l * cos(theta[i]) for i in 0..3, Capital = x, r#loop = x),
                kinetic = 0.5 * m * dot(x).powi(2) + (0..h.len()).map(|i| dot(h[i]).powi(2)).sum(),
                potential = v.x * x.min(m) + Capital + r#loop + PI * t,
                force(theta[0] = -m, x = sin(x)),
                output(height = h[1]),
            )]
            struct Model { m: f64, l: f64, v: [f64; 3] }",
        );
        // Functions, components behind points, and variables of closures are no mentions.
        let expected = [
            "&self.m,Self::X,h,h,",
            "&self.v,Self::X,&self.m,",
            "&self.l,Self::THETA,Self::X,Self::X,",
            "&self.m,Self::X,h,",
            "Self::THETA,Self::X,",
        ];
        let sorted = |text: &str| {
            let mut words: Vec<String> = text.split(',').map(str::to_owned).collect();
            words.sort();
            words
        };
        assert_eq!(sorted(&written), sorted(&expected.concat()), "{written}");
    }

    #[test]
    fn functions_and_their_arguments_are_mentioned() {
        let written = mentions(
            "#[lagrangian(
                coordinates(x),
                function(drag(x, Area) = self.c * x, derivative(x) = m * slope(x) * Area, derivative(Area) = 0.0),
                function(slope(v) = 1.0, derivative(v) = 0.0),
                kinetic = 0.5 * m * dot(x).powi(2),
                force(x = -drag(x, m).slope() + drag),
            )]
            struct Model { m: f64 }",
        );
        // An argument hides the coordinate, and what is no variable is left out.
        let energies = "&self.m,Self::X,";
        let forces = "drag,Self::X,&self.m,slope,Self::X,";
        let derivatives = "|x:()|(x,x,&self.m,slope,x,),|v:()|(v,v,),";
        assert_eq!(written, [energies, forces, derivatives].concat());
    }

    #[test]
    fn a_declaration_with_an_error_is_understood_by_editors_too() {
        let written = mentions(
            "#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), potential = m * )]
            struct Model { m: f64 }",
        );
        assert_eq!(written, "&self.m,Self::X,");
    }
}
