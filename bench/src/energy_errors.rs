//! How the energy is kept over long times.

use std::thread;

use lagrangian::prelude::*;
use lagrangian::quantities::MotionSeries;
use lagrangian::{DoubleDouble, Lanes};

use crate::motions::{LANES, rows, state};
use crate::question::EnergyErrors;

/// All starts, as many at once as there are lanes, on two threads.
pub(crate) fn energy_errors<const N: usize, M>(
    model: &M,
    question: &EnergyErrors,
) -> Result<Vec<Vec<f64>>, String>
where
    M: Lagrangian<N, Lanes<LANES>, Model: MotionSeries<N, Lanes<LANES>>>
        + Lagrangian<N, DoubleDouble>
        + Sync,
{
    let chunks: Vec<&[Vec<f64>]> = question.starts.chunks_exact(LANES).collect();
    let halves = chunks.chunks(chunks.len().div_ceil(2).max(1));
    let mut errors = vec![Vec::new(); question.times.len()];
    thread::scope(|scope| {
        let threads: Vec<_> = halves
            .map(|half| {
                scope.spawn(move || {
                    let errors = half
                        .iter()
                        .map(|starts| errors_together(model, starts, question));
                    errors.collect::<Result<Vec<_>, _>>()
                })
            })
            .collect();
        for thread in threads {
            for rows in thread.join().map_err(|_| "a thread has panicked")?? {
                for (errors, row) in errors.iter_mut().zip(rows) {
                    errors.extend(row);
                }
            }
        }
        Ok(errors)
    })
}

/// The errors of starts that fill the lanes, a row for each time.
fn errors_together<const N: usize, M>(
    model: &M,
    starts: &[Vec<f64>],
    EnergyErrors {
        times, tolerance, ..
    }: &EnergyErrors,
) -> Result<Vec<Vec<f64>>, String>
where
    M: Lagrangian<N, Lanes<LANES>, Model: MotionSeries<N, Lanes<LANES>>>
        + Lagrangian<N, DoubleDouble>,
{
    let initial: Vec<_> = starts.iter().map(|row| energy(model, row)).collect();
    let method = tolerance.map_or(Taylor::new(), |tolerance| {
        Taylor::new()
            .relative_tolerance(tolerance)
            .absolute_tolerance(tolerance)
    });
    let end = times.last().copied().unwrap_or(0.0);
    let solution = Problem::new(model, state::<Lanes<LANES>, N>(starts))
        .max_steps(u64::MAX)
        .save(times)
        .solve(end, method)
        .map_err(|error| error.to_string())?;
    let drifts = |phase| {
        let rows = rows(phase);
        let pairs = rows.iter().zip(&initial);
        pairs
            .map(|(row, initial)| drift(model, row, *initial))
            .collect()
    };
    Ok(solution
        .samples()
        .iter()
        .map(|sample| drifts(&sample.x))
        .collect())
}

/// In double-double, so that what rounds is the state alone.
pub(crate) fn energy<const N: usize, M: Lagrangian<N, DoubleDouble>>(
    model: &M,
    row: &[f64],
) -> DoubleDouble {
    model.energy(&state::<DoubleDouble, N>(&[row.to_vec()]))
}

/// The relative change of the energy.
pub(crate) fn drift<const N: usize, M: Lagrangian<N, DoubleDouble>>(
    model: &M,
    row: &[f64],
    initial: DoubleDouble,
) -> f64 {
    ((energy(model, row) - initial) / initial).to_f64()
}
