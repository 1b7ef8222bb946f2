//! Bounds for the difference between the linearized equations at a computed state and at the exact equilibrium nearby.
//!
//! A search ends at a finite distance from the equilibrium. Where the second variation vanishes, as for V = x³, it has
//! a sign at the computed state that it lacks at the equilibrium. The distance along each principal direction of
//! K is estimated by Newton's correction and by the rounding error of the force, in units of the stiffness along this
//! direction. K is then evaluated at this distance on both sides. The rounding errors of forces are seen in their
//! fourth differences: R. W. Hamming, *Introduction to Applied Numerical Analysis*, 1971, chapter 6; J. J. Moré and S.
//! M. Wild, *Estimating computational noise*, SIAM J. Sci. Comput. **33** (2011) 1292–1314.

use nalgebra::{SMatrix, SVector};

use super::components::components;
use super::members::Members;
use super::reduced_equations::{Part, Reduced};
use super::symmetric_eigenvalues::symmetric_eigenvalues;
use crate::integrate::SingleNumber;
use crate::limits::analysis::{
    ENERGY_SAMPLES, EQUILIBRIUM_TOLERANCE, FARTHEST, FIRST_DISTANCE, POSITION_ERRORS, SINGULAR,
};
use crate::linalg::largest;
use crate::model::{Lagrangian, State, StateJacobian};
use crate::scalar::Scalar;

/// The sign patterns in which principal directions are combined.
const PATTERNS: [fn(usize) -> bool; 3] = [|_| true, |i| i % 2 == 0, |i| i % 4 < 2];

/// The states beside an equilibrium, and the equations there.
pub(super) trait Neighbourhood<S: Scalar, const N: usize> {
    /// Returns the state whose oscillating coordinates are displaced; its constant momenta are unchanged, and it meets the constraints.
    fn moved(&self, displacement: &SVector<S, N>) -> State<S, N>;
    /// Returns the reduced linear equations at a state.
    fn reduced(&self, state: &State<S, N>) -> Reduced<S, N>;
    /// Returns the accelerations.
    fn accelerations(&self, state: &State<S, N>) -> SVector<S, N>;
    /// Returns the generalized forces.
    fn generalized_forces(&self, state: &State<S, N>) -> SVector<S, N>;
    /// Returns what constraints allow of a change of velocities.
    fn allowed(&self, state: &State<S, N>, change: SVector<S, N>) -> SVector<S, N>;
}

/// The neighbourhood of an equilibrium of a model without constraints.
pub(super) struct Unconstrained<'a, M: ?Sized, S: Scalar, const N: usize> {
    pub(super) model: &'a M,
    pub(super) state: &'a State<S, N>,
    pub(super) parts: &'a [Part; N],
    pub(super) eliminated: &'a [SMatrix<S, N, N>; 2],
}

impl<M, S, const N: usize> Neighbourhood<S, N> for Unconstrained<'_, M, S, N>
where
    S: SingleNumber,
    M: Lagrangian<N, S, Model: StateJacobian<N, S>> + ?Sized,
{
    fn moved(&self, displacement: &SVector<S, N>) -> State<S, N> {
        let [by_position, _] = self.eliminated;
        State::new(
            self.state.t,
            self.state.q + displacement,
            self.state.v + by_position * displacement,
        )
    }

    fn reduced(&self, state: &State<S, N>) -> Reduced<S, N> {
        Reduced::at(self.model, state, self.parts)
    }

    fn accelerations(&self, state: &State<S, N>) -> SVector<S, N> {
        self.model.accelerations(state)
    }

    fn generalized_forces(&self, state: &State<S, N>) -> SVector<S, N> {
        self.model.generalized_forces(state)
    }

    fn allowed(&self, _: &State<S, N>, change: SVector<S, N>) -> SVector<S, N> {
        change
    }
}

