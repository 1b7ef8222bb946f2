//! The bodies of methods: the statements of their programs, and the values that they return.

use lagrangian_symbolic::Symbol;
use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::body::Body;
use super::constraints::pattern_of_parts;
use super::emitter::Emitter;
use super::item_names::{outputs_name, value_name};
use super::model_symbols::ModelSymbols;
use crate::plan::{
    AccelerationOutputs, EmittedMethod, LowerTriangle, Method, MethodOutputs, OutputSlice,
    ParameterSource, PivotOutputs,
};
use crate::syntax::names::unraw;
use crate::syntax::shape::Shape;

/// Streams one after the other. They are moved: `quote` would copy long ones, token by token.
pub(super) fn joined(parts: impl IntoIterator<Item = TokenStream>) -> TokenStream {
    let mut parts = parts.into_iter();
    let mut all = parts.next().unwrap_or_default();
    parts.for_each(|part| all.extend(part));
    all
}

/// Writes the body of one method.
pub(super) struct Writer<'a> {
    pub(super) emitter: &'a Emitter<'a>,
    pub(super) method: &'a Method,
    /// Where the method reads parameters.
    pub(super) parameters: ParameterSource,
    pub(super) body: Body<'a>,
    /// The outputs of the groups that are written.
    pub(super) computed: Vec<Vec<TokenStream>>,
}

impl Emitter<'_> {
    /// The body of a method, with variables of its own; in that of a function's derivative its arguments have
    /// these names.
    pub(super) fn body(
        &self,
        method: &Method,
        parameters: ParameterSource,
        arguments: &[Ident],
    ) -> TokenStream {
        #[allow(clippy::redundant_closure_for_method_calls)]
        // The path has one lifetime, the closure any.
        self.with_writer(method, parameters, arguments, |writer| writer.write())
    }

    /// What is written with a writer of the body of a method.
    pub(super) fn with_writer(
        &self,
        method: &Method,
        parameters: ParameterSource,
        arguments: &[Ident],
        write: impl FnOnce(&mut Writer<'_>) -> TokenStream,
    ) -> TokenStream {
        let symbols = ModelSymbols {
            emitter: self,
            parameters,
        };
        let functions = self.declaration.clauses.functions.iter();
        let functions = functions.map(value_name).collect();
        let locals = self.locals();
        let locals = locals.with_arguments(arguments.iter().map(unraw));
        let is_solution = matches!(
            &method.outputs,
            MethodOutputs::Accelerations(AccelerationOutputs::Symbolic { .. })
        );
        let solves_saddle_point = is_solution && self.is_constrained();
        let mut writer = Writer {
            emitter: self,
            method,
            parameters,
            body: Body::new(
                &method.program,
                self.model.graph.passes,
                locals,
                &self.scalar,
                &symbols,
                functions,
                self.limits.of_body(solves_saddle_point),
            ),
            computed: Vec::new(),
        };
        write(&mut writer)
    }
}

