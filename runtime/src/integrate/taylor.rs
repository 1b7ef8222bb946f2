//! The Taylor series method.
//!
//! R. E. Moore, *Interval Analysis* (1966), chapter 11; À. Jorba & M. Zou, *A Software Package for the Numerical
//! Integration of ODEs by Means of High-Order Taylor Methods*, Experimental Mathematics **14** (2005) 99–117.

mod branch_crossings;
pub(super) mod coefficients;
mod convolutions;
mod correction;
mod discontinuity;
mod interpolant;
mod lanes;
mod unrolled_convolutions;
mod paired_convolutions;
mod residual;
pub mod recurrences;
mod series;
mod series_memory;
mod singular_configuration;
mod step_size;
mod stepper;
mod uncertain_steps;
mod unit_polynomial;

pub use branch_crossings::BranchVisitor;
pub use coefficients::TaylorCoefficients;
pub(crate) use convolutions::{Convolutions, FewConvolutions, OnlineConvolutions};
pub use convolutions::{FactorPairs, PairSums};
pub use interpolant::TaylorInterpolant;
pub use lanes::TaylorLanes;
pub(super) use lanes::{SingleMotions, StepOfLane};
pub(crate) use paired_convolutions::PairedConvolutions;
pub use series::{Series, SwitchingFunction};
pub use series_memory::SeriesMemory;
pub use stepper::TaylorStepper;
pub(crate) use unrolled_convolutions::UnrolledConvolutions;

use super::checkpoint::Resume;
use super::error::IntegrationError;
use super::integrator::Integrator;
use super::stepper::Advance;
use super::tolerance::Tolerance;
use crate::limits::taylor::SINGULARITY_TOLERANCE;
use crate::scalar::Scalar;
use singular_configuration::SingularConfiguration;

/// The Taylor series method of order 2·`HALF`.
///
/// The step sizes are chosen from the last coefficients, and the polynomials are the dense output.
///
/// The last two terms of the polynomial, at the end of a step, are about absoluteᵢ + relative · sizeᵢ for each
/// component. The size of a component is the largest value that it reaches within the step. Otherwise the tolerances
/// mean what they mean for [`Dop853`](crate::Dop853#tolerances), except that the time T is 8 times as long: they depend
/// neither on the unit of time nor on how far an angle has turned, and sizes can be given by coordinate. By default,
/// both tolerances are the machine epsilon of the scalar, since full accuracy costs little more with this method. A
/// relative tolerance alone does not depend on any unit.
///
/// At relative tolerances of 1024 machine epsilons and more, the derivative of the motion at the end of a step corrects
/// this end, unless the equations have branches, such as |u|. The order is then 2·`HALF` + 1, and local errors are smaller
/// than the last terms. A corrected step costs one more evaluation of the equations.
///
/// A series cannot anticipate a change of the equations: where a force has a corner, the polynomial continues as before
/// it. Therefore the derivative at the end of a step is compared with the derivative of the polynomial. In the first
/// step, in one that is more than twice as long as the one before, and in one for which a polynomial of low degree is
/// enough, they are also compared at sixteen times within it. Where they differ, the step is rejected, and steps up to
/// the end of the last attempt are compared at times as close to each other. If a force acts for less than a sixteenth
/// of a step, such as a pulse of an external function, set [`max_step`](Self::max_step) to less than its duration. With
/// dual numbers the derivative parts count, too, relative to their largest component, so that a derivative is equally
/// accurate where the value is at rest.
///
/// # Corners and jumps
///
/// The corners and jumps of |u|, sgn u, min, max and atan2 in a declaration are found from the series of their
/// switching functions ([`Series::branches`]), however short a contact is. If the equations after a change of sign
/// differ from the polynomial, the step ends there, to the digits of the scalar, and the next step begins on the new
/// branch. This covers square waves, relays, forces that are switched on, and dry friction that reverses. Sensitivities
/// (dual numbers, `StateTransition`) jump with the force.
///
/// ```
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = -signum(x)))]
/// struct Relay;
///
/// // Parabolas between x = 1 and x = −1, with the period 4√2.
/// let start = State::new(0.0, [1.0], [0.0]);
/// let end = Problem::new(&Relay, start).solve(40.0 * 2.0_f64.sqrt(), Taylor::new())?;
/// assert!((end.q[0] - 1.0).abs() < 1e-12);
/// # Ok::<(), IntegrationError>(())
/// ```
///
/// If the equations on both sides of a discontinuity surface lead back to it, like dry friction that holds a mass, the
/// motion cannot leave it: [`IntegrationError::SlidingMode`] names the switching function and the time.
///
/// The method integrates systems that have a [`Series`], such as a model with the clause `taylor` in its declaration.
///
/// ```
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     taylor,
///     coordinates(theta),
///     kinetic = 0.5 * m * l.powi(2) * dot(theta).powi(2),
///     potential = -m * g * l * cos(theta),
/// )]
/// struct Pendulum { m: f64, g: f64, l: f64 }
///
/// let pendulum = Pendulum { m: 1.0, g: 9.81, l: 1.0 };
/// let start = State::new(0.0, [3.0], [0.0]);
/// let end = Problem::new(&pendulum, start).solve(100.0, Taylor::new())?;
/// assert!((pendulum.energy(&end) - pendulum.energy(&start)).abs() < 1e-13);
/// # Ok::<(), IntegrationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Taylor<const HALF: usize = 14> {
    /// The machine epsilon of the scalar if `None`.
    tolerance: Option<Tolerance>,
    max_step: Option<f64>,
    passes_singularities: bool,
}

