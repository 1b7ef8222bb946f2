//! What is known of a model at compile time, as constants of its type.

use lagrangian_symbolic::{Listing, OperationCount};
use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::documentation;
use super::editor;
use super::emitter::Emitter;
use super::implementation;
use crate::syntax::coordinate::indices;
use crate::syntax::names::{constant_name, hygienic_ident};

impl Emitter<'_> {
    /// What is known of the model at compile time, as constants of its type.
    pub(super) fn constants(&self) -> TokenStream {
        let root = &self.declaration.root;
        let name = &self.declaration.name;
        let visibility = &self.declaration.visibility;
        let (generics, arguments, conditions) = self.declaration.generics.split_for_impl();
        let n = self.coordinates();
        let Listing { unicode, latex } = self.listing;
        let documentation = documentation::of(self, unicode);
        let coordinates = &self.lowered.quantities.coordinates;
        let names = coordinates.iter().map(ToString::to_string);
        let operations = self.operations();
        let mentions = editor::method(self.declaration);
        let indices = indices(&self.declaration.clauses.coordinates);
        let indices = indices.map(|(coordinate, indices)| {
            let constant = hygienic_ident(&constant_name(&coordinate.name), &coordinate.name);
            let text = coordinate.documentation();
            let (ty, value) = coordinate.constant(indices.start);
            quote!(#[doc = #text] #visibility const #constant: #ty = #value;)
        });
        let inputs = self.input_constants();
        let events = self.event_constants();
        let constraints = self.constraint_constants();
        let conserved = self.conservation_constants();
        let requested = self.requested_constants();
        // A lifetime of the struct stands in its impl but once.
        let lifetimes = self.declaration.generics.lifetimes().next().is_some();
        let lints = lifetimes.then(|| quote!(#[allow(single_use_lifetimes)]));
        quote! {
            #[doc = #documentation]
            #lints
            impl #generics #name #arguments #conditions {
                /// The names of the coordinates, in order.
                #visibility const COORDINATES: [&'static str; #n] = [#(#names),*];
                #(#indices)*
                #inputs
                #events
                #constraints
                #conserved
                #requested
                /// The equations of motion as they were derived, in lines of Unicode.
                #visibility const EQUATIONS: &'static str = #unicode;
                /// The same in displays of LaTeX, for `amsmath`, `KaTeX` and `MathJax`.
                #visibility const LATEX: &'static str = #latex;
                /// The operation counts of the methods.
                #visibility const OPERATIONS: #root::Operations = #operations;
                #mentions
            }
        }
    }

    fn operations(&self) -> TokenStream {
        let root = &self.declaration.root;
        let counts = self.methods.counted();
        let counts = counts.map(|(_, method)| method.map(|method| method.count));
        let counts = counts.map(|count| count.unwrap_or_default().by_kind());
        let counts: Vec<_> = counts.collect();
        let kinds = OperationCount::default().by_kind().len();
        let kinds = (0..kinds).map(|kind| {
            let counts = counts.iter();
            let counts = counts.map(|count| Literal::usize_unsuffixed(count[kind]));
            quote!([#(#counts),*])
        });
        quote!(#root::__private::operations([#(#kinds),*]))
    }

    pub(super) fn system(&self) -> TokenStream {
        let root = &self.declaration.root;
        let n = self.signatures().dimension;
        let structure = &self.equations.coordinate_properties;
        let (angles, ignorable) = (&structure.angles, &structure.ignorable);
        let periods = structure.periods.iter();
        let periods = periods.map(|turns| Literal::u32_unsuffixed(*turns));
        let singularities = structure.singularities.iter().map(|coordinates| {
            let coordinates = coordinates.iter().map(|i| Literal::u32_unsuffixed(*i));
            quote!(&[#(#coordinates),*])
        });
        let poles = self.poles.iter().map(|i| Literal::u32_unsuffixed(*i));
        let [has_angles, has_ignorable] = [angles, ignorable].map(|all| all.contains(&true));
        let is_periodic = structure.periods.iter().any(|turns| *turns > 0);
        let may_be_singular = structure
            .singularities
            .iter()
            .any(|found| !found.is_empty());
        // The others have the defaults of the trait.
        let constants = [
            has_angles.then(|| quote!(ANGLES: [bool; #n] = [#(#angles),*])),
            is_periodic.then(|| quote!(PERIODS: [u32; #n] = [#(#periods),*])),
            has_ignorable.then(|| quote!(IGNORABLE: [bool; #n] = [#(#ignorable),*])),
            may_be_singular
                .then(|| quote!(SINGULARITIES: [&'static [usize]; #n] = [#(#singularities),*])),
            self.methods
                .stays_regular
                .then(|| quote!(STAYS_REGULAR: bool = true)),
            (!self.poles.is_empty()).then(|| quote!(POLES: &'static [usize] = &[#(#poles),*])),
        ];
        let constants = constants.into_iter().flatten();
        let items = quote! {
            const COORDINATES: [&'static str; #n] = Self::COORDINATES;
            #(const #constants;)*
        };
        let interface = quote!(#root::GeneralizedCoordinates<#n>);
        let generics = &self.declaration.generics;
        implementation::of_trait(self.declaration, generics, &interface, &items)
    }
}
