//! Stability of equilibria and steady motions.
//!
//! By the second variation: theorems of Lagrange and Dirichlet and of Routh; by the linearized motion: Lyapunov's first
//! method. D. R. Merkin, *Introduction to the Theory of Stability*, 1997, chapters 2, 3 and 6.

use nalgebra::SMatrix;

use super::exceeds;
use super::oscillation_error::OscillationError;
use super::small_oscillations::{Part, SmallOscillations, largest, negligible};
use super::symmetric_eigenvalues::symmetric_eigenvalues;
use crate::integrate::SingleNumber;
use crate::limits::analysis::NEGLIGIBLE;

/// The second variation of the potential energy, or of the effective potential: the signs of the eigenvalues of K φ = κ M φ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SecondVariation {
    /// Positive definite: the potential has a minimum.
    PositiveDefinite,
    /// No eigenvalue is negative, and some are zero to rounding: higher orders decide.
    PositiveSemidefinite,
    /// Some eigenvalues are negative: no minimum, and a maximum if all are.
    NotPositive {
        /// How many are negative: the degree of instability (Poincaré).
        negative: usize,
    },
    /// There is no potential: forces are not conservative, or an ignorable coordinate has no constant momentum.
    NoPotential,
}

/// What the eigenvalues of the linearized motion say.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LinearStability {
    /// All perturbations decay.
    Decaying {
        /// The rate at which the slowest does.
        rate: f64,
    },
    /// None grows exponentially, and some do not decay: real parts are zero to rounding.
    Neutral,
    /// Some grow.
    Growing {
        /// The rate at which the fastest does.
        rate: f64,
    },
}

/// What follows for perturbations of the true motion that change no constant momentum.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// They decay.
    AsymptoticallyStable,
    /// They stay small: the effective potential has a minimum, and no force gives energy (Lagrange and Dirichlet, Routh).
    Stable,
    /// They neither grow nor decay to first order, though the potential has no minimum: gyroscopic stabilization, which dissipation
    /// destroys.
    LinearlyStable,
    /// The first order does not decide: an eigenvalue is zero, or two equal ones are on the imaginary axis.
    Undecided,
    /// Some grow.
    Unstable,
}

/// The stability of an equilibrium or a steady motion, by the second variation and by the linearized motion, which may differ.
///
/// The triangular points of Lagrange are maxima of the effective potential in the rotating frame, and stable below Routh's
/// ratio of the masses:
///
/// ```
/// use lagrangian::analysis::{EquilibriumSearch, SecondVariation, SmallOscillations, Verdict};
/// use lagrangian::prelude::*;
///
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(x, y),
///     kinetic = 0.5 * ((dot(x) - y).powi(2) + (dot(y) + x).powi(2)),
///     potential = -(1 - mu) / ((x + mu).powi(2) + y.powi(2)).sqrt()
///         - mu / ((x - 1 + mu).powi(2) + y.powi(2)).sqrt(),
/// )]
/// struct ThreeBodies { mu: f64 }
///
/// for (mu, verdict) in [(0.012, Verdict::LinearlyStable), (0.05, Verdict::Unstable)] {
///     let model = ThreeBodies { mu };
///     let guess = State::new(0.0, [0.4, 0.8], [0.0, 0.0]);
///     let point = EquilibriumSearch::of(&model).near(&guess)?.state;
///     let stability = SmallOscillations::about(&model, &point)?.stability()?;
///     assert_eq!(stability.second_variation, SecondVariation::NotPositive { negative: 2 });
///     assert_eq!(stability.verdict(), verdict);
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stability {
    /// By the second variation.
    pub second_variation: SecondVariation,
    /// By the linearized motion.
    pub linear: LinearStability,
    /// Whether no force gives energy to perturbations: the symmetric part of −M ∂q̈/∂q̇ is positive semidefinite.
    pub is_passive: bool,
    /// Whether eigenvalues are zero, or multiple on the imaginary axis.
    is_degenerate: bool,
}

