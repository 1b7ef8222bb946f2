//! The Dormand–Prince method 8(5,3), DOP853.
//!
//! P. J. Prince & J. R. Dormand, *High order embedded Runge–Kutta formulae*, J. Comput. Appl. Math. **7** (1981) 67–75;
//! Hairer, Nørsett & Wanner, *Solving Ordinary Differential Equations I*, 2nd edition (1993), II.4 (step size control),
//! II.5 (the method), II.6 and II.10 (dense output and error estimate). Steps are chosen as in their code DOP853.

mod coefficients;
mod dense_output;
mod derivative_parts;
mod passing;
mod stage_sums;
mod step_control;
mod stepper;

pub use dense_output::Dop853Interpolant;
pub use stepper::Dop853Stepper;

use super::checkpoint::Resume;
use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::integrator::Integrator;
use super::stepper::Advance;
use super::tolerance::Tolerance;
use crate::limits::dormand_prince as limits;
use crate::scalar::Scalar;

/// Stages of the method, excluding the derivative at the end of the step, which is the first stage of the next step
/// (first same as last).
const STAGES: usize = 12;

/// The stages, the derivative at the end of the step, and the three additional stages of the dense output.
const ALL_STAGES: usize = 16;

/// The Dormand–Prince method 8(5,3) with step-size control and dense output of order 7.
///
/// # Tolerances
///
/// A step is accepted when the root mean square over the components of errorᵢ / (absoluteᵢ + relative · sizeᵢ) is at
/// most 1 (Hairer, Nørsett & Wanner, II.4). It depends neither on the unit of time nor on how far an angle has turned:
///
/// - The size of a component is the larger of |xᵢ| before and after the step. The size of a coordinate that is an angle
///   is 1, and the size of any other ignorable coordinate is |q̇ᵢ| T.
/// - The absolute tolerance of a coordinate is `absolute` in its units, or `absolute` times its size if one is given by
///   [`with_sizes`](crate::SetTypicalSizes::with_sizes). For a velocity it is divided by T: an error of a velocity
///   counts by the displacement that it causes in the time T.
/// - T is the longest step so far, and at the start the time in which the coordinates change by their size. T thus is a
///   property of the motion, not a setting. (For constrained systems it is usual to multiply errors of velocities by
///   the present step instead. This would admit large errors where steps are short, as near a collision: E. Hairer & G.
///   Wanner, *Solving Ordinary Differential Equations II*, 2nd edition (1996), VII.)
///
/// For a state without velocities, such as a plain vector, every component is a coordinate.
///
/// Both tolerances are 10⁻¹⁰ by default. One of them may be zero. Without an absolute tolerance an integration may
/// start from rest, but steps become ever smaller where a component approaches zero without being exactly zero. Near a
/// singularity of the mass matrix the integration ends where the estimated relative error of the accelerations exceeds
/// the relative tolerance ([`Problem::singularity_tolerance`](crate::Problem::singularity_tolerance)).
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian::nalgebra::SVector;
///
/// /// ẍ = −x.
/// struct Oscillator;
///
/// impl Dynamics for Oscillator {
///     type State = SVector<f64, 2>;
///
///     fn derivative(&self, _: f64, x: &Self::State) -> Self::State {
///         SVector::from([x[1], -x[0]])
///     }
/// }
///
/// let start = At { t: 0.0, x: SVector::from([1.0, 0.0]) };
/// let method = Dop853::new().relative_tolerance(1e-12).absolute_tolerance(1e-12);
/// for sample in Problem::new(&Oscillator, start).save([1.0, 2.0, 3.0]).solve(3.0, method)? {
///     assert!((sample[0] - sample.t.cos()).abs() < 1e-11);
/// }
/// # Ok::<(), IntegrationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Dop853 {
    tolerance: Tolerance,
    initial_step: Option<f64>,
    max_step: Option<f64>,
    min_step: Option<f64>,
    passes_singularities: bool,
}

impl Dop853 {
    /// The method with its default settings.
    #[must_use]
    pub fn new() -> Self {
        Self {
            tolerance: Tolerance {
                relative: limits::TOLERANCE,
                absolute: limits::TOLERANCE,
            },
            initial_step: None,
            max_step: None,
            min_step: None,
            passes_singularities: false,
        }
    }

    /// Sets the tolerance of the error of a step relative to the [size](Self#tolerances) of a component.
    #[must_use]
    pub fn relative_tolerance(mut self, relative: f64) -> Self {
        self.tolerance.relative = relative;
        self
    }

    /// Sets the tolerance of the error of a step in the units of a coordinate, or in units of the sizes given by
    /// [`with_sizes`](crate::SetTypicalSizes::with_sizes). For a velocity it is divided by a [time scale of the
    /// motion](Self#tolerances).
    #[must_use]
    pub fn absolute_tolerance(mut self, absolute: f64) -> Self {
        self.tolerance.absolute = absolute;
        self
    }

    /// Sets the size of the first step, which is otherwise chosen automatically.
    #[must_use]
    pub fn initial_step(mut self, step: f64) -> Self {
        self.initial_step = Some(step);
        self
    }

    /// Sets the largest step size.
    #[must_use]
    pub fn max_step(mut self, step: f64) -> Self {
        self.max_step = Some(step);
        self
    }

    /// Sets the smallest step size. No shorter step is tried; where a step of this size does not meet the tolerance,
    /// the integration ends with [`SmallestStep`](IntegrationError::SmallestStep). Only a step that ends at the end of
    /// the integration or of a part of it, or where a sampled controller is updated, may be shorter.
    ///
    /// Without this setting, the shortest step is ten times the spacing ε |t| of floating-point numbers at the time t.
    #[must_use]
    pub fn min_step(mut self, step: f64) -> Self {
        self.min_step = Some(step);
        self
    }

    /// Lets steps pass singular configurations of constraints, as [`Taylor`](crate::Taylor::pass_singular_configurations) does: a
    /// step that would evaluate the accelerations close to one is shortened so that the next one passes. Tolerances below
    /// 10⁻¹⁰ are not met there.
    #[must_use]
    pub fn pass_singular_configurations(mut self) -> Self {
        self.passes_singularities = true;
        self
    }

    fn check(&self) -> Result<(), IntegrationError> {
        let steps = [self.initial_step, self.max_step, self.min_step];
        for step in steps.into_iter().flatten() {
            if !(step.is_finite() && step > 0.0) {
                return Err(IntegrationError::InvalidStep { step });
            }
        }
        if let (Some(min), Some(max)) = (self.min_step, self.max_step)
            && min > max
        {
            return Err(IntegrationError::InvalidStepRange { min, max });
        }
        self.tolerance.check()
    }
}

impl Default for Dop853 {
    fn default() -> Self {
        Self::new()
    }
}

impl<S: Scalar, D: Dynamics<S> + ?Sized> Integrator<S, D> for Dop853 {
    type Stepper = Dop853Stepper<D::State>;

    fn start(&self, dynamics: &D, t: f64, x: D::State) -> Result<Self::Stepper, IntegrationError> {
        self.check()?;
        Dop853Stepper::new(*self, dynamics, t, x)
    }

    fn singularity_tolerance(&self) -> f64 {
        if self.passes_singularities {
            self.tolerance.relative.max(limits::PASSING_TOLERANCE)
        } else {
            self.tolerance.relative
        }
    }
}

impl<S: Scalar, D: Dynamics<S> + ?Sized> Resume<S, D> for Dop853 {
    type Memory = Dop853Stepper<D::State>;

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
