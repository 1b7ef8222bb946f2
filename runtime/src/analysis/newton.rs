//! Damped Newton's method for equilibria.
//!
//! Algorithm NLEQ-ERR of P. Deuflhard, *Newton Methods for Nonlinear Problems. Affine Invariance and Adaptive
//! Algorithms*, Springer 2004, 3.3.3. A step is accepted if the simplified Newton correction after it, with an
//! unchanged Jacobian, is shorter than the step's own correction (natural monotonicity test). The next damping factor
//! is predicted from both corrections. The method does not depend on the units of the equations. Each correction is the
//! shortest of all least-squares solutions (4.4 there), so that ignorable directions and equations that are always
//! satisfied do no harm. In addition, no step is longer than the sizes of the variables.

use nalgebra::SVector;

use super::balance::{Balance, Point};
use super::equilibrium::{Equilibrium, SearchReport};
use super::equilibrium_error::EquilibriumError;
use super::equilibrium_problem::EquilibriumProblem;
use super::force_balance::{UnbalancedForce, nearly_singular, unbalanced_force};
use super::jacobian_rows::{JacobianRows, Residuals, Variables};
use crate::integrate::SingleNumber;
use crate::limits::analysis::{MAX_NEWTON_STEP, MIN_DAMPING, UNBALANCED};
use crate::linalg::{first_largest, largest_or_nan};
use crate::scalar::Scalar;

/// A running search.
pub(super) struct Newton<'a, B, S: Scalar, const N: usize, const U: usize> {
    problem: &'a EquilibriumProblem<B, S, N, U>,
    /// The sizes of the unknowns; 0 for given variables.
    sizes: Variables<S, N, U>,
    point: Point<S, N, U>,
    residuals: Residuals<S, N>,
    report: SearchReport,
}

type Failure<S, const N: usize, const U: usize> = EquilibriumError<S, N, U>;

/// An accepted step, from which the next damping factor is predicted.
struct Accepted<S: Scalar, const N: usize, const U: usize> {
    correction: f64,
    simplified: Variables<S, N, U>,
    damping: f64,
}

/// The outcome of a step.
enum Trial<S: Scalar, const N: usize, const U: usize> {
    Accepted(Accepted<S, N, U>),
    Converged,
}

