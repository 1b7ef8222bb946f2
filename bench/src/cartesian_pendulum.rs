//! A pendulum by the position of its bob, with the length of the rod as a constraint, beside a pendulum by its angle:
//! instructions of a motion of 2000 s, 845 swings from side to side and back, as valgrind counts them.
//!
//! Both are integrated by the same method at its own tolerance. Instructions do not depend on what the machine does
//! besides; programs are for processors with vectors of 256 bits, the widest that valgrind knows.

use std::process::Command;

use crate::cargo::build_source;
use crate::command::output;
use crate::flags::Flags;
use crate::folders::Folders;
use crate::instructions::counted;
use crate::verdict::{Verdict, judge};

/// The instructions by the position over those by the angle.
const LIMIT: f64 = 3.0;

const BY_POSITION: &str = "    coordinates(p: Vector2),
    kinetic = 0.5 * m * dot(p).norm_squared(),
    potential = m * g * p.y,
    constraint(rod = 0.5 * (p.norm_squared() - l.powi(2))),
";

const BY_ANGLE: &str = "    coordinates(theta),
    kinetic = 0.5 * m * l.powi(2) * dot(theta).powi(2),
    potential = -m * g * l * cos(theta),
";

/// A program that prints the position of the bob at the end, by a method. From rest at an angle of 2 rad.
fn source(clauses: &str, method: &str) -> String {
    let (start, end) = if clauses == BY_ANGLE {
        ("[2.0], [0.0]", "[end.q[0].sin(), -end.q[0].cos()]")
    } else {
        (
            "[2.0_f64.sin(), -2.0_f64.cos()], [0.0; 2]",
            "[end.q[0], end.q[1]]",
        )
    };
    format!(
        "use lagrangian::prelude::*;\n\n\
         #[derive(Lagrangian)]\n#[lagrangian(\n    taylor,\n{clauses})]\n\
         struct Pendulum {{ m: f64, l: f64, g: f64 }}\n\n\
         fn main() -> Result<(), IntegrationError> {{\n    \
             let model = Pendulum {{ m: 1.0, l: 1.0, g: 9.81 }};\n    \
             let start = State::new(0.0, {start});\n    \
             let end = Problem::new(&model, start).solve(2000.0, {method}::new())?;\n    \
             let [x, y] = {end};\n    \
             println!(\"{{x}} {{y}} {{}}\", end.statistics.steps);\n    \
             Ok(())\n}}\n"
    )
}

/// Prints instructions and ends, and is an error where `Taylor` misses the limit.
pub(crate) fn run() -> Result<(), String> {
    let folders = Folders::new()?;
    let mut verdicts = Vec::new();
    for method in ["Taylor", "Dop853"] {
        let mut instructions = [0.0; 2];
        for (side, (name, clauses)) in [("position", BY_POSITION), ("angle", BY_ANGLE)]
            .into_iter()
            .enumerate()
        {
            let program = format!("pendulum-{name}-{method}");
            let built = build_source(
                &folders,
                &program,
                &source(clauses, method),
                Flags::Vectors256,
            )?;
            let end = output(&mut Command::new(built.program()))?;
            instructions[side] = counted(&folders, built.program(), &[])?;
            println!(
                "{method} by the {name}: {:.1} million instructions; x, y and steps: {}",
                instructions[side] / 1e6,
                end.trim()
            );
        }
        let limit = if method == "Taylor" {
            LIMIT
        } else {
            f64::INFINITY
        };
        verdicts.push(Verdict {
            what: format!("{method}, instructions by the position over those by the angle"),
            figure: instructions[0] / instructions[1],
            target: LIMIT,
            limit,
        });
    }
    judge(&verdicts)
}
