//! Systems whose motions are integrated in SIMD lanes.

use super::taylor::Series;
use super::typical_sizes::WithSizes;
use crate::linalg::LaneStates;
use crate::scalar::Lanes;

/// A system of which [`Ensemble`](crate::Ensemble) integrates `L` motions at once by [`Taylor`](crate::Taylor).
///
/// Each motion is in its own SIMD lane.
///
/// The equations of motion of a model with the clause `taylor` implement this trait, under held inputs and under every
/// [law](crate::laws::LawSeries) whose series is known. Members may have different parameters, inputs and laws. A model
/// with an external function that reads `self` does not implement it
/// ([`MembersInLanes`](crate::quantities::MembersInLanes)).
///
/// A system that is written by hand defines the parameters of its lanes, and the equations of all lanes:
///
/// ```
/// use lagrangian::prelude::*;
/// use lagrangian::{InLanes, Lanes, Series, SeriesMemory, TaylorCoefficients};
///
/// /// ẋ = −rate · x.
/// #[derive(Clone, Copy)]
/// struct Decay<S> {
///     rate: S,
/// }
///
/// impl<S: Scalar> Dynamics<S> for Decay<S> {
///     type State = SVector<S, 1>;
///
///     fn derivative(&self, _: S, x: &Self::State) -> Self::State {
///         x * -self.rate
///     }
/// }
///
/// impl<S: Scalar> Series<S> for Decay<S> {
///     fn series<const HALF: usize>(
///         &self,
///         (_, x): (S, &Self::State),
///         unit: S,
///         coefficients: &mut TaylorCoefficients<Self::State, HALF>,
///         _: Option<&mut SeriesMemory>,
///     ) {
///         *coefficients.initial_mut() = *x;
///         let (mut last, mut order) = (*x, S::zero());
///         for coefficient in coefficients.higher_mut() {
///             order += S::one();
///             last *= -self.rate * unit / order;
///             *coefficient = last;
///         }
///     }
/// }
///
/// impl<const L: usize> InLanes<L> for Decay<f64> {
///     type States = SVector<Lanes<L>, 1>;
///     type Parameters = Decay<Lanes<L>>;
///     type Together<'a> = &'a Decay<Lanes<L>>;
///
///     fn parameters(&self) -> Self::Parameters {
///         Decay { rate: Lanes([self.rate; L]) }
///     }
///
///     fn set_lane(&self, parameters: &mut Self::Parameters, lane: usize) {
///         parameters.rate.set(lane, self.rate);
///     }
///
///     fn together<'a>(&'a self, parameters: &'a Self::Parameters) -> Self::Together<'a> {
///         parameters
///     }
/// }
///
/// let start = At { t: 0.0, x: SVector::from([1.0]) };
/// let members = [1.0, 2.0, 3.0].map(|rate| Problem::new(Decay { rate }, start));
/// for (found, rate) in Ensemble::new(members).solve(1.0, Taylor::new()).into_iter().zip(1..) {
///     assert!((found?[0] - (-f64::from(rate)).exp()).abs() < 1e-14);
/// }
/// # Ok::<(), IntegrationError>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "motions of `{Self}` are not integrated in SIMD lanes",
    note = "`Taylor` integrates a model in lanes if its declaration has the clause `taylor` and none of its external functions reads \
            `self`",
    note = "a control law needs a series: held inputs, `driven_by`, `sampled_feedback`, and `lagged` behind them; its closure needs to \
            be `Clone`",
    note = "`Dop853` and `RungeKutta` take every system, one motion after the other; other systems implement `InLanes`"
)]
pub trait InLanes<const L: usize>: Series<f64> {
    /// The type of the states of all lanes.
    type States: LaneStates<L, Lane = Self::State>;

    /// The type of everything that the equations of all lanes read: parameters, inputs, laws.
    type Parameters;

    /// The type of the equations of all lanes.
    type Together<'a>: Series<Lanes<L>, State = Self::States>
    where
        Self: 'a;

    /// Returns the parameters of this system, in every lane.
    fn parameters(&self) -> Self::Parameters;

    /// Sets a lane to the parameters of this system; does nothing if there is no such lane.
    fn set_lane(&self, parameters: &mut Self::Parameters, lane: usize);

    /// Returns the equations of all lanes with their parameters. `self` may be any one of the members.
    fn together<'a>(&'a self, parameters: &'a Self::Parameters) -> Self::Together<'a>;
}

impl<D: InLanes<L>, const L: usize> InLanes<L> for &D {
    type States = D::States;
    type Parameters = D::Parameters;
    type Together<'a>
        = D::Together<'a>
    where
        Self: 'a;

    fn parameters(&self) -> D::Parameters {
        (**self).parameters()
    }

    fn set_lane(&self, parameters: &mut D::Parameters, lane: usize) {
        (**self).set_lane(parameters, lane);
    }

    fn together<'a>(&'a self, parameters: &'a D::Parameters) -> D::Together<'a> {
        (**self).together(parameters)
    }
}

/// Each lane has its own sizes.
impl<D: InLanes<L>, const L: usize> InLanes<L> for WithSizes<D, D::State> {
    type States = D::States;
    type Parameters = (D::Parameters, D::States);
    type Together<'a>
        = WithSizes<D::Together<'a>, D::States>
    where
        Self: 'a;

    fn parameters(&self) -> Self::Parameters {
        let sizes = LaneStates::broadcast(&self.sizes);
        (self.dynamics.parameters(), sizes)
    }

    fn set_lane(&self, (parameters, sizes): &mut Self::Parameters, lane: usize) {
        self.dynamics.set_lane(parameters, lane);
        sizes.set_lane(lane, &self.sizes);
    }

    fn together<'a>(&'a self, (parameters, sizes): &'a Self::Parameters) -> Self::Together<'a> {
        WithSizes {
            dynamics: self.dynamics.together(parameters),
            sizes: sizes.clone(),
        }
    }
}
