//! Quantities that a declaration names for observers.

use crate::{Lagrangian, Scalar, State};

/// A system whose declaration has `output(name = expression, …)`.
pub trait Outputs<const N: usize, S: Scalar = f64>: Lagrangian<N, S> {
    /// A struct with one field for each output, named as declared.
    type Outputs;

    /// All the outputs at a state. Where one contains accelerations, they are those of
    /// [`accelerations`](Lagrangian::accelerations).
    fn outputs(&self, state: &State<S, N>) -> Self::Outputs;
}
