//! Stability of equilibria and steady motions.
//!
//! By the second variation: theorems of Lagrange and Dirichlet and of Routh; by the linearized motion: Lyapunov's first
//! method. D. R. Merkin, *Introduction to the Theory of Stability*, 1997, chapters 2, 3 and 6.

use nalgebra::{Complex, SMatrix};

use super::components::components;
use super::eigenvalue_errors::Located;
use super::exceeds;
use super::oscillation_error::OscillationError;
use super::small_oscillations::{Part, SmallOscillations, largest, negligible};
use super::spectrum::modulus;
use super::symmetric_eigenvalues::symmetric_eigenvalues;
use crate::integrate::SingleNumber;
use crate::limits::analysis::{SINGULAR, VARIATION_ERRORS};
use crate::scalar::Scalar;

/// The second variation of the potential energy, or of the effective potential: the signs of the eigenvalues of K φ = κ M φ.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SecondVariation {
    /// Positive definite: the potential has a minimum.
    PositiveDefinite,
    /// No eigenvalue is negative, and some are zero to rounding, or as far as the place of the equilibrium is known: higher orders
    /// decide.
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
    /// The first order does not decide: an eigenvalue is zero, or may be at the equilibrium beside which the state is, two equal ones of coordinates that are coupled are on the imaginary axis,
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
    /// Whether no force gives energy to perturbations: the symmetric part of −M ∂q̈/∂q̇ is positive semidefinite, and the generalized
    /// forces give none to some small perturbations that are tried, so that forces of higher order count, too.
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
            LinearStability::Neutral
                if self.is_degenerate
                    || self.second_variation == SecondVariation::PositiveSemidefinite =>
            {
                Verdict::Undecided
            }
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

    /// Whether no force gives energy: the symmetric part of −M ∂q̈/∂q̇ is positive semidefinite; and whether it is zero: each entry
    /// to its own rounding. Neither, where the error of the equilibrium does not allow to say.
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

    /// A unit for each coordinate, in which the largest entry of its row of a matrix is at most 1: by Sylvester's law of
    /// inertia the signs of the eigenvalues are the same. A row counts as zero if it is less than `zero` of the
    /// others, in units of the roots of inertia: of those with which it shares inertia, so that its entries have their rounding.
    fn units(&self, matrix: &SMatrix<S, N, N>, zero: f64) -> [f64; N] {
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

    /// How many eigenvalues of a symmetric matrix on the coordinates that are left are negative, and how many are zero: up to
    /// `zero` of their own, or up to what `error` makes of them. Coordinates that are not coupled are looked at apart.
    fn signs(&self, matrix: &SMatrix<S, N, N>, zero: f64, error: &SMatrix<S, N, N>) -> [usize; 2] {
        let (variables, [_, count]) = self.variables();
        let labels = components(&[matrix]);
        let mut found = [0; 2];
        for label in 0..N {
            let mut members = [0; N];
            let mut order = 0;
            let all = variables.iter().take(count);
            for (entry, i) in members.iter_mut().zip(all.filter(|i| labels[**i] == label)) {
                *entry = *i;
                order += 1;
            }
            let part = |whole: &SMatrix<S, N, N>| {
                SMatrix::<S, N, N>::from_fn(|i, j| {
                    if i < order && j < order {
                        whole[(members[i], members[j])]
                    } else {
                        S::zero()
                    }
                })
            };
            let (values, vectors) = symmetric_eigenvalues(&part(matrix), order);
            let error = part(error);
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

/// A symmetric matrix in units of its rows and columns.
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

/// Whether an eigenvalue on the imaginary axis may be zero or multiple.
fn is_degenerate(all: &[Located]) -> bool {
    all.iter().enumerate().any(|(i, x)| {
        let is_zero = modulus(x.value) <= x.error;
        let others = all.iter().enumerate().filter(|(j, _)| *j != i);
        let mut equal = others.filter(|(_, y)| x.may_equal(y));
        x.value.re.abs() <= x.error && (is_zero || equal.next().is_some())
    })
}
