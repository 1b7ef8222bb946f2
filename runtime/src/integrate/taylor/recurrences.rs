//! Building blocks of Taylor series that are written by hand.
//!
//! Each function of a series has a block. It is given the coefficients of its arguments order by order, from order 0,
//! and returns the coefficients of its value. Sums, differences and multiples by constants need no block. The formulas
//! follow from the differential equations of the functions: R. E. Moore, *Interval Analysis* (1966), section 11.2; À.
//! Jorba & M. Zou, Experimental Mathematics **14** (2005) 99–117, proposition 2.1; A. Griewank & A. Walther,
//! *Evaluating Derivatives*, 2nd edition (2008), section 13.2.
//!
//! A block of half order `HALF` serves polynomials of order 2·`HALF`, like
//! [`TaylorCoefficients`](crate::TaylorCoefficients); beyond this order its results are meaningless. Nothing is
//! allocated. Where a function has no derivative, such as √x at 0, the coefficients are not finite.
//!
//! For example, the Kepler problem, r̈ = −r/|r|³ in the plane, has a [`Square`] for each coordinate, a [`Power`] and
//! two [`Product`]s:
//!
//! ```
//! use lagrangian::prelude::*;
//! use lagrangian::recurrences::{Power, Product, Square};
//! use lagrangian::{Series, SeriesMemory, TaylorCoefficients};
//!
//! struct Kepler;
//!
//! impl<S: Scalar> Dynamics<S> for Kepler {
//!     type State = SVector<S, 4>;
//!
//!     fn derivative(&self, _: S, x: &Self::State) -> Self::State {
//!         let distance = (x[0] * x[0] + x[1] * x[1]).sqrt();
//!         let factor = -S::one() / (distance * distance * distance);
//!         SVector::from([x[2], x[3], factor * x[0], factor * x[1]])
//!     }
//! }
//!
//! impl<S: Scalar> Series<S> for Kepler {
//!     fn series<const HALF: usize>(
//!         &self,
//!         (t, x): (S, &Self::State),
//!         unit: S,
//!         coefficients: &mut TaylorCoefficients<Self::State, HALF>,
//!         _: Option<&mut SeriesMemory>,
//!     ) {
//!         let mut squares = [Square::<S, HALF>::new(), Square::new()];
//!         let mut power = Power::<S, HALF>::new(S::from_f64(-1.5));
//!         let mut products = [Product::<S, HALF>::new(), Product::new()];
//!         coefficients.solve(t, x, unit, |_, x| {
//!             let square = squares[0].next(x[0]) + squares[1].next(x[1]);
//!             let factor = -power.next(square);
//!             let [first, second] = &mut products;
//!             SVector::from([x[2], x[3], first.next(factor, x[0]), second.next(factor, x[1])])
//!         });
//!     }
//! }
//!
//! // An ellipse of eccentricity 0.6 and period 2π.
//! let start = At { t: 0.0, x: SVector::from([0.4, 0.0, 0.0, 2.0]) };
//! let end = Problem::new(&Kepler, start).solve(20.0 * core::f64::consts::PI, Taylor::new())?;
//! assert!((end.x - start.x).norm() < 1e-12);
//! # Ok::<(), IntegrationError>(())
//! ```

mod algebraic;
mod exponential;
mod inverse;
mod order;
mod terms;

pub use algebraic::{Power, Product, Quotient, Square, SquareRoot};
pub use exponential::{
    Exponential, HyperbolicSineCosine, HyperbolicTangent, Logarithm, SineCosine, Tangent,
};
pub use inverse::{
    ArcCosine, ArcSine, ArcTangent, ArcTangent2, InverseHyperbolicCosine, InverseHyperbolicSine,
    InverseHyperbolicTangent,
};
pub use order::Order;
pub(super) use terms::convolution;
