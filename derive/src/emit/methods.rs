//! The methods of the table: their bodies, and the impls of `Lagrangian` and `Energies`.

use proc_macro2::{Delimiter, Group, TokenStream, TokenTree};
use quote::quote;

use super::emitter::Emitter;
use super::parameters::marked_if_unused;
use super::signatures::{InputsFrom, method_name};
use crate::limits::COSTLIEST_INLINED_ACCELERATIONS;
use crate::plan::{EmittedMethod, Interface, Invariants, Method, MethodRow, ResultType, Variant};

impl Emitter<'_> {
    pub(super) fn lagrangian(&self) -> TokenStream {
        let n = self.coordinates();
        let root = &self.declaration.root;
        let scalar = &self.scalar;
        let of_trait = |row: MethodRow| row.interface == Interface::Lagrangian;
        let prepare = self.methods_where(InputsFrom::Fields, |row| {
            of_trait(row) && !row.takes_state()
        });
        let taking_inputs = if self.has_inputs() {
            self.delegations(Interface::Lagrangian)
        } else {
            let taking_inputs = |row: MethodRow| of_trait(row) && row.takes_inputs;
            self.methods_where(InputsFrom::Fields, taking_inputs)
        };
        let others = self.methods_where(InputsFrom::Fields, |row| {
            of_trait(row) && row.takes_state() && !row.takes_inputs
        });
        self.implement(
            &quote!(#root::Lagrangian<#n, #scalar>),
            &quote!(#prepare #taking_inputs #others),
        )
    }

    pub(super) fn energies(&self) -> TokenStream {
        if self.methods.energies.is_none() {
            return TokenStream::new();
        }
        let n = self.coordinates();
        let root = &self.declaration.root;
        let scalar = &self.scalar;
        let items = self.methods_where(InputsFrom::Fields, |row| {
            row.interface == Interface::Energies
        });
        self.implement(&quote!(#root::Energies<#n, #scalar>), &items)
    }

    /// The methods of some rows that the model has.
    pub(super) fn methods_where(
        &self,
        inputs: InputsFrom,
        is_wanted: impl Fn(MethodRow) -> bool,
    ) -> TokenStream {
        let methods = self.methods.all();
        let methods = methods.filter(|(emitted, _)| is_wanted(emitted.row()));
        methods
            .map(|(emitted, method)| self.method(emitted, method, inputs))
            .collect()
    }

    /// The emitted functions of one row.
    fn method(&self, emitted: EmittedMethod, method: &Method, inputs: InputsFrom) -> TokenStream {
        let row = emitted.row();
        if row.result == ResultType::Invariants {
            return self.prepare(row, method);
        }
        if !row.takes_state() {
            return self.of_parameters(row, method);
        }
        row.variants()
            .map(|variant| {
                if row.invariants == Invariants::Hoisted && !variant.is_prepared {
                    self.both_stages(variant, inputs)
                } else {
                    self.function(variant, method, inputs)
                }
            })
            .collect()
    }

    /// A function of the state, with its body.
    fn function(&self, variant: Variant, method: &Method, inputs: InputsFrom) -> TokenStream {
        let signatures = self.signatures();
        let body = self.body(method, inputs, &[]);
        let (name, state) = (method_name(variant, inputs), signatures.state());
        let output = signatures.result(variant.row.result);
        let given = self.input_parameter(inputs);
        let others = signatures.parameters(variant);
        let others = others.iter().map(|(name, ty)| quote!(#name: #ty,));
        let [state, arguments] = [quote!(state: #state), quote!(#given #(#others)*)]
            .map(|parameters| marked_if_unused(parameters, &body));
        // Steppers evaluate the accelerations in a loop, in which their results are best kept in registers.
        let is_inlined = variant.is_prepared
            && !variant.takes_accelerations()
            && method.count.cost() <= COSTLIEST_INLINED_ACCELERATIONS;
        let inline = is_inlined.then(|| quote!(#[inline(always)]));
        let signature = quote!(#inline fn #name(&self, #state, #arguments) -> #output);
        with_body(signature, body)
    }

    /// `inputs: …,` where a function takes them.
    fn input_parameter(&self, inputs: InputsFrom) -> Option<TokenStream> {
        let ty = self.signatures().inputs();
        (inputs == InputsFrom::Argument).then(|| quote!(inputs: &#ty,))
    }

    /// The function that computes the hoisted invariants.
    fn prepare(&self, row: MethodRow, method: &Method) -> TokenStream {
        let signatures = self.signatures();
        let output = signatures.result(row.result);
        let body = self.body(method, InputsFrom::Fields, &[]);
        let signature = quote! {
            type Prepared = #output;
            fn prepare(&self) -> #output
        };
        with_body(signature, body)
    }

    /// A function of the parameters.
    fn of_parameters(&self, row: MethodRow, method: &Method) -> TokenStream {
        let name = method_name(row.unprepared(), InputsFrom::Fields);
        let output = self.signatures().result(row.result);
        let body = self.body(method, InputsFrom::Fields, &[]);
        with_body(quote!(fn #name(&self) -> #output), body)
    }

    /// The function that computes the invariants, and then calls the one that takes them.
    fn both_stages(&self, variant: Variant, inputs: InputsFrom) -> TokenStream {
        let signatures = self.signatures();
        let (name, state) = (method_name(variant, inputs), signatures.state());
        let output = signatures.result(variant.row.result);
        let lagrangian = signatures.interface(Interface::Lagrangian, InputsFrom::Fields);
        let interface = signatures.interface(variant.row.interface, inputs);
        let prepared = Variant {
            is_prepared: true,
            ..variant
        };
        let prepared = method_name(prepared, inputs);
        let parameter = self.input_parameter(inputs);
        let given = (inputs == InputsFrom::Argument).then(|| quote!(inputs,));
        let others = signatures.parameters(variant);
        let (names, types): (Vec<_>, Vec<_>) = others.into_iter().unzip();
        quote! {
            fn #name(&self, state: #state, #parameter #(#names: #types,)*) -> #output {
                let prepared = #lagrangian::prepare(self);
                #interface::#prepared(self, state, #given #(#names,)* &prepared)
            }
        }
    }

    /// The methods of a trait for a model with inputs: those that take inputs, at the fields' values.
    pub(super) fn delegations(&self, interface: Interface) -> TokenStream {
        let rows = EmittedMethod::ALL.iter().map(|method| method.row());
        let rows = rows.filter(|row| row.interface == interface && row.takes_inputs);
        let mut variants: Vec<Variant> = rows.flat_map(MethodRow::variants).collect();
        // Those of the state alone stand first.
        variants.sort_by_key(|variant| variant.is_prepared || variant.takes_accelerations());
        let delegations = variants.into_iter();
        delegations
            .map(|variant| self.delegation(variant))
            .collect()
    }

    fn delegation(&self, variant: Variant) -> TokenStream {
        let signatures = self.signatures();
        let (state, output) = (signatures.state(), signatures.result(variant.row.result));
        let [name, with] =
            [InputsFrom::Fields, InputsFrom::Argument].map(|inputs| method_name(variant, inputs));
        let interface = signatures.interface(variant.row.interface, InputsFrom::Argument);
        let inputs = signatures.interface(Interface::Inputs, InputsFrom::Argument);
        let (names, types): (Vec<_>, Vec<_>) = signatures.parameters(variant).into_iter().unzip();
        quote! {
            fn #name(&self, state: #state, #(#names: #types,)*) -> #output {
                #interface::#with(self, state, &#inputs::inputs(self), #(#names,)*)
            }
        }
    }
}

/// A function with its body, which is moved: `quote` would copy it, token by token.
fn with_body(mut signature: TokenStream, body: TokenStream) -> TokenStream {
    signature.extend([TokenTree::Group(Group::new(Delimiter::Brace, body))]);
    signature
}
