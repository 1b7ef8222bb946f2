//! Where the emitted code reads the values of symbols.

use lagrangian_symbolic::Symbol;
use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use super::body::{Array, Element, SymbolReader};
use super::emitter::Emitter;
use crate::lower::quantities::Component;
use crate::plan::ParameterSource;

/// Reads the symbols of a model.
pub(super) struct ModelSymbols<'a> {
    pub(super) emitter: &'a Emitter<'a>,
    /// Where parameters are.
    pub(super) parameters: ParameterSource,
}

impl ModelSymbols<'_> {
    /// The index of a symbol in the prepared array, if it is read there.
    fn prepared(&self, symbol: Symbol) -> Option<usize> {
        match (symbol, self.parameters) {
            (Symbol::Invariant(_), _) | (Symbol::Parameter(_), ParameterSource::Prepared) => {
                self.emitter.prepared.index(symbol)
            }
            _ => None,
        }
    }
}

impl SymbolReader for ModelSymbols<'_> {
    fn read(&self, symbol: Symbol) -> TokenStream {
        if let Some(index) = self.prepared(symbol) {
            let index = Literal::usize_unsuffixed(index);
            return quote!(prepared[#index]);
        }
        let quantities = &self.emitter.lowered.quantities;
        let field = |components: &[Component], i: u32| self.emitter.read(&components[i as usize]);
        match symbol {
            Symbol::Time => quote!(state.t),
            Symbol::Coordinate(i) => element(&quote!(state.x.q), i),
            Symbol::Velocity(i) => element(&quote!(state.x.v), i),
            Symbol::Acceleration(i) => unknown(i, self.emitter.coordinates()),
            Symbol::RightHandSide(i) => element(&quote!(momenta), i),
            Symbol::Parameter(i) => field(&quantities.parameters, i),
            Symbol::Input(i) => element(&quote!(inputs), i),
            Symbol::Variation(i) => element(&quote!(variation), i),
            Symbol::Argument(i) => element(&quote!(arguments), i),
            // Invariants are in the prepared array. Symbols of recurrences, which are read from their terms, of equations before they are solved, and of vectors
            // before they are resolved.
            Symbol::Invariant(_)
            | Symbol::Order
            | Symbol::ReciprocalOrder
            | Symbol::Convolution(_)
            | Symbol::QuasiVelocity(_)
            | Symbol::QuasiVelocityRate(_)
            | Symbol::PositionComponent(_)
            | Symbol::VelocityComponent(_) => TokenStream::new(),
        }
    }

    fn element(&self, symbol: Symbol) -> Option<Element> {
        Some(Element {
            array: Ident::new("prepared", Span::call_site()),
            length: self.emitter.prepared.len(),
            index: self.prepared(symbol)?,
        })
    }

    fn array(&self, symbol: Symbol) -> Option<Array> {
        if let Some(index) = self.prepared(symbol) {
            return Some(Array {
                value: quote!(*prepared),
                length: self.emitter.prepared.len(),
                index,
            });
        }
        let n = self.emitter.coordinates();
        let (vector, length, index) = match symbol {
            Symbol::Coordinate(i) => (quote!(state.x.q), n, i),
            Symbol::Velocity(i) => (quote!(state.x.v), n, i),
            Symbol::Acceleration(i) if (i as usize) < n => (quote!(accelerations), n, i),
            Symbol::RightHandSide(i) => (quote!(momenta), n, i),
            Symbol::Input(i) => (quote!(inputs), self.emitter.model.inputs as usize, i),
            _ => return None,
        };
        Some(Array {
            value: quote!(#vector.data.0[0]),
            length,
            index: index as usize,
        })
    }
}

/// The tokens of an acceleration, or of a multiplier behind those.
pub(super) fn unknown(index: u32, coordinates: usize) -> TokenStream {
    let multiplier = usize::try_from(index).ok();
    let multiplier = multiplier.and_then(|index| index.checked_sub(coordinates));
    match multiplier {
        Some(index) => {
            let index = Literal::usize_unsuffixed(index);
            quote!(multipliers[#index])
        }
        None => element(&quote!(accelerations), index),
    }
}

/// The tokens of an element.
pub(super) fn element(vector: &TokenStream, index: u32) -> TokenStream {
    let index = Literal::u32_unsuffixed(index);
    quote!(#vector[#index])
}
