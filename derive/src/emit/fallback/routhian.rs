//! The struct of a reduced model and its impls, beside errors.
//!
//! Which coordinates are ignorable is known if the full model has equations. If it has none, all coordinates and all momenta
//! have their names, and one coordinate is taken to remain, as in most reductions.

use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens, quote};

use super::Fallback;
use crate::emit::implementation;
use crate::emit::item_names::outputs_name;
use crate::emit::routhian::reduced_struct;
use crate::lower::Lowered;
use crate::reduce::{ReducedDeclaration, Split};
use crate::syntax::declaration::Declaration;
use crate::syntax::names::unraw;
use crate::syntax::routhian::RouthianClause;

/// The items of the reduced model without equations, and the way there.
pub(crate) fn reduced_without_equations(
    declaration: &Declaration,
    lowered: &Lowered,
    known: Option<&ReducedDeclaration>,
) -> TokenStream {
    let Some(clause) = &declaration.clauses.routhian else {
        return TokenStream::new();
    };
    let name = &declaration.name;
    let is_taken = clause.name == *name || clause.name == outputs_name(declaration);
    if is_taken || *name == format!("{}Outputs", unraw(&clause.name)) {
        return TokenStream::new();
    }
    let count = lowered.quantities.coordinates.len();
    let remaining = known.map_or(1, |reduced| reduced.split.remaining.len());
    let guess;
    let reduced = if let Some(reduced) = known {
        reduced
    } else {
        guess = guessed(declaration, lowered, clause);
        &guess
    };
    let definition = reduced_struct(declaration, &reduced.declaration);
    let fallback = Fallback::new(&reduced.declaration, &reduced.lowered);
    let items = fallback.items();
    let there = Fallback::new(declaration, lowered).routh_reduction(&clause.name, remaining);
    let back = fallback.routhian(count.saturating_sub(remaining), count);
    quote!(#definition #items #there #back)
}

/// The reduced model with all coordinates and all momenta.
fn guessed(
    declaration: &Declaration,
    lowered: &Lowered,
    clause: &RouthianClause,
) -> ReducedDeclaration {
    let all = || (0..lowered.quantities.coordinates.len()).collect();
    let split = Split {
        ignorable: all(),
        remaining: all(),
    };
    let mut reduced = ReducedDeclaration::of(declaration, lowered, split, clause);
    reduced.lowered.scope.complete = false;
    reduced
}

impl Fallback<'_> {
    /// The impl of `RouthReduction` for the full model.
    fn routh_reduction(&self, target: &Ident, remaining: usize) -> TokenStream {
        let root = &self.declaration.root;
        let (n, scalar) = (&self.dimension, self.scalar.of_parameters());
        let (_, arguments, _) = self.declaration.generics.split_for_impl();
        let items = quote! {
            type Scalar = #scalar;
            type Reduced = #target #arguments;
            fn reduce(
                &self,
                _: &#root::State<#scalar, #n>,
            ) -> (Self::Reduced, #root::State<#scalar, #remaining>) {
                ::core::unreachable!()
            }
        };
        self.implement(&quote!(#root::RouthReduction<#n, #remaining>), None, &items)
    }

    /// The impls of `Routhian` and `RouthianSeries` for the reduced model, of `all` coordinates and `k` that are ignorable.
    fn routhian(&self, k: usize, all: usize) -> TokenStream {
        let root = &self.declaration.root;
        let (n, scalar) = (&self.dimension, &self.scalar);
        let state = self.signatures().state();
        let vector = quote!(#root::__private::SVector<#scalar, #k>);
        let full = quote!(#root::State<#scalar, #all>);
        let items = quote! {
            type FullState = #full;
            const ELIMINATED: [&'static str; #k] = [""; #k];
            fn constants(&self) -> #vector { ::core::unreachable!() }
            fn effective_potential(&self, _: #state) -> #scalar { ::core::unreachable!() }
            fn eliminated_velocities(&self, _: #state, _: &[#scalar; 0]) -> #vector { ::core::unreachable!() }
            fn full_state(&self, _: #state, _: &#vector) -> #full { ::core::unreachable!() }
        };
        let interface = quote!(#root::Routhian<#n, #k, #scalar>);
        let routhian = self.implement(&interface, Some(scalar), &items);
        let series = self.declaration.clauses.taylor.as_ref().map(|_| {
            let motion = quote!(#root::TaylorCoefficients<#root::Phase<#scalar, #n>, HALF>);
            let items = quote! {
                fn ignorable_velocity_series<const HALF: usize>(
                    &self, _: #state, _: &[#scalar; 0], _: #scalar, _: &#motion,
                ) -> #root::TaylorCoefficients<[#scalar; #k], HALF> {
                    ::core::unreachable!()
                }
            };
            let interface = quote!(#root::quantities::RouthianSeries<#n, #k, #scalar>);
            self.implement(&interface, Some(scalar), &items)
        });
        let visibility = &self.declaration.visibility;
        let constants = self.on_own_scalar(&quote!(constants), k);
        let items = quote! {
            #visibility const ELIMINATED: [&'static str; #k] = [""; #k];
            #constants
        };
        let own = implementation::inherent(self.declaration, &self.declaration.generics, &items);
        [own, routhian, series.to_token_stream()]
            .into_iter()
            .collect()
    }
}
