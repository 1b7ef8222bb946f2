//! What a step of a reduced model takes beside one of the full model.

use std::process::ExitCode;

use lagrangian::RouthReduction;
use lagrangian::prelude::*;
use lagrangian::quantities::MotionSeries;

use crate::thread_time::fewest_seconds;

/// So many integrations of each, in turn.
const ROUNDS: usize = 400;

/// The time to which both are integrated: short against interruptions.
const END: f64 = 100.0;

/// Prints the nanoseconds of a step of the full model and of the reduced one, the fewest of many.
pub fn compare_steps<const N: usize, const R: usize, M>(full: &M, start: State<f64, N>) -> ExitCode
where
    M: RouthReduction<N, R, Scalar = f64> + Lagrangian<N, Model: MotionSeries<N>>,
    M::Reduced: Lagrangian<R, Model: MotionSeries<R>>,
{
    let (reduced, reduced_start) = full.reduce(&start);
    let mut fewest = [f64::INFINITY; 2];
    for _ in 0..ROUNDS {
        match [of_step(full, start), of_step(&reduced, reduced_start)] {
            [Ok(full), Ok(reduced)] => {
                fewest = [fewest[0].min(full), fewest[1].min(reduced)];
            }
            [Err(error), _] | [_, Err(error)] => {
                eprintln!("{error}");
                return ExitCode::FAILURE;
            }
        }
    }
    println!("{} {}", fewest[0], fewest[1]);
    ExitCode::SUCCESS
}

/// Nanoseconds.
#[allow(clippy::cast_precision_loss)] // Some hundreds of steps.
fn of_step<const N: usize, M: Lagrangian<N, Model: MotionSeries<N>>>(
    model: &M,
    start: State<f64, N>,
) -> Result<f64, String> {
    let (solution, seconds) = fewest_seconds(0.0, || {
        let solution = Problem::new(model, start).solve(END, Taylor::new());
        solution.map_err(|error| error.to_string())
    })?;
    Ok(1e9 * seconds / solution.statistics.steps as f64)
}
