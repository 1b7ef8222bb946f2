//! Small oscillations about equilibria and steady motions.
//!
//! Ignorable coordinates with constant momenta are eliminated (E. J. Routh, *A Treatise on the Stability of a Given
//! State of Motion*, 1877): δpᵢ = 0 determines their velocities. The remaining coordinates satisfy
//! M δq̈ + (G + C) δq̇ + K δq = 0 with the Hessian K of the effective potential, gyroscopic forces G and damping C;
//! D. R. Merkin, *Introduction to the Theory of Stability*, 1997, chapters 3 and 6.

use nalgebra::{Complex, SMatrix, SVector};

use super::balance::{HeldInputs, momentum_gradients};
use super::components::components;
use super::eigenvalues::eigenvalues;
use super::exceeds;
use super::force_balance::{UnbalancedForce, unbalanced_force};
use super::jacobian_rows::Variables;
use super::linear_errors::{Neighbourhood, Unconstrained, gives_energy, linear_errors};
use super::members::Members;
use super::oscillation_error::OscillationError;
use super::reduced_equations::{Part, Reduced, under_held_inputs};
use super::spectrum::Spectrum;
use super::time_dependence::contains_time;
use crate::integrate::SingleNumber;
use crate::limits::analysis::NEGLIGIBLE;
use crate::linalg::largest;
use crate::model::{Lagrangian, State, StateJacobian};
use crate::scalar::Scalar;

/// The linear equations of small oscillations about an equilibrium, or about a steady motion in which only ignorable
/// coordinates move.
///
/// Ignorable coordinates whose momenta are constant to first order are eliminated: perturbations leave these momenta
/// unchanged. Ignorable coordinates on which a force acts, such as friction, keep their velocities as variables. In the
/// matrices, rows and columns of eliminated coordinates are zero, so that they can be indexed by the constants of the
/// model, such as `Top::THETA`.
///
/// ```
/// use lagrangian::analysis::SmallOscillations;
/// use lagrangian::prelude::*;
/// use lagrangian::rigid_body::SteadyPrecession;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(phi, theta, psi),
///     kinetic = 0.5 * (i * (dot(phi).powi(2) * sin(theta).powi(2) + dot(theta).powi(2))
///         + i_s * (dot(phi) * cos(theta) + dot(psi)).powi(2)),
///     potential = mgl * cos(theta),
/// )]
/// struct Top { i: f64, i_s: f64, mgl: f64 }
///
/// let top = Top { i: 1.2, i_s: 0.5, mgl: 5.1 };
/// let (theta, spin) = (0.5_f64, 40.0);
/// let slope = -top.mgl * theta.sin();
/// let precession = SteadyPrecession::of_top(top.i, top.i_s, spin, theta, slope);
/// let SteadyPrecession::Two { slow, .. } = precession else { unreachable!() };
/// let steady = State::new(0.0, [0.0, theta, 0.0], [slow, 0.0, spin - slow * theta.cos()]);
///
/// // Nutation: Ω² = φ̇² − 2 (m g l/I) cos θ + (m g l/(I φ̇))².
/// let ratio = top.mgl / top.i;
/// let expected = slow * slow - 2.0 * ratio * theta.cos() + (ratio / slow).powi(2);
/// let oscillations = SmallOscillations::about(&top, &steady)?;
/// let modes = oscillations.normal_modes()?;
/// assert_eq!(modes.len(), 1);
/// assert!((modes.squared_frequency(0) / expected - 1.0).abs() < 1e-12);
/// assert!(oscillations.stability()?.is_stable());
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SmallOscillations<S: Scalar, const N: usize> {
    /// The role of each coordinate.
    pub(super) parts: [Part; N],
    /// The mass matrix M after elimination (a Schur complement).
    pub mass: SMatrix<S, N, N>,
    /// ∂q̈ᵢ/∂qⱼ at constant momenta.
    pub position: SMatrix<S, N, N>,
    /// ∂q̈ᵢ/∂q̇ⱼ at constant momenta.
    pub velocity: SMatrix<S, N, N>,
    /// The eliminated velocities as linear functions of coordinates and of velocities.
    pub(super) eliminated: [SMatrix<S, N, N>; 2],
    /// The sizes of the terms of M ∂q̈/∂q̇, by which its rounding errors are measured.
    pub(super) velocity_terms: SMatrix<S, N, N>,
    /// Bounds, entry by entry, for the differences of `position` and `velocity` from their values at the exact
    /// equilibrium.
    pub(super) errors: [SMatrix<S, N, N>; 2],
    /// Whether a force supplies energy to small perturbations, in whatever order.
    pub(super) gives_energy: bool,
    /// Whether the equations depend on time.
    pub(super) contains_time: bool,
}

