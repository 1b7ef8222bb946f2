//! Models of which members with different parameters share SIMD lanes.

/// The message where members do not share lanes: of the trait, and of the one through which models on every scalar have it.
macro_rules! with_message {
    ($item:item) => {
        #[diagnostic::on_unimplemented(
            message = "members of `{Self}` with different parameters do not share SIMD lanes",
            note = "an external function of its declaration reads `self`, which differs from member to member; or its type \
                    parameter has other bounds than `Scalar`, or stands within the type of a field that is no number, vector or \
                    array; `Dop853` integrates such members one after the other"
        )]
        $item
    };
}

with_message! {
/// A model of which members with different parameters share `L` SIMD lanes: the methods of an integration's loop read parameters
/// nowhere but in the [prepared](crate::quantities::Quantities::Prepared) array, whatever model they are called on.
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
pub trait MembersInLanes<const L: usize> {
    /// The model on which lanes are evaluated: the struct itself, or, if it has a type parameter for its scalar, the struct with lanes.
    type InLanes;

    /// What is made once for all members: nothing where each of them may serve as that model, or the model.
    type Made;

    /// Makes it.
    fn make(&self) -> Self::Made;

    /// The model on which lanes are evaluated. An integration reads no parameter of it.
    fn in_lanes<'a>(&'a self, made: &'a Self::Made) -> &'a Self::InLanes;
}
}

with_message! {
/// Models on every scalar, which have [`MembersInLanes`] through it.
pub trait SharesLanes {}
}

impl<M: SharesLanes, const L: usize> MembersInLanes<L> for M {
    type InLanes = M;
    type Made = ();

    fn make(&self) {}

    fn in_lanes<'a>(&'a self, (): &'a ()) -> &'a M {
        self
    }
}
