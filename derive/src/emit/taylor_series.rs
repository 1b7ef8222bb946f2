//! The impl of `MotionSeries`: the Taylor coefficients of a motion.
//!
//! The emitted code computes the accelerations of order 0, and in a closure those of any order k from the terms of
//! order k and the convolutions of lower ones. The loop over the orders is in the runtime.

use lagrangian_symbolic::{Convolution, Symbol, TaylorProgram};
use proc_macro2::{Ident, Span, TokenStream};
use quote::quote;

use super::body::{Body, SymbolReader};
use super::emitter::Emitter;
use super::model_symbols::{element, unknown};
use super::printed_names::printed_names;
use super::writer::{Writer, joined};
use crate::limits::MAX_SWITCHING_FUNCTION_LENGTH;
use crate::plan::{AccelerationOutputs, BranchSeries, ParameterSource, Rates, TaylorMethod};
use crate::syntax::root::Root;

/// The `f64` in a vector register of 256 bits.
const REGISTER: usize = 4;

/// As many pairs of factors are summed at once: the sums of four orders stay in registers, and the compiler unrolls what is
/// done for each pair of a block. Blocks of 32 were functions that are called; ten links took twice the time.
const MAX_BLOCK: usize = 24;

/// Reads the symbols of the recurrence for the terms of order k, in a model with so many coordinates.
struct TermSymbols(usize);

impl SymbolReader for TermSymbols {
    fn read(&self, symbol: Symbol) -> TokenStream {
        match symbol {
            Symbol::Time => quote!(term.t),
            Symbol::Coordinate(i) => element(&quote!(term.q), i),
            Symbol::Velocity(i) | Symbol::QuasiVelocity(i) => element(&quote!(term.v), i),
            Symbol::Input(i) => element(&quote!(term_of_inputs), i),
            Symbol::Acceleration(i) => unknown(i, self.0),
            Symbol::Order => quote!(term.order),
            Symbol::ReciprocalOrder => quote!(term.reciprocal_order),
            Symbol::Convolution(i) => element(&quote!(term.convolutions), i),
            // The rest does not depend on the order.
            Symbol::Invariant(i)
            | Symbol::Parameter(i)
            | Symbol::Argument(i)
            | Symbol::RightHandSide(i)
            | Symbol::PositionComponent(i)
            | Symbol::VelocityComponent(i)
            | Symbol::Variation(i)
            | Symbol::QuasiVelocityRate(i) => element(&quote!(invariants), i),
        }
    }
}

