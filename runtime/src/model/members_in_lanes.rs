//! Models of which members with different parameters share SIMD lanes.

use super::generalized_coordinates::GeneralizedCoordinates;
use super::lagrangian::Lagrangian;
use super::quantities::Quantities;
use crate::scalar::Scalar;

/// A model of which members with different parameters share `L` SIMD lanes: the methods of an integration's loop read parameters
/// nowhere but in the [prepared](Quantities::Prepared) array, whatever model they are called on.
///
/// `#[derive(Lagrangian)]` implements it for structs of plain numbers, and for those with a type parameter that stands for `f64`,
/// unless the value of an external function mentions `self`: the function is evaluated on
/// all lanes at once, for one member. A model that is written by hand may implement it if it keeps this promise.
///
/// ```compile_fail,E0277
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     taylor,
///     coordinates(x),
///     function(pull(y) = times(self.k, y), derivative(y) = k),
///     kinetic = 0.5 * m * dot(x).powi(2),
///     force(x = -pull(x)),
/// )]
/// struct Spring { m: f64, k: f64 }
///
/// fn times<S: Scalar>(k: f64, y: S) -> S { S::from_f64(k) * y }
///
/// let start = State::new(0.0, [1.0], [0.0]);
/// let motions = [1.0, 2.0].map(|k| Problem::new(Spring { m: 1.0, k }, start));
/// let found = Ensemble::new(motions).solve(1.0, Taylor::new());
/// ```
#[diagnostic::on_unimplemented(
    message = "members of `{Self}` with different parameters do not share SIMD lanes",
    note = "an external function of its declaration reads `self`, which is that of one member; or it has a type parameter with other \
            bounds than `Scalar`, or that is within the type of a field that is no number, vector or array; `Dop853` integrates such \
            members one after the other"
)]
pub trait MembersInLanes<const L: usize> {
    /// The model on which lanes are evaluated: the same struct, or, of a struct with a type parameter for its scalar, the one with
    /// lanes.
    type InLanes;

    /// The model in lanes, whose parameters nothing reads but its methods outside of an integration.
    fn in_lanes(&self) -> ModelInLanes<'_, Self::InLanes>;
}

/// Models on every scalar, which have the trait by themselves.
#[diagnostic::on_unimplemented(
    message = "members of `{Self}` with different parameters do not share SIMD lanes",
    note = "an external function of its declaration reads `self`, which is that of one member; or it has a type parameter with other \
            bounds than `Scalar`, or that is within the type of a field that is no number, vector or array; `Dop853` integrates such \
            members one after the other"
)]
pub trait SharesLanes {}

impl<M: SharesLanes, const L: usize> MembersInLanes<L> for M {
    type InLanes = M;

    fn in_lanes(&self) -> ModelInLanes<'_, M> {
        ModelInLanes::Member(self)
    }
}

/// A model on which lanes are evaluated: one of the members, or one that is made for them.
#[derive(Clone, Copy, Debug)]
pub enum ModelInLanes<'a, M> {
    /// One of the members.
    Member(&'a M),
    /// A model with parameters that are lanes.
    Made(M),
}

impl<M: GeneralizedCoordinates<N>, const N: usize> GeneralizedCoordinates<N>
    for ModelInLanes<'_, M>
{
    const COORDINATES: [&'static str; N] = M::COORDINATES;
    const ANGLES: [bool; N] = M::ANGLES;
    const PERIODS: [u32; N] = M::PERIODS;
    const IGNORABLE: [bool; N] = M::IGNORABLE;
    const SINGULARITIES: [&'static [usize]; N] = M::SINGULARITIES;
    const STAYS_REGULAR: bool = M::STAYS_REGULAR;
    const POLES: &'static [usize] = M::POLES;
}

impl<M, S, const N: usize> Lagrangian<N, S> for ModelInLanes<'_, M>
where
    M: Lagrangian<N, S, Model = M> + Quantities<N, S>,
    S: Scalar,
{
    type Model = M;

    #[inline]
    fn model(&self) -> &M {
        match self {
            Self::Member(model) => model,
            Self::Made(model) => model,
        }
    }
}
