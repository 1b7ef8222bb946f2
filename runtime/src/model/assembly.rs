//! Consistent states of constrained models.

use nalgebra::SVector;

use super::assembly_error::{AssemblyError, OpenConstraints};
use super::constraints::Constraints;
use super::phase::Phase;
use super::saddle_point::{rounding_errors, row_size, sizes_in_metric};
use super::state::State;
use crate::limits::assembly::{
    LEAST_DAMPING, MAX_ITERATIONS, SUFFICIENT_DECREASE, VELOCITY_SWEEPS, max_residual,
};
use crate::linalg::VectorSpace as _;
use crate::linalg::lane_select::greater;
use crate::scalar::Scalar;

/// The search for a state that meets the constraints of a model, from a guess; made by
/// [`Lagrangian::assemble`](crate::Lagrangian::assemble).
///
/// Coordinates are moved by damped steps of the Gauss–Newton method, each of which is the smallest in the metric of the
/// mass matrix, so that the units of coordinates do not matter (P. Deuflhard, *Newton Methods for Nonlinear Problems*
/// (2004), 4.4, with the natural monotonicity test). Velocities are projected then.
///
/// ```
/// use lagrangian::prelude::*;
///
/// /// A crank drives a slider along the x-axis by a connecting rod.
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(theta, phi, x),
///     kinetic = 0.5 * j * dot(theta).powi(2) + 0.5 * m * dot(x).powi(2) + 0.5 * i * dot(phi).powi(2),
///     constraint(pin = [r * cos(theta) + l * cos(phi) - x, r * sin(theta) + l * sin(phi)]),
/// )]
/// struct SliderCrank { j: f64, i: f64, m: f64, r: f64, l: f64 }
///
/// let mechanism = SliderCrank { j: 0.1, i: 0.02, m: 0.5, r: 0.1, l: 0.3 };
/// let guess = State::new(0.0, [1.0, -0.2, 0.3], [6.0, 0.0, 0.0]);
/// let start = mechanism
///     .assemble(guess)
///     .hold([SliderCrank::THETA])
///     .hold_velocities([SliderCrank::THETA])
///     .solve()?;
/// assert_eq!((start.state.q[0], start.state.v[0]), (1.0, 6.0));
/// // How far each coordinate and velocity was moved.
/// assert!(start.moved.q[2].abs() < 0.1);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
#[must_use = "a search does nothing until it is solved"]
pub struct Assembly<'a, M: ?Sized, S: Scalar, const N: usize, const C: usize> {
    model: &'a M,
    guess: State<S, N>,
    held: [bool; N],
    held_velocities: [bool; N],
}

/// A state that meets the constraints, and how far it is from the guess.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Assembled<S: Scalar, const N: usize> {
    /// The consistent state.
    pub state: State<S, N>,
    /// The changes of the coordinates and of the velocities.
    pub moved: Phase<S, N>,
}

