//! Explicit Runge–Kutta methods with fixed steps.
//!
//! Each method is given by its Butcher tableau, with a reference; the step is implemented once for all. Hairer, Nørsett
//! & Wanner, *Solving Ordinary Differential Equations I*, 2nd edition (1993), II.1. The adaptive method of order 8 is
//! [`Dop853`](crate::Dop853).

mod stepper;

pub use stepper::{RungeKuttaMemory, RungeKuttaStepper};

use super::compensated::Clock;
use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::integrator::Integrator;
use super::passing::{self, Clearance};
use crate::limits::FIXED_STEP_SINGULARITY_TOLERANCE;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

/// The Butcher tableau of an explicit Runge–Kutta method.
///
/// ```text
/// kᵢ = f(t + cᵢ h, x + h Σⱼ aᵢⱼ kⱼ),   x(t + h) ≈ x + h Σᵢ bᵢ kᵢ
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ButcherTableau<const STAGES: usize> {
    /// The nodes cᵢ.
    pub nodes: [f64; STAGES],
    /// The rows of the Runge–Kutta matrix aᵢⱼ. Trailing zeros before the diagonal may be omitted; entries on or after
    /// the diagonal are not read.
    pub matrix: [&'static [f64]; STAGES],
    /// The weights bᵢ.
    pub weights: [f64; STAGES],
}

/// The classical method of order 4: Kutta, *Z. Math. Phys.* **46** (1901) 435; Hairer, Nørsett &
/// Wanner, *Solving Ordinary Differential Equations I*, table II.1.2.
pub const CLASSICAL_FOURTH_ORDER: ButcherTableau<4> = ButcherTableau {
    nodes: [0.0, 0.5, 0.5, 1.0],
    matrix: [&[], &[0.5], &[0.0, 0.5], &[0.0, 0.0, 1.0]],
    weights: [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0],
};

/// Returns the linear combination Σ aⱼ kⱼ, skipping terms whose coefficient is zero.
#[inline]
pub(crate) fn combination<S: Scalar, X: VectorSpace<S>>(
    coefficients: &[f64],
    derivatives: &[X],
    zero: &X,
) -> X {
    let mut sum = zero.clone();
    for (&coefficient, derivative) in coefficients.iter().zip(derivatives) {
        if coefficient != 0.0 {
            sum.add_scaled(S::from_f64(coefficient), derivative);
        }
    }
    sum
}

/// Returns the derivative kᵢ = f(t + cᵢ h, x + h Σ aᵢⱼ kⱼ) of a stage.
#[inline]
pub(crate) fn stage<S: Scalar, D: Dynamics<S> + ?Sized>(
    dynamics: &D,
    t: f64,
    x: &D::State,
    h: f64,
    row: &[f64],
    derivatives: &[D::State],
) -> D::State {
    let at = stage_state(x, h, row, derivatives);
    dynamics.derivative(S::from_f64(t), &at)
}

/// Returns the state x + h Σ aᵢⱼ kⱼ of a stage.
#[inline]
pub(crate) fn stage_state<S: Scalar, X: VectorSpace<S>>(
    x: &X,
    h: f64,
    row: &[f64],
    derivatives: &[X],
) -> X {
    let mut at = x.clone();
    let slope = combination(row, derivatives, &x.zeroed());
    at.add_scaled(S::from_f64(h), &slope);
    at
}

/// An explicit Runge–Kutta method with steps of fixed size.
///
/// Sample times need not be multiples of the step size. The interval between two of them is divided into equal steps
/// that are at most as long as the given step size.
///
/// There is no error control: to check the accuracy, halve the step size and compare. Near a singularity of the mass
/// matrix the integration ends where the estimated relative error of the accelerations exceeds 10⁻⁶.
///
/// ```
/// use lagrangian::{At, Dynamics, Problem, RungeKutta};
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
/// let end = Problem::new(&Oscillator, start).solve(1.0, RungeKutta::classical(0.01))?;
/// assert!((end[0] - 1.0_f64.cos()).abs() < 1e-9);
/// # Ok::<(), lagrangian::IntegrationError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RungeKutta<const STAGES: usize> {
    tableau: ButcherTableau<STAGES>,
    step: f64,
    passes_singularities: bool,
}

impl RungeKutta<4> {
    /// Creates the classical method of order 4 with steps of size `step`.
    #[must_use]
    pub fn classical(step: f64) -> Self {
        Self::new(CLASSICAL_FOURTH_ORDER, step)
    }
}