impl Emitter<'_> {
    /// The impl of `MotionSeries`, for a model with the clause `taylor`.
    pub(super) fn taylor_series(&self) -> TokenStream {
        let Some(series) = self.series else {
            return TokenStream::new();
        };
        let (root, scalar, n) = (&self.declaration.root, &self.scalar, self.coordinates());
        let state = self.signatures().state();
        let body = self.series(&series.motion);
        let (inputs, orders) = self.series_of_inputs(&body);
        let prepared = self.prepared_parameter(&body);
        let (branches, events) = (self.branches(), self.events_in_step());
        let names = self.switching_functions();
        let items = quote! {
            #names
            fn taylor_series<const HALF: usize>(
                &self,
                state: #state,
                #inputs
                #prepared
                unit: #scalar,
                coefficients: &mut #root::TaylorCoefficients<#root::Phase<#scalar, #n>, HALF>,
                memory: ::core::option::Option<&mut #root::SeriesMemory>,
            ) {
                #orders
                #body
            }
            #branches
            #events
        };
        self.implement(
            &quote!(#root::quantities::MotionSeries<#n, #scalar>),
            &items,
        )
    }

    /// The series of the switching functions, for equations that have some.
    fn branch_series(&self) -> Option<&BranchSeries> {
        self.series?.branches.as_ref()
    }

    /// What is known of the switching functions, for equations that have some.
    fn switching_functions(&self) -> Option<TokenStream> {
        let series = self.branch_series()?;
        let root = &self.declaration.root;
        let names = printed_names(self.lowered);
        let functions = series.functions.iter().zip(&series.are_inner);
        let functions = functions.map(|(function, is_inner)| {
            let formula = self.model.graph.display(*function, &names);
            let name = formula.limit(MAX_SWITCHING_FUNCTION_LENGTH).to_string();
            quote!(#root::SwitchingFunction { name: #name, is_inner: #is_inner })
        });
        Some(quote! {
            const SWITCHING_FUNCTIONS: &'static [#root::SwitchingFunction] = &[#(#functions),*];
        })
    }

    /// The method that visits the series of the arguments of branches, for equations that have some.
    fn branches(&self) -> Option<TokenStream> {
        let series = self.branch_series()?;
        let (root, scalar) = (&self.declaration.root, &self.scalar);
        let body = self.body_of_series(&series.series);
        let visit = quote!(visit: &mut #root::BranchVisitor<'_, #scalar>);
        let visited = quote!(#root::__private::visit_branches(&{ #body }, visit););
        Some(self.function_of_series(&quote!(branch_series), false, Some(&visit), &visited, None))
    }

    fn series(&self, method: &TaylorMethod) -> TokenStream {
        let (root, scalar) = (&self.declaration.root, &self.scalar);
        self.with_writer(&method.initial, ParameterSource::Prepared, &[], |writer| {
            let (statements, rates) = match &method.rates {
                Rates::Accelerations(outputs) => writer.accelerations(outputs),
                Rates::QuasiVelocities(rates) => {
                    let (statements, rates) = writer.compute(rates);
                    (statements, writer.vector(&rates))
                }
            };
            let expansion = match &method.rates {
                Rates::Accelerations(_) => quote!(taylor_series),
                Rates::QuasiVelocities(_) => quote!(taylor_series_in_quasi_velocities),
            };
            let (more, invariants) = writer.compute(&method.invariants);
            let term = self.term(method, writer);
            let (n, factors) = (self.coordinates(), method.program.factors());
            let of_variables = method.program.quasi_velocities.map(|count| quote!(#count,));
            let (pairs, lanes) = in_blocks(&method.program.convolutions);
            let count_of_pairs = pairs.len();
            let arrange = arrangement(&pairs, factors);
            let pairs = factor_pairs(root, &method.program.convolutions, count_of_pairs);
            let count = invariants.len();
            let next_inputs = self.next_inputs();
            let is_solution = matches!(method.rates, Rates::Accelerations(_));
            let parts = if is_solution {
                let readers = quote!(#more accelerations);
                self.parts_of_solution(&rates, &readers)
            } else {
                quote!(let accelerations = #rates;)
            };
            quote! {
                #statements
                #parts
                #more
                let invariants: [#scalar; #count] = [#(#invariants),*];
                #root::__private::#expansion::<_, #n, #of_variables #factors, #count_of_pairs, #lanes, HALF>(
                    state, unit, accelerations, (coefficients, memory), { #pairs }, #arrange, |term| { #next_inputs #term },
                );
            }
        })
    }

    /// The accelerations of order k, or the velocities and the rates of quasi-velocities, and the factors of the
    /// convolutions.
    fn term(&self, method: &TaylorMethod, writer: &Writer<'_>) -> TokenStream {
        let [(statements, computed), (more, factors)] = self.recurrence(&method.program);
        let vector = writer.vector(&computed);
        let solution = match &method.rates {
            Rates::Accelerations(AccelerationOutputs::Symbolic { .. }) => vector,
            Rates::Accelerations(AccelerationOutputs::Numerical { .. }) => {
                quote!(factors.solve(&#vector))
            }
            Rates::QuasiVelocities(_) => {
                let (velocities, rates) = computed.split_at(self.coordinates());
                let [velocities, rates] = [velocities, rates].map(|part| writer.vector(part));
                return quote!(#statements #more (#velocities, #rates, [#(#factors),*]));
            }
        };
        let behind = quote! {
            #more
            (accelerations, [#(#factors),*])
        };
        let parts = self.parts_of_solution(&solution, &behind);
        joined([statements, parts, behind])
    }

    /// The statements and the results of the two groups of a recurrence.
    pub(super) fn recurrence(
        &self,
        taylor: &TaylorProgram,
    ) -> [(TokenStream, Vec<TokenStream>); 2] {
        let symbols = TermSymbols(self.coordinates());
        let mut body = Body::new(
            &taylor.recurrence,
            self.model.graph.passes,
            self.locals(),
            &self.scalar,
            &symbols,
            Vec::new(),
            self.limits.of_body(false),
        );
        let groups = taylor.recurrence.groups.iter();
        let mut groups = groups.map(|group| body.group(group));
        core::array::from_fn(|_| groups.next().unwrap_or_default())
    }
}

/// The pairs of the convolutions in blocks, and the number of pairs in a block, the last of which is filled by repeating
/// the last pair.
fn in_blocks(convolutions: &[Convolution]) -> (Vec<&Convolution>, usize) {
    let blocks = convolutions.len().div_ceil(MAX_BLOCK).max(1);
    let registers = convolutions.len().div_ceil(blocks).div_ceil(REGISTER);
    let lanes = (registers * REGISTER).max(1);
    let last = convolutions.last().into_iter();
    let filled = convolutions.len().next_multiple_of(lanes);
    let repeated = last.cycle().take(filled - convolutions.len());
    let pairs = convolutions.iter().chain(repeated);
    (pairs.collect(), lanes)
}

/// The first and the second factors of the pairs. Patterns are checked much faster than indices.
fn arrangement(pairs: &[&Convolution], factors: usize) -> TokenStream {
    let names: Vec<_> = (0..factors)
        .map(|i| Ident::new(&format!("f{i}"), Span::mixed_site()))
        .collect();
    let first = pairs.iter().filter_map(|pair| names.get(pair.0));
    let second = pairs.iter().filter_map(|pair| names.get(pair.1));
    quote!(|&[#(#names),*]| [[#(#first),*], [#(#second),*]])
}

/// A value of a type with the factors of the pairs of convolutions, for so many places.
pub(super) fn factor_pairs(
    root: &Root,
    convolutions: &[Convolution],
    places: usize,
) -> TokenStream {
    let sums = convolutions.iter().enumerate().map(|(place, pair)| {
        let (x, y) = (pair.0, pair.1);
        quote!(sums.of(#place, #x, #y))
    });
    let none = (convolutions.len()..places).map(|_| quote!(sums.none()));
    let all = sums.chain(none);
    quote! {
        struct Pairs;
        impl #root::__private::FactorPairs<#places> for Pairs {
            #[inline(always)]
            fn each<S>(sums: &mut impl #root::__private::PairSums<S>) -> [S; #places] {
                [#(#all),*]
            }
        }
        Pairs
    }
}
