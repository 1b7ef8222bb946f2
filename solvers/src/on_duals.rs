//! States on dual numbers.

use lagrangian::nalgebra::SVector;
use lagrangian::{AugmentedPhase, CanonicalPhase, Dual, Phase, VectorSpace};

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

impl<const N: usize> OnDuals for Phase<f64, N> {
    type OnDuals = Phase<Dual, N>;

    fn on_duals(&self) -> Phase<Dual, N> {
        Phase {
            q: constants(&self.q),
            v: constants(&self.v),
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

impl<const N: usize, const K: usize> OnDuals for AugmentedPhase<f64, N, K> {
    type OnDuals = AugmentedPhase<Dual, N, K>;

    fn on_duals(&self) -> AugmentedPhase<Dual, N, K> {
        AugmentedPhase {
            q: constants(&self.q),
            v: constants(&self.v),
            controller: constants(&self.controller),
        }
    }
}
