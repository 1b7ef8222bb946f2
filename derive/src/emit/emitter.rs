//! What the emitted code depends on, and what all parts of it share.

use lagrangian_symbolic::{Equations, Listing, Model};
use proc_macro2::{Literal, TokenStream};
use quote::{ToTokens as _, format_ident, quote};

use super::implementation;
use super::locals::Locals;
use super::signatures::Signatures;
use crate::limits::MethodLimits;
use crate::lower::Lowered;
use crate::lower::quantities::Component;
use crate::plan::{
    EmittedMethod, Interface, Methods, ParameterSource, PreparedArray, SeriesMethods,
};
use crate::syntax::declaration::Declaration;
use crate::syntax::scalar::Scalar;

/// Everything about one model that the emitted code depends on.
pub(crate) struct Emitter<'a> {
    pub(crate) declaration: &'a Declaration,
    pub(crate) lowered: &'a Lowered,
    pub(crate) model: &'a Model,
    pub(crate) equations: &'a Equations,
    pub(crate) methods: &'a Methods,
    /// The equations in print.
    pub(crate) listing: &'a Listing,
    /// With the clause `taylor`.
    pub(crate) series: Option<&'a SeriesMethods>,
    /// The coordinates of a reduced model at whose poles it has no value.
    pub(crate) poles: Vec<u32>,
    pub(crate) prepared: PreparedArray,
    pub(crate) scalar: Scalar<'a>,
    pub(crate) limits: MethodLimits,
}

impl<'a> Emitter<'a> {
    pub(crate) fn new(
        declaration: &'a Declaration,
        lowered: &'a Lowered,
        model: &'a Model,
        (equations, listing): (&'a Equations, &'a Listing),
        methods: &'a Methods,
        series: Option<&'a SeriesMethods>,
        limits: MethodLimits,
    ) -> Self {
        Self {
            declaration,
            lowered,
            model,
            equations,
            methods,
            listing,
            series,
            poles: Vec::new(),
            prepared: PreparedArray::of(methods, series),
            scalar: Scalar::of(declaration),
            limits,
        }
    }

    pub(super) fn has_inputs(&self) -> bool {
        self.model.inputs > 0
    }

    pub(super) fn coordinates(&self) -> usize {
        self.model.coordinates as usize
    }

    /// `impl<…> trait<…> for Model`, on the scalar.
    pub(super) fn implement(&self, interface: &TokenStream, items: &TokenStream) -> TokenStream {
        self.implement_under(interface, &[], items)
    }

    /// The same under further conditions.
    pub(super) fn implement_under(
        &self,
        interface: &TokenStream,
        conditions: &[TokenStream],
        items: &TokenStream,
    ) -> TokenStream {
        let mut generics = self.scalar.generics(&self.declaration.generics);
        if !conditions.is_empty() {
            let predicates = &mut generics.make_where_clause().predicates;
            predicates.extend(
                conditions
                    .iter()
                    .map(|condition| -> syn::WherePredicate { syn::parse_quote!(#condition) }),
            );
        }
        implementation::of_trait(self.declaration, &generics, interface, items)
    }

    /// A method of the type on the scalar of the parameters, for one of a trait that takes nothing from which a scalar could
    /// be inferred.
    pub(super) fn on_own_scalar(
        &self,
        text: &str,
        method: &TokenStream,
        interface: &TokenStream,
        count: usize,
    ) -> TokenStream {
        let Declaration {
            root, visibility, ..
        } = self.declaration;
        let scalar = self.scalar.of_parameters();
        quote! {
            #[doc = #text]
            #visibility fn #method(&self) -> #root::__private::SVector<#scalar, #count> {
                #root::#interface::#method(self)
            }
        }
    }

    /// The value of a component on the scalar.
    pub(super) fn read(&self, component: &Component) -> TokenStream {
        let field = &component.field;
        let field = self.lowered.scope.first_use(field).unwrap_or(field);
        let place = component.read(field, &self.declaration.root);
        self.scalar.read(&place, &component.element)
    }

    /// The names of the variables of one method.
    pub(super) fn locals(&self) -> Locals<'a> {
        let Lowered {
            scope, quantities, ..
        } = self.lowered;
        Locals::new(&self.model.graph, scope, quantities)
    }

    /// What the types in signatures are made of.
    pub(super) fn signatures(&self) -> Signatures<'_> {
        let scalar = &self.scalar;
        let requested = &self.methods.requested;
        let (regressor, sensitivities) = (&requested.regressor, &requested.sensitivities);
        let base_parameters = regressor.as_ref().map_or(0, |found| found.values.len());
        let parameters = sensitivities.as_ref();
        let parameters = parameters.map_or(0, |found| found.parameters.len());
        let length = Literal::usize_unsuffixed(self.prepared.len());
        Signatures {
            root: &self.declaration.root,
            scalar,
            dimension: Literal::usize_unsuffixed(self.coordinates()).into_token_stream(),
            inputs: Literal::usize_unsuffixed(self.model.inputs as usize),
            parameters: Literal::usize_unsuffixed(parameters),
            constraints: Literal::usize_unsuffixed(self.constraint_count()),
            base_parameters: Literal::usize_unsuffixed(base_parameters).into_token_stream(),
            prepared: quote!([#scalar; #length]),
        }
    }

    /// A call of a method of the state at the same inputs, in a method that has the parameters from there.
    pub(super) fn call(&self, method: EmittedMethod, source: ParameterSource) -> TokenStream {
        let row = method.row();
        let interface = self.signatures().interface(row.interface);
        let quantities = self.signatures().interface(Interface::Quantities);
        let name = format_ident!("{}", row.name);
        let inputs = row.takes_inputs.then(|| quote!(, inputs));
        let prepared = row.takes_prepared().then(|| match source {
            ParameterSource::Prepared => quote!(, prepared),
            ParameterSource::Fields => quote!(, &#quantities::prepare(self)),
        });
        quote!(#interface::#name(self, state #inputs #prepared))
    }
}
