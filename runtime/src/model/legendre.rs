//! The Legendre transformation: the velocities that belong to given momenta.
//!
//! Where L is convex in the velocities, these velocities minimize L − p q̇ (R. T. Rockafellar, *Convex Analysis*, 1970,
//! section 26). Newton's method with step halving finds them if M is regular and finite along its path. At rest this
//! does not hold for L = |q̇|^(3/2) or q̇⁴. In such cases the velocities are changed one after another, each to the
//! zero of its own momentum equation, which increases with the velocity (P. Tseng, *Convergence of a block coordinate
//! descent method for nondifferentiable minimization*, J. Optim. Theory Appl. **109** (2001) 475–494). Then Newton's
//! directions are followed to the minimum of L − p q̇ along them.

use nalgebra::{Matrix1, SMatrix, SVector};

use super::canonical_phase::CanonicalPhase;
use super::hamiltonian::{Hamiltonian, NoVelocities};
use super::quantities::Quantities;
use super::state::State;
use crate::limits::{
    HELD_MOMENTUM, LEGENDRE_BISECTIONS, LEGENDRE_ITERATIONS, LEGENDRE_ROUNDING, LEGENDRE_SWEEPS,
    MIN_NEWTON_STEP,
};
use crate::linalg::lane_select::{LaneSelect, greater};
use crate::linalg::{Factorization, largest_or_nan};
use crate::scalar::Scalar;

/// Returns the velocities that belong to the momenta of a phase at a time.
pub(super) fn velocities<M, S, const N: usize>(
    model: &M,
    prepared: &M::Prepared,
    t: S,
    phase: &CanonicalPhase<S, N>,
) -> Result<SVector<S, N>, NoVelocities>
where
    M: Hamiltonian<N, S> + ?Sized,
    S: Scalar,
{
    let state = State::new(t, phase.q, SVector::zeros());
    let solved = model.solved_velocities(&state, &phase.p, prepared);
    if solved.iter().all(|v| v.is_finite()) {
        return Ok(solved);
    }
    let search = Search {
        model,
        prepared,
        momenta: &phase.p,
        state,
    };
    search.run()
}

/// A search for the velocities of a state with which it has these momenta.
struct Search<'a, M: Quantities<N, S> + ?Sized, S: Scalar, const N: usize> {
    model: &'a M,
    prepared: &'a M::Prepared,
    momenta: &'a SVector<S, N>,
    state: State<S, N>,
}

