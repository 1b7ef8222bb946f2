//! The signatures of the emitted methods.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::{format_ident, quote};

use crate::plan::{Argument, Interface, MethodRow, ResultType};
use crate::syntax::root::Root;
use crate::syntax::scalar::Scalar;

/// What the types in signatures are made of.
pub(crate) struct Signatures<'a> {
    pub(crate) root: &'a Root,
    pub(crate) scalar: &'a Scalar<'a>,
    /// How many coordinates there are.
    pub(crate) dimension: TokenStream,
    /// How many inputs there are.
    pub(crate) inputs: Literal,
    /// By how many parameters accelerations are differentiated.
    pub(crate) parameters: Literal,
    /// How many constraints there are.
    pub(crate) constraints: Literal,
    /// How many base parameters there are.
    pub(crate) base_parameters: TokenStream,
    /// The type of the prepared array.
    pub(crate) prepared: TokenStream,
}

impl Signatures<'_> {
    /// One component for each coordinate.
    pub(crate) fn vector(&self) -> TokenStream {
        let Self {
            root,
            scalar,
            dimension,
            ..
        } = self;
        quote!(#root::__private::SVector<#scalar, #dimension>)
    }

    pub(crate) fn state(&self) -> TokenStream {
        let Self {
            root,
            scalar,
            dimension,
            ..
        } = self;
        quote!(&#root::State<#scalar, #dimension>)
    }

    /// One component for each input.
    pub(crate) fn inputs(&self) -> TokenStream {
        let Self {
            root,
            scalar,
            inputs,
            ..
        } = self;
        quote!(#root::__private::SVector<#scalar, #inputs>)
    }

    /// What a method returns.
    pub(crate) fn result(&self, result: ResultType) -> TokenStream {
        let Self {
            root,
            scalar,
            dimension: n,
            inputs: u,
            prepared,
            parameters: p,
            constraints: c,
            base_parameters: b,
        } = self;
        match result {
            ResultType::Scalar => quote!(#scalar),
            ResultType::Vector => self.vector(),
            ResultType::SquareMatrix => quote!(#root::__private::SMatrix<#scalar, #n, #n>),
            ResultType::InputMatrix => quote!(#root::__private::SMatrix<#scalar, #n, #u>),
            ResultType::Linearization => quote!(#root::Linearization<#scalar, #n>),
            ResultType::Prepared => prepared.clone(),
            ResultType::Outputs => quote!(Self::Outputs),
            ResultType::EventValues => quote!(Self::EventValues),
            ResultType::ParameterMatrix => quote!(#root::__private::SMatrix<#scalar, #n, #p>),
            ResultType::ParameterMatrices => quote! {
                (#root::__private::SMatrix<#scalar, #n, #p>, #root::__private::SMatrix<#scalar, #c, #p>)
            },
            ResultType::Regressor => quote!(#root::__private::SMatrix<#scalar, #n, #b>),
            ResultType::BaseParameters => quote!(#root::__private::SVector<#scalar, #b>),
            ResultType::EventGradient => {
                let gradient = self.vector();
                quote!((#gradient, #scalar))
            }
            ResultType::ConstraintVector => quote!(#root::__private::SVector<#scalar, #c>),
            ResultType::ConstraintJacobian => quote!(#root::__private::SMatrix<#scalar, #c, #n>),
            ResultType::AccelerationsAndMultipliers => {
                let accelerations = self.vector();
                quote!((#accelerations, #root::__private::SVector<#scalar, #c>))
            }
        }
    }

    /// The names and the types of the parameters besides the state.
    pub(crate) fn parameters(&self, row: MethodRow) -> Vec<(Ident, TokenStream)> {
        let inputs = row.takes_inputs.then(|| ("inputs", self.inputs()));
        let vector = match row.argument {
            Argument::Accelerations => Some(("accelerations", self.vector())),
            Argument::Momenta => Some(("momenta", self.vector())),
            Argument::Event => Some(("event", quote!(::core::primitive::usize))),
            Argument::StateOnly | Argument::Parameters => None,
        };
        let prepared = row
            .takes_prepared()
            .then(|| ("prepared", self.prepared.clone()));
        let all = inputs.into_iter().chain(vector).chain(prepared);
        all.map(|(name, ty)| (format_ident!("{name}"), quote!(&#ty)))
            .collect()
    }

    /// The methods of `DirectionalDerivatives`, with bodies that are made of their names and arguments.
    pub(crate) fn directional_derivatives(
        &self,
        body: impl Fn(&Ident, TokenStream) -> TokenStream,
    ) -> TokenStream {
        let (root, scalar, n, c) = (self.root, self.scalar, &self.dimension, &self.constraints);
        let (state, inputs) = (self.state(), self.inputs());
        let result = quote!(#root::quantities::MotionDerivatives<#scalar, #n, #c>);
        let methods = [
            ("derivatives_along", "direction", state.clone()),
            (
                "derivatives_by_input",
                "input",
                quote!(::core::primitive::usize),
            ),
        ];
        let methods = methods.map(|(name, argument, ty)| {
            let [name, argument] = [name, argument].map(|name| format_ident!("{name}"));
            let body = body(&name, quote!(state, inputs, #argument));
            quote! {
                fn #name(&self, state: #state, inputs: &#inputs, #argument: #ty) -> #result {
                    #body
                }
            }
        });
        quote!(#(#methods)*)
    }

    /// The trait that declares a method.
    pub(crate) fn interface(&self, interface: Interface) -> TokenStream {
        let Self {
            root,
            scalar,
            dimension: n,
            inputs: u,
            parameters: p,
            constraints: c,
            base_parameters: b,
            ..
        } = self;
        let (name, counts) = match interface {
            Interface::Quantities => ("Quantities", quote!(#n)),
            Interface::StateJacobian => ("StateJacobian", quote!(#n)),
            Interface::Constraints => ("Constraints", quote!(#n, #c)),
            Interface::Impacts => ("Impacts", quote!(#n)),
            Interface::Energies => ("Energies", quote!(#n)),
            Interface::Inputs => ("Inputs", quote!(#n, #u)),
            Interface::Outputs => ("Outputs", quote!(#n)),
            Interface::Events => ("Events", quote!(#n)),
            Interface::Hamiltonian => ("Hamiltonian", quote!(#n)),
            Interface::EnergyBalance => ("EnergyBalance", quote!(#n)),
            Interface::Sensitivities => ("Sensitivities", quote!(#n, #p)),
            Interface::MultiplierSensitivities => ("MultiplierSensitivities", quote!(#n, #c, #p)),
            Interface::Regressor => ("Regressor", quote!(#n, #b)),
        };
        let name = format_ident!("{name}");
        quote!(#root::quantities::#name::<#counts, #scalar>)
    }
}
