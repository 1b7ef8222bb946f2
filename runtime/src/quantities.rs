//! The traits that the derive macro implements, one for each clause, for the bounds of functions that are generic over
//! models.
//!
//! Programs call the methods of [`Lagrangian`](trait@crate::Lagrangian), which evaluate these traits at the inputs of
//! the model and have the same names. Import these traits where bounds need them, but not where a model is used. A
//! function that accepts any model with outputs has the bound
//!
//! ```
//! use lagrangian::prelude::*;
//! use lagrangian::quantities::Outputs;
//!
//! fn outputs<M, const N: usize>(model: &M, state: &State<f64, N>) -> <M::Model as Outputs<N>>::Outputs
//! where
//!     M: Lagrangian<N, Model: Outputs<N>>,
//! {
//!     model.outputs(state)
//! }
//! ```

pub use crate::model::{
    Constraints, DirectionalDerivatives, Energies, EnergyBalance, Events, FieldDescription,
    FieldElement, FieldReader, FieldValue, Hamiltonian, Impacts, Inputs, InvalidNumbers,
    MembersInLanes, MotionDerivatives, MotionSeries, MultiplierSensitivities, Outputs, Quantities,
    Reflect, Regressor, RouthianSeries, Sensitivities, StateJacobian,
};
