//! What is printed: the equations, the constants of the motion, and the nutation beside its closed form.

use std::fmt::Write;

use lagrangian::State;
use lagrangian::rigid_body::SteadyPrecession;

use crate::model::HeavyTop;
use crate::motion::Motion;
use crate::nutation::{Cycle, Nutation};
use crate::options::{Integration, Method};

/// The length of a line of text.
const LINE: usize = 96;

/// Below this amplitude in rad a nutation is rounding error: the precession is steady.
const STEADY: f64 = 1e-9;

/// The equations of motion and what an evaluation of them costs.
pub(crate) fn equations() -> String {
    let mut text = String::from(
        "Heavy top: a rigid body about a fixed pivot, in z-x-z Euler angles φ, θ, ψ.\n\n\
         Equations of motion, derived from T and V when this program was compiled:\n\n",
    );
    for line in HeavyTop::EQUATIONS.lines() {
        text.push_str(&wrapped(line));
    }
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
    let method = match asked.method {
        Method::Taylor => "Taylor series of order 28",
        Method::Dop853 => "Dormand and Prince's method of order 8",
        Method::RungeKutta => "the classical Runge–Kutta method of order 4",
    };
    let accuracy = match asked.method {
        Method::RungeKutta => format!("in steps of at most {} s", asked.step),
        _ => format!("with tolerance {:.1e}", asked.tolerance()),
    };
    let (steps, rejected) = (motion.statistics.steps, motion.statistics.rejected);
    let time = motion.duration;
    format!(
        "Integrated by {method} {accuracy}: {steps} steps, {rejected} rejected, in {time:.1?}.\n"
    )
}

/// How well the constants of the motion were kept.
pub(crate) fn constants(top: &HeavyTop, motion: &Motion) -> String {
    let Some(first) = motion.samples.first() else {
        return String::new();
    };
    let heading = "Constants of the motion                 at the start   largest relative change";
    let mut text = format!("{heading}\n");
    let names = [
        ("energy E", "J"),
        ("C_φ, about the vertical", "kg m²/s"),
        ("C_ψ, about the axis", "kg m²/s"),
    ];
    let values = first.constants.iter().zip(motion.largest_errors());
    for ((name, unit), (value, error)) in names.iter().zip(values) {
        let value = format!("{value:.6} {unit}");
        let _ = writeln!(text, "  {name:28}{value:>22}{error:>26.1e}");
    }
    if !top.is_symmetric() {
        text.push_str("  C_ψ is a constant only of a symmetric top, i1 = i2, which this is not.\n");
    }
    text
}

/// The comparison of a motion with what is known in closed form.
pub(crate) fn comparison(top: &HeavyTop, motion: &Motion, closed: Option<&Nutation>) -> String {
    let Some(first) = motion.samples.first() else {
        return "There are no samples to compare.\n".into();
    };
    if !top.is_symmetric() {
        let reason = "With i1 ≠ i2 the motion has no closed form in general";
        return format!("{reason}: nothing is compared.\n");
    }
    let steady = steady_precession(top, &first.state);
    let Some(closed) = closed else {
        let reason = "The tilt has no period, for the axis reaches the vertical or rests";
        return format!("{reason}: nothing is compared.\n\n{steady}");
    };
    format!("{}\n{steady}", nutation(motion, closed))
}

/// How far the integrated nutation is from the closed form, in all and at the samples.
fn nutation(motion: &Motion, closed: &Nutation) -> String {
    let cycle = closed.cycle();
    let text = if cycle.greatest_tilt - cycle.least_tilt < STEADY {
        "The precession is steady: the tilt does not change.\n".into()
    } else if let Some((periods, integrated)) = motion.nutation() {
        table(periods, &integrated, &cycle)
    } else {
        let period = cycle.period;
        format!("The motion holds no whole nutation, whose period is {period:.6} s.\n")
    };
    let samples = motion.samples.iter();
    let distances = samples.map(|sample| (sample.tilt() - closed.tilt_at(sample.state.t)).abs());
    let farthest = distances.fold(0.0, f64::max).to_degrees();
    text + &format!("  At all samples the tilt is within {farthest:.1e}° of the closed form.\n")
}

/// The whole nutation, integrated and in closed form.
fn table(periods: usize, integrated: &Cycle, closed: &Cycle) -> String {
    let heading = format!("Nutation, over {periods} periods");
    let columns = "          integrated         closed form    difference";
    let mut text = format!("{heading:30}{columns}\n");
    let rows = |cycle: &Cycle| {
        [
            ("least tilt", cycle.least_tilt.to_degrees(), "°"),
            ("greatest tilt", cycle.greatest_tilt.to_degrees(), "°"),
            ("precession in a period", cycle.precession.to_degrees(), "°"),
            ("period", cycle.period, " s"),
        ]
    };
    let pairs = rows(integrated).into_iter().zip(rows(closed));
    for ((name, integrated, unit), (_, closed, _)) in pairs {
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

/// An equation, indented, and broken before a sign where a line would be too long.
fn wrapped(equation: &str) -> String {
    // The dots over a letter take no place of their own.
    let is_wide = |c: &char| !matches!(c, '\u{307}' | '\u{308}');
    let (mut text, mut length) = (String::from(" "), 1);
    for term in terms(equation).split('\n') {
        let width = term.chars().filter(is_wide).count();
        if length + 1 + width > LINE {
            text.push_str("\n        ");
            length = 8;
        }
        length += 1 + width;
        text.push(' ');
        text.push_str(term);
    }
    text + "\n"
}

/// The terms of an equation with their signs, each on a line. Signs within brackets part nothing.
fn terms(equation: &str) -> String {
    let (mut terms, mut depth) = (String::new(), 0_usize);
    for word in equation.split(' ') {
        let is_sign = depth == 0 && matches!(word, "+" | "−");
        terms.push(if is_sign { '\n' } else { ' ' });
        terms.push_str(word);
        depth += word.matches(['(', '[']).count();
        depth = depth.saturating_sub(word.matches([')', ']']).count());
    }
    terms.split_off(1)
}

#[cfg(test)]
mod tests {
    use super::{terms, wrapped};

    #[test]
    fn terms_part_at_signs_outside_of_brackets() {
        assert_eq!(
            terms("f[φ] = a − b (c + d) e + f"),
            "f[φ] = a\n− b (c + d) e\n+ f"
        );
    }

    #[test]
    fn long_equations_are_broken_before_a_sign() {
        assert_eq!(wrapped("a = b + c"), "  a = b + c\n");
        let term = "θ̇".repeat(60);
        assert_eq!(
            wrapped(&format!("f = {term} − {term}")),
            format!("  f = {term}\n         − {term}\n")
        );
    }
}
