//! Singular configurations of constraints, if steps pass them.

use super::TaylorStepper;
use crate::integrate::dense_output::Interpolant;
use crate::integrate::taylor::Series;
use crate::integrate::taylor::singular_configuration::SingularConfiguration;
use crate::limits::taylor::passing::SINGULAR_SINE;
use crate::linalg::VectorSpace;
use crate::scalar::Scalar;

impl<X, const HALF: usize> TaylorStepper<X, HALF> {
    /// Returns the singular configuration within reach of a step of this signed length.
    pub(super) fn singular_configuration<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &self,
        dynamics: &D,
        step: f64,
    ) -> SingularConfiguration
    where
        X: VectorSpace<S>,
    {
        if !self.method.passes_singularities {
            return SingularConfiguration::NONE;
        }
        let polynomial = self.polynomial();
        let [found] =
            SingularConfiguration::find((&[step], self.method.min_part::<S>()), |[after]| {
                let t = polynomial.time + after;
                let x: X = Interpolant::<S, X>::at(polynomial, t);
                let sine = dynamics.constraint_sine(S::from_f64(t), &x);
                [sine.map_or(f64::NAN, Scalar::smallest)]
            });
        found
    }

    /// Whether the method passes singular configurations, and a step of this length ends, in this state, at one that was not found
    /// ahead of it.
    pub(super) fn overlooks<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &self,
        dynamics: &D,
        (t, x): (S, &X),
        (passed, step): (SingularConfiguration, f64),
    ) -> bool
    where
        X: VectorSpace<S>,
    {
        let sine = || dynamics.constraint_sine(t, x);
        self.method.passes_singularities
            && sine().is_some_and(|sine| passed.is_overlooked(step, sine.smallest()))
    }

    /// Whether singular configurations are passed and this state is so near to one that accelerations are not known to the
    /// tolerance.
    pub(super) fn is_passing<S: Scalar, D: Series<S, State = X> + ?Sized>(
        &self,
        dynamics: &D,
        t: S,
        x: &X,
    ) -> bool
    where
        X: VectorSpace<S>,
    {
        let sine = || dynamics.constraint_sine(t, x);
        self.method.passes_singularities
            && sine().is_some_and(|sine| sine.smallest() < SINGULAR_SINE)
    }
}
