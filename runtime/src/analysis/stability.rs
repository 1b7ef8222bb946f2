//! Stability of equilibria and steady motions.
//!
//! By the second variation: theorems of Lagrange and Dirichlet and of Routh; by the linearized motion: Lyapunov's first
//! method. D. R. Merkin, *Introduction to the Theory of Stability*, 1997, chapters 2, 3 and 6.

use nalgebra::{Complex, SMatrix};

use super::eigenvalue_errors::Located;
use super::exceeds;
use super::oscillation_error::OscillationError;
use super::small_oscillations::{Part, SmallOscillations, largest, negligible};
use super::spectrum::modulus;
use super::symmetric_eigenvalues::symmetric_eigenvalues;
use crate::integrate::SingleNumber;
use crate::limits::analysis::SINGULAR;

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
    /// The first order does not decide: an eigenvalue is zero, two equal ones of coordinates that are coupled are on the imaginary axis,
    /// or there is damping that leaves some there, all to rounding. Or the equations contain the time: theorems of Lagrange and
    /// Dirichlet and of Lyapunov on eigenvalues hold for equations that do not.
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
    /// Whether the equations of motion contain the time, or inputs that are functions of it: `second_variation` and `linear` are then
    /// those of the equations as they are at the time of the state, from which nothing follows for later ones.
    pub contains_time: bool,
    /// Whether eigenvalues are zero, or multiple on the imaginary axis, or whether damping may move them off it.
    is_degenerate: bool,
}

impl Stability {
    /// What follows.
    #[must_use]
    pub fn verdict(&self) -> Verdict {
        let is_minimum = self.second_variation == SecondVariation::PositiveDefinite;
        if self.contains_time {
            return Verdict::Undecided;
        }
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
    /// Coordinates that are not coupled are looked at apart, and each eigenvalue is known up to what its condition number says.
    ///
    /// # Errors
    ///
    /// If the eigenvalues are not found.
    pub fn stability(&self) -> Result<Stability, OscillationError> {
        let nothing = Located {
            value: Complex::new(0.0, 0.0),
            error: 0.0,
            component: 0,
        };
        let mut located = [[nothing; N]; 2];
        let mut count = 0;
        let labels = self.components();
        let all = located.as_flattened_mut();
        self.eigenvalues_by_components(&mut |component, values| {
            let radius = values.iter().fold(0.0, |most, x| modulus(*x).max(most));
            for value in values {
                let error = self.eigenvalue_error(*value, radius, &|i| labels[i] == component);
                all[count] = Located {
                    value: *value,
                    error,
                    component,
                };
                count += 1;
            }
        })?;
        let all = &all[..count];
        let (is_passive, is_free) = self.passivity();
        Ok(Stability {
            second_variation: self.second_variation(),
            linear: linear_stability(all),
            is_passive,
            contains_time: self.contains_time,
            is_degenerate: !is_free || is_degenerate(all),
        })
    }

    fn second_variation(&self) -> SecondVariation {
        let stiffness = self.stiffness();
        let scaled = self.scaled(&stiffness, SINGULAR * S::machine_epsilon());
        let asymmetry = largest(&(scaled - scaled.transpose()));
        if self.parts.contains(&Part::Moving) || exceeds(asymmetry, negligible::<S>()) {
            return SecondVariation::NoPotential;
        }
        match self.signs(&scaled, negligible::<S>()) {
            [0, 0] => SecondVariation::PositiveDefinite,
            [0, _] => SecondVariation::PositiveSemidefinite,
            [negative, _] => SecondVariation::NotPositive { negative },
        }
    }

    /// Whether the symmetric part of −M ∂q̈/∂q̇ is positive semidefinite, and whether it is zero: each entry to its own
    /// rounding.
    fn passivity(&self) -> (bool, bool) {
        let forces = self.velocity_forces();
        let half = S::from_f64(0.5);
        let rounding = SINGULAR * S::machine_epsilon();
        let terms = self.velocity_terms + self.velocity_terms.transpose();
        let symmetric = SMatrix::<S, N, N>::from_fn(|i, j| {
            let entry = (forces[(i, j)] + forces[(j, i)]) * half;
            let is_rounding = entry.abs().largest() <= rounding * terms[(i, j)].largest();
            if is_rounding { S::zero() } else { entry }
        });
        let is_free = largest(&symmetric) <= 0.0;
        let scaled = self.scaled(&symmetric, 0.0);
        (is_free || self.signs(&scaled, rounding)[0] == 0, is_free)
    }

    /// A matrix on the coordinates that are left, with a unit for each in which the largest entry of its row is at most 1: by Sylvester's
    /// law of inertia the signs of the eigenvalues are the same. A row counts as zero if it is less than `zero`
    /// of the others, in units of the roots of inertia.
    fn scaled(&self, matrix: &SMatrix<S, N, N>, zero: f64) -> SMatrix<S, N, N> {
        let inertia: [f64; N] = core::array::from_fn(|i| {
            let inertia = self.mass[(i, i)].abs().largest();
            if inertia > 0.0 { inertia } else { 1.0 }
        });
        let rows: [f64; N] = core::array::from_fn(|i| {
            let entries = (0..N).map(|j| {
                let pair = [matrix[(i, j)], matrix[(j, i)]];
                pair.map(|x| x.abs().largest())
                    .into_iter()
                    .fold(0.0, f64::max)
            });
            entries.fold(0.0, f64::max)
        });
        let most = (0..N).fold(0.0, |most: f64, i| most.max(rows[i] / inertia[i]));
        let unit = |i: usize| {
            let least = most * inertia[i];
            let size = if rows[i] > zero * least {
                rows[i]
            } else {
                least
            };
            S::from_f64(if size > 0.0 { libm::sqrt(size) } else { 1.0 })
        };
        SMatrix::from_fn(|i, j| matrix[(i, j)] / unit(i) / unit(j))
    }

    /// How many eigenvalues of a symmetric matrix on the coordinates that are left are negative, and how many are zero.
    fn signs(&self, matrix: &SMatrix<S, N, N>, zero: f64) -> [usize; 2] {
        let (variables, [_, count]) = self.variables();
        let part = SMatrix::<S, N, N>::from_fn(|i, j| {
            if i < count && j < count {
                matrix[(variables[i], variables[j])]
            } else {
                S::zero()
            }
        });
        let (values, _) = symmetric_eigenvalues(&part, count);
        let values = || values.iter().take(count).map(|value| value.largest());
        [
            values().filter(|value| *value < -zero).count(),
            values().filter(|value| value.abs() <= zero).count(),
        ]
    }
}

fn linear_stability(all: &[Located]) -> LinearStability {
    let growing = all.iter().filter(|x| x.value.re > x.error);
    let fastest = growing.fold(0.0, |most: f64, x| most.max(x.value.re));
    if fastest > 0.0 {
        return LinearStability::Growing { rate: fastest };
    }
    if all.is_empty() || all.iter().any(|x| x.value.re >= -x.error) {
        return LinearStability::Neutral;
    }
    let slowest = all
        .iter()
        .fold(f64::INFINITY, |least, x| least.min(-x.value.re));
    LinearStability::Decaying { rate: slowest }
}

/// Whether an eigenvalue on the imaginary axis may be zero or multiple.
fn is_degenerate(all: &[Located]) -> bool {
    all.iter().enumerate().any(|(i, x)| {
        let is_zero = modulus(x.value) <= x.error;
        let others = all.iter().enumerate().filter(|(j, _)| *j != i);
        let mut equal = others.filter(|(_, y)| x.may_equal(y));
        x.value.re.abs() <= x.error && (is_zero || equal.next().is_some())
    })
}
