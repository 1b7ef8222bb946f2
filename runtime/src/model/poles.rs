//! Poles of the angles of reduced models, where the equations, as written, have no value.
//!
//! In quotients by sin²θ whose numerators vanish at the pole, the relative error grows like 1/sin²θ, and no digits are
//! left at the pole. A step of an integration can lead from one side of a pole to the other without coming near it.

use core::f64::consts::{FRAC_1_PI, PI};

use nalgebra::SVector;

use super::named_singularity::named;
use super::quantities::Quantities;
use super::state::State;
use crate::integrate::Singularity;
use crate::scalar::Scalar;

/// Returns the pole of a reduced model near which its accelerations have no correct digits: where sin²θ is below
/// `min_pivot`.
#[inline]
pub(super) fn at_pole<M, S, const N: usize>(
    state: &State<S, N>,
    min_pivot: f64,
) -> Option<Singularity>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    for i in M::POLES {
        let angle = *state.q.get(*i)?;
        let distance = (angle - nearest_pole(angle)).abs();
        let pivot = (distance * distance).smallest();
        if pivot < min_pivot {
            return Some(named::<M, S, N>(*i, pivot, state).at_pole(angle.smallest()));
        }
    }
    None
}

/// Returns the pole that lies between the coordinates before and after a step, in any lane.
#[inline]
pub(super) fn pole_between<M, S, const N: usize>(
    before: &SVector<S, N>,
    after: &State<S, N>,
) -> Option<Singularity>
where
    M: Quantities<N, S> + ?Sized,
    S: Scalar,
{
    for i in M::POLES {
        let (from, to) = (half_turns(*before.get(*i)?), half_turns(*after.q.get(*i)?));
        if (from - to).abs().largest() > 0.0 {
            let pole = from.max(to).largest() * PI;
            return Some(named::<M, S, N>(*i, 0.0, after).at_pole(pole));
        }
    }
    None
}

/// Returns the number of half turns below an angle; the poles are at whole numbers of half turns.
fn half_turns<S: Scalar>(angle: S) -> S {
    (angle * S::from_f64(FRAC_1_PI)).floor()
}

/// Returns the multiple of a half turn that is nearest to an angle.
fn nearest_pole<S: Scalar>(angle: S) -> S {
    half_turns(angle + S::pi() * S::from_f64(0.5)) * S::pi()
}
