//! The impl of `Reflect`: the fields of a model by their names, and its numbers one by one.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote, quote_spanned};
use syn::GenericParam;
use syn::spanned::Spanned as _;

use super::emitter::Emitter;
use super::on_another_scalar::{conditions_beside, replaced, scalar_parameter};
use crate::syntax::body_type::BodyType;
use crate::syntax::declaration::Declaration;
use crate::syntax::field::{Field, Role};
use crate::syntax::field_type::Content;
use crate::syntax::names::unraw;
use crate::syntax::root::Root;
use crate::syntax::scalar::Scalar;

impl Emitter<'_> {
    /// The impl of `Reflect`; nothing without the clause.
    pub(super) fn reflect(&self) -> TokenStream {
        let declaration = self.declaration;
        if declaration.clauses.reflect.is_none() {
            return TokenStream::new();
        }
        let (root, name) = (&declaration.root, unraw(&declaration.name));
        let documentation = without_indentation(&declaration.documentation);
        let n = self.coordinates();
        let described = || {
            declaration
                .fields
                .iter()
                .filter(|field| field.role != Role::Skipped)
        };
        let fields = described().map(|field| Description::of_field(field).tokens(root));
        let reads = declaration.fields.iter().map(read);
        let writes = described().map(|Field { name, ty, .. }| {
            let field = quote!(&self.#name);
            quote_spanned!(ty.span()=> #root::quantities::FieldValue::write(#field, each);)
        });
        let names = quote!(&'static [&'static ::core::primitive::str]);
        let inputs = self
            .has_inputs()
            .then(|| quote!(const INPUTS: #names = &Self::INPUTS;));
        let has_events = !self.lowered.events.is_empty();
        let events = has_events.then(|| quote!(const EVENTS: #names = &Self::EVENTS;));
        let (outputs, multipliers) = (self.reflected_outputs(), self.reflected_multipliers());
        let items = quote! {
            const NAME: &'static ::core::primitive::str = #name;
            const DOCUMENTATION: &'static ::core::primitive::str = #documentation;
            const FIELDS: &'static [#root::quantities::FieldDescription] = &[#(#fields),*];
            fn read_fields(
                numbers: &mut #root::quantities::FieldReader<'_>,
            ) -> ::core::result::Result<Self, #root::quantities::InvalidNumbers> {
                ::core::result::Result::Ok(Self { #(#reads),* })
            }
            fn numbers(&self, each: &mut dyn ::core::ops::FnMut(::core::primitive::f64)) {
                #(#writes)*
            }
            #outputs
            #inputs
            #events
            #multipliers
        };
        implementation(
            declaration,
            &self.scalar,
            &n.to_token_stream(),
            None,
            &items,
        )
    }

    /// The descriptions and the numbers of outputs.
    fn reflected_outputs(&self) -> TokenStream {
        let Declaration { root, clauses, .. } = self.declaration;
        if clauses.outputs.is_empty() {
            return TokenStream::new();
        }
        let n = self.coordinates();
        let named = clauses.outputs.iter().zip(&self.lowered.outputs);
        let descriptions = named.map(|(output, shape)| {
            let description = Description {
                name: &output.name,
                documentation: String::new(),
                lengths: shape.lengths(),
                body: None,
                is_input: false,
            };
            description.tokens(root)
        });
        let writes = clauses.outputs.iter().map(|output| {
            let name = &output.name;
            quote!(#root::quantities::FieldValue::write(&outputs.#name, each);)
        });
        quote! {
            const OUTPUTS: &'static [#root::quantities::FieldDescription] = &[#(#descriptions),*];
            fn output_numbers(
                &self,
                state: &#root::State<::core::primitive::f64, #n>,
                each: &mut dyn ::core::ops::FnMut(::core::primitive::f64),
            ) {
                let outputs = #root::Lagrangian::<#n, ::core::primitive::f64>::outputs(self, state);
                #(#writes)*
            }
        }
    }

    /// The names and the numbers of multipliers.
    fn reflected_multipliers(&self) -> TokenStream {
        if !self.is_constrained() {
            return TokenStream::new();
        }
        let root = &self.declaration.root;
        let (n, c) = (self.coordinates(), self.constraint_count());
        quote! {
            const CONSTRAINTS: &'static [&'static ::core::primitive::str] = &Self::CONSTRAINTS;
            fn multiplier_numbers(
                &self,
                state: &#root::State<::core::primitive::f64, #n>,
                each: &mut dyn ::core::ops::FnMut(::core::primitive::f64),
            ) {
                let multipliers =
                    #root::Lagrangian::<#n, ::core::primitive::f64>::multipliers::<#c>(self, state);
                #root::quantities::FieldValue::write(&multipliers, each);
            }
        }
    }
}

/// `impl<…> Reflect<N> for Model<f64>`, with one more parameter where the number of coordinates is not known.
pub(super) fn implementation(
    declaration: &Declaration,
    scalar: &Scalar<'_>,
    dimension: &TokenStream,
    parameter: Option<&TokenStream>,
    items: &TokenStream,
) -> TokenStream {
    let Declaration { name, root, .. } = declaration;
    let mut generics = declaration.generics.clone();
    let (_, arguments, _) = declaration.generics.split_for_impl();
    let mut arguments = arguments.to_token_stream();
    if let Some(own) = scalar_parameter(&declaration.generics, scalar) {
        let double = quote!(::core::primitive::f64);
        let conditions = conditions_beside(&generics, &own).into_iter();
        let conditions: Vec<_> = conditions
            .map(|condition| replaced(condition, &own, &double))
            .collect();
        generics.params = generics
            .params
            .into_iter()
            .filter(|parameter| !matches!(parameter, GenericParam::Type(ty) if ty.ident == own))
            .collect();
        generics.where_clause =
            (!conditions.is_empty()).then(|| syn::parse_quote!(where #(#conditions),*));
        arguments = replaced(arguments, &own, &double);
    }
    if let Some(parameter) = parameter {
        generics.params.push(syn::parse_quote!(#parameter));
    }
    let (generics, _, conditions) = generics.split_for_impl();
    quote! {
        #[automatically_derived]
        impl #generics #root::quantities::Reflect<#dimension> for #name #arguments #conditions {
            #items
        }
    }
}

/// `name: value`, which reads a field.
fn read(field: &Field) -> TokenStream {
    let name = &field.name;
    if field.role == Role::Skipped {
        return quote_spanned!(field.ty.span()=> #name: ::core::default::Default::default());
    }
    let (reader, text) = (quote!(numbers), unraw(name));
    // A type that is not made from numbers is an error at the type.
    quote_spanned!(field.ty.span()=> #name: #reader.field(#text)?)
}

/// What is said of a field or an output.
struct Description<'a> {
    name: &'a Ident,
    documentation: String,
    /// The lengths of the arrays, vectors and matrices, from the outermost.
    lengths: Vec<usize>,
    body: Option<BodyType>,
    is_input: bool,
}

impl<'a> Description<'a> {
    fn of_field(field: &'a Field) -> Self {
        let (mut all_lengths, mut body) = (Vec::new(), None);
        // A type that is not supported is an error elsewhere.
        if let Ok(ty) = field.field_type() {
            all_lengths.extend_from_slice(ty.array_lengths());
            match ty.content() {
                Content::Numbers(shape) => all_lengths.extend(shape.lengths()),
                Content::Body(found) => body = Some(found),
            }
        }
        Self {
            name: &field.name,
            documentation: without_indentation(&field.documentation),
            lengths: all_lengths,
            body,
            is_input: field.role == Role::Input,
        }
    }

    fn tokens(&self, root: &Root) -> TokenStream {
        let Self {
            documentation,
            lengths,
            is_input,
            ..
        } = self;
        let name = unraw(self.name);
        let element = match self.body {
            None => quote!(Number),
            Some(BodyType::Rigid) => quote!(RigidBody),
            Some(BodyType::Principal) => quote!(PrincipalBody),
            Some(BodyType::Symmetric) => quote!(SymmetricBody),
        };
        quote! {
            #root::quantities::FieldDescription {
                name: #name,
                documentation: #documentation,
                lengths: &[#(#lengths),*],
                element: #root::quantities::FieldElement::#element,
                is_input: #is_input,
            }
        }
    }
}

/// The lines of a documentation without the space behind `///`.
fn without_indentation(documentation: &str) -> String {
    let lines = documentation.lines();
    let lines: Vec<_> = lines
        .map(|line| line.strip_prefix(' ').unwrap_or(line))
        .collect();
    lines.join("\n")
}