impl<'a, B, S, const N: usize, const U: usize> Newton<'a, B, S, N, U>
where
    B: Balance<S, N, U>,
    S: SingleNumber,
{
    pub(super) fn new(problem: &'a EquilibriumProblem<B, S, N, U>, start: &Point<S, N, U>) -> Self {
        Self {
            problem,
            sizes: problem.sizes(start),
            point: *start,
            residuals: [SVector::zeros(); 2],
            report: SearchReport::default(),
        }
    }

    /// Continues the search after steps of another method.
    pub(super) fn after(self, report: SearchReport) -> Self {
        Self { report, ..self }
    }

    pub(super) fn run(mut self) -> Result<Equilibrium<S, N, U>, Failure<S, N, U>> {
        self.residuals = self.evaluate(&self.point.clone());
        let mut before: Option<Accepted<S, N, U>> = None;
        loop {
            let rows = self.factored()?;
            let correction = newton_correction(&rows, &self.residuals);
            let length = correction.norm();
            if !length.is_finite() {
                return Err(EquilibriumError::NotFinite { last: self.found() });
            }
            if length <= self.problem.tolerance {
                self.move_by(&correction, 1.0);
                return self.finish(&rows);
            }
            if self.report.iterations >= self.problem.max_iterations {
                return Err(EquilibriumError::NoConvergence { last: self.found() });
            }
            let damping = predicted(before.as_ref(), &correction, length);
            match self.step(&rows, &correction, damping)? {
                Trial::Converged => return self.finish(&rows),
                Trial::Accepted(accepted) => before = Some(accepted),
            }
        }
    }

    fn evaluate(&mut self, point: &Point<S, N, U>) -> Residuals<S, N> {
        self.report.evaluations += 1;
        let found = self.problem.residuals(point);
        self.report.residual = largest(&found);
        found
    }

    /// Returns the factored Jacobian by the unknowns, in their sizes.
    fn factored(&mut self) -> Result<JacobianRows<S, N, U>, Failure<S, N, U>> {
        if !largest(&self.residuals).is_finite() {
            return Err(EquilibriumError::NotFinite { last: self.found() });
        }
        let rows = self.problem.scaled_jacobian(&self.point, &self.sizes);
        if !rows.largest().is_finite() {
            return Err(EquilibriumError::NotFinite { last: self.found() });
        }
        self.report.rank = rows.rank();
        self.report.condition = rows.condition();
        Ok(rows)
    }

    /// Moves by a damped step; only the damping factor is varied between the attempts.
    fn step(
        &mut self,
        rows: &JacobianRows<S, N, U>,
        correction: &Variables<S, N, U>,
        predicted: f64,
    ) -> Result<Trial<S, N, U>, Failure<S, N, U>> {
        let length = correction.norm();
        let longest = (MAX_NEWTON_STEP / length).min(1.0);
        let mut damping = predicted.min(longest);
        let mut is_reduced = false;
        loop {
            if damping < MIN_DAMPING * longest {
                self.report.residual = largest(&self.residuals);
                return Err(EquilibriumError::Stalled { last: self.found() });
            }
            let step = (correction, damping);
            let trial = self.problem.moved(&self.point, step, &self.sizes);
            let residuals = self.evaluate(&trial);
            let simplified = newton_correction(rows, &residuals);
            let after = simplified.norm();
            let rest = S::from_f64(1.0 - damping);
            let nonlinear = simplified
                .zip_map(correction, |x, full| x - rest * full)
                .norm();
            let estimated = 0.5 * length * damping * damping / nonlinear;
            let is_finite = after.is_finite() && largest(&residuals).is_finite();
            if !is_finite || after >= length {
                is_reduced = true;
                self.report.step_reductions += 1;
                // NaN and infinity give no estimate of the right length.
                let less = if is_finite { estimated } else { 0.0 };
                damping = less.min(0.5 * damping).max(0.1 * damping);
                continue;
            }
            if !is_reduced && estimated.min(longest) >= 4.0 * damping {
                is_reduced = true;
                damping = estimated.min(longest);
                continue;
            }
            self.point = trial;
            self.residuals = residuals;
            self.report.iterations += 1;
            if damping >= 1.0 && after <= self.problem.tolerance {
                self.move_by(&simplified, 1.0);
                return Ok(Trial::Converged);
            }
            return Ok(Trial::Accepted(Accepted {
                correction: length,
                simplified,
                damping,
            }));
        }
    }

    fn move_by(&mut self, correction: &Variables<S, N, U>, factor: f64) {
        self.point = self
            .problem
            .moved(&self.point, (correction, factor), &self.sizes);
    }

    fn found(&self) -> Equilibrium<S, N, U> {
        Equilibrium {
            state: self.point.state,
            inputs: self.point.inputs,
            report: self.report,
        }
    }

    /// Returns the equilibrium or the steady motion that was found, or an error if what moves acts on what should not change.
    fn steady(self) -> Result<Equilibrium<S, N, U>, Failure<S, N, U>> {
        let last = self.found();
        let Point { independent, .. } = &self.point;
        let reason = self
            .problem
            .model
            .unsteady(&last.state, &last.inputs, independent);
        reason.map_or(Ok(last), |reason| {
            Err(EquilibriumError::NotSteady { last, reason })
        })
    }

    /// Returns the equilibrium if the residuals are zero, or an error if they are merely beyond the reach of the
    /// unknowns.
    fn finish(
        mut self,
        rows: &JacobianRows<S, N, U>,
    ) -> Result<Equilibrium<S, N, U>, Failure<S, N, U>> {
        self.residuals = self.evaluate(&self.point.clone());
        let left = largest(&self.residuals);
        if left.is_nan() {
            return Err(EquilibriumError::NotFinite { last: self.found() });
        }
        if let Some((constraint, residual)) = self.problem.model.violated(&self.point.state) {
            return Err(EquilibriumError::Inconsistent {
                last: self.found(),
                constraint,
                residual,
            });
        }
        let accurate = libm::pow(S::machine_epsilon(), UNBALANCED).max(self.problem.tolerance);
        let force = unbalanced_force(&self.problem.model, &self.point, &self.sizes, accurate);
        let is_still = left <= accurate * rows.largest();
        if is_still && force.is_none() {
            return self.steady();
        }
        if let (Some(force), Some((coordinate, pivot))) =
            (&force, nearly_singular(&self.problem.model, &self.point))
        {
            return Err(EquilibriumError::SingularMass {
                last: self.found(),
                name: B::COORDINATES[coordinate],
                pivot,
                unbalanced: B::COORDINATES[force.coordinate],
                force: force.force,
            });
        }
        if let (true, Some(UnbalancedForce { coordinate, force })) = (is_still, force) {
            return Err(EquilibriumError::Unbalanced {
                last: self.found(),
                name: B::COORDINATES[coordinate],
                residual: force,
            });
        }
        let entries = self.residuals.iter().flatten();
        let (worst, residual) = first_largest(entries.map(|x| x.abs().largest()));
        Err(EquilibriumError::Unbalanced {
            last: self.found(),
            name: B::COORDINATES[worst % N],
            residual,
        })
    }
}

/// Returns the correction for given residuals.
fn newton_correction<S: SingleNumber, const N: usize, const U: usize>(
    rows: &JacobianRows<S, N, U>,
    residuals: &Residuals<S, N>,
) -> Variables<S, N, U> {
    rows.solve(&residuals.map(|block| -block))
}

/// Returns the damping factor of the next step: the difference between the last simplified correction and the new
/// correction measures the nonlinearity.
fn predicted<S: SingleNumber, const N: usize, const U: usize>(
    before: Option<&Accepted<S, N, U>>,
    correction: &Variables<S, N, U>,
    length: f64,
) -> f64 {
    let Some(Accepted {
        correction: last,
        simplified,
        damping,
    }) = before
    else {
        return 1.0;
    };
    let difference = simplified.zip_map(correction, |x, y| x - y).norm();
    let predicted = damping * last * simplified.norm() / (difference * length);
    // 0/0 if both agree.
    if predicted.is_nan() {
        1.0
    } else {
        predicted.min(1.0)
    }
}

/// Returns the largest magnitude; NaN if an entry is NaN.
fn largest<S: SingleNumber, const N: usize>(residuals: &Residuals<S, N>) -> f64 {
    largest_or_nan(residuals.iter().flatten())
}
