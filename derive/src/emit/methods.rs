//! The methods of the table: their bodies, and the impls of `Quantities`, `Lagrangian` and `Energies`.

use lagrangian_symbolic::{Operand, Rational};
use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::{format_ident, quote};

use super::emitter::Emitter;
use super::members_in_lanes::members_in_lanes;
use super::parameters::marked_if_unused;
use crate::limits::COSTLIEST_INLINED_ACCELERATIONS;
use crate::plan::{EmittedMethod, Interface, Method, MethodOutputs, ResultType};

impl Emitter<'_> {
    /// The impls of `Quantities`, and of `Lagrangian`, whose methods evaluate them.
    pub(super) fn quantities(&self) -> TokenStream {
        let n = self.signatures().dimension;
        let root = &self.declaration.root;
        let scalar = &self.scalar;
        let inputs = self.signatures().inputs();
        let components = &self.lowered.quantities.inputs;
        let values = components.iter().map(|input| self.read(input));
        let of_constraints = [self.projection(), self.conditioning()];
        let items = quote! {
            type Inputs = #inputs;
            fn inputs(&self) -> #inputs { #root::__private::vector([#(#values),*]) }
            #(#of_constraints)*
        };
        let quantities = self.interface(Interface::Quantities, items);
        let lagrangian = self.implement(
            &quote!(#root::Lagrangian<#n, #scalar>),
            &quote! {
                type Model = Self;
                fn model(&self) -> &Self { self }
            },
        );
        let members = members_in_lanes(self.declaration, &self.scalar, true);
        quote!(#quantities #lagrangian #members)
    }

    pub(super) fn energies(&self) -> TokenStream {
        if self.methods.energies.is_none() {
            return TokenStream::new();
        }
        self.interface(Interface::Energies, TokenStream::new())
    }

    /// The impl of a trait of the table: these items, and the methods that the model has.
    pub(super) fn interface(&self, interface: Interface, mut items: TokenStream) -> TokenStream {
        let methods = self.methods.all();
        let methods = methods.filter(|(emitted, method)| {
            emitted.row().interface == interface && !is_provided(*emitted, method)
        });
        for (emitted, method) in methods {
            if emitted.row().result == ResultType::Prepared {
                items.extend(self.method(emitted, &self.prepared.method(method)));
            } else {
                items.extend(self.method(emitted, method));
            }
        }
        self.implement(&self.signatures().interface(interface), &items)
    }

    /// The emitted function of one row, with its body.
    fn method(&self, emitted: EmittedMethod, method: &Method) -> TokenStream {
        let (row, signatures) = (emitted.row(), self.signatures());
        // The multipliers are solved for together with the accelerations.
        let both = match emitted {
            EmittedMethod::Accelerations => Some(EmittedMethod::AccelerationsAndMultipliers),
            EmittedMethod::Sensitivities => Some(EmittedMethod::SensitivitiesAndMultipliers),
            _ => None,
        };
        let body = match both.filter(|_| self.is_constrained()) {
            Some(both) => {
                let both = self.call(both, row.parameters);
                quote!(#both.0)
            }
            None => self.body(method, row.parameters, &[]),
        };
        let (name, state) = (format_ident!("{}", row.name), signatures.state());
        let output = signatures.result(row.result);
        let state = row.takes_state().then(|| quote!(state: #state,));
        let others = signatures.parameters(row);
        let others = others.iter().map(|(name, ty)| quote!(#name: #ty,));
        let parameters = marked_if_unused(quote!(#state #(#others)*), &body);
        // Steppers evaluate the accelerations in a loop, in which their results are best kept in registers.
        let is_inlined = matches!(method.outputs, MethodOutputs::Accelerations(_))
            && method.count.cost() <= COSTLIEST_INLINED_ACCELERATIONS;
        let inline = is_inlined.then(|| quote!(#[inline(always)]));
        let prepared =
            (row.result == ResultType::Prepared).then(|| quote!(type Prepared = #output;));
        let signature = quote!(#prepared #inline fn #name(&self, #parameters) -> #output);
        with_body(signature, body)
    }
}

/// Whether the trait provides the method: for a model without forces, there are none by default.
fn is_provided(emitted: EmittedMethod, method: &Method) -> bool {
    let mut outputs = method
        .program
        .groups
        .iter()
        .flat_map(|group| &group.outputs);
    emitted == EmittedMethod::GeneralizedForces && outputs.all(is_zero)
}

pub(super) fn is_zero(operand: &Operand) -> bool {
    matches!(operand, Operand::Constant(number) if *number == Rational::ZERO)
}

/// A function with its body, which is moved: `quote` would copy it, token by token.
fn with_body(mut signature: TokenStream, body: TokenStream) -> TokenStream {
    signature.extend([TokenTree::Group(Group::new(Delimiter::Brace, body))]);
    signature
}
