//! The bodies of methods, each in the shape that it returns.

use lagrangian_symbolic::{Program, Symbol};
use proc_macro2::{Ident, TokenStream};
use quote::quote;

use crate::body::Body;

/// The body of one method, in the shape that it returns.
pub(super) struct Writer<'a> {
    pub(super) program: &'a Program,
    pub(super) body: Body<'a>,
    pub(super) scalar: &'a Ident,
}

impl Writer<'_> {
    pub(super) fn phase(&mut self, index: usize) -> (TokenStream, Vec<TokenStream>) {
        self.body.phase(&self.program.phases[index])
    }

    pub(super) fn columns(&mut self, rows: usize) -> TokenStream {
        let (statements, outputs) = self.phase(0);
        let matrix = matrix(&outputs, rows);
        quote!(#statements #matrix)
    }

    /// Solves M q̈ = f.
    pub(super) fn accelerations(&mut self, n: usize) -> TokenStream {
        let (statements, outputs) = self.phase(0);
        let factors = self.factors(&outputs, n);
        let forcing = vector(&outputs[outputs.len() - n..]);
        quote!(#statements #factors factors.solve(&#forcing))
    }

    /// The accelerations of an elimination whose pivots are positive; else M is factored in numbers.
    pub(super) fn eliminated(
        &mut self,
        n: usize,
        pivots: usize,
        forcing: &TokenStream,
    ) -> TokenStream {
        let (statements, outputs) = self.phase(0);
        let (pivots, accelerations) = outputs.split_at(pivots);
        let accelerations = vector(accelerations);
        let scalar = self.scalar;
        quote! {
            #statements
            ::lagrangian::__private::if_positive([#(#pivots),*], #accelerations, || {
                let mass = ::lagrangian::Lagrangian::<#n, #scalar>::mass_matrix(self, state);
                ::lagrangian::Factorization::new(mass).solve(&#forcing)
            })
        }
    }

    pub(super) fn relative_pivots(&mut self, n: usize) -> TokenStream {
        let (statements, outputs) = self.phase(0);
        let lists = outputs.chunks(n.max(1)).map(|list| quote!([#(#list),*]));
        quote!(#statements ::lagrangian::__private::relative_pivots(#(#lists),*))
    }

    /// Solves M q̈ = f, then M ∂q̈/∂x = −∂(M q̈ − f)/∂x.
    pub(super) fn linearize(&mut self, n: usize) -> TokenStream {
        let (statements, outputs) = self.phase(0);
        let factors = self.factors(&outputs, n);
        let forcing = vector(&outputs[outputs.len() - n..]);
        let (more, derivatives) = self.phase(1);
        let position = matrix(&derivatives[..n * n], n);
        let velocity = matrix(&derivatives[n * n..2 * n * n], n);
        let time = vector(&derivatives[2 * n * n..]);
        quote! {
            #statements
            #factors
            let accelerations = factors.solve(&#forcing);
            #more
            ::lagrangian::Linearization {
                position: -factors.solve(&#position),
                velocity: -factors.solve(&#velocity),
                time: -factors.solve(&#time),
            }
        }
    }

    pub(super) fn input_jacobian(&mut self, n: usize) -> TokenStream {
        let (statements, outputs) = self.phase(0);
        let factors = self.factors(&outputs, n);
        let derivatives = matrix(&outputs[n * (n + 1) / 2..], n);
        quote!(#statements #factors -factors.solve(&#derivatives))
    }

    /// Factors M, whose lower triangle stands first among the outputs.
    fn factors(&self, outputs: &[TokenStream], n: usize) -> TokenStream {
        let scalar = self.scalar;
        let zero = quote!(#scalar::from_f64(0.0));
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
        let mass = matrix(&columns, n);
        quote!(let factors = ::lagrangian::Factorization::new(#mass);)
    }

    pub(super) fn outputs(
        &mut self,
        results: &Ident,
        names: &[&Ident],
        accelerations: &TokenStream,
    ) -> TokenStream {
        let accelerates = self
            .program
            .symbols()
            .iter()
            .any(|symbol| matches!(symbol, Symbol::Acceleration(_)));
        let accelerations = accelerates.then(|| quote!(let accelerations = #accelerations;));
        let (statements, outputs) = self.phase(0);
        quote!(#accelerations #statements #results { #(#names: #outputs),* })
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
    let vector = vector(&outputs);
    quote!(#statements #vector)
}

fn vector(elements: &[TokenStream]) -> TokenStream {
    quote!(::lagrangian::__private::SVector::from([#(#elements),*]))
}

/// A matrix from its elements, column by column.
fn matrix(elements: &[TokenStream], rows: usize) -> TokenStream {
    let columns = elements
        .chunks(rows.max(1))
        .map(|column| quote!([#(#column),*]));
    quote!(::lagrangian::__private::SMatrix::from([#(#columns),*]))
}
