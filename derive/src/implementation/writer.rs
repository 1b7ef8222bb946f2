//! The bodies of methods, each in the shape that it returns.

use lagrangian_symbolic::{Operand, Program, Rational, Symbol};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::body::Body;
use crate::root::Root;
use crate::scalar::Scalar;
use crate::value::Shape;

/// The body of one method, in the shape that it returns.
pub(super) struct Writer<'a> {
    pub(super) program: &'a Program,
    pub(super) body: Body<'a>,
    pub(super) scalar: &'a Scalar<'a>,
    pub(super) root: &'a Root,
}

impl Writer<'_> {
    pub(super) fn phase(&mut self, index: usize) -> (TokenStream, Vec<TokenStream>) {
        self.body.phase(&self.program.phases[index])
    }

    pub(super) fn columns(&mut self, rows: usize) -> TokenStream {
        let (statements, outputs) = self.phase(0);
        let matrix = self.matrix(&outputs, rows);
        quote!(#statements #matrix)
    }

    /// Solves M q̈ = f.
    pub(super) fn accelerations(&mut self, n: usize) -> TokenStream {
        let (statements, outputs) = self.phase(0);
        let factors = self.factors(&outputs, n);
        let forcing = self.vector(&outputs[outputs.len() - n..]);
        quote!(#statements #factors factors.solve(&#forcing))
    }

    /// The accelerations of a solution that holds where all pivots are positive; else M is factored in
    /// numbers.
    pub(super) fn eliminated(
        &mut self,
        n: usize,
        pivots: usize,
        forcing: &TokenStream,
    ) -> TokenStream {
        let (statements, outputs) = self.phase(0);
        let accelerations = self.solved(n, &outputs, pivots, forcing);
        quote!(#statements #accelerations)
    }

    /// The accelerations from the outputs of their program.
    fn solved(
        &self,
        n: usize,
        outputs: &[TokenStream],
        pivots: usize,
        forcing: &TokenStream,
    ) -> TokenStream {
        let root = self.root;
        let (pivots, accelerations) = outputs.split_at(pivots);
        let accelerations = self.vector(accelerations);
        if pivots.is_empty() {
            return accelerations;
        }
        let factors = self.factors_of_mass_matrix(n);
        quote! {
            #root::__private::if_positive([#(#pivots),*], #accelerations, || {
                #factors.solve(&#forcing)
            })
        }
    }

    fn factors_of_mass_matrix(&self, n: usize) -> TokenStream {
        let root = self.root;
        let mass = self.mass_matrix(n);
        quote!(#root::Factorization::new(#mass))
    }

    fn mass_matrix(&self, n: usize) -> TokenStream {
        let root = self.root;
        let scalar = self.scalar;
        quote!(#root::Lagrangian::<#n, #scalar>::mass_matrix(self, state))
    }

    /// The derivatives of the accelerations, solved for before any number is known.
    pub(super) fn derivatives(
        &mut self,
        n: usize,
        pivots: usize,
        forcing: &TokenStream,
    ) -> TokenStream {
        let root = self.root;
        let (statements, outputs) = self.phase(0);
        let accelerations = self.solved(n, &outputs, pivots, forcing);
        let uses = self.program.symbols();
        let used = uses
            .iter()
            .any(|symbol| matches!(symbol, Symbol::Acceleration(_)));
        let accelerations =
            (used || pivots > 0).then(|| quote!(let accelerations = #accelerations;));
        let (more, columns) = self.phase(1);
        let linearization = self.linearization(&columns, n);
        if pivots == 0 {
            return quote!(#statements #accelerations #more #linearization);
        }
        let (others, residuals) = self.phase(2);
        let otherwise = self.linearization_of_residuals(2, &residuals, n);
        let factors = self.factors_of_mass_matrix(n);
        let pivots = &outputs[..pivots];
        quote! {
            #statements #accelerations #more #others
            #root::__private::if_positive([#(#pivots),*], #linearization, || {
                let factors = #factors;
                #otherwise
            })
        }
    }

    /// The relative pivots where all pivots are positive; else those of M in numbers.
    pub(super) fn relative_pivots(&mut self, n: usize) -> TokenStream {
        let root = self.root;
        let (statements, outputs) = self.phase(0);
        let lists = outputs.chunks(n.max(1)).map(|list| quote!([#(#list),*]));
        let mass = self.mass_matrix(n);
        quote!(#statements #root::__private::relative_pivots(#(#lists,)* || #mass))
    }

    /// Solves M q̈ = f, then M ∂q̈/∂x = −∂(M q̈ − f)/∂x.
    pub(super) fn linearize(&mut self, n: usize) -> TokenStream {
        let (statements, outputs) = self.phase(0);
        let factors = self.factors(&outputs, n);
        let forcing = self.vector(&outputs[outputs.len() - n..]);
        let (more, derivatives) = self.phase(1);
        let linearization = self.linearization_of_residuals(1, &derivatives, n);
        quote! {
            #statements
            #factors
            let accelerations = factors.solve(&#forcing);
            #more
            #linearization
        }
    }

    /// ∂q̈/∂u.
    pub(super) fn input_jacobian(&mut self, n: usize, pivots: Option<usize>) -> TokenStream {
        let root = self.root;
        let (statements, outputs) = self.phase(0);
        let (more, columns) = self.phase(1);
        let columns = self.matrix(&columns, n);
        match pivots {
            None => {
                let factors = self.factors(&outputs, n);
                quote!(#statements #more #factors -factors.solve(&#columns))
            }
            Some(0) => quote!(#statements #more #columns),
            Some(_) => {
                let (others, residuals) = self.phase(2);
                let residuals = self.matrix(&residuals, n);
                let factors = self.factors_of_mass_matrix(n);
                quote! {
                    #statements #more #others
                    #root::__private::if_positive([#(#outputs),*], #columns, || {
                        -#factors.solve(&#residuals)
                    })
                }
            }
        }
    }

    /// The derivatives −M⁻¹ ∂(M q̈ − f)/∂x, where `factors` are those of M, from the outputs of a phase. All
    /// columns are solved for at once, but for ∂/∂t where the time does not occur.
    fn linearization_of_residuals(
        &self,
        phase: usize,
        columns: &[TokenStream],
        n: usize,
    ) -> TokenStream {
        let root = self.root;
        let outputs = &self.program.phases[phase].outputs;
        let zero = Operand::Constant(Rational::ZERO);
        let timeless = outputs[2 * n * n..].iter().all(|output| *output == zero);
        let count = if timeless { 2 * n } else { 2 * n + 1 };
        let columns = self.matrix(&columns[..count * n], n);
        quote!(#root::__private::linearization(&factors, &#columns))
    }

    /// Factors M, whose lower triangle stands first among the outputs.
    fn factors(&self, outputs: &[TokenStream], n: usize) -> TokenStream {
        let root = self.root;
        let functions = self.scalar.functions();
        let zero = quote!(#functions::from_f64(0.0));
        let columns: Vec<_> = (0..n)
            .flat_map(|j| (0..n).map(move |i| (i, j)))
            .map(|(i, j)| {
                if i < j {
                    &zero
                } else {
                    &outputs[i * (i + 1) / 2 + j]
                }
            })
            .cloned()
            .collect();
        let mass = self.matrix(&columns, n);
        quote!(let factors = #root::Factorization::new(#mass);)
    }

    pub(super) fn outputs(
        &mut self,
        results: &Ident,
        named: &[(&Ident, Shape)],
        accelerations: &TokenStream,
    ) -> TokenStream {
        let accelerates = self
            .program
            .symbols()
            .iter()
            .any(|symbol| matches!(symbol, Symbol::Acceleration(_)));
        let accelerations = accelerates.then(|| quote!(let accelerations = #accelerations;));
        let (statements, outputs) = self.phase(0);
        let mut outputs = outputs.as_slice();
        let fields = named.iter().map(|(name, shape)| {
            let (components, rest) = outputs.split_at(shape.count());
            outputs = rest;
            let value = self.value(components, *shape);
            quote!(#name: #value)
        });
        let fields: Vec<_> = fields.collect();
        quote!(#accelerations #statements #results { #(#fields),* })
    }

    /// The derivatives by q, q̇ and t from their columns.
    fn linearization(&self, columns: &[TokenStream], n: usize) -> TokenStream {
        let root = self.root;
        let position = self.matrix(&columns[..n * n], n);
        let velocity = self.matrix(&columns[n * n..2 * n * n], n);
        let time = self.vector(&columns[2 * n * n..]);
        quote! {
            #root::Linearization {
                position: #position,
                velocity: #velocity,
                time: #time,
            }
        }
    }

    /// A value from its components.
    fn value(&self, components: &[TokenStream], shape: Shape) -> TokenStream {
        match shape {
            Shape::Scalar => quote!(#(#components)*),
            Shape::Array { columns: 1, .. } => self.vector(components),
            Shape::Array { rows, .. } => self.matrix(components, rows),
        }
    }

    fn vector(&self, elements: &[TokenStream]) -> TokenStream {
        let root = self.root;
        quote!(#root::__private::SVector::from([#(#elements),*]))
    }

    /// A matrix from its elements, column by column.
    fn matrix(&self, elements: &[TokenStream], rows: usize) -> TokenStream {
        let root = self.root;
        let columns = elements
            .chunks(rows.max(1))
            .map(|column| quote!([#(#column),*]));
        quote!(#root::__private::SMatrix::from([#(#columns),*]))
    }
}

/// A body that returns the one output.
pub(super) fn as_scalar(writer: &mut Writer<'_>) -> TokenStream {
    let (statements, outputs) = writer.phase(0);
    quote!(#statements #(#outputs)*)
}

/// A body that returns all outputs as a vector.
pub(super) fn as_vector(writer: &mut Writer<'_>) -> TokenStream {
    let (statements, outputs) = writer.phase(0);
    let vector = writer.vector(&outputs);
    quote!(#statements #vector)
}