/// Returns bounds, entry by entry, for the differences of ∂q̈/∂q and ∂q̈/∂q̇ of small oscillations from their values at
/// the equilibrium.
pub(super) fn linear_errors<S, B, const N: usize>(
    nearby: &B,
    state: &State<S, N>,
    parts: &[Part; N],
    reduced: &Reduced<S, N>,
) -> [SMatrix<S, N, N>; 2]
where
    S: SingleNumber,
    B: Neighbourhood<S, N>,
{
    let place = Place {
        nearby,
        state,
        parts,
        reduced,
    };
    let mut errors = [SMatrix::<S, N, N>::zeros(); 2];
    let displacements = place.displacements();
    for pattern in PATTERNS {
        let displacement = (0..N).fold(SVector::<S, N>::zeros(), |sum, k| {
            let direction = displacements.column(k);
            if pattern(k) {
                sum + direction
            } else {
                sum - direction
            }
        });
        if displacement.iter().all(|x| x.abs().largest() <= 0.0) {
            continue;
        }
        for displacement in [displacement, -displacement] {
            let beside = nearby.reduced(&nearby.moved(&displacement));
            let changes = [
                beside.position - reduced.position,
                beside.velocity - reduced.velocity,
            ];
            for (error, change) in errors.iter_mut().zip(changes) {
                // Beyond the domain of the model there is nothing to compare.
                *error = error.zip_map(&change, |most, x| {
                    if x.abs().largest() > most.largest() {
                        x.abs()
                    } else {
                        most
                    }
                });
            }
        }
    }
    errors
}

/// An equilibrium and its neighbourhood.
struct Place<'a, B, S: Scalar, const N: usize> {
    nearby: &'a B,
    state: &'a State<S, N>,
    parts: &'a [Part; N],
    reduced: &'a Reduced<S, N>,
}

impl<B, S, const N: usize> Place<'_, B, S, N>
where
    S: SingleNumber,
    B: Neighbourhood<S, N>,
{
    /// Returns in its columns how far the equilibrium may be along each principal direction of K, including the
    /// rounding of positions.
    fn displacements(&self) -> SMatrix<S, N, N> {
        let half = S::from_f64(0.5);
        let product = self.reduced.mass * self.reduced.position;
        let stiffness = (product + product.transpose()) * -half;
        let unit: [f64; N] = core::array::from_fn(|i| {
            let most = largest(stiffness.row(i));
            if most > 0.0 { libm::sqrt(most) } else { 1.0 }
        });
        let scaled = SMatrix::<S, N, N>::from_fn(|i, j| {
            stiffness[(i, j)] / S::from_f64(unit[i]) / S::from_f64(unit[j])
        });
        let labels = components(&[&scaled]);
        let mut columns = SMatrix::<S, N, N>::zeros();
        let mut count = 0;
        for label in 0..N {
            let members = Members::<N>::of(
                (0..N).filter(|i| labels[*i] == label && self.parts[*i] == Part::Oscillating),
            );
            let order = members.len();
            let (_, vectors) = symmetric_eigenvalues(&members.block(&scaled), order);
            for k in 0..order {
                let mut direction = SVector::<S, N>::zeros();
                for i in 0..order {
                    direction[members[i]] = vectors[(i, k)] / S::from_f64(unit[members[i]]);
                }
                columns.set_column(count, &self.displacement(&stiffness, &direction));
                count += 1;
            }
        }
        let rounding = EQUILIBRIUM_TOLERANCE * S::machine_epsilon();
        for i in (0..N).filter(|i| self.parts[*i] == Part::Oscillating) {
            columns[(i, 0)] += self.state.q[i].abs() * S::from_f64(rounding);
        }
        columns
    }

    /// Returns how far the equilibrium may be along a direction d.
    ///
    /// This is a multiple of the distance beyond which, on both sides, the force along d agrees with the stiffness κ =
    /// dᵀ K d up to a factor of two. If there is no such distance, it is the distance at which κ has changed by its own
    /// size.
    fn displacement(
        &self,
        stiffness: &SMatrix<S, N, N>,
        direction: &SVector<S, N>,
    ) -> SVector<S, N> {
        let longest = (0..N).fold(0.0, |most: f64, i| {
            let size = self.state.q[i].abs().largest().max(1.0);
            most.max(direction[i].abs().largest() / size)
        });
        let kappa = direction.dot(&(stiffness * direction)).largest();
        let nothing = SVector::zeros();
        if !(longest > 0.0 && kappa.abs() > 0.0) {
            return nothing;
        }
        let direction = direction * S::from_f64(1.0 / longest);
        let kappa = kappa / (longest * longest);
        let lengths = || {
            let lengths = (0..).map(|n| libm::ldexp(1.0, FIRST_DISTANCE + 3 * n));
            let lengths = lengths.take_while(|length| *length < FARTHEST);
            // Shorter displacements are lost by rounding.
            lengths.filter(|length| {
                let moved = self.state.q + direction * S::from_f64(*length);
                moved != self.state.q
            })
        };
        let is_resolved = |length: f64| {
            let force = |length: f64| {
                let beside = self.nearby.moved(&(direction * S::from_f64(length)));
                let force = self.reduced.mass * self.nearby.accelerations(&beside);
                -direction.dot(&force).largest() / kappa
            };
            [length, -length].into_iter().all(|length| {
                let ratio = force(length) / length;
                (0.5..=2.0).contains(&ratio)
            })
        };
        let is_another = |length: &f64| {
            [*length, -length].into_iter().any(|length| {
                let beside = self.nearby.moved(&(direction * S::from_f64(length)));
                let beside = self.nearby.reduced(&beside);
                let there = -(beside.mass * beside.position);
                let there = direction.dot(&(there * direction)).largest();
                (there - kappa).abs() >= kappa.abs()
            })
        };
        let length = match lengths().find(|length| is_resolved(*length)) {
            Some(length) => POSITION_ERRORS * length,
            None => lengths().find(is_another).unwrap_or(0.0),
        };
        direction * S::from_f64(length)
    }
}