impl Writer<'_> {
    /// The body: statements, and the value that the method returns.
    pub(super) fn write(&mut self) -> TokenStream {
        let method = self.method;
        match &method.outputs {
            MethodOutputs::Scalar(value) => {
                let (statements, value) = self.compute(value);
                self.behind_accelerations(joined([statements].into_iter().chain(value)))
            }
            MethodOutputs::Vector(vector) => self.returned(vector, Self::vector),
            MethodOutputs::SquareMatrix(matrix) => self.returned(matrix, Self::matrix),
            MethodOutputs::ConstraintJacobian(columns) => self
                .returned(columns, |writer, elements| {
                    writer.matrix_of(elements, writer.emitter.constraint_count())
                }),
            MethodOutputs::Invariants(values) | MethodOutputs::Events(values) => {
                let (statements, values) = self.compute(values);
                self.behind_accelerations(joined([statements, quote!([#(#values),*])]))
            }
            MethodOutputs::EventGradients(gradients) => {
                let root = &self.emitter.declaration.root;
                let (statements, elements) = self.compute(gradients);
                let rows = elements.chunks(self.emitter.coordinates() + 1);
                let rows = rows.map(|row| quote!([#(#row),*]));
                let value = quote!(#root::__private::gradient(&[#(#rows),*], *event));
                self.behind_accelerations(joined([statements, value]))
            }
            MethodOutputs::Accelerations(outputs) => {
                let (statements, solution) = self.accelerations(outputs);
                if self.emitter.is_constrained() {
                    return joined([statements, self.emitter.split(&solution)]);
                }
                joined([statements, solution])
            }
            MethodOutputs::Linearization(outputs) => self.acceleration_derivatives(outputs),
            MethodOutputs::InputJacobian(outputs) => self.input_jacobian(outputs),
            MethodOutputs::Sensitivities(outputs) => self.sensitivities(outputs),
            MethodOutputs::Velocities { pivots, velocities } => {
                let (statements, pivots) = self.compute(pivots);
                let (_, velocities) = self.compute(velocities);
                let velocities = self.vector(&velocities);
                if pivots.is_empty() {
                    return quote!(#statements #velocities);
                }
                let root = &self.emitter.declaration.root;
                quote! {
                    #statements
                    #root::__private::if_positive([#(#pivots),*], #velocities, || {
                        #root::__private::no_velocities()
                    })
                }
            }
            MethodOutputs::RelativePivots(outputs) => self.relative_pivots(outputs),
            MethodOutputs::Pivots(pivots) => self.returned(pivots, |writer, pivots| {
                let root = &writer.emitter.declaration.root;
                quote!(#root::__private::not_positive([#(#pivots),*]))
            }),
            MethodOutputs::Declared(outputs) => self.declared_outputs(outputs),
            MethodOutputs::ByColumns(columns) => self.by_columns(*columns),
        }
    }

    /// The body that returns what is made of some outputs.
    fn returned(
        &mut self,
        slice: &OutputSlice,
        value: impl FnOnce(&Self, &[TokenStream]) -> TokenStream,
    ) -> TokenStream {
        let (statements, elements) = self.compute(slice);
        joined([statements, value(self, &elements)])
    }

    /// The statements that compute some outputs, as far as they are not written yet, and the outputs.
    pub(super) fn compute(&mut self, slice: &OutputSlice) -> (TokenStream, Vec<TokenStream>) {
        let mut statements = TokenStream::new();
        let groups = self.method.program.groups.iter();
        for group in groups.take(slice.group() + 1).skip(self.computed.len()) {
            let (more, outputs) = self.body.group(group);
            statements.extend(more);
            self.computed.push(outputs);
        }
        (statements, slice.of(&self.computed).to_vec())
    }

    /// The statements before the solution of the equations of motion, and the solution: the accelerations, and with constraints
    /// the multipliers behind.
    pub(super) fn accelerations(
        &mut self,
        outputs: &AccelerationOutputs,
    ) -> (TokenStream, TokenStream) {
        match outputs {
            AccelerationOutputs::Symbolic {
                pivots,
                accelerations,
            } => {
                let (statements, pivots) = self.compute(pivots);
                let (_, accelerations) = self.compute(accelerations);
                (statements, self.if_positive(&pivots, &accelerations))
            }
            AccelerationOutputs::Numerical { mass, forcing } => {
                let (statements, factors) = self.factors(mass);
                let (_, forcing) = self.compute(forcing);
                let forcing = self.vector(&forcing);
                (
                    joined([statements, factors]),
                    quote!(factors.solve(&#forcing)),
                )
            }
        }
    }

    /// A solution that holds where all pivots are positive; elsewhere the matrix is factored numerically.
    pub(super) fn if_positive(
        &self,
        pivots: &[TokenStream],
        accelerations: &[TokenStream],
    ) -> TokenStream {
        let root = &self.emitter.declaration.root;
        let accelerations = self.vector(accelerations);
        if pivots.is_empty() {
            return accelerations;
        }
        let factors = self.factors_by_methods();
        let right = self.emitter.right_hand_side(self.parameters);
        quote! {
            #root::__private::if_positive([#(#pivots),*], #accelerations, || {
                #factors.solve(&#right)
            })
        }
    }

    /// The factors of M, or of the saddle point problem, by other methods.
    pub(super) fn factors_by_methods(&self) -> TokenStream {
        self.emitter.factors(self.parameters)
    }

    /// A call of another method at the same state and inputs.
    pub(super) fn call(&self, method: EmittedMethod) -> TokenStream {
        self.emitter.call(method, self.parameters)
    }

    /// Whether the program reads accelerations.
    pub(super) fn reads_accelerations(&self) -> bool {
        let symbols = self.method.program.symbols();
        let mut symbols = symbols.iter();
        symbols.any(|symbol| matches!(symbol, Symbol::Acceleration(_)))
    }

    /// The relative pivots where all pivots are positive; else those of a numerical factorization of M.
    fn relative_pivots(&mut self, outputs: &PivotOutputs) -> TokenStream {
        let root = &self.emitter.declaration.root;
        let (statements, positive) = self.compute(&outputs.positive);
        let (more, pivots) = self.compute(&outputs.pivots);
        let (_, magnitudes) = self.compute(&outputs.magnitudes);
        let (_, diagonal) = self.compute(&outputs.diagonal);
        let positions = outputs.by_coordinate.iter().map(|positions| {
            let positions = positions.iter().copied().map(Literal::usize_unsuffixed);
            quote!(&[#(#positions),*])
        });
        let relative = quote! {
            #root::__private::relative_pivots(
                [#(#pivots),*], [#(#magnitudes),*], [#(#diagonal),*], [#(#positions),*]
            )
        };
        if positive.is_empty() {
            return quote!(#statements #more #relative);
        }
        let factors = self.factors_by_methods();
        quote! {
            #statements #more
            #root::__private::if_positive([#(#positive),*], #relative, || {
                #root::__private::factored_pivots(&#factors)
            })
        }
    }

    /// Factors M, or the matrix of the saddle point problem, of which a program computes the lower triangle.
    pub(super) fn factors(&mut self, mass: &LowerTriangle) -> (TokenStream, TokenStream) {
        let root = &self.emitter.declaration.root;
        let functions = self.emitter.scalar.functions();
        let zero = quote!(#functions::from_f64(0.0));
        let n = self.emitter.unknowns();
        let (statements, lower) = self.compute(&mass.0);
        let entries = (0..n).flat_map(|column| (0..n).map(move |row| (row, column)));
        let entries = entries.map(|(row, column)| {
            let entry = lower.get(LowerTriangle::position(row, column));
            entry.filter(|_| row >= column).unwrap_or(&zero).clone()
        });
        let matrix = self.matrix_of(&entries.collect::<Vec<_>>(), n);
        let factors = if self.emitter.is_constrained() {
            self.emitter.saddle_point(&matrix, self.parameters)
        } else {
            quote!(#root::Factorization::new(#matrix))
        };
        (statements, quote!(let factors = #factors;))
    }

    /// Statements that may read accelerations and multipliers, behind the call that computes them.
    fn behind_accelerations(&self, statements: TokenStream) -> TokenStream {
        if !self.reads_accelerations() {
            return statements;
        }
        let call = if self.emitter.is_constrained() {
            let pattern = pattern_of_parts(&statements);
            let both = self.call(EmittedMethod::AccelerationsAndMultipliers);
            quote!(let #pattern = #both;)
        } else {
            let accelerations = self.call(EmittedMethod::Accelerations);
            quote!(let accelerations = #accelerations;)
        };
        joined([call, statements])
    }

    /// The struct of the declared outputs.
    fn declared_outputs(&mut self, outputs: &[(Shape, OutputSlice)]) -> TokenStream {
        let mut statements = TokenStream::new();
        let mut fields = Vec::with_capacity(outputs.len());
        let declaration = self.emitter.declaration;
        for (output, (shape, slice)) in declaration.clauses.outputs.iter().zip(outputs) {
            let (more, components) = self.compute(slice);
            statements.extend(more);
            let (name, value) = (&output.name, self.value(&components, *shape));
            fields.push(quote!(#name: #value));
        }
        let results = outputs_name(declaration);
        self.behind_accelerations(quote!(#statements #results { #(#fields),* }))
    }

    /// A value from its components.
    fn value(&self, components: &[TokenStream], shape: Shape) -> TokenStream {
        match shape {
            Shape::Scalar => quote!(#(#components)*),
            Shape::Array { columns: 1, .. } => self.vector(components),
            Shape::Array { rows, .. } => self.matrix_of(components, rows),
        }
    }

    pub(super) fn vector(&self, elements: &[TokenStream]) -> TokenStream {
        let root = &self.emitter.declaration.root;
        quote!(#root::__private::vector([#(#elements),*]))
    }

    /// A matrix with a row for each unknown, from its elements, column by column.
    pub(super) fn columns(&self, elements: &[TokenStream]) -> TokenStream {
        self.matrix_of(elements, self.emitter.unknowns())
    }

    /// A matrix with a row for each coordinate, from its elements, column by column.
    pub(super) fn matrix(&self, elements: &[TokenStream]) -> TokenStream {
        self.matrix_of(elements, self.emitter.coordinates())
    }

    /// A matrix from its elements, column by column.
    fn matrix_of(&self, elements: &[TokenStream], rows: usize) -> TokenStream {
        let root = &self.emitter.declaration.root;
        let columns = elements
            .chunks(rows.max(1))
            .map(|column| quote!([#(#column),*]));
        quote!(#root::__private::matrix([#(#columns),*]))
    }
}
