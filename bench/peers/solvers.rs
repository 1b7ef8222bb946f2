//! Solvers of other crates, for a contest; its argument is the model. The equations are those by hand, as in
//! `systems.py`, with constants folded by the compiler.

use std::process::ExitCode;

use differential_equations::prelude::*;
use lagrangian_bench::{Integrated, Integration, Question, answer_questions, fewest_seconds};
use nalgebra::SVector;
use rayon::prelude::*;

const G: f64 = 9.81;

/// First-order equations in D components.
trait Equations<const D: usize>: Copy + 'static {
    fn derivatives(x: &[f64; D]) -> [f64; D];
}

#[derive(Clone, Copy)]
struct SymmetricTop;

impl Equations<6> for SymmetricTop {
    #[inline(always)]
    fn derivatives(&[_, theta, _, phi_rate, theta_rate, psi_rate]: &[f64; 6]) -> [f64; 6] {
        const ACROSS: f64 = 1.2;
        const ALONG: f64 = 0.5;
        const WEIGHT: f64 = 1.3 * G * 0.4;
        let (s, c) = theta.sin_cos();
        let turn = phi_rate * c;
        let w3 = turn + psi_rate;
        let phi = (ALONG * w3 - 2.0 * ACROSS * turn) * theta_rate / (ACROSS * s);
        let torque = ACROSS * phi_rate * turn - ALONG * w3 * phi_rate + WEIGHT;
        let psi = phi_rate * theta_rate * s - phi * c;
        [phi_rate, theta_rate, psi_rate, phi, s * torque * (1.0 / ACROSS), psi]
    }
}

#[derive(Clone, Copy)]
struct GeneralTop;

impl Equations<6> for GeneralTop {
    #[inline(always)]
    fn derivatives(&[_, theta, psi, phi_rate, theta_rate, psi_rate]: &[f64; 6]) -> [f64; 6] {
        const I: [f64; 3] = [1.2, 1.5, 0.7];
        const WEIGHT: [f64; 3] = [1.3 * G * 0.05, 1.3 * G * 0.03, 1.3 * G * 0.4];
        let ((s, c), (sp, cp)) = (theta.sin_cos(), psi.sin_cos());
        let (k1, k2, turn) = (s * sp, s * cp, phi_rate * c);
        let (w1, w2) = (phi_rate * k1 + theta_rate * cp, phi_rate * k2 - theta_rate * sp);
        let w3 = turn + psi_rate;
        // Euler's equations.
        let r1 = ((I[1] - I[2]) * w2 * w3 - (WEIGHT[1] * c - WEIGHT[2] * k2)) * (1.0 / I[0]);
        let r2 = ((I[2] - I[0]) * w3 * w1 - (WEIGHT[2] * k1 - WEIGHT[0] * c)) * (1.0 / I[1]);
        let r3 = ((I[0] - I[1]) * w1 * w2 - (WEIGHT[0] * k2 - WEIGHT[1] * k1)) * (1.0 / I[2]);
        let (e1, e2) = (r1 - psi_rate * w2, r2 + psi_rate * w1);
        let phi = (e1 * sp + e2 * cp - theta_rate * turn) / s;
        let third = r3 - phi * c + phi_rate * theta_rate * s;
        [phi_rate, theta_rate, psi_rate, phi, e1 * cp - e2 * sp, third]
    }
}

#[derive(Clone, Copy)]
struct DoublePendulum;

impl Equations<4> for DoublePendulum {
    #[inline(always)]
    fn derivatives(&[upper, lower, upper_rate, lower_rate]: &[f64; 4]) -> [f64; 4] {
        const RATE: f64 = G / 0.7;
        let (s, c) = (upper - lower).sin_cos();
        let f1 = -s * (lower_rate * lower_rate) - 2.0 * RATE * upper.sin();
        let f2 = s * (upper_rate * upper_rate) - RATE * lower.sin();
        let d = 1.0 / (2.0 - c * c);
        [upper_rate, lower_rate, (f1 - c * f2) * d, (2.0 * f2 - c * f1) * d]
    }
}

/// Both crates want the system as a type of their trait.
#[derive(Clone, Copy)]
struct System<E>(E);

impl<E: Equations<D>, const D: usize> ode_solvers::System<f64, SVector<f64, D>> for System<E> {
    #[inline(always)]
    fn system(&self, _: f64, x: &SVector<f64, D>, derivatives: &mut SVector<f64, D>) {
        *derivatives = SVector::from(E::derivatives(&x.data.0[0]));
    }
}

