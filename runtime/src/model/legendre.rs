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
use crate::linalg::Factorization;
use crate::linalg::lane_select::{LaneSelect, greater};
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
    searched(model, prepared, &state, &phase.p)
}

/// Searches for the velocities with which the state has these momenta, starting from the velocities of `state`.
fn searched<M, S, const N: usize>(
    model: &M,
    prepared: &M::Prepared,
    state: &State<S, N>,
    momenta: &SVector<S, N>,
) -> Result<SVector<S, N>, NoVelocities>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    if !momenta.iter().all(|p| p.is_finite()) {
        return Err(NoVelocities::NotFound { change: f64::NAN });
    }
    let mut state = *state;
    let mut found = newton(model, prepared, &mut state, momenta);
    for _ in 0..LEGENDRE_SWEEPS {
        match found {
            Err(NoVelocities::NotFound { .. }) => {}
            found => return found,
        }
        if !state.v.iter().all(|v| v.is_finite()) {
            state.v.fill(S::zero());
        }
        let negligible = HELD_MOMENTUM * S::machine_epsilon() * largest(momenta);
        for i in 0..N {
            let missing = momenta - model.momenta(&state, prepared);
            let size = missing[i].abs().largest();
            if size.is_nan() || size > negligible {
                state.v[i] = zero_of_momentum(model, prepared, &state, momenta, i);
            }
        }
        let missing = largest(&(momenta - model.momenta(&state, prepared)));
        if !missing.is_finite() {
            break;
        }
        let next = if missing == 0.0 {
            unique(model, prepared, &state)
        } else {
            descend(model, prepared, &mut state, momenta);
            newton(model, prepared, &mut state, momenta)
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

/// Runs Newton's method from the velocities of a state, and updates them.
fn newton<M, S, const N: usize>(
    model: &M,
    prepared: &M::Prepared,
    state: &mut State<S, N>,
    momenta: &SVector<S, N>,
) -> Result<SVector<S, N>, NoVelocities>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    let mut missing = momenta - model.momenta(state, prepared);
    let mut change = f64::NAN;
    for _ in 0..LEGENDRE_ITERATIONS {
        let (mass, is_regular) = without_infinite(&model.mass_matrix(state, prepared));
        let step = Factorization::new(mass).solve(&missing.component_mul(&is_regular));
        change = largest(&step);
        if !change.is_finite() {
            break;
        }
        let before = state.v;
        let (mut factor, least) = (1.0, largest(&missing));
        let reached = loop {
            state.v = before + step * S::from_f64(factor);
            missing = momenta - model.momenta(state, prepared);
            if largest(&missing) < least || least == 0.0 {
                break true;
            }
            factor *= 0.5;
            if factor < MIN_NEWTON_STEP {
                break false;
            }
        };
        if !reached {
            // Derivative parts lag one step behind.
            state.v = if S::DERIVATIVES > 0 {
                before + step
            } else {
                before
            };
        }
        // Only rounding errors are left.
        let size = largest(&state.v);
        let is_still = change <= LEGENDRE_ROUNDING * S::machine_epsilon() * size;
        let is_small = !reached && change <= S::machine_epsilon().sqrt() * size;
        let held = missing.component_mul(&is_regular.map(|regular| S::one() - regular));
        let negligible = HELD_MOMENTUM * S::machine_epsilon() * largest(momenta);
        if (is_still || is_small) && largest(&held) <= negligible {
            return unique(model, prepared, state);
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
fn descend<M, S, const N: usize>(
    model: &M,
    prepared: &M::Prepared,
    state: &mut State<S, N>,
    momenta: &SVector<S, N>,
) where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    let (zero, one) = (S::zero(), S::one());
    for _ in 0..LEGENDRE_ITERATIONS {
        let missing = momenta - model.momenta(state, prepared);
        let (mass, is_regular) = without_infinite(&model.mass_matrix(state, prepared));
        let step = Factorization::new(mass).solve(&missing.component_mul(&is_regular));
        let before = state.v;
        let change = largest(&step);
        if !(change.is_finite() && change > S::machine_epsilon() * largest(&before)) {
            return;
        }
        let mut decreases = |factor: S| {
            state.v = before + step * factor;
            let missing = momenta - model.momenta(state, prepared);
            greater(missing.dot(&step), zero)
        };
        let mut near = decreases(one);
        let mut far = one;
        for _ in 0..LEGENDRE_BISECTIONS {
            let middle = (near + far) * S::from_f64(0.5);
            let is_near = decreases(middle);
            near += is_near * (middle - near);
            far = middle + is_near * (far - middle);
        }
        state.v = before + step * far;
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

/// Returns the velocity of a coordinate at which its momentum has the given value, while the other velocities are held.
///
/// In each lane separately, the exponent is found by bisection. A velocity for which the momentum is not defined counts
/// as too large.
fn zero_of_momentum<M, S, const N: usize>(
    model: &M,
    prepared: &M::Prepared,
    state: &State<S, N>,
    momenta: &SVector<S, N>,
    coordinate: usize,
) -> S
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    let missing = |velocity: S| {
        let mut state = *state;
        state.v[coordinate] = velocity;
        momenta[coordinate] - model.momenta(&state, prepared)[coordinate]
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

/// Returns the velocities of a state, unless L is neither quadratic in the velocities nor convex there.
fn unique<M, S, const N: usize>(
    model: &M,
    prepared: &M::Prepared,
    state: &State<S, N>,
) -> Result<SVector<S, N>, NoVelocities>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    let mass = model.mass_matrix(state, prepared);
    // These velocities all differ from the given ones, even where some or all of those are zero.
    let v = state.v.map(|v| S::from_f64(0.5) * v + S::from_f64(0.618));
    let is_quadratic = mass == model.mass_matrix(&State::new(state.t, state.q, v), prepared);
    if is_quadratic || is_positive_definite(mass) || is_convex_beside(model, prepared, state) {
        Ok(state.v)
    } else {
        Err(NoVelocities::NotConvex)
    }
}

/// Returns whether M is positive definite at nearby velocities on all sides: L = q̇⁴ is convex at q̇ = 0 though M
/// vanishes there.
fn is_convex_beside<M, S, const N: usize>(
    model: &M,
    prepared: &M::Prepared,
    state: &State<S, N>,
) -> bool
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    let fastest = largest(&state.v);
    let size = if fastest > 0.0 { fastest } else { 1.0 };
    let distance = S::from_f64(size * S::machine_epsilon().sqrt());
    [1, 2].into_iter().all(|period| {
        [distance, -distance].into_iter().all(|distance| {
            let mut beside = *state;
            for (i, v) in beside.v.iter_mut().enumerate() {
                *v += if i % period == 0 { distance } else { -distance };
            }
            is_positive_definite(model.mass_matrix(&beside, prepared))
        })
    })
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

/// Returns the largest magnitude of a component, in any lane.
fn largest<S: Scalar, const N: usize>(vector: &SVector<S, N>) -> f64 {
    let sizes = vector.iter().map(|component| component.abs().largest());
    // NaN is preserved.
    sizes.fold(0.0, |most, size| if size <= most { most } else { size })
}
