//! Jacobi's elliptic functions, and elliptic integrals of the first and the third kind.
//!
//! The free rotation of a rigid body ([`FreeRotation`](crate::rigid_body::FreeRotation)), pendulums and tops have
//! closed solutions in these functions. They work on `f64`, `f32`, double-doubles and dual numbers, with the full
//! accuracy of the scalar.
//!
//! ```
//! use lagrangian::elliptic::Modulus;
//!
//! // A pendulum released at rest from the angle α: sin ½θ = k sn(K + t √(g/l)), k = sin ½α, with the period 4 K √(l/g).
//! let alpha = 2.0_f64;
//! let (k, cosine) = (0.5 * alpha).sin_cos();
//! let modulus = Modulus::new(k * k, cosine * cosine);
//! let quarter = modulus.complete_first();
//! let (sn, _, _) = modulus.jacobi(quarter);
//! assert!((sn - 1.0).abs() < 1e-15);
//! assert!((4.0 * quarter - 8.349_752_926_918_495).abs() < 1e-14);
//! ```

mod carlson;
mod modulus;

pub use carlson::{carlson_rc, carlson_rf, carlson_rj};
pub use modulus::Modulus;
pub(crate) use modulus::sign;
