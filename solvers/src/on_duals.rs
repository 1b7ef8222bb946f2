//! States on dual numbers.

use lagrangian::nalgebra::SVector;
use lagrangian::{CanonicalPhase, Dual, Phase, VectorSpace};

/// A state that also exists on [dual numbers](Dual), as those of mechanical systems and vectors do.
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not known on dual numbers",
    note = "implement `OnDuals` for a state of your own"
)]
pub trait OnDuals: VectorSpace<f64> {
    /// The type of the state on dual numbers.
    type OnDuals: VectorSpace<Dual>;

    /// This state, its components constants.
    fn on_duals(&self) -> Self::OnDuals;
}

fn constants<const D: usize>(vector: &SVector<f64, D>) -> SVector<Dual, D> {
    vector.map(Dual::constant)
}

impl<const D: usize> OnDuals for SVector<f64, D> {
    type OnDuals = SVector<Dual, D>;

    fn on_duals(&self) -> SVector<Dual, D> {
        constants(self)
    }
}

impl OnDuals for () {
    type OnDuals = ();

    fn on_duals(&self) {}
}

/// With what is integrated beside coordinates and velocities, such as the states of a controller.
impl<const N: usize, Z: OnDuals> OnDuals for Phase<f64, N, Z> {
    type OnDuals = Phase<Dual, N, Z::OnDuals>;

    fn on_duals(&self) -> Self::OnDuals {
        Phase {
            q: constants(&self.q),
            v: constants(&self.v),
            z: self.z.on_duals(),
        }
    }
}

impl<const N: usize> OnDuals for CanonicalPhase<f64, N> {
    type OnDuals = CanonicalPhase<Dual, N>;

    fn on_duals(&self) -> CanonicalPhase<Dual, N> {
        CanonicalPhase {
            q: constants(&self.q),
            p: constants(&self.p),
        }
    }
}
