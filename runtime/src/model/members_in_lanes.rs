//! Models whose members with different parameters share SIMD lanes.

/// Adds the message for members that do not share lanes, to the trait and to the marker trait for models on every
/// scalar.
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
/// A model whose members with different parameters share `L` SIMD lanes.
///
/// In the loop of an integration, its methods read parameters only from the
/// [prepared](crate::quantities::Quantities::Prepared) array, whatever model they are called on.
///
/// `#[derive(Lagrangian)]` implements this trait for structs of plain numbers, and for structs with a type parameter
/// that stands for `f64`. The exception are external functions whose value mentions `self`: such a function is
/// evaluated on all lanes at once, for one member. A handwritten model may implement the trait if it keeps this
/// promise.
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
    /// The model on which lanes are evaluated: the struct itself or, if it has a type parameter for its scalar, the
    /// struct with lanes.
    type InLanes;

    /// The value that is made once for all members: `()` if each member may itself serve as the model of the lanes,
    /// otherwise that model.
    type Made;

    /// Makes this value.
    fn make(&self) -> Self::Made;

    /// Returns the model on which lanes are evaluated. An integration does not read its parameters.
    fn in_lanes<'a>(&'a self, made: &'a Self::Made) -> &'a Self::InLanes;
}
}

with_message! {
/// A marker for models on every scalar, for which [`MembersInLanes`] is implemented.
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
