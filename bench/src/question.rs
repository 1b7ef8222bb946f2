//! What the program asks a contestant, a program that runs beside it, and what that answers: a line of JSON each.

use std::io::{self, BufRead, Write};
use std::process::ExitCode;

use serde::{Deserialize, Serialize};
use serde_json::Value;

/// A line from the program. The answer is a `Result` of what the question asks for, or of a message.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub enum Question {
    /// An [`Integrated`].
    Integrate(Integration),
    /// By how much the energy at each of these states differs from that at the first, relative to it. Coordinates and
    /// then velocities.
    EnergyDrifts(Vec<Vec<f64>>),
    /// The relative errors of the energy, a row for each of the times, and in it one for each start.
    EnergyErrors(EnergyErrors),
    /// How many motions the process integrates in a second by the clock.
    Throughput(Throughput),
}

/// An integration from time 0 that is measured.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Integration {
    /// The method, by a name that the contestant knows.
    pub method: String,
    /// The relative and absolute tolerance; none is the method's own.
    pub tolerance: Option<f64>,
    /// Coordinates and velocities; if there are several, all are integrated at once.
    pub starts: Vec<Vec<f64>>,
    /// The final time.
    pub end: f64,
    /// It is repeated until it has taken so many seconds.
    pub at_least: f64,
}

/// How it went.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Integrated {
    /// The fewest seconds of CPU time.
    pub seconds: f64,
    /// Steps; of several starts together, the most; of an ensemble, all.
    pub steps: u64,
    /// Events that were recorded.
    #[serde(default)]
    pub events: u64,
    /// The final states.
    pub states: Vec<Vec<f64>>,
}

/// An integration that is repeated by the clock.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Throughput {
    /// The ensemble.
    pub integration: Integration,
    /// No repetition begins after that.
    pub seconds: f64,
}

/// How the energy is kept over long times.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct EnergyErrors {
    /// Coordinates and velocities.
    pub starts: Vec<Vec<f64>>,
    /// The times, which grow.
    pub times: Vec<f64>,
    /// The relative and absolute tolerance; none is the method's own.
    pub tolerance: Option<f64>,
}

/// What a contestant answers.
///
/// # Errors
///
/// The message of the serializer.
pub fn answer(value: &impl Serialize) -> Result<Value, String> {
    serde_json::to_value(value).map_err(|error| error.to_string())
}

/// The `main` of a contestant: answers questions until there are no more.
pub fn answer_questions(answer: impl Fn(Question) -> Result<Value, String>) -> ExitCode {
    for line in io::stdin().lock().lines() {
        let question = line.map_err(|error| error.to_string()).and_then(|line| {
            serde_json::from_str(&line).map_err(|error| format!("{line}: {error}"))
        });
        let answer = serde_json::to_string(&question.and_then(&answer));
        let mut output = io::stdout().lock();
        let sent = answer
            .map_err(io::Error::from)
            .and_then(|answer| writeln!(output, "{answer}"))
            .and_then(|()| output.flush());
        if sent.is_err() {
            return ExitCode::FAILURE;
        }
    }
    ExitCode::SUCCESS
}