impl<E: Equations<D>, const D: usize> ODE<f64, [f64; D]> for System<E> {
    #[inline(always)]
    fn diff(&self, _: f64, x: &[f64; D], derivatives: &mut [f64; D]) {
        *derivatives = E::derivatives(x);
    }
}

/// Only the last state is kept: no dense output, no list of times.
fn by_ode_solvers<E: Equations<D>, const D: usize>(
    equations: E,
    start: [f64; D],
    end: f64,
    tolerance: f64,
) -> Result<(u64, [f64; D]), String> {
    use ode_solvers::{Dop853, OutputType};
    let mut stepper = Dop853::from_param(
        System(equations), 0.0, end, end, SVector::from(start), tolerance, tolerance,
        0.9, 0.0, 0.333, 6.0, end, 0.0, u32::MAX, u32::MAX, OutputType::Sparse,
    );
    let statistics = stepper.integrate().map_err(|error| error.to_string())?;
    let last = stepper.y_out().last().ok_or("no state")?;
    let steps = u64::from(statistics.accepted_steps + statistics.rejected_steps);
    Ok((steps, (*last).into()))
}

fn by_differential_equations<E: Equations<D>, const D: usize>(
    equations: E,
    start: [f64; D],
    end: f64,
    tolerance: f64,
) -> Result<(u64, [f64; D]), String> {
    let method = ExplicitRungeKutta::dop853().rtol(tolerance).atol(tolerance).max_steps(usize::MAX);
    let system = System(equations);
    let solution = IVP::ode(&system, 0.0, end, start).method(method).solve();
    let solution = solution.map_err(|error| format!("{error:?}"))?;
    let last = solution.y.last().ok_or("no state")?;
    Ok((solution.steps.total() as u64, *last))
}

/// Motions that are distributed over threads by rayon: one thread, this one.
fn ensemble<E: Equations<D> + Send + Sync, const D: usize>(
    equations: E,
    integration: &Integration,
) -> Result<Integrated, String> {
    let Integration { tolerance, starts, end, at_least, .. } = integration;
    let start = |row: &Vec<f64>| <[f64; D]>::try_from(row.as_slice());
    let starts: Result<Vec<_>, _> = starts.iter().map(start).collect();
    let starts = starts.map_err(|_| "another number of components")?;
    let tolerance = tolerance.ok_or("no tolerance")?;
    let (ends, seconds) = fewest_seconds(*at_least, || {
        let motions = starts.par_iter();
        motions.map(|start| by_ode_solvers(equations, *start, *end, tolerance)).collect::<Result<Vec<_>, _>>()
    })?;
    let steps = ends.iter().map(|(steps, _)| steps).sum();
    let states = ends.iter().map(|(_, state)| state.to_vec()).collect();
    Ok(Integrated { seconds, steps, events: 0, states })
}

fn integrated<E: Equations<D> + Send + Sync, const D: usize>(
    equations: E,
    integration: &Integration,
) -> Result<Integrated, String> {
    let Integration { method, tolerance, starts, end, at_least } = integration;
    if starts.len() > 1 && method == "ode_solvers" {
        return ensemble(equations, integration);
    }
    let start = starts.first().ok_or("no start")?;
    let start: [f64; D] = start.as_slice().try_into().map_err(|_| "another number of components")?;
    let tolerance = tolerance.ok_or("no tolerance")?;
    let ((steps, state), seconds) = fewest_seconds(*at_least, || match method.as_str() {
        "ode_solvers" => by_ode_solvers(equations, start, *end, tolerance),
        "differential-equations" => by_differential_equations(equations, start, *end, tolerance),
        other => Err(format!("there is no method `{other}`")),
    })?;
    Ok(Integrated { seconds, steps, events: 0, states: vec![state.to_vec()] })
}

fn main() -> ExitCode {
    let model = std::env::args().nth(1).unwrap_or_default();
    // The CPU time of this thread is measured, which is the only thread of the pool.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).use_current_thread();
    if let Err(error) = pool.build_global() {
        eprintln!("{error}");
        return ExitCode::FAILURE;
    }
    answer_questions(|question| {
        let Question::Integrate(integration) = question else {
            return Err("these solvers know no energies".to_owned());
        };
        let integrated = match model.as_str() {
            "A1" => integrated(SymmetricTop, &integration),
            "A2" => integrated(GeneralTop, &integration),
            "P2" => integrated(DoublePendulum, &integration),
            other => Err(format!("there is no model `{other}`")),
        }?;
        serde_json::to_value(&integrated).map_err(|error| error.to_string())
    })
}