/// Storage for two eigenvalues per coordinate.
type Pairs<const N: usize> = [[Complex<f64>; N]; 2];

impl<S: SingleNumber, const N: usize> SmallOscillations<S, N> {
    /// Linearizes a model about a state at which accelerations are zero and only ignorable coordinates move, as found
    /// by [`EquilibriumSearch`].
    ///
    /// # Errors
    ///
    /// [`OscillationError`], if the state is neither an equilibrium nor a steady motion.
    ///
    /// [`EquilibriumSearch`]: crate::analysis::EquilibriumSearch
    pub fn about<M>(model: &M, state: &State<S, N>) -> Result<Self, OscillationError>
    where
        M: Lagrangian<N, S, Model: StateJacobian<N, S>> + ?Sized,
    {
        let slopes = model.linearize(state);
        let (position, velocity) = (slopes.position, slopes.velocity);
        check_steady::<S, M, N>(model, state, &[&position, &velocity])?;
        let mass = model.mass_matrix(state);
        let gradients = momentum_gradients(&HeldInputs(model), &under_held_inputs(state));
        let constant = constant_momenta::<S, M, N>(&mass, &gradients, &position, &velocity);
        let parts = core::array::from_fn(|i| match (M::IGNORABLE[i], constant[i]) {
            (false, _) => Part::Oscillating,
            (true, false) => Part::Moving,
            (true, true) => Part::Eliminated,
        });
        let reduced = Reduced::of(&parts, &mass, &gradients, &slopes);
        let nearby = Unconstrained {
            model,
            state,
            parts: &parts,
            eliminated: &reduced.eliminated,
        };
        let time = contains_time(model, state, &slopes);
        Ok(Self::of(&nearby, state, (parts, &reduced), time))
    }

    /// The equations at a state, with what is found in its neighbourhood.
    pub(super) fn of(
        nearby: &impl Neighbourhood<S, N>,
        state: &State<S, N>,
        (parts, reduced): ([Part; N], &Reduced<S, N>),
        contains_time: bool,
    ) -> Self {
        Self {
            parts,
            mass: reduced.mass,
            position: reduced.position,
            velocity: reduced.velocity,
            eliminated: reduced.eliminated,
            velocity_terms: reduced.velocity_terms,
            errors: linear_errors(nearby, state, &parts, reduced),
            gives_energy: gives_energy(nearby, state, reduced),
            contains_time,
        }
    }

    /// Returns the oscillating coordinates.
    pub fn coordinates(&self) -> impl Iterator<Item = usize> + '_ {
        (0..N).filter(|i| self.parts[*i] == Part::Oscillating)
    }

    /// Returns the oscillating coordinates, then the coordinates of which only velocities are variables; and the number
    /// of the oscillating ones.
    pub(super) fn variables(&self) -> (Members<N>, usize) {
        let moving = (0..N).filter(|i| self.parts[*i] == Part::Moving);
        let variables = Members::of(self.coordinates().chain(moving));
        (variables, self.coordinates().count())
    }

    /// Returns the stiffness matrix K = −M ∂q̈/∂q.
    ///
    /// If all forces are conservative, it is the Hessian of the potential energy or, if coordinates were eliminated, of
    /// the effective potential (4.10).
    #[must_use]
    pub fn stiffness(&self) -> SMatrix<S, N, N> {
        -(self.mass * self.position)
    }

    /// Returns the matrix G + C = −M ∂q̈/∂q̇. Its antisymmetric part G describes gyroscopic forces, its symmetric part
    /// C damping.
    #[must_use]
    pub fn velocity_forces(&self) -> SMatrix<S, N, N> {
        -(self.mass * self.velocity)
    }

    /// Computes the eigenvalues of the first-order system in the oscillating coordinates, their velocities, and the
    /// velocities of ignorable coordinates without constant momenta.
    ///
    /// # Errors
    ///
    /// If the QR algorithm does not converge, or if an entry is not finite.
    pub fn spectrum(&self) -> Result<Spectrum<N>, OscillationError> {
        let (found, count) = self.eigenvalues_by_components(&mut |_, _| {})?;
        Ok(Spectrum::new(found, count))
    }

    /// Calls `visit` with the label and the eigenvalues of each group of coupled coordinates; returns all and their
    /// count.
    pub(super) fn eigenvalues_by_components(
        &self,
        visit: &mut dyn FnMut(usize, &[Complex<f64>]),
    ) -> Result<(Pairs<N>, usize), OscillationError> {
        let labels = self.components();
        let mut found = [[Complex::new(0.0, 0.0); N]; 2];
        let all = found.as_flattened_mut();
        let mut start = 0;
        for label in 0..N {
            let mut entries = [[[[0.0; N]; 2]; N]; 2];
            let flat = entries.as_flattened_mut().as_flattened_mut();
            let flat = flat.as_flattened_mut();
            let order = self.first_order_matrix(flat, &|i| labels[i] == label);
            let part = &mut all[start..start + order];
            if !eigenvalues(flat, 2 * N, order, part) {
                return Err(OscillationError::NoEigenvalues);
            }
            visit(label, part);
            start += order;
        }
        Ok((found, start))
    }

    /// Returns the label of the group of coupled coordinates to which each coordinate belongs.
    pub(super) fn components(&self) -> [usize; N] {
        components(&[&self.mass, &self.position, &self.velocity])
    }

    /// Writes the matrix of the first-order system of some coordinates in rows of length 2 `N`, and returns its order.
    fn first_order_matrix(&self, flat: &mut [f64], is_member: &dyn Fn(usize) -> bool) -> usize {
        let (variables, all_coordinates) = self.variables();
        let members = |count: usize| {
            let variables = variables[..count].iter().copied();
            variables.filter(|i| is_member(*i))
        };
        let all = variables.len();
        let [coordinates, count] = [all_coordinates, all].map(|count| members(count).count());
        for i in 0..coordinates {
            flat[i * 2 * N + coordinates + i] = 1.0;
        }
        for (i, row) in members(all).enumerate() {
            let start = (coordinates + i) * 2 * N;
            for (j, column) in members(all_coordinates).enumerate() {
                flat[start + j] = self.position[(row, column)].largest();
            }
            for (j, column) in members(all).enumerate() {
                flat[start + coordinates + j] = self.velocity[(row, column)].largest();
            }
        }
        coordinates + count
    }
}

