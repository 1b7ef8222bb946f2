//! Models of which members with different parameters share SIMD lanes.

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
/// let start = State::new(0.0, [1.0], [0.0]);
/// let motions = [1.0, 2.0].map(|k| Problem::new(Spring { m: 1.0, k }, start));
/// let found = Ensemble::new(motions).solve(1.0, Taylor::new());
/// ```
#[diagnostic::on_unimplemented(
    message = "members of `{Self}` with different parameters do not share SIMD lanes",
    note = "an external function of its declaration reads `self`, which is that of one member, or it is not a struct of plain \
            numbers that is a model on every scalar; `Dop853` integrates such members one after the other"
)]
pub trait MembersInLanes {}