impl<M: Quantities<N, S> + ?Sized, S: Scalar, const N: usize> Search<'_, M, S, N> {
    /// Returns what the momenta lack with the present velocities.
    fn missing(&self) -> SVector<S, N> {
        self.momenta - self.model.momenta(&self.state, self.prepared)
    }

    /// Returns the size of momenta that may be left out.
    fn negligible(&self) -> f64 {
        HELD_MOMENTUM * S::machine_epsilon() * largest_or_nan(self.momenta)
    }

    /// Returns the step of Newton's method, and which velocities have finite inertias.
    fn step(&self, missing: &SVector<S, N>) -> [SVector<S, N>; 2] {
        let mass = self.model.mass_matrix(&self.state, self.prepared);
        let (mass, is_regular) = without_infinite(&mass);
        let step = Factorization::new(mass).solve(&missing.component_mul(&is_regular));
        [step, is_regular]
    }

    /// Starts from the velocities of the state.
    fn run(mut self) -> Result<SVector<S, N>, NoVelocities> {
        if !self.momenta.iter().all(|p| p.is_finite()) {
            return Err(NoVelocities::NotFound { change: f64::NAN });
        }
        let mut found = self.newton();
        for _ in 0..LEGENDRE_SWEEPS {
            match found {
                Err(NoVelocities::NotFound { .. }) => {}
                found => return found,
            }
            if !self.state.v.iter().all(|v| v.is_finite()) {
                self.state.v.fill(S::zero());
            }
            let negligible = self.negligible();
            for i in 0..N {
                let size = self.missing()[i].abs().largest();
                if size.is_nan() || size > negligible {
                    self.state.v[i] = self.zero_of_momentum(i);
                }
            }
            let missing = largest_or_nan(&self.missing());
            if !missing.is_finite() {
                break;
            }
            let next = if missing == 0.0 {
                self.unique()
            } else {
                self.descend();
                self.newton()
            };
            match next {
                Err(NoVelocities::NotConvex) if missing == 0.0 => break,
                // The first error shows why the search failed.
                Err(NoVelocities::NotFound { .. }) => {}
                next => found = next,
            }
        }
        found
    }

    /// Runs Newton's method and updates the velocities.
    fn newton(&mut self) -> Result<SVector<S, N>, NoVelocities> {
        let mut missing = self.missing();
        let mut change = f64::NAN;
        for _ in 0..LEGENDRE_ITERATIONS {
            let [step, is_regular] = self.step(&missing);
            change = largest_or_nan(&step);
            if !change.is_finite() {
                break;
            }
            let before = self.state.v;
            let (mut factor, least) = (1.0, largest_or_nan(&missing));
            let reached = loop {
                self.state.v = before + step * S::from_f64(factor);
                missing = self.missing();
                if largest_or_nan(&missing) < least || least == 0.0 {
                    break true;
                }
                factor *= 0.5;
                if factor < MIN_NEWTON_STEP {
                    break false;
                }
            };
            if !reached {
                // Derivative parts lag one step behind.
                self.state.v = if S::DERIVATIVES > 0 {
                    before + step
                } else {
                    before
                };
            }
            // Only rounding errors are left.
            let size = largest_or_nan(&self.state.v);
            let is_still = change <= LEGENDRE_ROUNDING * S::machine_epsilon() * size;
            let is_small = !reached && change <= S::machine_epsilon().sqrt() * size;
            let held = missing.component_mul(&is_regular.map(|regular| S::one() - regular));
            if (is_still || is_small) && largest_or_nan(&held) <= self.negligible() {
                return self.unique();
            }
            if is_still || !reached {
                break;
            }
        }
        Err(NoVelocities::NotFound { change })
    }

    /// Follows Newton's directions as far as L − p q̇ decreases along them.
    ///
    /// In each lane separately, the distance is found by bisection of the slope, which increases with the distance where L
    /// is convex.
    fn descend(&mut self) {
        let (zero, one) = (S::zero(), S::one());
        for _ in 0..LEGENDRE_ITERATIONS {
            let [step, _] = self.step(&self.missing());
            let before = self.state.v;
            let change = largest_or_nan(&step);
            if !(change.is_finite() && change > S::machine_epsilon() * largest_or_nan(&before)) {
                return;
            }
            let mut decreases = |factor: S| {
                self.state.v = before + step * factor;
                greater(self.missing().dot(&step), zero)
            };
            let mut near = decreases(one);
            let mut far = one;
            for _ in 0..LEGENDRE_BISECTIONS {
                let middle = (near + far) * S::from_f64(0.5);
                let is_near = decreases(middle);
                near += is_near * (middle - near);
                far = middle + is_near * (far - middle);
            }
            self.state.v = before + step * far;
        }
    }

    /// Returns the velocity of a coordinate at which its momentum has the given value, while the other velocities are held.
    ///
    /// In each lane separately, the exponent is found by bisection. A velocity for which the momentum is not defined counts
    /// as too large.
    fn zero_of_momentum(&self, coordinate: usize) -> S {
        let missing = |velocity: S| {
            let mut state = self.state;
            state.v[coordinate] = velocity;
            self.momenta[coordinate] - self.model.momenta(&state, self.prepared)[coordinate]
        };
        let zero = S::zero();
        let at_rest = missing(zero);
        let sign = greater(at_rest, zero) - greater(zero, at_rest);
        let mut least = S::min_positive();
        let mut most = S::one() / least;
        for _ in 0..LEGENDRE_BISECTIONS {
            let middle = least.sqrt() * most.sqrt();
            let is_less = greater(missing(sign * middle) * sign, zero);
            least += is_less * (middle - least);
            most = middle + is_less * (most - middle);
        }
        sign * least
    }

    /// Returns the velocities, unless L is neither quadratic in the velocities nor convex there.
    fn unique(&self) -> Result<SVector<S, N>, NoVelocities> {
        let (state, prepared) = (&self.state, self.prepared);
        let mass = self.model.mass_matrix(state, prepared);
        // These velocities all differ from the given ones, even where some or all of those are zero.
        let v = state.v.map(|v| S::from_f64(0.5) * v + S::from_f64(0.618));
        let other = State::new(state.t, state.q, v);
        let is_quadratic = mass == self.model.mass_matrix(&other, prepared);
        if is_quadratic || is_positive_definite(mass) || self.is_convex_beside() {
            Ok(state.v)
        } else {
            Err(NoVelocities::NotConvex)
        }
    }

    /// Returns whether M is positive definite at nearby velocities on all sides: L = q̇⁴ is convex at q̇ = 0 though M
    /// vanishes there.
    fn is_convex_beside(&self) -> bool {
        let fastest = largest_or_nan(&self.state.v);
        let size = if fastest > 0.0 { fastest } else { 1.0 };
        let distance = S::from_f64(size * S::machine_epsilon().sqrt());
        [1, 2].into_iter().all(|period| {
            [distance, -distance].into_iter().all(|distance| {
                let mut beside = self.state;
                for (i, v) in beside.v.iter_mut().enumerate() {
                    *v += if i % period == 0 { distance } else { -distance };
                }
                is_positive_definite(self.model.mass_matrix(&beside, self.prepared))
            })
        })
    }
}

/// Returns the mass matrix without the rows and columns of velocities at which it is not finite, such as at rest for
/// L = |q̇|^(3/2), and which velocities are regular. The removed rows and columns are replaced by rows and
/// columns of the identity matrix.
fn without_infinite<S: Scalar, const N: usize>(
    mass: &SMatrix<S, N, N>,
) -> (SMatrix<S, N, N>, SVector<S, N>) {
    let (zero, one) = (S::zero(), S::one());
    if mass.iter().all(|x| x.is_finite()) {
        return (*mass, SVector::repeat(one));
    }
    // For a number that is not finite, its product with zero is NaN, which `max` ignores.
    let is_regular = SVector::<S, N>::from_fn(|i, _| {
        let entry = mass[(i, i)];
        zero.max(one + entry * zero)
    });
    let regular = SMatrix::<S, N, N>::from_fn(|i, j| {
        let entry = Matrix1::new(mass[(i, j)]);
        let held = Matrix1::new(if i == j { one } else { zero });
        entry.select(held, is_regular[i] * is_regular[j])[0]
    });
    (regular, is_regular)
}

/// Returns whether all pivots are positive.
fn is_positive_definite<S: Scalar, const N: usize>(mut matrix: SMatrix<S, N, N>) -> bool {
    for j in 0..N {
        let pivot = matrix[(j, j)];
        let least = pivot.smallest();
        if least.is_nan() || least <= 0.0 {
            return false;
        }
        for i in j + 1..N {
            let factor = matrix[(i, j)] / pivot;
            for k in j + 1..=i {
                let change = factor * matrix[(k, j)];
                matrix[(i, k)] -= change;
            }
        }
    }
    true
}
