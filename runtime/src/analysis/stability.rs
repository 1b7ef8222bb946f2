//! Stability of equilibria and steady motions.
//!
//! By the second variation: the theorems of Lagrange, Dirichlet and Routh. By the linearized motion: Lyapunov's first
//! method. D. R. Merkin, *Introduction to the Theory of Stability*, 1997, chapters 2, 3 and 6.

use nalgebra::{Complex, SMatrix};

use super::components::components;
use super::eigenvalue_errors::Located;
use super::exceeds;
use super::members::Members;
use super::oscillation_error::OscillationError;
use super::reduced_equations::Part;
use super::small_oscillations::{SmallOscillations, negligible};
use super::spectrum::modulus;
use super::symmetric_eigenvalues::symmetric_eigenvalues;
use crate::integrate::SingleNumber;
use crate::limits::analysis::{SINGULAR, VARIATION_ERRORS};
use crate::linalg::largest;
use crate::scalar::Scalar;

/// The second variation of the potential energy or of the effective potential: the signs of the eigenvalues of K φ = κ
/// M φ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SecondVariation {
    /// Positive definite: the potential has a minimum.
    PositiveDefinite,
    /// No eigenvalue is negative, and some are zero up to rounding errors and the uncertainty of the equilibrium:
    /// higher orders decide.
    PositiveSemidefinite,
    /// Some eigenvalues are negative: there is no minimum, and a maximum if all are negative.
    NotPositive {
        /// The number of negative eigenvalues: the degree of instability (Poincaré).
        negative: usize,
    },
    /// There is no potential: forces are not conservative, or an ignorable coordinate has no constant momentum.
    NoPotential,
}

/// The stability of the linearized motion, by its eigenvalues.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum LinearStability {
    /// All perturbations decay.
    Decaying {
        /// The rate of the slowest decay.
        rate: f64,
    },
    /// No perturbation grows exponentially, but some do not decay: their real parts are zero up to rounding.
    Neutral,
    /// Some perturbations grow.
    Growing {
        /// The rate of the fastest growth.
        rate: f64,
    },
}

/// The conclusion for perturbations of the nonlinear motion that leave the constant momenta unchanged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Perturbations decay.
    AsymptoticallyStable,
    /// Perturbations stay small: the effective potential has a minimum, and no force supplies energy (Lagrange,
    /// Dirichlet, Routh).
    Stable,
    /// Perturbations neither grow nor decay to first order, though the potential has no minimum: gyroscopic
    /// stabilization, which dissipation destroys.
    LinearlyStable,
    /// The first order does not decide.
    ///
    /// Up to rounding errors and the uncertainty of the equilibrium, an eigenvalue is zero, or two equal eigenvalues of
    /// coupled coordinates are on the imaginary axis, or damping leaves some eigenvalues there. The verdict is also
    /// undecided if the equations depend on time: the theorems of Lagrange and Dirichlet, and Lyapunov's theorem on
    /// eigenvalues, hold for autonomous equations only.
    Undecided,
    /// Some perturbations grow.
    Unstable,
}

/// The stability of an equilibrium or a steady motion, by the second variation and by the linearized motion, which may
/// differ.
///
/// Lagrange's triangular points are maxima of the effective potential in the rotating frame, and stable below Routh's
/// mass ratio:
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
    /// The second variation.
    pub second_variation: SecondVariation,
    /// The stability of the linearized motion.
    pub linear: LinearStability,
    /// Whether no force supplies energy to perturbations.
    ///
    /// This requires that the symmetric part of −M ∂q̈/∂q̇ is positive semidefinite, and that the generalized forces
    /// supply no energy to some small trial perturbations, so that forces of higher order count, too.
    pub is_passive: bool,
    /// Whether the equations of motion depend on time, directly or through inputs that are functions of time.
    ///
    /// If so, `second_variation` and `linear` refer to the equations at the time of the state, and nothing follows for
    /// later times.
    pub contains_time: bool,
    /// Whether eigenvalues are zero, or multiple on the imaginary axis, or whether damping may move them off it.
    is_degenerate: bool,
}

impl Stability {
    /// Returns the conclusion for the nonlinear motion.
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
            LinearStability::Neutral
                if self.is_degenerate
                    || self.second_variation == SecondVariation::PositiveSemidefinite =>
            {
                Verdict::Undecided
            }
            LinearStability::Neutral => Verdict::LinearlyStable,
        }
    }

    /// Returns whether perturbations stay small, at least to first order.
    #[must_use]
    pub fn is_stable(&self) -> bool {
        !matches!(self.verdict(), Verdict::Unstable | Verdict::Undecided)
    }
}

