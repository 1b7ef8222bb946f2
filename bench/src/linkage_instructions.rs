//! The instructions of the accelerations and multipliers of four-bar linkages in a row, and the exponent with which they grow with
//! the number of linkages.
//!
//! The programs are for processors with vectors of 256 bits, the widest that valgrind knows.

use std::fs;

use crate::cargo::build_source;
use crate::flags::Flags;
use crate::folders::Folders;
use crate::instructions::counted;
use crate::verdict::{Verdict, judge};

/// Linkages that the tests declare.
const DECLARATION: &str = "tests/tests/constraints/four_bars.rs";

/// How many linkages are in a row.
const LINKAGES: [u32; 4] = [5, 10, 20, 40];

/// The largest exponent allowed.
const LIMIT: f64 = 1.15;

/// A program is run with the first and the second number of evaluations: the difference is what they take.
const EVALUATIONS: [u32; 2] = [1, 101];

/// Measures, prints, and is an error where the exponent is too large.
pub(crate) fn run() -> Result<(), String> {
    let folders = Folders::new()?;
    let path = folders.workspace.join(DECLARATION);
    let declaration = fs::read_to_string(path).map_err(|error| error.to_string())?;
    println!("linkages  unknowns  instructions  seconds to build");
    let mut points = Vec::new();
    for linkages in LINKAGES {
        let source = declaration.clone() + &program(linkages);
        let name = format!("linkages-{linkages}");
        let built = build_source(&folders, &name, &source, Flags::Vectors256)?;
        let [few, many] =
            EVALUATIONS.map(|count| counted(&folders, built.program(), &[count.to_string()]));
        let more = f64::from(EVALUATIONS[1] - EVALUATIONS[0]);
        let instructions = (many? - few?) / more;
        let unknowns = 4 * linkages + 3;
        println!(
            "{linkages:>8}  {unknowns:>8}  {instructions:>12.0}  {:>16.1}",
            built.seconds
        );
        points.push([f64::from(linkages).ln(), instructions.ln()]);
    }
    judge(&[Verdict {
        what: "accelerations and multipliers, exponent of the instructions".to_owned(),
        figure: slope(&points),
        target: LIMIT,
        limit: LIMIT,
    }])
}

/// The slope of the line through some points with the least sum of squares.
fn slope(points: &[[f64; 2]]) -> f64 {
    let count = points.iter().fold(0.0, |count, _| count + 1.0);
    let mean = |i: usize| points.iter().map(|point| point[i]).sum::<f64>() / count;
    let [x, y] = [mean(0), mean(1)];
    let products = points.iter().map(|point| (point[0] - x) * (point[1] - y));
    let squares = points.iter().map(|point| (point[0] - x).powi(2));
    products.sum::<f64>() / squares.sum::<f64>()
}

/// What evaluates them as often as its argument says, with all cranks 0.3 rad beside the upright.
fn program(linkages: u32) -> String {
    let (cranks, coordinates) = (linkages + 1, 2 * linkages + 2);
    format!(
        "four_bars!(Row, {cranks}, {linkages});\n\n\
         fn main() {{\n    \
             let count = std::env::args().nth(1).and_then(|count| count.parse().ok());\n    \
             let mut state = upright::<{cranks}, {coordinates}>(1.0);\n    \
             let (sine, cosine) = 0.3_f64.sin_cos();\n    \
             for i in 0..{cranks} {{\n        \
                 state.q[i] += sine;\n        \
                 state.q[{cranks} + i] = cosine;\n        \
                 state.v[i] = cosine;\n        \
                 state.v[{cranks} + i] = -sine;\n    \
             }}\n    \
             let inputs = lagrangian::quantities::Quantities::inputs(&Row::NEW);\n    \
             let prepared = lagrangian::quantities::Quantities::prepare(&Row::NEW);\n    \
             for _ in 0..count.unwrap_or(1) {{\n        \
                 let state = std::hint::black_box(&state);\n        \
                 let found = lagrangian::quantities::Constraints::accelerations_and_multipliers(\n            \
                     &Row::NEW, state, &inputs, &prepared,\n        );\n        \
                 std::hint::black_box(&found);\n    \
             }}\n}}\n"
    )
}
