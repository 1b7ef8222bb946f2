//! The instructions of the accelerations and multipliers of four-bar linkages in a row, and the exponent with which they grow with
//! the number of linkages.
//!
//! The programs in Cartesian coordinates are for processors with vectors of 256 bits, the widest that valgrind knows. Those in
//! angles are for any processor: valgrind does not know an instruction by which many sines are moved on those.

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

/// The coordinates of the linkages.
#[derive(Clone, Copy)]
enum Coordinates {
    /// The positions of the ends of the cranks.
    Cartesian,
    /// The angles of each rod against the one before.
    Relative,
}

/// Measures, prints, and is an error where an exponent is too large.
pub(crate) fn run() -> Result<(), String> {
    let mut verdicts = Vec::new();
    for coordinates in [Coordinates::Cartesian, Coordinates::Relative] {
        let exponent = exponent(coordinates)?;
        verdicts.push(Verdict {
            what: format!("{}, exponent of the instructions", coordinates.name()),
            figure: exponent,
            target: LIMIT,
            limit: LIMIT,
        });
    }
    judge(&verdicts)
}

/// Measures and prints the instructions, and returns their exponent.
fn exponent(coordinates: Coordinates) -> Result<f64, String> {
    let folders = Folders::new()?;
    let path = folders.workspace.join(DECLARATION);
    let declaration = fs::read_to_string(path).map_err(|error| error.to_string())?;
    let name = coordinates.name();
    println!("{name}\nlinkages  unknowns  instructions  seconds to build");
    let mut points = Vec::new();
    for linkages in LINKAGES {
        let source = declaration.clone() + &coordinates.program(linkages);
        let name = format!("linkages-{linkages}");
        let built = build_source(&folders, &name, &source, coordinates.flags())?;
        let [few, many] =
            EVALUATIONS.map(|count| counted(&folders, built.program(), &[count.to_string()]));
        let more = f64::from(EVALUATIONS[1] - EVALUATIONS[0]);
        let instructions = (many? - few?) / more;
        let unknowns = coordinates.unknowns(linkages);
        println!(
            "{linkages:>8}  {unknowns:>8}  {instructions:>12.0}  {:>16.1}",
            built.seconds
        );
        points.push([f64::from(linkages).ln(), instructions.ln()]);
    }
    Ok(slope(&points))
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

impl Coordinates {
    const fn name(self) -> &'static str {
        match self {
            Self::Cartesian => "Cartesian coordinates",
            Self::Relative => "relative angles",
        }
    }

    const fn flags(self) -> Flags {
        match self {
            Self::Cartesian => Flags::Vectors256,
            Self::Relative => Flags::Default,
        }
    }

    /// Accelerations and multipliers.
    const fn unknowns(self, linkages: u32) -> u32 {
        match self {
            Self::Cartesian => 4 * linkages + 3,
            Self::Relative => 4 * linkages + 1,
        }
    }

    /// What evaluates them as often as its argument says, with all cranks 0.3 rad beside the upright.
    fn program(self, linkages: u32) -> String {
        let (declaration, state) = match self {
            Self::Cartesian => {
                let (cranks, coordinates) = (linkages + 1, 2 * linkages + 2);
                let state = format!(
                    "let mut state = upright::<{cranks}, {coordinates}>(1.0);\n    \
                     let (sine, cosine) = 0.3_f64.sin_cos();\n    \
                     for i in 0..{cranks} {{\n        \
                         state.q[i] += sine;\n        \
                         state.q[{cranks} + i] = cosine;\n        \
                         state.v[i] = cosine;\n        \
                         state.v[{cranks} + i] = -sine;\n    \
                     }}"
                );
                (format!("four_bars!(Row, {cranks}, {linkages});"), state)
            }
            Self::Relative => {
                let (others, coordinates) = (linkages - 1, 2 * linkages + 1);
                let state = format!("let state = chained::<{coordinates}>(0.3, 1.0);");
                let declaration = format!("chained_four_bars!(Row, {linkages}, {others});");
                (declaration, state)
            }
        };
        format!(
            "{declaration}\n\n\
             fn main() {{\n    \
                 let count = std::env::args().nth(1).and_then(|count| count.parse().ok());\n    \
                 {state}\n    \
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
}