impl<'a, M, S, const N: usize, const C: usize> Assembly<'a, M, S, N, C>
where
    M: Constraints<N, C, S> + ?Sized,
    S: Scalar,
{
    pub(crate) fn new(model: &'a M, guess: State<S, N>) -> Self {
        Self {
            model,
            guess,
            held: [false; N],
            held_velocities: [false; N],
        }
    }

    /// Holds the coordinates with these indices at their values.
    pub fn hold(mut self, coordinates: impl IntoIterator<Item = usize>) -> Self {
        mark(&mut self.held, coordinates);
        self
    }

    /// Holds the velocities of the coordinates with these indices at their values.
    pub fn hold_velocities(mut self, coordinates: impl IntoIterator<Item = usize>) -> Self {
        mark(&mut self.held_velocities, coordinates);
        self
    }

    /// Finds the consistent state.
    ///
    /// # Errors
    ///
    /// [`AssemblyError`], with the constraints that stay open: where the guess is too far away, the mechanism cannot be
    /// closed for these parameters, or what is held contradicts the constraints.
    pub fn solve(self) -> Result<Assembled<S, N>, AssemblyError> {
        let prepared = self.model.prepare();
        let mut state = self.guess;
        if let Some(index) = not_finite(&state) {
            return Err(AssemblyError::NotFinite {
                coordinate: M::COORDINATES[index],
            });
        }
        if M::HOLONOMIC > 0 {
            self.assemble_positions(&mut state, &prepared)?;
        }
        for _ in 0..VELOCITY_SWEEPS {
            let residuals = self.model.constraint_velocities(&state, &prepared);
            let (model, held) = (self.model, &self.held_velocities);
            let step =
                model.constrained_response(&state, &prepared, (&zero(), &residuals), held, C);
            state.v += step;
        }
        let velocities = self.model.constraint_velocities(&state, &prepared);
        let open = self.open(&state, &prepared, &velocities, Level::Velocities);
        open.map_or(Ok(()), |open| Err(AssemblyError::Velocities(open)))?;
        let mut moved = state.x;
        moved.add_scaled(-S::one(), &self.guess.x);
        Ok(Assembled { state, moved })
    }

    fn assemble_positions(
        &self,
        state: &mut State<S, N>,
        prepared: &M::Prepared,
    ) -> Result<(), AssemblyError> {
        for _ in 0..MAX_ITERATIONS {
            let residuals = self.model.constraint_positions(state, prepared);
            let step = self.step(state, prepared, &residuals);
            let length = self.length(state, prepared, &step);
            if length <= S::machine_epsilon() * self.length(state, prepared, &state.q) {
                state.q += step;
                break;
            }
            if !self.damped(state, prepared, &step, length) {
                break;
            }
        }
        let residuals = self.model.constraint_positions(state, prepared);
        let open = self.open(state, prepared, &residuals, Level::Positions);
        open.map_or(Ok(()), |open| Err(AssemblyError::Positions(open)))
    }

    /// Takes as much of a step as makes the next one shorter. Returns whether there is such a part.
    fn damped(
        &self,
        state: &mut State<S, N>,
        prepared: &M::Prepared,
        step: &SVector<S, N>,
        length: f64,
    ) -> bool {
        let mut damping = 1.0;
        while damping > LEAST_DAMPING {
            let mut trial = *state;
            trial.q += step.map(|x| x * S::from_f64(damping));
            let residuals = self.model.constraint_positions(&trial, prepared);
            let next = self.step(state, prepared, &residuals);
            let next = self.length(state, prepared, &next);
            if next <= (1.0 - SUFFICIENT_DECREASE * damping) * length {
                *state = trial;
                return true;
            }
            damping *= 0.5;
        }
        false
    }

    /// Returns the step that takes the residuals of holonomic constraints away to first order.
    fn step(
        &self,
        state: &State<S, N>,
        prepared: &M::Prepared,
        residuals: &SVector<S, C>,
    ) -> SVector<S, N> {
        let (model, count) = (self.model, M::HOLONOMIC);
        model.constrained_response(state, prepared, (&zero(), residuals), &self.held, count)
    }

    /// Returns the length of a change of coordinates in the metric of the diagonal of M, in any lane.
    fn length(&self, state: &State<S, N>, prepared: &M::Prepared, x: &SVector<S, N>) -> f64 {
        let mass = self.model.mass_matrix(state, prepared);
        let square = (0..N).fold(S::zero(), |sum, i| sum + mass[(i, i)].abs() * x[i] * x[i]);
        libm::sqrt(square.largest())
    }

    /// Returns the constraints whose residuals are above rounding errors.
    fn open(
        &self,
        state: &State<S, N>,
        prepared: &M::Prepared,
        residuals: &SVector<S, C>,
        level: Level,
    ) -> Option<OpenConstraints> {
        let jacobian = self.model.constraint_jacobian(state, prepared);
        let sizes = sizes_in_metric(self.model, state, prepared, &state.x);
        let [of_positions, of_velocities] = rounding_errors(self.model, state, prepared, &sizes);
        let (of, rounding) = match level {
            Level::Positions => (&state.q, of_positions),
            Level::Velocities => (&state.v, of_velocities),
        };
        let mut open =
            OpenConstraints::new(<M as crate::quantities::Quantities<N, S>>::CONSTRAINTS);
        for j in 0..C {
            let size = row_size(&jacobian, j, of);
            let residual = residuals[j].abs();
            let tolerance = S::from_f64(max_residual::<S>());
            let allowed = (tolerance * size.max(tolerance)).max(rounding[j]);
            let is_open = greater(residual, allowed).largest() > 0.0;
            if is_open || residual.largest().is_nan() {
                open.add(j, residual.largest());
            }
        }
        (!open.is_empty()).then_some(open)
    }
}

/// What constraints are relations of.
#[derive(Clone, Copy)]
enum Level {
    Positions,
    Velocities,
}

fn zero<S: Scalar, const N: usize>() -> SVector<S, N> {
    SVector::from_element(S::zero())
}

fn mark<const N: usize>(held: &mut [bool; N], coordinates: impl IntoIterator<Item = usize>) {
    for coordinate in coordinates {
        if let Some(held) = held.get_mut(coordinate) {
            *held = true;
        }
    }
}

/// Returns a coordinate of which the value or the velocity is not finite.
fn not_finite<S: Scalar, const N: usize>(state: &State<S, N>) -> Option<usize> {
    let is_finite = |x: S| x.largest().is_finite() && x.smallest().is_finite();
    (0..N).find(|i| !is_finite(state.q[*i]) || !is_finite(state.v[*i]))
}
