//! The items that are emitted for a model.

mod acceleration_derivatives;
mod as_declared;
mod body;
mod by_columns;
mod c;
mod constants;
mod constants_of_motion;
mod constraints;
mod documentation;
mod editor;
mod emitter;
mod implementation;
mod events;
mod external_functions;
mod fallback;
mod impacts;
mod inputs;
mod item_names;
mod locals;
mod members_in_lanes;
mod methods;
mod model_symbols;
mod on_another_scalar;
mod outputs;
mod parameters;
mod printed_names;
mod reflect;
mod requested;
mod routhian;
mod signatures;
mod taylor_series;
mod warnings;
mod writer;

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