/// Returns whether the generalized forces supply energy to some small perturbation, in whatever order: (Q(q, q̇ + w) −
/// Q(q, q̇)) w > 0.
pub(super) fn gives_energy<S, B, const N: usize>(
    nearby: &B,
    state: &State<S, N>,
    reduced: &Reduced<S, N>,
) -> bool
where
    S: SingleNumber,
    B: Neighbourhood<S, N>,
{
    let steepest = largest(&reduced.position);
    let rate = if steepest > 0.0 {
        libm::sqrt(steepest)
    } else {
        1.0
    };
    let rounding = SINGULAR * S::machine_epsilon();
    let moved = |sign: f64, pattern: fn(usize) -> bool| {
        SVector::<S, N>::from_fn(|i, _| {
            let size = state.q[i].abs().largest();
            let size = if size > 0.0 { size } else { 1.0 };
            S::from_f64(if pattern(i) {
                sign * size
            } else {
                -sign * size
            })
        })
    };
    let power = |q: SVector<S, N>, w: SVector<S, N>| {
        let still = State::new(state.t, state.q + q, state.v);
        let w = nearby.allowed(&still, w);
        let moving = State::new(still.t, still.q, still.v + w);
        let [before, after] = [&still, &moving].map(|state| nearby.generalized_forces(state));
        let terms = before.map(S::abs) + after.map(S::abs);
        let power = (after - before).dot(&w).largest();
        power > rounding * terms.dot(&w.map(S::abs)).largest()
    };
    let rate = S::from_f64(rate);
    ENERGY_SAMPLES.into_iter().any(|size| {
        PATTERNS.into_iter().any(|of_positions| {
            PATTERNS.into_iter().any(|of_velocities| {
                [size, -size].into_iter().any(|sign| {
                    let w = moved(size, of_velocities) * rate;
                    power(moved(sign, of_positions), w) || power(moved(sign, of_positions), -w)
                })
            })
        })
    })
}
