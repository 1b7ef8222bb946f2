//! Small oscillations of mechanisms with constraints, in independent coordinates.
//!
//! With virtual displacements V, G V = 0, the reduced mass matrix is Vᵀ M V, and ∂q̈/∂q and ∂q̈/∂q̇ are derivatives of the independent
//! accelerations along the manifold of states that meet the constraints (P. E. Nikravesh, *Computer-Aided Analysis of Mechanical
//! Systems*, 1988, chapter 13).

use nalgebra::{SMatrix, SVector};

use super::equilibrium::Variable;
use super::linear_errors::Neighbourhood;
use super::reduced_equations::{Part, Reduced};
use super::small_oscillations::SmallOscillations;
use super::tangent_error::TangentError;
use super::tangent_space::TangentSpace;
use super::tangents::Tangents;
use crate::integrate::SingleNumber;
use crate::limits::analysis::OTHER_TIMES;
use crate::linalg::kept;
use crate::model::{Constraints as _, DirectionalDerivatives, Lagrangian, Quantities as _, State};
use crate::scalar::Scalar;

impl<S: SingleNumber, const N: usize> SmallOscillations<S, N> {
    /// Linearizes a constrained model about an equilibrium, or about a steady motion whose moving coordinates are left out.
    ///
    /// Matrices have rows and columns of the independent coordinates; rows and columns of other coordinates are zero, as if eliminated. If
    /// a coordinate is left out and its velocity is independent, only the velocity is a variable. Stability is judged for the variables.
    ///
    /// ```
    /// use lagrangian::analysis::{SmallOscillations, TangentSpace};
    /// use lagrangian::prelude::*;
    ///
    /// /// A bob on a rod, in Cartesian coordinates.
    /// #[derive(Lagrangian)]
    /// #[lagrangian(
    ///     coordinates(x, y),
    ///     kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    ///     potential = m * g * y,
    ///     constraint(rod = x.powi(2) + y.powi(2) - l.powi(2)),
    /// )]
    /// struct Pendulum { m: f64, g: f64, l: f64 }
    ///
    /// let pendulum = Pendulum { m: 2.0, g: 9.81, l: 0.5 };
    /// for (y, is_stable) in [(-0.5, true), (0.5, false)] {
    ///     let state = State::new(0.0, [0.0, y], [0.0; 2]);
    ///     let oscillations = SmallOscillations::constrained(&TangentSpace::at(&pendulum, &state))?;
    ///     let square = oscillations.normal_modes()?.squared_frequency(0);
    ///     assert!((square + 9.81 / y).abs() < 1e-13);
    ///     assert_eq!(oscillations.stability()?.is_stable(), is_stable);
    /// }
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`TangentError`], if the choice of variables or the state does not allow it, or the velocity of an independent coordinate is
    /// not independent.
    pub fn constrained<M, const C: usize>(
        tangent: &TangentSpace<'_, M, S, N, C>,
    ) -> Result<Self, TangentError>
    where
        M: Lagrangian<N, S, Model: DirectionalDerivatives<N, C, S>> + ?Sized,
    {
        let tangents = Tangents::of(tangent)?;
        let parts = tangents.parts()?;
        let reduced = reduced_along(&tangents, &parts);
        tangents.check(&parts, &reduced, tangent.is_steady)?;
        let nearby = Manifold {
            space: tangent.fixed(&tangents),
            parts: &parts,
        };
        let state = tangents.state();
        let time = contains_time(tangent.model, state);
        Ok(Self::of(&nearby, state, (parts, &reduced), time))
    }
}

