//! Checkpoints: integrations that are stored and resumed later.

use super::dynamics::Dynamics;
use super::error::IntegrationError;
use super::event::MetConditions;
use super::integrator::Integrator;
use crate::scalar::Scalar;

/// The whole state of an integration in progress: time, state, what rounding has removed from them, and the memory of
/// the method. It is made by [`Run::checkpoint`](crate::problem::Run::checkpoint).
/// [`Problem::resume`](crate::Problem::resume) continues the integration, to the last bit as if it had not stopped. The
/// problem then has to watch for the same events in the same order, since the signs of their functions are stored, too:
/// a zero at the time of the checkpoint is reported once.
///
/// With the feature `serde` a checkpoint is stored in any format that keeps all digits of numbers, provided that the
/// components of the state can be serialized; `serde_json` keeps the digits with its feature `float_roundtrip`. If the
/// motion is a polynomial, the next step of the Taylor method is infinite, and a format without infinite numbers, such
/// as JSON, cannot store the checkpoint.
///
/// ```
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(theta),
///     kinetic = 0.5 * m * l.powi(2) * dot(theta).powi(2),
///     potential = -m * g * l * cos(theta),
/// )]
/// struct Pendulum { m: f64, g: f64, l: f64 }
///
/// let pendulum = Pendulum { m: 1.0, g: 9.81, l: 1.0 };
/// let problem = Problem::new(&pendulum, State::new(0.0, [0.5], [0.0]));
/// let whole = problem.clone().solve(10.0, Dop853::new())?;
/// // A step limit or a cancellation ends an integration without losing anything.
/// let mut part = problem.clone().max_steps(7).start(Dop853::new())?;
/// assert_eq!(part.advance(10.0)?.reason, StopReason::StepLimit);
/// let checkpoint = part.checkpoint();
///
/// let mut resumed = problem.resume(checkpoint, Dop853::new())?;
/// assert_eq!(resumed.advance(10.0)?.last, whole.last);
/// # Ok::<(), IntegrationError>(())
/// ```
#[derive(Clone, Debug)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Checkpoint<M> {
    pub(super) memory: M,
    /// What is known about the event functions, if any were watched.
    #[cfg_attr(feature = "serde", serde(default))]
    pub(super) events: Option<EventSigns>,
}

/// The signs of event functions at the end of a step: a bit for each event.
#[derive(Clone, Copy, Debug, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct EventSigns {
    pub(super) positive: u64,
    pub(super) negative: u64,
    /// Whether time goes forwards; `None` before the first step.
    pub(super) forwards: Option<bool>,
    /// The events whose functions touch zero there.
    pub(super) touching: MetConditions,
}

impl EventSigns {
    /// Returns the signs of two concatenated lists of events, the first of which has `count` events.
    pub(super) fn followed_by(self, other: Self, count: usize) -> Self {
        let shifted = |bits: u64| MetConditions::from_bits(bits).shifted(count).bits();
        Self {
            positive: self.positive | shifted(other.positive),
            negative: self.negative | shifted(other.negative),
            forwards: self.forwards.or(other.forwards),
            touching: self.touching.or(other.touching.shifted(count)),
        }
    }

    /// Returns the signs of the events after the first `count`.
    pub(super) fn behind(self, count: usize) -> Self {
        let rest = |bits: u64| MetConditions::from_bits(bits).behind(count).bits();
        Self {
            positive: rest(self.positive),
            negative: rest(self.negative),
            forwards: self.forwards,
            touching: self.touching.behind(count),
        }
    }

    /// Returns a bit mask of the positive values and one of the negative values.
    pub(super) fn bits(values: &[f64]) -> [u64; 2] {
        [1.0, -1.0].map(|sign| {
            let pairs = (0..u64::BITS).zip(values);
            pairs.fold(0, |bits, (i, value)| {
                bits | u64::from(sign * value > 0.0) << i
            })
        })
    }

    /// Returns the sign of an event's function; 0 if it had none.
    pub(super) fn sign(self, event: usize) -> f64 {
        let is_in = |bits: u64| {
            let shifted = u32::try_from(event).ok().and_then(|i| bits.checked_shr(i));
            shifted.is_some_and(|bits| bits & 1 == 1)
        };
        f64::from(u8::from(is_in(self.positive))) - f64::from(u8::from(is_in(self.negative)))
    }
}

/// A method whose integrations can be resumed from checkpoints.
pub trait Resume<S: Scalar, D: Dynamics<S> + ?Sized>: Integrator<S, D> {
    /// The part of a stepper that is stored.
    type Memory: Clone;

    /// Returns the part of a stepper that is to be stored.
    fn memory(stepper: &Self::Stepper) -> Self::Memory;

    /// Returns a stepper that continues from `memory`, with the settings of this method. Stored values that belong to
    /// other dynamics, for example to other values of the parameters, are recomputed.
    ///
    /// # Errors
    ///
    /// If a setting is invalid.
    fn recall(&self, dynamics: &D, memory: Self::Memory)
    -> Result<Self::Stepper, IntegrationError>;
}
