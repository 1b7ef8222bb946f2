//! Derives the equations of motion of a mechanical system from its energies, and integrates them.
//!
//! You write the energies on a struct of the system's parameters; the equations of motion are derived at compile time
//! as specialized Rust code.
//!
//! ```
//! use lagrangian::prelude::*;
//!
//! #[derive(Lagrangian)]
//! #[lagrangian(
//!     coordinates(theta),
//!     define(x = l * sin(theta), y = -l * cos(theta)),
//!     kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
//!     potential = m * g * y,
//! )]
//! struct Pendulum { m: f64, g: f64, l: f64 }
//!
//! let pendulum = Pendulum { m: 1.0, g: 9.81, l: 1.0 };
//! let start = State::new(0.0, [0.5], [0.0]);
//! let end = Problem::new(&pendulum, start).solve(10.0, Dop853::new())?;
//! assert!((pendulum.energy(&end) - pendulum.energy(&start)).abs() < 1e-8);
//! # Ok::<(), IntegrationError>(())
//! ```
//!
//! # Where to begin
//!
//! Most programs need a dozen names:
//!
//! | to | use |
//! |---|---|
//! | declare a model | [`derive(Lagrangian)`](derive@Lagrangian), the language of declarations, clause by clause |
//! | evaluate it: q̈, M, f, momenta, energy, inverse dynamics, outputs, multipliers | the methods of [`trait@Lagrangian`], at a [`State`] |
//! | integrate it from a state | [`Problem`], which ends in a [`Solution`] or an [`IntegrationError`] |
//! | choose a method | [`Taylor`] for models with the clause `taylor`, [`Dop853`] and [`RungeKutta`] for all |
//! | stop at events, record them, react to them | `when` and `on` of [`Problem`], then `stop`, `record` or `then` a reaction |
//! | save samples | `save` of [`Problem`], with times, `Every`, `StepEnds` or `Dense` |
//! | control it | `feedback` and the other laws of [`Problem`], which [`laws`] lists |
//! | integrate many motions | [`Ensemble`] on one core; the crate `lagrangian-ensembles` on many |
//! | find equilibria and steady motions | [`analysis::EquilibriumSearch`] |
//! | linearize, find poles, design a regulator | [`analysis::StateSpace`], with constraints about an [`analysis::TangentSpace`] |
//! | judge stability, find modes | [`analysis::SmallOscillations`] |
//! | assemble a mechanism | [`assemble`](Lagrangian::assemble) |
//! | identify parameters | [`identification::Identification`] |
//! | compute with mass, centre and inertia of bodies | [`rigid_body`], with meshes from files by the feature `mesh-files` |
//!
//! Functions that are generic over models name the traits of [`quantities`] in their bounds, and functions over other systems
//! ẋ = f(t, x) the trait [`Dynamics`]. [`Scalar`] is the trait of the numbers over which models and integrators are generic: `f64`,
//! `f32`, [`Lanes`], [`DoubleDouble`], and [`Dual`] numbers, which carry derivatives. [`rotation`] has Euler angles and quaternions,
//! [`elliptic`] the elliptic functions of free rotation.
//!
//! Without the default feature `std` the crate is `no_std`, and without `alloc` it does not allocate.
#![no_std] // Nothing but re-exports: whether std is linked is decided in lagrangian-runtime.

pub mod prelude;

#[doc = include_str!("declaration.md")]
pub use lagrangian_derive::Lagrangian;
#[doc(no_inline)]
pub use lagrangian_runtime::__private::{nalgebra, num_traits};
#[doc(inline)]
pub use lagrangian_runtime::*;
