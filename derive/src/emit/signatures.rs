//! The signatures of the emitted methods.

use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::plan::{Argument, Interface, ResultType, Variant};
use crate::syntax::root::Root;
use crate::syntax::scalar::Scalar;

/// Where the values of inputs come from.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum InputsFrom {
    /// From the fields of the struct.
    Fields,
    /// From a parameter: then the name of the method ends in `_with`.
    Argument,
}

/// What the types in signatures are made of.
pub(crate) struct Signatures<'a> {
    pub(crate) root: &'a Root,
    pub(crate) scalar: &'a Scalar<'a>,
    /// How many coordinates there are.
    pub(crate) dimension: TokenStream,
    /// How many inputs there are.
    pub(crate) inputs: usize,
    /// By how many parameters accelerations are differentiated.
    pub(crate) parameters: usize,
    /// How many base parameters there are.
    pub(crate) base_parameters: TokenStream,
    /// The type of the hoisted invariants.
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
            base_parameters: b,
        } = self;
        match result {
            ResultType::Scalar => quote!(#scalar),
            ResultType::Vector => self.vector(),
            ResultType::SquareMatrix => quote!(#root::__private::SMatrix<#scalar, #n, #n>),
            ResultType::InputMatrix => quote!(#root::__private::SMatrix<#scalar, #n, #u>),
            ResultType::Linearization => quote!(#root::Linearization<#scalar, #n>),
            ResultType::Invariants => prepared.clone(),
            ResultType::Outputs => quote!(Self::Outputs),
            ResultType::EventValues => quote!(Self::EventValues),
            ResultType::ParameterMatrix => quote!(#root::__private::SMatrix<#scalar, #n, #p>),
            ResultType::Regressor => quote!(#root::__private::SMatrix<#scalar, #n, #b>),
            ResultType::BaseParameters => quote!(#root::__private::SVector<#scalar, #b>),
        }
    }

    /// The names and the types of the parameters besides the state and the inputs.
    pub(crate) fn parameters(&self, variant: Variant) -> Vec<(Ident, TokenStream)> {
        let vector = match variant.row.argument {
            Argument::Accelerations => Some(("accelerations", self.vector())),
            Argument::Momenta => Some(("momenta", self.vector())),
            Argument::StateOnly | Argument::Parameters => None,
        };
        let prepared = variant
            .is_prepared
            .then(|| ("prepared", self.prepared.clone()));
        let all = vector.into_iter().chain(prepared);
        all.map(|(name, ty)| (format_ident!("{name}"), quote!(&#ty)))
            .collect()
    }

    /// The trait that declares a method.
    pub(crate) fn interface(&self, interface: Interface, inputs: InputsFrom) -> TokenStream {
        let Self {
            root,
            scalar,
            dimension: n,
            inputs: u,
            parameters: p,
            base_parameters: b,
            ..
        } = self;
        match (interface, inputs) {
            (Interface::Lagrangian, InputsFrom::Fields) => quote!(#root::Lagrangian::<#n, #scalar>),
            (Interface::Events, InputsFrom::Fields) => quote!(#root::Events::<#n, #scalar>),
            (Interface::Events, InputsFrom::Argument) => {
                quote!(#root::EventsWith::<#n, #u, #scalar>)
            }
            (Interface::Hamiltonian, InputsFrom::Fields) => {
                quote!(#root::Hamiltonian::<#n, #scalar>)
            }
            (Interface::Hamiltonian, InputsFrom::Argument) => {
                quote!(#root::HamiltonianWith::<#n, #u, #scalar>)
            }
            (Interface::EnergyBalance, InputsFrom::Fields) => {
                quote!(#root::EnergyBalance::<#n, #scalar>)
            }
            (Interface::EnergyBalance, InputsFrom::Argument) => {
                quote!(#root::EnergyBalanceWith::<#n, #u, #scalar>)
            }
            (Interface::Sensitivities, InputsFrom::Fields) => {
                quote!(#root::Sensitivities::<#n, #p, #scalar>)
            }
            (Interface::Sensitivities, InputsFrom::Argument) => {
                quote!(#root::SensitivitiesWith::<#n, #u, #p, #scalar>)
            }
            (Interface::Regressor, InputsFrom::Fields) => {
                quote!(#root::Regressor::<#n, #b, #scalar>)
            }
            (Interface::Regressor, InputsFrom::Argument) => {
                quote!(#root::RegressorWith::<#n, #u, #b, #scalar>)
            }
            (Interface::Energies, _) => quote!(#root::Energies::<#n, #scalar>),
            (Interface::Lagrangian, InputsFrom::Argument) | (Interface::Inputs, _) => {
                quote!(#root::Inputs::<#n, #u, #scalar>)
            }
            (Interface::Outputs, InputsFrom::Fields) => quote!(#root::Outputs::<#n, #scalar>),
            (Interface::Outputs, InputsFrom::Argument) => {
                quote!(#root::OutputsWith::<#n, #u, #scalar>)
            }
        }
    }
}

/// The name of an emitted function.
pub(crate) fn method_name(variant: Variant, inputs: InputsFrom) -> Ident {
    let name = variant.name();
    match inputs {
        InputsFrom::Fields => format_ident!("{name}"),
        InputsFrom::Argument => format_ident!("{name}_with"),
    }
}
