//! Descent to a minimum of the accelerations, for searches whose Newton path meets a singular Jacobian.
//!
//! The Levenberg–Marquardt method: K. Levenberg, *A method for the solution of certain non-linear problems in least
//! squares*, Quart. Appl. Math. **2** (1944) 164–168; D. W. Marquardt, *An algorithm for least-squares estimation of
//! nonlinear parameters*, J. SIAM **11** (1963) 431–441. The damping follows H. B. Nielsen, *Damping parameter in
//! Marquardt's method*, 1999. The descent ends near a solution or a local minimum, where
//! [`Newton`](super::newton::Newton) takes over.

use super::balance::{Balance, Point};
use super::equilibrium::SearchReport;
use super::equilibrium_problem::EquilibriumProblem;
use super::jacobian_rows::Residuals;
use crate::integrate::SingleNumber;
use crate::limits::analysis::{DESCENT_DAMPING, DESCENT_END, MAX_NEWTON_STEP};

/// Returns the point to which the descent from `start` leads, and adds the steps and evaluations to the report.
pub(super) fn descended<B, S, const N: usize, const U: usize>(
    problem: &EquilibriumProblem<B, S, N, U>,
    start: &Point<S, N, U>,
    report: &mut SearchReport,
) -> Point<S, N, U>
where
    B: Balance<S, N, U>,
    S: SingleNumber,
{
    let sizes = problem.sizes(start);
    let mut point = *start;
    let mut found = problem.residuals(&point);
    let mut rows = problem.scaled_jacobian(&point, &sizes);
    let mut damping = DESCENT_DAMPING * rows.largest() * rows.largest();
    let mut growth = 2.0;
    for _ in 0..problem.max_iterations {
        let right = found.map(|block| -block);
        let (step, predicted) = rows.damped(&right, S::from_f64(damping));
        // NaN ends the descent, too.
        if step.norm().is_nan() || step.norm() <= DESCENT_END || predicted <= 0.0 {
            break;
        }
        let trial = problem.moved(&point, (&step, 1.0), &sizes);
        let after = problem.residuals(&trial);
        report.evaluations += 1;
        let gain = (squared(&found) - squared(&after)) / predicted;
        if gain > 0.0 && step.norm() <= MAX_NEWTON_STEP {
            point = trial;
            found = after;
            rows = problem.scaled_jacobian(&point, &sizes);
            let bend = 2.0 * gain - 1.0;
            damping *= (1.0 - bend * bend * bend).max(1.0 / 3.0);
            growth = 2.0;
            report.descent_steps += 1;
        } else {
            damping *= growth;
            growth *= 2.0;
        }
    }
    point
}

fn squared<S: SingleNumber, const N: usize>(residuals: &Residuals<S, N>) -> f64 {
    let [accelerations, momenta] = residuals;
    (accelerations.dot(accelerations) + momenta.dot(momenta)).largest()
}
