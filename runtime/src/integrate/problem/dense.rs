//! The whole motion as what is kept. Needs the feature `alloc`.

use super::keep::{Begun, Keep, Saved};
use crate::integrate::at::At;
use crate::integrate::dense_output::DenseOutput;
use crate::integrate::dense_solution::{DenseSolution, Whole};
use crate::integrate::dynamics::Dynamics;
use crate::integrate::outcome::Outcome;
use crate::integrate::part::Part;
use crate::scalar::Scalar;

/// The whole motion, which can be evaluated at any time: `solution.at(t)`.
///
/// Between the ends of steps a state is on the manifold of the [dynamics](crate::Dynamics::project) within the
/// tolerance; samples are projected onto it.
#[derive(Clone, Copy, Debug)]
pub struct Dense;

impl Saved for Dense {}

impl<S, D, T> Keep<S, D, T> for Dense
where
    S: Scalar,
    D: Dynamics<S>,
    T: DenseOutput<S, D>,
{
    type Kept = DenseSolution<D::State, T::Interpolant, S>;
    type Times = ();
    type Collection = Whole<D::State, T::Interpolant>;

    const READS_STEPS: bool = true;

    fn begin(self, start: &At<f64, D::State>, _: Part) -> Begun<(), Self::Collection> {
        Begun::valid((), Whole::from(start.clone()))
    }

    fn finish(collection: Self::Collection, outcome: &Outcome<D::State>) -> Self::Kept {
        collection.until(outcome.last.clone())
    }
}