/// Checks that all accelerations are zero, and all velocities except those of ignorable coordinates.
fn check_steady<S, M, const N: usize>(
    model: &M,
    state: &State<S, N>,
    slopes: &[&SMatrix<S, N, N>; 2],
) -> Result<(), OscillationError>
where
    S: SingleNumber,
    M: Lagrangian<N, S, Model: StateJacobian<N, S>> + ?Sized,
{
    let steepest = largest(slopes.iter().copied().flatten());
    let accelerations = model.accelerations(state);
    for (i, name) in M::COORDINATES.into_iter().enumerate() {
        let velocity = state.v[i].largest();
        if !M::IGNORABLE[i] && velocity.abs() > 0.0 {
            return Err(OscillationError::Moving { name, velocity });
        }
        let acceleration = accelerations[i].largest();
        if exceeds(acceleration.abs(), negligible::<S>() * steepest) {
            return Err(OscillationError::Accelerated { name, acceleration });
        }
    }
    let point = under_held_inputs(state);
    let size = |x: &S| S::from_f64(x.abs().largest().max(1.0));
    let sizes = Variables {
        positions: state.q.map(|x| size(&x)),
        velocities: state.v.map(|x| size(&x)),
        inputs: SVector::zeros(),
    };
    match unbalanced_force(&HeldInputs(model), &point, &sizes, negligible::<S>()) {
        None => Ok(()),
        Some(UnbalancedForce { coordinate, force }) => {
            let name = M::COORDINATES[coordinate];
            Err(OscillationError::Unbalanced { name, force })
        }
    }
}

/// Returns which momenta are constant to first order: ṗᵢ = Σ ∂pᵢ/∂qⱼ δq̇ⱼ + Σ Mᵢⱼ δq̈ⱼ vanishes for all perturbations.
fn constant_momenta<S, M, const N: usize>(
    mass: &SMatrix<S, N, N>,
    gradients: &SMatrix<S, N, N>,
    position: &SMatrix<S, N, N>,
    velocity: &SMatrix<S, N, N>,
) -> [bool; N]
where
    S: SingleNumber,
    M: Lagrangian<N, S, Model: StateJacobian<N, S>> + ?Sized,
{
    let by_position = mass * position;
    let by_velocity = mass * velocity + gradients;
    let absolute = |matrix: &SMatrix<S, N, N>| matrix.map(S::abs);
    let position_terms = absolute(mass) * absolute(position);
    let velocity_terms = absolute(mass) * absolute(velocity) + absolute(gradients);
    core::array::from_fn(|i| {
        let pairs = [
            (&by_position, &position_terms),
            (&by_velocity, &velocity_terms),
        ];
        M::IGNORABLE[i]
            && pairs.iter().all(|(sums, terms)| {
                largest(sums.row(i)) <= negligible::<S>() * largest(terms.row(i))
            })
    })
}

/// Returns the bound below which a number is negligible relative to 1.
pub(super) fn negligible<S: Scalar>() -> f64 {
    libm::pow(S::machine_epsilon(), NEGLIGIBLE)
}
