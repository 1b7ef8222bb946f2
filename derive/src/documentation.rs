//! What the emitted impl says of itself.

use crate::implementation::Implementation;

/// The documentation of the model's impl: coordinates, energies, mass matrix, equations of motion.
pub(crate) fn of(implementation: &Implementation<'_>) -> String {
    format!(
        "The equations of motion of [`{}`].",
        implementation.declaration.name
    )
}

/// The equations of motion as text.
pub(crate) fn equations(_implementation: &Implementation<'_>) -> String {
    String::new()
}
