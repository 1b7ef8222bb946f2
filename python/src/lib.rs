//! Models of [`lagrangian`] as classes of a Python module.
//!
//! A crate of models with the clause `reflect` becomes a module by one macro:
//!
//! ```ignore
//! use lagrangian::prelude::*;
//!
//! /// A ball above a floor.
//! #[derive(Lagrangian)]
//! #[lagrangian(
//!     taylor,
//!     reflect,
//!     coordinates(height),
//!     kinetic = 0.5 * m * dot(height).powi(2),
//!     potential = m * g * height,
//!     event(floor = height),
//! )]
//! pub struct Ball {
//!     /// The mass in kg.
//!     m: f64,
//!     /// The acceleration of gravity in m/s².
//!     g: f64,
//! }
//!
//! lagrangian_python::module! {
//!     /// Balls.
//!     mechanisms: Ball
//! }
//! ```
//!
//! In Python:
//!
//! ```python
//! from mechanisms import Ball
//!
//! ball = Ball(m=0.1, g=9.81)
//! motion = ball.integrate(q=[2.0], v=[0.0], until=1.0, samples=101, stop={"floor": "falling"})
//! motion.t, motion.q, motion.end.t
//! ```
//!
//! The folder `python/template` of the repository is a crate to start from, with the files that `maturin` needs.

mod ability;
mod arrays;
mod class;
mod description;
mod ensemble;
mod errors;
mod evaluator;
mod fields;
mod instant;
mod integrated;
mod integration;
mod members;
mod method;
mod model;
mod motion;
mod motions;
mod numbers;
mod parameters;
mod quantities;
mod registry;
mod request;
mod settings;
mod states;
mod watch;

#[doc(hidden)]
pub mod emitted;

pub use errors::IntegrationError;
pub use model::Model;
pub use motion::{Event, Motion, Point};
pub use motions::Motions;
#[doc(hidden)]
pub use {lagrangian, pyo3};

/// Makes a Python module of models with the clause `reflect`: `module! { name: First, Second }`, with documentation in front of
/// the name.
#[macro_export]
macro_rules! module {
    ($(#[$attribute:meta])* $name:ident: $($model:ty),+ $(,)?) => {
        $(#[$attribute])*
        #[$crate::pyo3::pymodule]
        #[pyo3(crate = "lagrangian_python::pyo3")]
        fn $name(
            module: &$crate::pyo3::Bound<'_, $crate::pyo3::types::PyModule>,
        ) -> $crate::pyo3::PyResult<()> {
            $crate::emitted::add_shared(module)?;
            $($crate::emitted::add(module, &$crate::description!($model))?;)+
            Ok(())
        }
    };
}
