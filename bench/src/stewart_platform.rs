//! Accelerations and multipliers of the Stewart platform of the ready models, thirteen bodies with 24 coordinates and 24 constraints,
//! beside C that `CasADi` generates for the same mechanism: instructions, as valgrind counts them, and times, in turn.
//!
//! Both are for processors with vectors of 256 bits, the widest that valgrind knows.

use std::fs;
use std::path::Path;
use std::process::Command;

use serde::Deserialize;

use crate::cargo::build_source;
use crate::command::output;
use crate::flags::Flags;
use crate::folders::Folders;
use crate::instructions::counted;
use crate::peers::CASADI;
use crate::python::Python;
use crate::verdict::{Verdict, judge};

const DECLARATION: &str = "models/src/stewart_platform.rs";

/// The values that both have to agree on, in relation to the largest one.
const AGREEMENT: f64 = 1e-10;

/// A program is run with the first and the second number of evaluations: the difference is what they take.
const EVALUATIONS: [u32; 2] = [1, 101];

/// How often each side is timed, and with how many evaluations.
const TIMINGS: (usize, u32) = (7, 100_000);

/// What the script says that has written C.
#[derive(Deserialize)]
struct Written {
    derive_seconds: f64,
}

/// What a program prints: q̈ and λ, and the seconds of its evaluations.
struct Reply {
    values: Vec<f64>,
    seconds: f64,
}

/// Measures, prints, and is an error where `CasADi` is ahead.
pub(crate) fn run() -> Result<(), String> {
    let folders = Folders::new()?;
    let declaration = fs::read_to_string(folders.workspace.join(DECLARATION));
    let source = declaration.map_err(|error| error.to_string())? + PROGRAM;
    let ours = build_source(&folders, "stewart", &source, Flags::Vectors256)?;
    let state = folders.output.join("stewart-state.txt");
    let text = output(Command::new(ours.program()).arg("state"))?;
    fs::write(&state, text).map_err(|error| error.to_string())?;

    let python = Python::new(&folders)?;
    python.install(&[CASADI])?;
    let [c, theirs] = ["stewart.c", "stewart-casadi"].map(|name| folders.output.join(name));
    let written: Written = python.run("casadi_stewart.py", &[&c.display().to_string()])?;
    let mut compiler = Command::new("gcc");
    compiler
        .args(Flags::Vectors256.c())
        .arg(&c)
        .arg("-o")
        .arg(&theirs);
    output(compiler.arg("-lm"))?;

    let sides = [("lagrangian", ours.program()), ("CasADi", &theirs)];
    let [found, expected] = sides.map(|(_, program)| reply(program, &state, 1));
    compare(&found?.values, &expected?.values)?;
    println!(
        "CasADi derives in {:.1} s; ours is built in {:.1} s",
        written.derive_seconds, ours.seconds
    );
    let mut instructions = Vec::new();
    for (name, program) in sides {
        let arguments = |count: u32| [state.display().to_string(), count.to_string()];
        let [few, many] = EVALUATIONS.map(|count| counted(&folders, program, &arguments(count)));
        let more = f64::from(EVALUATIONS[1] - EVALUATIONS[0]);
        let taken = (many? - few?) / more;
        println!("{name:>12}  {taken:>8.0} instructions");
        instructions.push(taken);
    }
    let mut times = [f64::INFINITY; 2];
    for _ in 0..TIMINGS.0 {
        for (least, (_, program)) in times.iter_mut().zip(sides) {
            *least = least.min(reply(program, &state, TIMINGS.1)?.seconds);
        }
    }
    for (time, (name, _)) in times.iter().zip(sides) {
        println!("{name:>12}  {:>8.3} µs", 1e6 * time / f64::from(TIMINGS.1));
    }
    let ratio = |what: &str, figure: f64| Verdict {
        what: format!("Stewart platform, {what} over CasADi"),
        figure,
        target: 1.0,
        limit: 1.0,
    };
    judge(&[
        ratio("instructions", instructions[0] / instructions[1]),
        ratio("time", times[0] / times[1]),
    ])
}

/// What a program prints at a state after so many evaluations.
fn reply(program: &Path, state: &Path, evaluations: u32) -> Result<Reply, String> {
    let text = output(
        Command::new(program)
            .arg(state)
            .arg(evaluations.to_string()),
    )?;
    let numbers = text.split_whitespace().map(str::parse);
    let mut values: Vec<f64> = numbers
        .collect::<Result<_, _>>()
        .map_err(|error| format!("{}: {error}", program.display()))?;
    let seconds = values.pop().ok_or_else(|| "no time".to_owned())?;
    Ok(Reply { values, seconds })
}

fn compare(found: &[f64], expected: &[f64]) -> Result<(), String> {
    let largest = expected.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
    let pairs = found.iter().zip(expected);
    let difference = pairs.fold(0.0, |most: f64, (x, y)| most.max((x - y).abs())) / largest;
    println!("largest difference {difference:.1e} of the largest value");
    if found.len() == expected.len() && difference <= AGREEMENT {
        return Ok(());
    }
    Err(format!("the sides differ by {difference:.1e}"))
}

/// What prints a state, or evaluates at the state in a file as often as its second argument says, and prints q̈, λ and the seconds.
const PROGRAM: &str = r#"
fn model() -> Result<StewartPlatform, Box<dyn std::error::Error>> {
    Ok(StewartPlatform {
        platform: SymmetricBody::new(40.0, 0.0, 2.0, 4.0)?,
        cylinder: [SymmetricBody::new(3.0, 0.3, 0.35, 0.01)?; 6],
        rod: [SymmetricBody::new(1.5, -0.3, 0.18, 0.002)?; 6],
        base: StewartPlatform::hexagon(1.0, 0.2),
        top: StewartPlatform::hexagon(0.6, 0.847_197_551_196_597_7),
        height: 1.0,
        radius: 0.2,
        omega: 1.5,
        g: 9.81,
    })
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let model = model()?;
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let Some(count) = arguments.get(1) else {
        let state = model.assemble(model.guess(0.3)).solve()?.state;
        for x in state.q.iter().chain(state.v.iter()).chain([&state.t]) {
            println!("{x:e}");
        }
        return Ok(());
    };
    let text = std::fs::read_to_string(&arguments[0])?;
    let numbers: Vec<f64> = text.split_whitespace().map(str::parse).collect::<Result<_, _>>()?;
    let state = State::new(
        numbers[48],
        std::array::from_fn(|i| numbers[i]),
        std::array::from_fn(|i| numbers[24 + i]),
    );
    let inputs = lagrangian::quantities::Quantities::inputs(&model);
    let prepared = lagrangian::quantities::Quantities::prepare(&model);
    let evaluate = |state: &State<f64, 24>| {
        lagrangian::quantities::Constraints::accelerations_and_multipliers(&model, state, &inputs, &prepared)
    };
    let mut found = evaluate(&state);
    let begin = std::time::Instant::now();
    for _ in 0..count.parse()? {
        found = evaluate(std::hint::black_box(&state));
        std::hint::black_box(&found);
    }
    let seconds = begin.elapsed().as_secs_f64();
    for x in found.0.iter().chain(found.1.iter()) {
        println!("{x:e}");
    }
    println!("{seconds:e}");
    Ok(())
}
"#;
