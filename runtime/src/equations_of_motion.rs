//! The door through which a Lagrangian system enters an integrator.

use core::marker::PhantomData;

use nalgebra::SVector;

use crate::{Component, Dynamics, Lagrangian, Phase, Scalar, Singularity, State, System};

/// Lagrange's equations as first-order equations (q, q̇)˙ = (q̇, q̈); made by
/// [`Lagrangian::dynamics`].
///
/// What depends on the parameters alone is computed when it is made.
#[derive(Debug)]
pub struct EquationsOfMotion<'a, M, S, const N: usize>
where
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    model: &'a M,
    prepared: M::Prepared,
}

impl<'a, M, S, const N: usize> EquationsOfMotion<'a, M, S, N>
where
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    pub(crate) fn new(model: &'a M) -> Self {
        Self {
            model,
            prepared: model.prepare(),
        }
    }
}

impl<M, S, const N: usize> Clone for EquationsOfMotion<'_, M, S, N>
where
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    fn clone(&self) -> Self {
        Self {
            model: self.model,
            prepared: self.prepared.clone(),
        }
    }
}

impl<M, S, const N: usize> Dynamics<S> for EquationsOfMotion<'_, M, S, N>
where
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    type State = Phase<S, N>;

    #[inline]
    fn derivative(&self, t: S, x: &Phase<S, N>) -> Phase<S, N> {
        Phase {
            q: x.v,
            v: self.model.accelerations_prepared(&x.at(t), &self.prepared),
        }
    }

    #[inline]
    fn magnitude(&self, x: &Phase<S, N>) -> Phase<S, N> {
        magnitude::<M, S, N>(x)
    }

    #[inline]
    fn singularity(&self, t: S, x: &Phase<S, N>, least_pivot: f64) -> Option<Singularity> {
        singularity(self.model, &x.at(t), least_pivot)
    }

    fn component(&self, index: usize) -> Component {
        component::<M, N>(index)
    }
}

/// |qᵢ| and |q̇ᵢ|, but 1 for a coordinate that is an angle, which is the same after a whole turn; and for
/// one that is ignorable what it moves in a unit of time, if that is more than 1, wherever it is.
#[inline]
pub(crate) fn magnitude<M, S, const N: usize>(x: &Phase<S, N>) -> Phase<S, N>
where
    M: System<N> + ?Sized,
    S: Scalar,
{
    let mut sizes = Phase {
        q: x.q.map(Scalar::abs),
        v: x.v.map(Scalar::abs),
    };
    for (i, size) in sizes.q.iter_mut().enumerate() {
        if M::ANGLES[i] {
            *size = S::one();
        } else if M::IGNORABLE[i] {
            *size = sizes.v[i].max(S::one());
        }
    }
    sizes
}

/// The coordinate with the smallest relative pivot, if that is below `least_pivot`.
#[inline]
pub(crate) fn singularity<M, S, const N: usize>(
    model: &M,
    state: &State<S, N>,
    least_pivot: f64,
) -> Option<Singularity>
where
    M: Lagrangian<N, S> + ?Sized,
    S: Scalar,
{
    let pivots = model.relative_pivots(state);
    let regular = pivots
        .iter()
        .all(|pivot| pivot.abs().smallest() >= least_pivot);
    if regular {
        None
    } else {
        Some(report::<M, S, N>(&pivots, state))
    }
}

/// Names the coordinates that make the smallest of the relative pivots small.
#[cold]
fn report<M, S, const N: usize>(pivots: &SVector<S, N>, state: &State<S, N>) -> Singularity
where
    M: System<N> + ?Sized,
    S: Scalar,
{
    // A pivot that is no number comes from a division by zero: nothing is smaller.
    let sizes = pivots.iter().map(|pivot| {
        let size = pivot.abs().smallest();
        if size.is_nan() { 0.0 } else { size }
    });
    let (coordinate, least) = sizes
        .enumerate()
        .fold((0, f64::INFINITY), |least, (i, size)| {
            if size < least.1 { (i, size) } else { least }
        });
    let dependencies = Structure::<M, N>::SINGULARITIES
        .get(coordinate)
        .copied()
        .unwrap_or_default();
    Singularity::new(
        least,
        coordinate,
        Structure::<M, N>::COORDINATES,
        dependencies,
        |i| state.q.get(i).map_or(f64::NAN, |value| value.smallest()),
    )
}

pub(crate) fn component<M: System<N> + ?Sized, const N: usize>(index: usize) -> Component {
    let names = Structure::<M, N>::COORDINATES;
    let coordinate = names.get(index);
    let velocity = index.checked_sub(N).and_then(|i| names.get(i));
    match (coordinate, velocity) {
        (Some(name), _) => Component::Coordinate(name),
        (None, Some(name)) => Component::Velocity(name),
        (None, None) => Component::Index(index),
    }
}

/// The constants of a system as slices that live as long as the program.
struct Structure<M: ?Sized, const N: usize>(PhantomData<M>);

impl<M: System<N> + ?Sized, const N: usize> Structure<M, N> {
    const COORDINATES: &'static [&'static str] = &M::COORDINATES;
    const SINGULARITIES: &'static [&'static [usize]] = &M::SINGULARITIES;
}
