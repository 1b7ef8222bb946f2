//! The balance of forces, which is tested in addition to the accelerations.
//!
//! Near a singular mass matrix, the derivatives of the accelerations are so large that any acceleration is small in
//! comparison. The equation M q̈ = f stays well scaled there.

use nalgebra::SVector;

use super::balance::{Balance, Point};
use super::jacobian_rows::Variables;
use crate::integrate::SingleNumber;
use crate::limits::analysis::{FORCE_DIFFERENCE, NEARLY_SINGULAR, SINGULAR};
use crate::linalg::Factorization;

/// A force that is not balanced.
pub(super) struct UnbalancedForce {
    /// The index of its coordinate.
    pub(super) coordinate: usize,
    /// Its value.
    pub(super) force: f64,
}

/// Returns the unbalanced component of f in M q̈ = f that is farthest from zero, if there is one.
///
/// Each force is compared with its change where variables change by their sizes. For forces that do not change, the
/// rounding errors of the other forces are used, in units of the square roots of the inertias.
pub(super) fn unbalanced_force<S, B, const N: usize, const U: usize>(
    model: &B,
    point: &Point<S, N, U>,
    sizes: &Variables<S, N, U>,
    accurate: f64,
) -> Option<UnbalancedForce>
where
    S: SingleNumber,
    B: Balance<S, N, U>,
{
    let forces = model.forcing(&point.state, &point.inputs, &point.independent);
    let slopes = force_slopes(model, point, sizes);
    let mass = model.mass_matrix(&point.state);
    let unit: [f64; N] = core::array::from_fn(|i| {
        let inertia = mass[(i, i)].largest();
        if inertia > 0.0 {
            libm::sqrt(inertia)
        } else {
            1.0
        }
    });
    let steepest = (0..N).fold(0.0, |most: f64, i| most.max(slopes[i] / unit[i]));
    let rounding = SINGULAR * S::machine_epsilon() * steepest;
    let excess = |i: usize| {
        let limit = (accurate * slopes[i]).max(rounding * unit[i]);
        let size = forces[i].abs().largest();
        if size <= limit { 0.0 } else { size / limit }
    };
    let worst = (0..N).fold((0, 0.0), |worst, i| {
        let excess = excess(i);
        // NaN counts as unbalanced.
        if excess <= worst.1 {
            worst
        } else {
            (i, excess)
        }
    });
    (worst.1 != 0.0).then(|| UnbalancedForce {
        coordinate: worst.0,
        force: forces[worst.0].largest(),
    })
}

/// Returns how much each force changes where one variable changes by its size, to first order. Central differences are
/// used, since the derivatives of the accelerations have no correct digits near a singular mass matrix.
fn force_slopes<S, B, const N: usize, const U: usize>(
    model: &B,
    point: &Point<S, N, U>,
    sizes: &Variables<S, N, U>,
) -> [f64; N]
where
    S: SingleNumber,
    B: Balance<S, N, U>,
{
    let mut slopes = [0.0_f64; N];
    let mut add = |direction: &Variables<S, N, U>| {
        let forces = |factor: f64| -> SVector<S, N> {
            let moved = point.moved(direction, factor, sizes);
            model.forcing(&moved.state, &moved.inputs, &moved.independent)
        };
        let change = forces(FORCE_DIFFERENCE) - forces(-FORCE_DIFFERENCE);
        for (slope, change) in slopes.iter_mut().zip(change.iter()) {
            // NaN, beyond the domain of the model, is ignored.
            *slope = slope.max(change.abs().largest() / (2.0 * FORCE_DIFFERENCE));
        }
    };
    for i in 0..N {
        let mut direction = Variables::zeros();
        direction.positions[i] = S::one();
        add(&direction);
        let mut direction = Variables::zeros();
        direction.velocities[i] = S::one();
        add(&direction);
    }
    for i in 0..U {
        let mut direction = Variables::zeros();
        direction.inputs[i] = S::one();
        add(&direction);
    }
    slopes
}

/// Returns the coordinate with the least relative pivot, and this pivot, if the mass matrix is nearly singular.
pub(super) fn nearly_singular<S, B, const N: usize, const U: usize>(
    model: &B,
    point: &Point<S, N, U>,
) -> Option<(usize, f64)>
where
    S: SingleNumber,
    B: Balance<S, N, U>,
{
    // The method of solving for the accelerations may have no pivot that shows the singularity.
    let factored = Factorization::new(model.mass_matrix(&point.state)).relative_pivots();
    let pivots = model.relative_pivots(&point.state);
    let pairs = pivots.iter().zip(factored.iter());
    let sizes = pairs.map(|(pivot, other)| {
        let [pivot, other] = [*pivot, *other].map(|pivot| pivot.abs().largest());
        if other >= pivot { pivot } else { other }
    });
    let sizes = sizes.enumerate();
    let least = sizes.fold((0, f64::INFINITY), |least, (i, size)| {
        // NaN counts as singular.
        if size >= least.1 { least } else { (i, size) }
    });
    (least.1.is_nan() || least.1 < NEARLY_SINGULAR).then_some(least)
}
