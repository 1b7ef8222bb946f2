//! Members of an ensemble in SIMD lanes, each with parameters and inputs of its own.

use nalgebra::SVector;

use super::equations_of_motion::EquationsOfMotion;
use super::lagrangian::Lagrangian;
use super::quantities::Quantities;
use crate::scalar::Lanes;

/// A model of plain numbers of which members with different parameters share SIMD lanes: the methods of an integration's loop read
/// parameters nowhere but in the [prepared](Quantities::Prepared) array, whatever model they are called on.
///
/// `#[derive(Lagrangian)]` implements it, unless the value of an external function mentions `self`: the function is evaluated on
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
/// let motions = [1.0, 2.0].map(|k| (Spring { m: 1.0, k }, State::new(0.0, [1.0], [0.0]), 1.0));
/// Taylor::new().ensemble::<2>().run_members(motions, |_, _| {});
/// ```
#[diagnostic::on_unimplemented(
    message = "members of `{Self}` with different parameters do not share SIMD lanes",
    note = "an external function of its declaration reads `self`, which is that of one member, or it is not a struct of plain \
            numbers that is a model on every scalar; a struct that is generic over its scalar has parameters that are `Lanes`: \
            `Ensemble::run_with_parameters`"
)]
pub trait MembersInLanes {}

impl<M, const N: usize, const U: usize, const L: usize> EquationsOfMotion<M, Lanes<L>, N>
where
    M: MembersInLanes
        + Quantities<N, f64, Inputs = SVector<f64, U>>
        + Quantities<N, Lanes<L>, Inputs = SVector<Lanes<L>, U>>
        + Lagrangian<N, Lanes<L>, Model = M>,
{
    /// The equations of motion of a member in all lanes. What depends on parameters alone is computed on `f64`, so that a lane has
    /// the bits that the member has alone.
    pub(crate) fn of_member(member: M) -> Self {
        let mut equations = Self::new(member);
        let alone = Alone::of(&equations.model);
        for lane in 0..L {
            equations.set(lane, &alone);
        }
        equations
    }

    /// Gives one lane the parameters and the inputs of a member. [`change`](Self::change) gives all lanes those of the model again.
    ///
    /// The lanes of a model of plain numbers have the parameters of that model to begin with. Each then computes what its member
    /// computes alone, bit by bit. Nothing is done where there is no such lane.
    ///
    /// ```
    /// use lagrangian::prelude::*;
    /// use lagrangian::Lanes;
    ///
    /// #[derive(Lagrangian, Clone)]
    /// #[lagrangian(
    ///     coordinates(theta),
    ///     kinetic = 0.5 * (l * dot(theta)).powi(2),
    ///     potential = -g * l * cos(theta),
    /// )]
    /// struct Pendulum { l: f64, g: f64 }
    ///
    /// let [short, long] = [0.5, 2.0].map(|l| Pendulum { l, g: 9.81 });
    /// let mut both = Lagrangian::<1, Lanes<2>>::into_dynamics(short);
    /// both.set_lane(1, &long);
    /// let q = SVector::from([Lanes([0.3; 2])]);
    /// let rates = both.derivative(Lanes([0.0; 2]), &Phase::new(q, q));
    /// assert_eq!(rates.v[0].lane(1), long.accelerations(&State::new(0.0, [0.3], [0.3]))[0]);
    /// assert!(rates.v[0].lane(0) < 3.9 * rates.v[0].lane(1));
    /// ```
    pub fn set_lane(&mut self, lane: usize, member: &M) {
        self.set(lane, &Alone::of(member));
    }

    fn set(&mut self, lane: usize, member: &Alone<M, N>) {
        let of_member = member.prepared.as_ref().iter();
        for (value, of_member) in self.prepared.as_mut().iter_mut().zip(of_member) {
            value.set(lane, *of_member);
        }
        for (input, of_member) in self.inputs.iter_mut().zip(&member.inputs) {
            input.set(lane, *of_member);
        }
    }
}

/// What the equations of a member read, alone.
struct Alone<M: Quantities<N, f64>, const N: usize> {
    inputs: M::Inputs,
    prepared: M::Prepared,
}

impl<M: Quantities<N, f64>, const N: usize> Alone<M, N> {
    fn of(member: &M) -> Self {
        Self {
            inputs: member.inputs(),
            prepared: member.prepare(),
        }
    }
}
