//! The items that are emitted for a model.

mod constants;
mod lagrangian;
mod inputs;
mod outputs;
mod functions;
mod signatures;
mod reader;
mod writer;
mod parameters;

use lagrangian_symbolic::{Equations, Model};
use proc_macro2::{Ident, TokenStream};
use quote::{ToTokens as _, quote};

use crate::body::Body;
use crate::declaration::Declaration;
use crate::lower::Lowered;
use crate::names::{Locals, plain};
use crate::plan::{Method, Methods};
use crate::quantities::Component;
use crate::scalar::Scalar;
use functions::value_name;
use reader::Reader;
use writer::Writer;

pub(crate) use constants::indices;
pub(crate) use functions::{of_checks, signatures, values};
pub(crate) use inputs::{Indices, input_indices};
pub(crate) use outputs::results;
pub(crate) use signatures::{InputsFrom, Signatures, method_name};

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

    /// What the types in signatures are made of.
    fn signatures(&self) -> Signatures<'_> {
        let scalar = &self.scalar;
        let prepared = &self.methods.prepare.program.phases;
        let kept = prepared.first().map_or(0, |phase| phase.outputs.len());
        Signatures {
            root: &self.declaration.root,
            scalar,
            dimension: self.coordinates().to_token_stream(),
            inputs: self.model.inputs as usize,
            prepared: quote!([#scalar; #kept]),
        }
    }

    /// The body of a method, with variables of its own; in that of a function's derivative its arguments have
    /// these names.
    fn body(&self, method: &Method, inputs: InputsFrom, arguments: &[Ident]) -> TokenStream {
        let reader = Reader {
            implementation: self,
            inputs,
        };
        let graph = &self.model.graph;
        let functions = self.declaration.clauses.functions.iter();
        let functions = functions.map(value_name).collect();
        let locals = Locals::new(graph, &self.lowered.scope, &self.lowered.quantities)
            .with_arguments(arguments.iter().map(plain));
        let mut writer = Writer {
            implementation: self,
            method,
            inputs,
            body: Body::new(
                &method.program,
                graph.passes,
                locals,
                &self.scalar,
                &reader,
                functions,
                self.most_scopes,
            ),
            computed: Vec::new(),
        };
        writer.write()
    }
}
