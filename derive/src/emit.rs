//! The items that are emitted for a model.

mod emitter;
mod implementation;
mod members_in_lanes;
mod methods;
mod constants;
mod constants_of_motion;
mod inputs;
mod on_another_scalar;
mod outputs;
mod events;
mod impacts;
mod constraints;
mod requested;
mod reflect;
mod c;
mod external_functions;
mod routhian;
mod item_names;
mod signatures;
mod parameters;
mod writer;
mod acceleration_derivatives;
mod by_columns;
mod taylor_series;
mod model_symbols;
mod body;
mod locals;
mod documentation;
mod printed_names;
mod as_declared;
mod editor;
mod warnings;
mod fallback;

use proc_macro2::TokenStream;

#[cfg(test)]
pub(crate) use documentation::declared;
pub(crate) use documentation::listing;
pub(crate) use emitter::Emitter;
pub(crate) use fallback::{items as items_without_equations, reduced_without_equations};
pub(crate) use printed_names::printed_names;
pub(crate) use routhian::reduced_struct;
pub(crate) use warnings::warning;

/// All items, in the order in which a reader wants them.
pub(crate) fn items(emitter: &Emitter<'_>) -> TokenStream {
    [
        emitter.constants(),
        emitter.system(),
        emitter.quantities(),
        emitter.state_jacobian(),
        emitter.constraints(),
        emitter.directional_derivatives(),
        emitter.energies(),
        emitter.constants_of_motion(),
        emitter.inputs(),
        emitter.outputs(),
        emitter.functions(),
        emitter.taylor_series(),
        emitter.events(),
        emitter.impacts(),
        emitter.requested(),
        emitter.reflect(),
    ]
    .into_iter()
    .collect()
}
