//! The items that are emitted for a model.

mod constants;
mod lagrangian;
mod inputs;
mod outputs;
mod functions;
mod reader;
mod writer;
mod parameters;

use lagrangian_symbolic::{Equations, Model};
use proc_macro2::{Ident, TokenStream};
use quote::{format_ident, quote};

use crate::body::Body;
use crate::declaration::Declaration;
use crate::lower::Lowered;
use crate::methods::{Method, Methods};
use crate::names::{Locals, plain};
use crate::quantities::Component;
use crate::scalar::Scalar;
use functions::method_name;
use parameters::marked_if_unused;
use reader::{InputsFrom, Reader};
use writer::Writer;

pub(crate) use constants::indices;
pub(crate) use functions::{of_checks, signatures, values};
pub(crate) use inputs::{Indices, input_indices};
pub(crate) use outputs::results;

/// Everything about one model that the emitted text depends on.
pub(crate) struct Implementation<'a> {
    pub(crate) declaration: &'a Declaration,
    pub(crate) lowered: &'a Lowered,
    pub(crate) model: &'a Model,
    pub(crate) equations: &'a Equations,
    pub(crate) methods: &'a Methods,
    pub(crate) scalar: Scalar<'a>,
    /// See [`MOST_SCOPES`](crate::body::MOST_SCOPES).
    pub(crate) most_scopes: usize,
}

impl<'a> Implementation<'a> {
    pub(crate) fn new(
        declaration: &'a Declaration,
        lowered: &'a Lowered,
        model: &'a Model,
        equations: &'a Equations,
        methods: &'a Methods,
        most_scopes: usize,
    ) -> Self {
        Self {
            declaration,
            lowered,
            model,
            equations,
            methods,
            scalar: Scalar::of(declaration),
            most_scopes,
        }
    }

    /// All items, in the order in which a reader wants them.
    pub(crate) fn items(&self) -> TokenStream {
        [
            self.constants(),
            self.system(),
            self.lagrangian(),
            self.energies(),
            self.inputs(),
            self.outputs(),
            self.functions(),
        ]
        .into_iter()
        .collect()
    }

    fn has_inputs(&self) -> bool {
        self.model.inputs > 0
    }

    fn coordinates(&self) -> usize {
        self.model.coordinates as usize
    }

    /// `impl<…> trait<…> for Model`, on the scalar.
    fn implement(&self, interface: &TokenStream, items: &TokenStream) -> TokenStream {
        let name = &self.declaration.name;
        let generics = self.scalar.generics(&self.declaration.generics);
        let (generics, _, conditions) = generics.split_for_impl();
        let (_, arguments, _) = self.declaration.generics.split_for_impl();
        quote! {
            #[automatically_derived]
            impl #generics #interface for #name #arguments #conditions {
                #items
            }
        }
    }

    /// The value of a component on the scalar.
    fn read(&self, component: &Component) -> TokenStream {
        let field = &component.field;
        let field = self.lowered.scope.first_use(field).unwrap_or(field);
        self.scalar.read(&component.read(field), &component.element)
    }

    fn vector(&self) -> TokenStream {
        let root = &self.declaration.root;
        let (n, scalar) = (self.coordinates(), &self.scalar);
        quote!(#root::__private::SVector<#scalar, #n>)
    }

    /// A method of the state, with its body.
    fn method(
        &self,
        name: &str,
        arguments: &[TokenStream],
        output: &TokenStream,
        method: &Method,
        write: impl FnOnce(&mut Writer<'_>) -> TokenStream,
    ) -> TokenStream {
        let inputs = if name.ends_with("_with") {
            InputsFrom::Argument
        } else {
            InputsFrom::Fields
        };
        let body = self.writer(method, inputs, write);
        let root = &self.declaration.root;
        let (n, scalar, name) = (self.coordinates(), &self.scalar, format_ident!("{name}"));
        let [state, arguments] = [
            quote!(state: &#root::State<#scalar, #n>),
            quote!(#(#arguments),*),
        ]
        .map(|parameters| marked_if_unused(parameters, &body));
        quote! {
            fn #name(&self, #state, #arguments) -> #output {
                #body
            }
        }
    }

    /// Writes a program with variables of its own.
    fn writer<T>(
        &self,
        method: &Method,
        inputs: InputsFrom,
        write: impl FnOnce(&mut Writer<'_>) -> T,
    ) -> T {
        self.writer_of_arguments(method, inputs, &[], write)
    }

    /// The same for a function whose arguments have these names.
    fn writer_of_arguments<T>(
        &self,
        method: &Method,
        inputs: InputsFrom,
        arguments: &[Ident],
        write: impl FnOnce(&mut Writer<'_>) -> T,
    ) -> T {
        let reader = Reader {
            implementation: self,
            inputs,
        };
        let graph = &self.model.graph;
        let functions = self.declaration.clauses.functions.iter();
        let functions = functions.map(method_name).collect();
        let locals = Locals::new(graph, &self.lowered.scope, &self.lowered.quantities)
            .with_arguments(arguments.iter().map(plain));
        let mut writer = Writer {
            program: &method.program,
            root: &self.declaration.root,
            body: Body::new(
                &method.program,
                graph.passes,
                locals,
                &self.scalar,
                &reader,
                functions,
                self.most_scopes,
            ),
            scalar: &self.scalar,
        };
        write(&mut writer)
    }
}