impl Taylor<6> {
    /// Creates the method of order 12, for relative tolerances of about 10⁻⁸.
    #[must_use]
    pub fn order_12() -> Self {
        Self::of_half_order()
    }
}

impl Taylor<8> {
    /// Creates the method of order 16, for relative tolerances of about 10⁻¹².
    #[must_use]
    pub fn order_16() -> Self {
        Self::of_half_order()
    }
}

impl Taylor<14> {
    /// Creates the method of order 28, for the accuracy of `f64`.
    ///
    /// The best order for a tolerance ε is −½ ln ε + 1 if the cost of a step grows with the square of its order (Jorba
    /// & Zou 2005, section 3.2), which would be 19. Here the cost grows more slowly: the processor waits for the terms
    /// of one order, and computes most of the sums meanwhile.
    #[must_use]
    pub fn new() -> Self {
        Self::of_half_order()
    }
}

impl Taylor<20> {
    /// Creates the method of order 40, for the accuracy of double-doubles.
    #[must_use]
    pub fn order_40() -> Self {
        Self::of_half_order()
    }
}

impl<const HALF: usize> Taylor<HALF> {
    /// Creates the method of order 2·`HALF`.
    #[must_use]
    pub fn of_half_order() -> Self {
        const { assert!(HALF > 0, "the order of a Taylor polynomial is at least 2") }
        Self {
            tolerance: None,
            max_step: None,
            passes_singularities: false,
        }
    }

    /// Sets the tolerance of the last terms relative to the size of a component. The absolute tolerance is then 0
    /// unless it is set.
    #[must_use]
    pub fn relative_tolerance(mut self, relative: f64) -> Self {
        let absolute = self.tolerance.map_or(0.0, |tolerance| tolerance.absolute);
        self.tolerance = Some(Tolerance { relative, absolute });
        self
    }

    /// Sets the tolerance of the last terms in the units of a coordinate. For a velocity it is divided by a [time scale
    /// of the motion](crate::Dop853#tolerances). The relative tolerance is then 0 unless it is set.
    #[must_use]
    pub fn absolute_tolerance(mut self, absolute: f64) -> Self {
        let relative = self.tolerance.map_or(0.0, |tolerance| tolerance.relative);
        self.tolerance = Some(Tolerance { relative, absolute });
        self
    }

    /// Sets the largest step size.
    #[must_use]
    pub fn max_step(mut self, step: f64) -> Self {
        self.max_step = Some(step);
        self
    }

    /// Lets steps pass singular configurations of constraints, at which their gradients depend on each other for a moment, as
    /// in a four-bar linkage of equal lengths whenever it is flat.
    ///
    /// Without this setting the integration ends near such a configuration. With it no step begins or ends close to one: a
    /// step that would is lengthened, or shortened so that the next one passes. It relies on the motion being smooth there, so
    /// that the polynomial of a step describes it on both sides; this is checked at the end of the step. Where a mechanism may
    /// leave such a configuration in several ways, the motion goes on smoothly.
    #[must_use]
    pub fn pass_singular_configurations(mut self) -> Self {
        self.passes_singularities = true;
        self
    }

    fn tolerance<S: Scalar>(&self) -> Tolerance {
        let epsilon = S::machine_epsilon();
        self.tolerance.unwrap_or(Tolerance {
            relative: epsilon,
            absolute: epsilon,
        })
    }

    /// Returns the part of the distance from a singular configuration from which on a step is lengthened to pass.
    fn min_part<S: Scalar>(&self) -> f64 {
        let Tolerance { relative, absolute } = self.tolerance::<S>();
        SingularConfiguration::min_part(relative.max(absolute) / S::machine_epsilon(), 2 * HALF)
    }

    fn check(&self) -> Result<(), IntegrationError> {
        if let Some(step) = self
            .max_step
            .filter(|step| !(step.is_finite() && *step > 0.0))
        {
            return Err(IntegrationError::InvalidStep { step });
        }
        self.tolerance.map_or(Ok(()), Tolerance::check)
    }
}

impl Default for Taylor {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, D: Series<S> + ?Sized, const HALF: usize> Integrator<S, D> for Taylor<HALF> {
    type Stepper = TaylorStepper<D::State, HALF>;

    fn start(&self, dynamics: &D, t: f64, x: D::State) -> Result<Self::Stepper, IntegrationError> {
        self.check()?;
        TaylorStepper::new(*self, dynamics, t, &x)
    }

    fn singularity_tolerance(&self) -> f64 {
        self.tolerance::<S>().relative.max(SINGULARITY_TOLERANCE)
    }
}

impl<S: Scalar, D: Series<S> + ?Sized, const HALF: usize> Resume<S, D> for Taylor<HALF> {
    type Memory = TaylorStepper<D::State, HALF>;

    fn memory(stepper: &Self::Stepper) -> Self::Memory {
        stepper.clone()
    }

    fn recall(
        &self,
        dynamics: &D,
        memory: Self::Memory,
    ) -> Result<Self::Stepper, IntegrationError> {
        self.check()?;
        let mut stepper = memory.under(*self);
        if !stepper.is_of(dynamics) {
            Advance::<S, D>::restart(&mut stepper, dynamics);
        }
        Ok(stepper)
    }
}
