//! What is printed: the equations, the constants of the motion, and the nutation beside its closed form.

use std::fmt::Write;

use lagrangian::State;
use lagrangian::rigid_body::{Nutation, SteadyPrecession};
use lagrangian_examples::wrapped;

use crate::model::HeavyTop;
use crate::motion::{Cycle, Motion, Sample};
use crate::options::{Integration, Method};

/// Below this amplitude in rad a nutation is rounding error: the precession is steady.
const STEADY: f64 = 1e-9;

/// The equations of motion and what an evaluation of them costs.
pub(crate) fn equations() -> String {
    let equations = wrapped(HeavyTop::EQUATIONS);
    let mut text = format!(
        "Heavy top: a rigid body about a fixed pivot, in z-x-z Euler angles φ, θ, ψ.\n\n\
         Equations of motion, derived from T and V when this program was compiled:\n\n{equations}"
    );
    let heading = "Operations of one evaluation     + −     ×     ÷     √  sin, cos  other";
    let _ = writeln!(text, "\n{heading}");
    let operations = HeavyTop::OPERATIONS;
    for (name, count) in [
        ("energy", operations.energy),
        ("momenta", operations.momenta),
        ("mass matrix", operations.mass_matrix),
        ("accelerations", operations.accelerations),
        ("derivatives of accelerations", operations.linearize),
    ] {
        let _ = write!(text, "  {name:28}{:>6}", count.additions);
        let _ = write!(text, "{:>6}{:>6}", count.multiplications, count.divisions);
        let (roots, sines) = (count.square_roots, count.sines_and_cosines);
        let _ = writeln!(text, "{roots:>6}{sines:>10}{:>7}", count.functions);
    }
    text
}

/// What the integration has cost.
pub(crate) fn cost(motion: &Motion, asked: &Integration) -> String {
    let tolerance = format!("with tolerance {:.1e}", asked.tolerance());
    let (method, accuracy) = match asked.method {
        Method::Taylor => ("Taylor series of order 28", tolerance),
        Method::Dop853 => ("Dormand and Prince's method of order 8", tolerance),
        Method::RungeKutta => {
            let steps = format!("in steps of at most {} s", asked.step);
            ("the classical Runge–Kutta method of order 4", steps)
        }
    };
    let (steps, rejected) = (motion.statistics.steps, motion.statistics.rejected);
    let time = motion.duration;
    format!(
        "Integrated by {method} {accuracy}: {steps} steps, {rejected} rejected, in {time:.1?}.\n"
    )
}

/// How well the constants of the motion were kept.
pub(crate) fn constants(top: &HeavyTop, motion: &Motion) -> String {
    let heading =
        "Constants of the motion                 at the start   largest relative change\n";
    let mut text = heading.to_string();
    let names = [
        ("energy E", "J"),
        ("C_φ, about the vertical", "kg m²/s"),
        ("C_ψ, about the axis", "kg m²/s"),
    ];
    for (i, (name, unit)) in names.iter().enumerate() {
        let value = format!("{:.6} {unit}", motion.samples[0].constants[i]);
        let errors = motion.samples.iter().map(|sample| sample.errors[i].abs());
        let error = errors.fold(0.0, f64::max);
        let _ = writeln!(text, "  {name:28}{value:>22}{error:>26.1e}");
    }
    if !top.is_symmetric() {
        text.push_str("  C_ψ is a constant only of a symmetric top, i1 = i2, which this is not.\n");
    }
    text
}

/// The comparison of a motion with what is known in closed form.
pub(crate) fn comparison(top: &HeavyTop, motion: &Motion, closed: Option<&Nutation>) -> String {
    if !top.is_symmetric() {
        let reason = "With i1 ≠ i2 the motion has no closed form in general";
        return format!("{reason}: nothing is compared.\n");
    }
    let steady = steady_precession(top, &motion.samples[0].state);
    let Some(closed) = closed else {
        let reason = "The tilt has no period, for the axis reaches the vertical or rests";
        return format!("{reason}: nothing is compared.\n\n{steady}");
    };
    format!("{}\n{steady}", nutation(motion, closed))
}

/// How far the integrated nutation is from the closed form, in all and at the samples.
fn nutation(motion: &Motion, closed: &Nutation) -> String {
    let cycle = Cycle::from(closed);
    let [least, greatest] = cycle.tilts;
    let text = if greatest - least < STEADY {
        "The precession is steady: the tilt does not change.\n".into()
    } else if let Some((periods, integrated)) = motion.nutation() {
        table(periods, &integrated, &cycle)
    } else {
        let period = cycle.period;
        format!("The motion holds no whole nutation, whose period is {period:.6} s.\n")
    };
    let error = |sample: &Sample| (sample.tilt() - closed.inclination_at(sample.state.t)).abs();
    let largest = motion.samples.iter().map(error).fold(0.0, f64::max);
    let largest = largest.to_degrees();
    text + &format!("  At all samples the tilt is within {largest:.1e}° of the closed form.\n")
}

/// The whole nutation, integrated and in closed form.
fn table(periods: usize, integrated: &Cycle, closed: &Cycle) -> String {
    let heading = format!("Nutation, over {periods} periods");
    let columns = "          integrated         closed form    difference";
    let mut text = format!("{heading:30}{columns}\n");
    let values = |cycle: &Cycle| {
        let [least, greatest] = cycle.tilts;
        let [a, b, c] = [least, greatest, cycle.precession].map(f64::to_degrees);
        [a, b, c, cycle.period]
    };
    let names = [
        ("least tilt", "°"),
        ("greatest tilt", "°"),
        ("precession in a period", "°"),
        ("period", " s"),
    ];
    let values = values(integrated).into_iter().zip(values(closed));
    for ((name, unit), (integrated, closed)) in names.iter().zip(values) {
        let difference = format!("{:.1e}", integrated - closed);
        let [integrated, closed] = [integrated, closed].map(|value| format!("{value:.12}{unit}"));
        let _ = writeln!(
            text,
            "  {name:28}{integrated:>20}{closed:>20}{difference:>14}"
        );
    }
    text
}

/// The steady precessions (4.11) at the initial tilt and ω₃.
fn steady_precession(top: &HeavyTop, start: &State<f64, 3>) -> String {
    let tilt = start.q[HeavyTop::THETA];
    let axial_rate = start.v[HeavyTop::PSI] + start.v[HeavyTop::PHI] * tilt.cos();
    let found = match top.steady_precession(tilt, axial_rate) {
        SteadyPrecession::Two { slow, fast } => {
            format!("slow {slow:.6} rad/s, fast {fast:.6} rad/s")
        }
        SteadyPrecession::One { rate } => format!("{rate:.6} rad/s, and no fast one"),
        SteadyPrecession::None {
            least_axial_velocity: least,
            ..
        } => format!("exists only from |ω₃| = {least:.4} rad/s"),
        SteadyPrecession::Any => "at any rate".into(),
    };
    let tilt = tilt.to_degrees();
    format!("Steady precession at θ = {tilt:.4}° and ω₃ = {axial_rate:.4} rad/s: {found}\n")
}
