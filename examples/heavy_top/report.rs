//! What is printed about the equations and the constants of the motion.

use std::fmt::Write;

use lagrangian::OperationCount;

use crate::model::HeavyTop;
use crate::motion::Motion;
use crate::options::Options;
use crate::record::{Record, largest_errors};
use crate::symmetric_top::SymmetricTop;

/// The length of a line of text.
const LINE: usize = 96;

/// The equations of motion and what an evaluation of them costs.
pub(crate) fn equations() -> String {
    let mut text = String::from(
        "Heavy top: a rigid body about a fixed pivot, in z-x-z Euler angles φ, θ, ψ.\n\n\
         Equations of motion, derived from T and V when this program was compiled:\n\n",
    );
    for line in HeavyTop::EQUATIONS.lines() {
        text.push_str(&wrapped(line));
    }
    let _ = writeln!(
        text,
        "\n{:30}{:>6}{:>6}{:>6}{:>6}{:>10}{:>7}",
        "Operations of one evaluation", "+ −", "×", "÷", "√", "sin, cos", "other"
    );
    let operations = HeavyTop::OPERATIONS;
    for (name, count) in [
        ("energy", operations.energy),
        ("momenta", operations.momenta),
        ("mass matrix", operations.mass_matrix),
        ("accelerations", operations.accelerations),
        ("derivatives of accelerations", operations.linearize),
    ] {
        let OperationCount {
            additions,
            multiplications,
            divisions,
            square_roots,
            ..
        } = count;
        let _ = writeln!(
            text,
            "  {name:28}{additions:>6}{multiplications:>6}{divisions:>6}{square_roots:>6}{:>10}{:>7}",
            count.sines_and_cosines, count.functions
        );
    }
    text
}

/// What the integration has cost.
pub(crate) fn cost(motion: &Motion, options: &Options) -> String {
    format!(
        "Integrated by Dormand and Prince's method of order 8 with tolerance {:e}: {} steps, {} \
         rejected, in {:.1?}.\n",
        options.tolerance, motion.statistics.steps, motion.statistics.rejected, motion.duration
    )
}

/// How well the constants of the motion were kept.
pub(crate) fn constants(top: &HeavyTop, records: &[Record]) -> String {
    let Some(first) = records.first() else {
        return String::new();
    };
    let errors = largest_errors(records);
    let mut text = format!(
        "{:30}{:>22}{:>26}\n",
        "Constants of the motion", "at the start", "largest relative change"
    );
    for (name, value, unit, error) in [
        ("energy E", first.energy, "J", errors[0]),
        ("C_φ, about the vertical", first.c_phi, "kg m²/s", errors[1]),
        ("C_ψ, about the axis", first.c_psi, "kg m²/s", errors[2]),
    ] {
        let value = format!("{value:.6} {unit}");
        let _ = writeln!(text, "  {name:28}{value:>22}{error:>26.1e}");
    }
    if SymmetricTop::of(top).is_none() {
        text.push_str("  C_ψ is a constant only of a symmetric top, i1 = i2, which this is not.\n");
    }
    text
}

/// An equation, indented, and broken before a sign where a line would be too long.
fn wrapped(equation: &str) -> String {
    // The dots over a letter take no place of their own.
    let width = |text: &str| {
        text.chars()
            .filter(|c| !matches!(c, '\u{307}' | '\u{308}'))
            .count()
    };
    let mut text = String::from(" ");
    let mut length = 1;
    for term in terms(equation) {
        if length + 1 + width(&term) > LINE {
            text.push_str("\n        ");
            length = 8;
        }
        length += 1 + width(&term);
        text.push(' ');
        text.push_str(&term);
    }
    text.push('\n');
    text
}

/// The terms of an equation with their signs. Signs within brackets part nothing.
fn terms(equation: &str) -> Vec<String> {
    let mut terms = vec![String::new()];
    let mut depth = 0_i32;
    for word in equation.split(' ') {
        if depth == 0 && matches!(word, "+" | "−") {
            terms.push(word.to_owned());
        } else if let Some(term) = terms.last_mut() {
            term.push_str(if term.is_empty() { "" } else { " " });
            term.push_str(word);
        }
        for character in word.chars() {
            depth += i32::from(matches!(character, '(' | '['));
            depth -= i32::from(matches!(character, ')' | ']'));
        }
    }
    terms
}

#[cfg(test)]
mod tests {
    use super::{terms, wrapped};

    #[test]
    fn terms_part_at_signs_outside_of_brackets() {
        assert_eq!(
            terms("f[φ] = a − b (c + d) e + f"),
            ["f[φ] = a", "− b (c + d) e", "+ f"]
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