impl Stability {
    /// What follows.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let is_minimum = self.second_variation == SecondVariation::PositiveDefinite;
        match self.linear {
            LinearStability::Growing { .. } => Verdict::Unstable,
            LinearStability::Decaying { .. } => Verdict::AsymptoticallyStable,
            LinearStability::Neutral if is_minimum && self.is_passive => Verdict::Stable,
            LinearStability::Neutral if self.is_degenerate => Verdict::Undecided,
            LinearStability::Neutral => Verdict::LinearlyStable,
        }
    }

    /// Whether perturbations stay small, at least to first order.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        !matches!(self.verdict(), Verdict::Unstable | Verdict::Undecided)
    }
}

impl<S: SingleNumber, const N: usize> SmallOscillations<S, N> {
    /// The stability, by the second variation and by the linearized motion.
    ///
    /// # Errors
    ///
    /// If the eigenvalues are not found.
    pub fn stability(&self) -> Result<Stability, OscillationError> {
        let spectrum = self.spectrum()?;
        // Eigenvalues are found in f64, whatever the scalar.
        let negligible = libm::pow(f64::EPSILON.max(S::machine_epsilon()), NEGLIGIBLE);
        let zero = negligible * spectrum.radius();
        let abscissa = spectrum.abscissa();
        let linear = if abscissa > zero {
            LinearStability::Growing { rate: abscissa }
        } else if abscissa < -zero {
            LinearStability::Decaying { rate: -abscissa }
        } else {
            LinearStability::Neutral
        };
        let on_axis = || spectrum.iter().filter(|x| x.re.abs() <= zero);
        let is_zero = on_axis().any(|x| x.im.abs() <= zero);
        let axis = || on_axis().filter(|x| x.im > zero).enumerate();
        // Nearer than what rounding makes of a double eigenvalue.
        let is_multiple = axis().any(|(i, x)| {
            let mut others = axis().filter(|(j, _)| *j != i);
            others.any(|(_, y)| (x.im - y.im).abs() <= zero)
        });
        Ok(Stability {
            second_variation: self.second_variation(),
            linear,
            is_passive: self.is_passive(),
            is_degenerate: is_zero || is_multiple,
        })
    }

    fn second_variation(&self) -> SecondVariation {
        let stiffness = self.stiffness();
        let asymmetry = largest(&(stiffness - stiffness.transpose()));
        let scale = largest(&stiffness);
        let is_moving = self.parts.contains(&Part::Moving);
        if is_moving || exceeds(asymmetry, negligible::<S>() * scale) {
            return SecondVariation::NoPotential;
        }
        let signs = self.signs(&stiffness);
        let [negative, zero] = signs;
        match (negative, zero) {
            (0, 0) => SecondVariation::PositiveDefinite,
            (0, _) => SecondVariation::PositiveSemidefinite,
            _ => SecondVariation::NotPositive { negative },
        }
    }

    fn is_passive(&self) -> bool {
        let forces = self.velocity_forces();
        let half = S::from_f64(0.5);
        let symmetric = (forces + forces.transpose()) * half;
        let gyroscopic = largest(&forces);
        let stiffness = largest(&self.stiffness()) * largest(&self.mass);
        let size = gyroscopic.max(libm::sqrt(stiffness));
        largest(&symmetric) <= negligible::<S>() * size || self.signs(&symmetric)[0] == 0
    }

    /// How many eigenvalues of a symmetric matrix on the coordinates that oscillate are negative, and how many are zero, in coordinates
    /// whose inertia is 1.
    fn signs(&self, matrix: &SMatrix<S, N, N>) -> [usize; 2] {
        let (variables, [count, _]) = self.variables();
        // With the roots of inertia as units, sizes of different kinds can be compared.
        let unit = |i: usize| {
            let inertia = self.mass[(variables[i], variables[i])].abs();
            if inertia.largest() > 0.0 {
                inertia.sqrt()
            } else {
                S::one()
            }
        };
        let part = SMatrix::<S, N, N>::from_fn(|i, j| {
            if i < count && j < count {
                matrix[(variables[i], variables[j])] / (unit(i) * unit(j))
            } else {
                S::zero()
            }
        });
        let (values, _) = symmetric_eigenvalues(&part, count);
        let zero = negligible::<S>() * largest(&part);
        let values = || values.iter().take(count).map(|value| value.largest());
        [
            values().filter(|value| *value < -zero).count(),
            values().filter(|value| value.abs() <= zero).count(),
        ]
    }
}
