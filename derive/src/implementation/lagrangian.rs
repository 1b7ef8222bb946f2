//! The impls of `Lagrangian` and `Energies`.

use proc_macro2::TokenStream;
use quote::{format_ident, quote};

use super::Implementation;
use super::reader::InputsFrom;
use super::writer::{as_scalar, as_vector};

impl Implementation<'_> {
    pub(super) fn lagrangian(&self) -> TokenStream {
        let n = self.coordinates();
        let root = &self.declaration.root;
        let scalar = &self.scalar;
        let methods = self.methods;
        let vector = self.vector();
        let momenta = self.method("momenta", &[], &vector, &methods.momenta, as_vector);
        let mass = quote!(#root::__private::SMatrix<#scalar, #n, #n>);
        let mass = self.method("mass_matrix", &[], &mass, &methods.mass_matrix, |b| {
            b.columns(n)
        });
        let pivots = methods.relative_pivots.as_ref().map(|method| {
            self.method("relative_pivots", &[], &vector, method, |b| {
                b.relative_pivots(n)
            })
        });
        let prepare = self.prepare();
        let driven = if self.has_inputs() {
            self.delegations()
        } else {
            self.driven(&[], "")
        };
        self.implement(
            &quote!(#root::Lagrangian<#n, #scalar>),
            &quote!(#prepare #driven #momenta #mass #pivots),
        )
    }

    /// The methods that inputs act on, with the arguments and the suffix that they then have.
    pub(super) fn driven(&self, arguments: &[TokenStream], suffix: &str) -> TokenStream {
        let root = &self.declaration.root;
        let scalar = &self.scalar;
        let n = self.coordinates();
        let vector = self.vector();
        let methods = self.methods;
        let name = |name: &str| format!("{name}{suffix}");
        let mut with_accelerations = arguments.to_vec();
        with_accelerations.push(quote!(accelerations: &#vector));
        let scalar = quote!(#scalar);
        let linearization = quote!(#root::Linearization<#scalar, #n>);
        [
            self.method(
                &name("lagrangian"),
                arguments,
                &scalar,
                &methods.lagrangian,
                as_scalar,
            ),
            self.method(
                &name("energy"),
                arguments,
                &scalar,
                &methods.energy,
                as_scalar,
            ),
            self.method(
                &name("forcing"),
                arguments,
                &vector,
                &methods.forcing,
                as_vector,
            ),
            self.method(
                &name("generalized_forces"),
                arguments,
                &vector,
                &methods.generalized_forces,
                as_vector,
            ),
            self.accelerations(arguments, suffix),
            self.method(
                &name("inverse_dynamics"),
                &with_accelerations,
                &vector,
                &methods.inverse_dynamics,
                as_vector,
            ),
            self.method(
                &name("linearize"),
                arguments,
                &linearization,
                &methods.linearize,
                |b| match methods.pivots_of_derivatives() {
                    Some(pivots) => b.derivatives(n, pivots, &self.forcing(suffix)),
                    None => b.linearize(n),
                },
            ),
        ]
        .into_iter()
        .collect()
    }

    /// The accelerations with and without what has been prepared.
    fn accelerations(&self, arguments: &[TokenStream], suffix: &str) -> TokenStream {
        let n = self.coordinates();
        let methods = self.methods;
        let root = &self.declaration.root;
        let (scalar, vector) = (&self.scalar, self.vector());
        let kept = methods.prepare.program.phases[0].outputs.len();
        let mut with_prepared = arguments.to_vec();
        with_prepared.push(quote!(prepared: &[#scalar; #kept]));
        let prepared = self.method(
            &format!("accelerations_prepared{suffix}"),
            &with_prepared,
            &vector,
            &methods.accelerations,
            |b| match methods.solved {
                Some(0) => as_vector(b),
                Some(pivots) => b.eliminated(n, pivots, &self.forcing(suffix)),
                None => b.accelerations(n),
            },
        );
        let (name, interface, given) = if suffix.is_empty() {
            let interface = quote!(#root::Lagrangian::<#n, #scalar>::accelerations_prepared);
            (format_ident!("accelerations"), interface, quote!())
        } else {
            let u = self.model.inputs as usize;
            let interface = quote!(#root::Inputs::<#n, #u, #scalar>::accelerations_prepared_with);
            (
                format_ident!("accelerations_with"),
                interface,
                quote!(inputs,),
            )
        };
        quote! {
            fn #name(&self, state: &#root::State<#scalar, #n>, #(#arguments),*) -> #vector {
                let prepared = #root::Lagrangian::<#n, #scalar>::prepare(self);
                #interface(self, state, #given &prepared)
            }
            #prepared
        }
    }

    /// What depends on the parameters alone.
    fn prepare(&self) -> TokenStream {
        let scalar = &self.scalar;
        let method = &self.methods.prepare;
        let kept = method.program.phases[0].outputs.len();
        let (statements, outputs) =
            self.writer(method, InputsFrom::Fields, |writer| writer.phase(0));
        quote! {
            type Prepared = [#scalar; #kept];
            fn prepare(&self) -> [#scalar; #kept] {
                #statements
                [#(#outputs),*]
            }
        }
    }

    /// The forcing, as the method with a suffix computes it.
    fn forcing(&self, suffix: &str) -> TokenStream {
        let (n, u) = (self.coordinates(), self.model.inputs as usize);
        let root = &self.declaration.root;
        let scalar = &self.scalar;
        if suffix.is_empty() {
            quote!(#root::Lagrangian::<#n, #scalar>::forcing(self, state))
        } else {
            quote!(#root::Inputs::<#n, #u, #scalar>::forcing_with(self, state, inputs))
        }
    }

    /// The methods of `Lagrangian` for a model with inputs: those of `Inputs`, at the fields' values.
    fn delegations(&self) -> TokenStream {
        let (n, u) = (self.coordinates(), self.model.inputs as usize);
        let root = &self.declaration.root;
        let scalar = &self.scalar;
        let vector = self.vector();
        let inputs = quote!(&#root::Inputs::<#n, #u, #scalar>::inputs(self));
        let delegation = |name: &str, output: TokenStream| {
            let (name, with) = (format_ident!("{name}"), format_ident!("{name}_with"));
            quote! {
                fn #name(&self, state: &#root::State<#scalar, #n>) -> #output {
                    #root::Inputs::<#n, #u, #scalar>::#with(self, state, #inputs)
                }
            }
        };
        let mut delegations: TokenStream = [
            delegation("lagrangian", quote!(#scalar)),
            delegation("energy", quote!(#scalar)),
            delegation("forcing", vector.clone()),
            delegation("generalized_forces", vector.clone()),
            delegation("accelerations", vector.clone()),
            delegation("linearize", quote!(#root::Linearization<#scalar, #n>)),
        ]
        .into_iter()
        .collect();
        let kept = self.methods.prepare.program.phases[0].outputs.len();
        delegations.extend(quote! {
            fn accelerations_prepared(
                &self,
                state: &#root::State<#scalar, #n>,
                prepared: &[#scalar; #kept],
            ) -> #vector {
                #root::Inputs::<#n, #u, #scalar>::accelerations_prepared_with(
                    self, state, #inputs, prepared,
                )
            }
            fn inverse_dynamics(
                &self,
                state: &#root::State<#scalar, #n>,
                accelerations: &#vector,
            ) -> #vector {
                #root::Inputs::<#n, #u, #scalar>::inverse_dynamics_with(
                    self, state, #inputs, accelerations,
                )
            }
        });
        delegations
    }

    pub(super) fn energies(&self) -> TokenStream {
        let Some([kinetic, potential]) = &self.methods.energies else {
            return TokenStream::new();
        };
        let n = self.coordinates();
        let root = &self.declaration.root;
        let scalar = &self.scalar;
        let output = quote!(#scalar);
        let kinetic = self.method("kinetic_energy", &[], &output, kinetic, as_scalar);
        let potential = self.method("potential_energy", &[], &output, potential, as_scalar);
        self.implement(
            &quote!(#root::Energies<#n, #scalar>),
            &quote!(#kinetic #potential),
        )
    }
}
