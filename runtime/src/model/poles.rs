//! Poles of the angles of reduced models, where the equations have no value as they are written.

use super::lagrangian::Lagrangian;
use super::singular_configuration::named;
use super::state::State;
use crate::integrate::Singularity;
use crate::limits::NEAR_POLE;
use crate::scalar::Scalar;

/// The pole of a reduced model at which it has no accelerations, where scalars are read so.
#[inline]
pub(super) fn at_pole<M, S, const N: usize>(
    model: &M,
    state: &State<S, N>,
    read: impl Fn(S) -> f64,
) -> Option<Singularity>
where
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    if M::POLES.is_empty() {
        return None;
    }
    let accelerations = model.accelerations(state);
    if accelerations.iter().all(|value| read(*value).is_finite()) {
        return None;
    }
    let poles = M::POLES
        .iter()
        .filter_map(|i| Some((*i, *state.q.get(*i)?)));
    let mut poles = poles.filter(|(_, angle)| read(angle.sin_cos().0.abs()) < NEAR_POLE);
    let (pole, angle) = poles.next()?;
    Some(named::<M, S, N>(pole, 0.0, state).at_pole(read(angle)))
}