impl<S: SingleNumber, const N: usize> SmallOscillations<S, N> {
    /// Determines the stability by the second variation and by the linearized motion.
    ///
    /// Groups of uncoupled coordinates are treated separately, and each eigenvalue is known up to an error given by its
    /// condition number.
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
        let [of_position, _] = &self.errors;
        let error = self.mass.map(S::abs) * of_position;
        let units = self.units(&stiffness, SINGULAR * S::machine_epsilon());
        let scaled = in_units(&stiffness, &units);
        let asymmetry = largest(&(scaled - scaled.transpose()));
        if self.parts.contains(&Part::Moving) || exceeds(asymmetry, negligible::<S>()) {
            return SecondVariation::NoPotential;
        }
        match self.signs(&scaled, negligible::<S>(), &in_units(&error, &units)) {
            [0, 0] => SecondVariation::PositiveDefinite,
            [0, _] => SecondVariation::PositiveSemidefinite,
            [negative, _] => SecondVariation::NotPositive { negative },
        }
    }

    /// Returns whether no force supplies energy (the symmetric part of −M ∂q̈/∂q̇ is positive semidefinite), and
    /// whether this part is zero, each entry up to its own rounding. Both are `false` if the uncertainty of the
    /// equilibrium does not allow a decision.
    fn passivity(&self) -> (bool, bool) {
        if self.gives_energy {
            return (false, false);
        }
        let forces = self.velocity_forces();
        let half = S::from_f64(0.5);
        let rounding = SINGULAR * S::machine_epsilon();
        let terms = self.velocity_terms + self.velocity_terms.transpose();
        let [_, of_velocity] = &self.errors;
        let error = self.mass.map(S::abs) * of_velocity;
        let mut is_certain = true;
        let symmetric = SMatrix::<S, N, N>::from_fn(|i, j| {
            let entry = (forces[(i, j)] + forces[(j, i)]) * half;
            let size = entry.abs().largest();
            let of_rounding = rounding * terms[(i, j)].largest();
            let of_place = VARIATION_ERRORS * (error[(i, j)] + error[(j, i)]).largest();
            is_certain &= of_place <= size.max(of_rounding);
            if size <= of_rounding {
                S::zero()
            } else {
                entry
            }
        });
        let is_free = largest(&symmetric) <= 0.0;
        let scaled = in_units(&symmetric, &self.units(&symmetric, 0.0));
        let is_passive = is_free || self.signs(&scaled, rounding, &SMatrix::zeros())[0] == 0;
        (is_certain && is_passive, is_certain && is_free)
    }

    /// Returns a unit for each coordinate, in which the largest entry of its row of a matrix is at most 1.
    ///
    /// By Sylvester's law of inertia, the eigenvalues keep their signs. A row counts as zero if it is less than `zero`
    /// relative to the other rows, in units of the square roots of the inertias. It is compared only with rows of
    /// coordinates that share inertia with it, whose rounding errors its entries have.
    fn units(&self, matrix: &SMatrix<S, N, N>, zero: f64) -> [f64; N] {
        let inertia: [f64; N] = core::array::from_fn(|i| {
            let inertia = self.mass[(i, i)].abs().largest();
            if inertia > 0.0 { inertia } else { 1.0 }
        });
        let rows: [f64; N] =
            core::array::from_fn(|i| largest(matrix.row(i).iter().chain(&matrix.column(i))));
        let labels = components(&[&self.mass]);
        core::array::from_fn(|i| {
            let sharing = (0..N).filter(|j| labels[*j] == labels[i]);
            let most = sharing.fold(0.0, |most: f64, j| most.max(rows[j] / inertia[j]));
            let least = most * inertia[i];
            let size = if rows[i] > zero * least {
                rows[i]
            } else {
                least
            };
            if size > 0.0 { libm::sqrt(size) } else { 1.0 }
        })
    }

    /// Returns the numbers of negative and of zero eigenvalues of a symmetric matrix on the remaining coordinates.
    ///
    /// An eigenvalue counts as zero up to `zero`, relative to its group, or up to the uncertainty that results from
    /// `error`. Groups of uncoupled coordinates are treated separately.
    fn signs(&self, matrix: &SMatrix<S, N, N>, zero: f64, error: &SMatrix<S, N, N>) -> [usize; 2] {
        let (variables, _) = self.variables();
        let labels = components(&[matrix]);
        let mut found = [0; 2];
        for label in 0..N {
            let of_label = variables.iter().filter(|i| labels[**i] == label);
            let members = Members::of(of_label.copied());
            let order = members.len();
            let (values, vectors) = symmetric_eigenvalues(&members.block(matrix), order);
            let error = members.block(error);
            for k in 0..order {
                let vector = vectors.column(k).map(S::abs);
                let undetermined = VARIATION_ERRORS * vector.dot(&(error * vector)).largest();
                let value = values[k].largest();
                if value.abs() <= zero.max(undetermined) {
                    found[1] += 1;
                } else if value < 0.0 {
                    found[0] += 1;
                }
            }
        }
        found
    }
}

/// Returns a symmetric matrix in units of its rows and columns.
fn in_units<S: Scalar, const N: usize>(
    matrix: &SMatrix<S, N, N>,
    units: &[f64; N],
) -> SMatrix<S, N, N> {
    SMatrix::from_fn(|i, j| matrix[(i, j)] / S::from_f64(units[i]) / S::from_f64(units[j]))
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

/// Returns whether an eigenvalue on the imaginary axis may be zero or multiple.
fn is_degenerate(all: &[Located]) -> bool {
    all.iter().enumerate().any(|(i, x)| {
        let is_zero = modulus(x.value) <= x.error;
        let others = all.iter().enumerate().filter(|(j, _)| *j != i);
        let mut equal = others.filter(|(_, y)| x.may_equal(y));
        x.value.re.abs() <= x.error && (is_zero || equal.next().is_some())
    })
}