/// Returns the linear equations along the manifold at a state.
fn reduced_along<M, S, const N: usize, const C: usize>(
    tangents: &Tangents<'_, M, S, N, C>,
    parts: &[Part; N],
) -> Reduced<S, N>
where
    M: DirectionalDerivatives<N, C, S> + ?Sized,
    S: SingleNumber,
{
    let zero = SMatrix::<S, N, N>::zeros();
    let [mut position, mut velocity, mut by_position, mut by_velocity] = [zero; 4];
    let independent = |rates: SVector<S, N>| kept(&rates, |i, _| parts[i] != Part::Eliminated);
    for j in (0..N).filter(|j| parts[*j] != Part::Eliminated) {
        let direction = tangents.along(Variable::Velocity(j));
        by_velocity.set_column(j, &direction.v);
        velocity.set_column(j, &independent(tangents.rates_along(&direction).v));
        if parts[j] == Part::Oscillating {
            let direction = tangents.along(Variable::Coordinate(j));
            by_position.set_column(j, &direction.v);
            position.set_column(j, &independent(tangents.rates_along(&direction).v));
        }
    }
    let mass = tangents.mass_matrix();
    let mass_terms =
        by_velocity.map(S::abs).transpose() * mass.map(S::abs) * by_velocity.map(S::abs);
    Reduced {
        mass: by_velocity.transpose() * mass * by_velocity,
        position,
        velocity_terms: mass_terms * velocity.map(S::abs),
        velocity,
        eliminated: [by_position, by_velocity],
    }
}

/// The states that meet the constraints beside an equilibrium, in the same independent variables.
struct Manifold<'a, M: ?Sized, S: Scalar, const N: usize, const C: usize> {
    space: TangentSpace<'a, M, S, N, C>,
    parts: &'a [Part; N],
}

impl<M, S, const N: usize, const C: usize> Neighbourhood<S, N> for Manifold<'_, M, S, N, C>
where
    M: Lagrangian<N, S, Model: DirectionalDerivatives<N, C, S>> + ?Sized,
    S: SingleNumber,
{
    /// Beyond the reach of the mechanism the state is not a number, and nothing is compared.
    fn moved(&self, displacement: &SVector<S, N>) -> State<S, N> {
        let mut moved = self.space.state;
        moved.q += displacement;
        let held = self.space.held();
        let marked = |marks: [bool; N]| (0..N).filter(move |i| marks[*i]);
        let search = self.space.model.assemble(moved).hold(marked(held[0]));
        let found = search.hold_velocities(marked(held[1])).solve();
        let nothing = SVector::repeat(S::from_f64(f64::NAN));
        found.map_or(State::new(moved.t, nothing, nothing), |found| found.state)
    }

    fn reduced(&self, state: &State<S, N>) -> Reduced<S, N> {
        let nothing = SMatrix::repeat(S::from_f64(f64::NAN));
        let nothing = Reduced {
            mass: nothing,
            position: nothing,
            velocity: nothing,
            velocity_terms: nothing,
            eliminated: [nothing; 2],
        };
        let tangents = Tangents::of(&self.space.at_state(state));
        tangents.map_or(nothing, |tangents| reduced_along(&tangents, self.parts))
    }

    fn accelerations(&self, state: &State<S, N>) -> SVector<S, N> {
        self.space.model.accelerations(state)
    }

    fn generalized_forces(&self, state: &State<S, N>) -> SVector<S, N> {
        self.space.model.generalized_forces(state)
    }

    fn allowed(&self, state: &State<S, N>, change: SVector<S, N>) -> SVector<S, N> {
        let model = self.space.model.model();
        let prepared = model.prepare();
        let residuals = model.constraint_jacobian(state, &prepared) * change;
        let right = (&SVector::zeros(), &residuals);
        change + model.constrained_response(state, &prepared, right, &[false; N], C)
    }
}

/// Returns whether the equations or the constraints change with time: otherwise they agree to the last bit.
fn contains_time<M, S, const N: usize, const C: usize>(model: &M, state: &State<S, N>) -> bool
where
    M: Lagrangian<N, S, Model: DirectionalDerivatives<N, C, S>> + ?Sized,
    S: SingleNumber,
{
    let at = |state: &State<S, N>| {
        let (positions, velocities) = model.constraint_residuals(state);
        let mass = model.mass_matrix(state);
        (positions, velocities, mass, model.accelerations(state))
    };
    let here = at(state);
    OTHER_TIMES.iter().any(|after| {
        let mut later = *state;
        later.t += S::from_f64(*after);
        // NaN differs from itself.
        at(&later) != here
    })
}