impl<const STAGES: usize> RungeKutta<STAGES> {
    /// Creates the method of a tableau with steps of size `step`, which is positive even for backward integrations.
    #[must_use]
    pub fn new(tableau: ButcherTableau<STAGES>, step: f64) -> Self {
        Self {
            tableau,
            step,
            passes_singularities: false,
        }
    }

    /// Lets steps pass singular configurations of constraints, as [`Taylor`](crate::Taylor::pass_singular_configurations) does: a
    /// step that would evaluate the accelerations close to one is taken with another length.
    #[must_use]
    pub fn pass_singular_configurations(mut self) -> Self {
        self.passes_singularities = true;
        self
    }

    fn check(&self) -> Result<(), IntegrationError> {
        if self.step.is_finite() && self.step > 0.0 {
            Ok(())
        } else {
            Err(IntegrationError::InvalidStep { step: self.step })
        }
    }

    /// Returns the increment h Σ bᵢ kᵢ over a step h from (t, x), where x is reduced.
    #[inline]
    fn increment<S: Scalar, D: Dynamics<S> + ?Sized>(
        &self,
        dynamics: &D,
        clock: &Clock,
        x: &D::State,
        h: f64,
    ) -> D::State {
        let derivatives = self.stages(dynamics, clock, x, h);
        self.sum::<S, D::State>(&derivatives, h)
    }

    /// Returns h Σ bᵢ kᵢ.
    #[inline]
    fn sum<S: Scalar, X: VectorSpace<S>>(&self, derivatives: &[X; STAGES], h: f64) -> X {
        let zero = derivatives[0].zeroed();
        combination(&self.tableau.weights, derivatives, &zero).map(|slope| slope * S::from_f64(h))
    }

    /// Returns the derivatives kᵢ.
    #[inline]
    fn stages<S: Scalar, D: Dynamics<S> + ?Sized>(
        &self,
        dynamics: &D,
        clock: &Clock,
        x: &D::State,
        h: f64,
    ) -> [D::State; STAGES] {
        let zero = x.zeroed();
        let mut derivatives: [D::State; STAGES] = core::array::from_fn(|_| zero.clone());
        let rows = self.tableau.nodes.iter().zip(&self.tableau.matrix);
        for (i, (node, row)) in rows.enumerate() {
            let (done, rest) = derivatives.split_at_mut(i);
            if let Some(next) = rest.first_mut() {
                *next = stage(dynamics, clock.after(node * h), x, h, row, done);
            }
        }
        derivatives
    }

    /// Returns the length and the increment of a step, at most `remaining`, that keeps away from singular configurations: of a
    /// step `h` or as near to it as possible.
    #[cold]
    fn passing<S: Scalar, D: Dynamics<S> + ?Sized>(
        &self,
        dynamics: &D,
        clock: &Clock,
        x: &D::State,
        (h, remaining): (f64, f64),
    ) -> (f64, D::State) {
        let attempt = |h: f64| {
            let derivatives = self.stages(dynamics, clock, x, h);
            let rows = self.tableau.nodes.iter().zip(self.tableau.matrix);
            let end = (&1.0, &self.tableau.weights[..]);
            let stages = rows.skip(1).chain([end]);
            let clearance = stages.fold(Clearance::UNLIMITED, |clearance, (node, row)| {
                let at = stage_state(x, h, row, &derivatives);
                clearance.with(dynamics, clock.after(node * h), &at)
            });
            (h, self.sum(&derivatives, h), clearance)
        };
        let (mut length, mut increment, mut clearance) = attempt(h);
        for h in passing::lengths(h, remaining).skip(1) {
            if clearance.is_sufficient() {
                break;
            }
            let next = attempt(h);
            if next.2.is_larger_than(clearance) {
                (length, increment, clearance) = next;
            }
        }
        (length, increment)
    }
}

impl<S: Scalar, D: Dynamics<S> + ?Sized, const STAGES: usize> Integrator<S, D>
    for RungeKutta<STAGES>
{
    type Stepper = RungeKuttaStepper<D::State, STAGES>;

    fn start(&self, dynamics: &D, t: f64, x: D::State) -> Result<Self::Stepper, IntegrationError> {
        self.check()?;
        RungeKuttaStepper::new(*self, dynamics, t, x)
    }

    fn singularity_tolerance(&self) -> f64 {
        FIXED_STEP_SINGULARITY_TOLERANCE
    }
}
