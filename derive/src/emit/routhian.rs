//! What is emitted for the clause `routhian`: the reduced struct, and the impls that lead there and back.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::emitter::Emitter;
use super::implementation;
use super::parameters::{marked_if_unused, mentions};
use crate::plan::{ParameterSource, ReducedMethods};
use crate::reduce::{ReducedDeclaration, Split};
use crate::syntax::declaration::Declaration;
use crate::syntax::field::Role;
use crate::syntax::names::unraw;

/// The struct of a reduced model.
pub(crate) fn reduced_struct(full: &Declaration, reduced: &Declaration) -> TokenStream {
    let Declaration {
        name,
        visibility,
        generics,
        fields,
        ..
    } = reduced;
    let conditions = &generics.where_clause;
    let documentation = format!(
        "[`{}`] without its ignorable coordinates, whose momenta are parameters: the model whose Lagrangian is −R, with the \
         Routhian R = Σ p q̇ − L (4.9).",
        full.name
    );
    let definitions = fields.iter().map(|field| {
        let (visibility, name, ty) = (&field.visibility, &field.name, &field.ty);
        let written = unraw(name);
        let own = full.fields.iter().any(|other| other.name == *name);
        let text = if own {
            format!("`{written}` of [`{}`].", full.name)
        } else {
            let coordinate = written.trim_start_matches("p_");
            format!("The constant momentum of `{coordinate}`.")
        };
        quote!(#[doc = #text] #visibility #name: #ty)
    });
    let shown = fields.iter().filter(|field| field.role != Role::Skipped);
    let shown = shown.map(|field| {
        let (name, written) = (&field.name, unraw(&field.name));
        quote!(.field(#written, &self.#name))
    });
    let skips = fields.iter().any(|field| field.role == Role::Skipped);
    let finish = if skips {
        quote!(finish_non_exhaustive)
    } else {
        quote!(finish)
    };
    let written = unraw(name);
    let items = quote! {
        fn fmt(&self, f: &mut ::core::fmt::Formatter<'_>) -> ::core::fmt::Result {
            f.debug_struct(#written) #(#shown)* .#finish()
        }
    };
    let interface = quote!(::core::fmt::Debug);
    let debug = implementation::of_trait(reduced, generics, &interface, &items);
    quote! {
        #[doc = #documentation]
        #[derive(::core::clone::Clone)]
        #[allow(missing_copy_implementations)]
        #visibility struct #name #generics #conditions {
            #(#definitions),*
        }
        #debug
    }
}

impl Emitter<'_> {
    /// The impl of `RouthReduction` for the full model.
    pub(crate) fn routh_reduction(&self, reduced: &ReducedDeclaration) -> TokenStream {
        let Declaration { root, generics, .. } = self.declaration;
        let (_, arguments, _) = generics.split_for_impl();
        let scalar = self.scalar.of_parameters();
        let (n, remaining) = (self.coordinates(), &reduced.split.remaining);
        let left = remaining.len();
        let target = &reduced.declaration.name;
        let own = self.declaration.fields.iter();
        let own = own.map(|field| {
            let name = &field.name;
            quote!(#name: ::core::clone::Clone::clone(&self.#name))
        });
        let constants = reduced.declaration.fields.iter();
        let constants = constants.skip(self.declaration.fields.len());
        let constants = constants.zip(&reduced.split.ignorable).map(|(field, i)| {
            let (name, i) = (&field.name, Literal::usize_unsuffixed(*i));
            quote!(#name: momenta[#i])
        });
        let indices: Vec<Literal> = remaining
            .iter()
            .map(|i| Literal::usize_unsuffixed(*i))
            .collect();
        let items = quote! {
            type Scalar = #scalar;
            type Reduced = #target #arguments;
            fn reduce(
                &self,
                state: &#root::State<#scalar, #n>,
            ) -> (Self::Reduced, #root::State<#scalar, #left>) {
                let momenta = #root::Lagrangian::<#n, #scalar>::momenta(self, state);
                let reduced = #target { #(#own,)* #(#constants),* };
                let state = #root::State::new(state.t, #root::__private::vector([#(state.q[#indices]),*]), #root::__private::vector([#(state.v[#indices]),*]));
                (reduced, state)
            }
        };
        let interface = quote!(#root::RouthReduction<#n, #left>);
        implementation::of_trait(self.declaration, generics, &interface, &items)
    }

    /// The impls of `Routhian` and `RouthianSeries` for the reduced model.
    pub(crate) fn routhian(
        &self,
        reduced: &ReducedDeclaration,
        methods: &ReducedMethods,
        full: &Emitter<'_>,
    ) -> TokenStream {
        let (root, scalar) = (&self.declaration.root, &self.scalar);
        let (n, k) = (self.coordinates(), reduced.split.ignorable.len());
        let all = n + k;
        let signatures = self.signatures();
        let state = signatures.state();
        let vector = quote!(#root::__private::SVector<#scalar, #k>);
        let labels = &full.lowered.quantities.coordinates;
        let names = reduced
            .split
            .ignorable
            .iter()
            .map(|i| labels[*i].to_string());
        let constants = self.lowered.quantities.parameters.iter();
        let constants = constants.skip(full.lowered.quantities.parameters.len());
        let constants = constants.map(|constant| self.read(constant));
        let potential = self.body(&methods.effective_potential, ParameterSource::Fields, &[]);
        let potential = self.at_own_inputs(potential);
        let of_potential = marked_if_unused(quote!(state: #state), &potential);
        let velocities = &methods.ignorable_velocities;
        let velocities = self.body(velocities, ParameterSource::Prepared, &[]);
        let prepared = signatures.prepared;
        let of_velocities = quote!(state: #state, prepared: &#prepared);
        let of_velocities = marked_if_unused(of_velocities, &velocities);
        let [places, rates] = [
            [quote!(ignorable), quote!(state.q)],
            [quote!(velocities), quote!(state.v)],
        ]
        .map(|[ignorable, remaining]| interleaved(&reduced.split, all, &ignorable, &remaining));
        let items = quote! {
            type FullState = #root::State<#scalar, #all>;
            const ELIMINATED: [&'static str; #k] = Self::ELIMINATED;
            fn constants(&self) -> #vector {
                let constants: [#scalar; #k] = [#(#constants),*];
                #root::__private::vector(constants)
            }
            fn effective_potential(&self, #of_potential) -> #scalar { #potential }
            fn eliminated_velocities(&self, #of_velocities) -> #vector { #velocities }
            fn full_state(
                &self,
                state: #state,
                ignorable: &#vector,
            ) -> #root::State<#scalar, #all> {
                let velocities = #root::Routhian::<#n, #k, #scalar>::ignorable_velocities(self, state);
                #root::State::new(state.t, #root::__private::vector([#(#places),*]), #root::__private::vector([#(#rates),*]))
            }
        };
        let routhian = self.implement(&quote!(#root::Routhian<#n, #k, #scalar>), &items);
        let series = self.routhian_series(methods, k);
        let own = self.own_items_of_reduced(&names.collect::<Vec<_>>());
        quote!(#own #routhian #series)
    }

    /// What a reduced model has without a scalar that has to be named.
    fn own_items_of_reduced(&self, eliminated: &[String]) -> TokenStream {
        let visibility = &self.declaration.visibility;
        let (n, k) = (self.coordinates(), eliminated.len());
        let constants = self.on_own_scalar(
            "The constant momenta of the ignorable coordinates.",
            &quote!(constants),
            &quote!(Routhian::<#n, #k, _>),
            k,
        );
        let items = quote! {
            /// The names of the ignorable coordinates, in their order.
            #visibility const ELIMINATED: [&'static str; #k] = [#(#eliminated),*];
            #constants
        };
        implementation::inherent(self.declaration, &self.declaration.generics, &items)
    }

    fn routhian_series(&self, methods: &ReducedMethods, k: usize) -> Option<TokenStream> {
        let series = methods.series.as_ref()?;
        let (root, scalar, n) = (&self.declaration.root, &self.scalar, self.coordinates());
        let (state, signature) = (self.signatures().state(), self.parameters_of_series(false));
        let body = self.body_of_series(series);
        let prepared = self.prepared_parameter(&body);
        // Momenta contain no input.
        let u = self.model.inputs as usize;
        let none = self.has_inputs().then(
            || quote!(let (_, mut higher_inputs) = #root::__private::orders::<#scalar, #u>(&[]);),
        );
        let items = quote! {
            fn ignorable_velocity_series<const HALF: usize>(
                &self,
                state: #state,
                #prepared
                #signature
            ) -> #root::TaylorCoefficients<[#scalar; #k], HALF> {
                #none
                #body
            }
        };
        let interface = quote!(#root::quantities::RouthianSeries<#n, #k, #scalar>);
        Some(self.implement(&interface, &items))
    }

    /// A body in which the inputs, if it reads them, are those of the fields.
    fn at_own_inputs(&self, body: TokenStream) -> TokenStream {
        if !mentions(&body, "inputs") {
            return body;
        }
        let (root, scalar, n) = (&self.declaration.root, &self.scalar, self.coordinates());
        quote! {
            let inputs = #root::quantities::Quantities::<#n, #scalar>::inputs(self);
            #body
        }
    }
}

/// The components of the full state, from those of the ignorable coordinates and of the others.
fn interleaved(
    split: &Split,
    all: usize,
    ignorable: &TokenStream,
    remaining: &TokenStream,
) -> Vec<TokenStream> {
    let place = |list: &[usize], i: usize| {
        let place = list.iter().position(|other| *other == i);
        place.map(Literal::usize_unsuffixed)
    };
    let component = |i| {
        if let Some(k) = place(&split.ignorable, i) {
            quote!(#ignorable[#k])
        } else {
            let k = place(&split.remaining, i);
            quote!(#remaining[#k])
        }
    };
    (0..all).map(component).collect()
}
