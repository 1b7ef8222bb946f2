//! Brouwer's law: the error of the energy of an integrator without bias grows like √t.
//!
//! D. Brouwer, *On the accumulation of errors in numerical integration*, Astronomical Journal **46** (1937) 149–153.
//! The symmetric top and the double pendulum are integrated over 10⁶ periods from 32 starts, eight at once in the lanes of
//! one scalar, which have the arithmetic of `f64`. Of the root of the mean square of the relative energy error, the
//! exponent in time is fitted by least squares in logarithms. Energies are computed in double-double from the state as it is
//! read, in doubles; their rounding alone is what the error is after a single period, whose square is subtracted.

use std::f64::consts::TAU;
use std::time::Instant;

use lagrangian_bench::{EnergyErrors, Question};

use crate::arguments::Arguments;
use crate::cargo::build;
use crate::declaration::Calls;
use crate::flags::Flags;
use crate::folders::Folders;
use crate::model::Model;
use crate::states::uniform;
use crate::trajectories::Trajectory;
use crate::verdict::{Verdict, judge};

const STARTS: usize = 32;

/// Each component of a start is moved by up to that.
const MOVED: f64 = 0.05;

/// Doubling times up to the last.
const DOUBLINGS: i32 = 10;

/// Prints the errors and the exponents, and is an error where an exponent is off.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    let folders = Folders::new()?;
    let periods = if arguments.quick { 1e4 } else { 1e6 };
    let mut verdicts = Vec::new();
    for &model in &arguments.models {
        let period = period(model)?;
        eprintln!("{model}: {periods:.0e} periods of {period:.3} s, from {STARTS} starts");
        let began = Instant::now();
        let (times, rows) = errors(&folders, arguments.tolerance, model, (period, periods))?;
        let errors: Vec<f64> = rows.iter().map(|row| root_mean_square(row)).collect();
        let exponent = exponent(&times, &errors);
        println!(
            "\n{model}, {STARTS} starts, in {:.0} s:",
            began.elapsed().as_secs_f64()
        );
        println!("  {:>12} {:>32}", "periods", "relative energy error, rms");
        for (time, error) in times.iter().zip(&errors) {
            println!("  {:>12.0} {error:>32.1e}", time / period);
        }
        println!("  it grows like t to the power of {exponent:.3}");
        let [mean, uncertainty] = mean(rows.last().map_or(&[], Vec::as_slice));
        println!(
            "  the mean of the last errors is {mean:.1e} ± {uncertainty:.1e}: that of an unbiased one is 0"
        );
        verdicts.push(Verdict {
            what: format!("{model}, distance of the exponent from ½"),
            figure: (exponent - 0.5).abs(),
            target: 0.1,
            limit: 0.1,
        });
    }
    judge(&verdicts)
}

/// The slowest oscillation: the nutation of a fast top, with ω = `I_s` ω₃ / I, and the first mode of the pendulum, with
/// ω² = (2 − √2) g/l.
fn period(model: Model) -> Result<f64, String> {
    match model {
        Model::SymmetricTop => Ok(TAU / (0.5 * (20.0 + 0.3 * f64::cos(0.5)) / 1.2)),
        Model::Pendulum(2) => Ok(TAU / f64::sqrt((2.0 - f64::sqrt(2.0)) * 9.81 / 0.7)),
        other => Err(format!("the period of {other} is not known here")),
    }
}

/// Times, and the errors of all starts at each.
fn errors(
    folders: &Folders,
    tolerance: Option<f64>,
    model: Model,
    (period, periods): (f64, f64),
) -> Result<(Vec<f64>, Vec<Vec<f64>>), String> {
    let trajectory = Trajectory::of(folders, model)?;
    let mut uniform = uniform();
    let mut start = || {
        let moved = trajectory
            .start
            .iter()
            .map(|x| x + MOVED * (2.0 * uniform() - 1.0));
        moved.collect()
    };
    let doublings = (0..=DOUBLINGS).rev();
    let times = doublings.map(|k| period * periods * f64::powi(0.5, k));
    let times: Vec<f64> = [period].into_iter().chain(times).collect();
    let question = Question::EnergyErrors(EnergyErrors {
        starts: (0..STARTS).map(|_| start()).collect(),
        times: times.clone(),
        tolerance,
    });
    let built = build(folders, model, Calls::Integrate, Flags::Native)?;
    let rows: Vec<Vec<f64>> = built.start()?.ask(&question)?;
    Ok((times, rows))
}

#[allow(clippy::cast_precision_loss)] // Some starts.
fn root_mean_square(errors: &[f64]) -> f64 {
    let sum: f64 = errors.iter().map(|error| error * error).sum();
    f64::sqrt(sum / errors.len() as f64)
}

/// The mean of errors, and the standard deviation of such a mean.
#[allow(clippy::cast_precision_loss)] // Some starts.
fn mean(errors: &[f64]) -> [f64; 2] {
    let count = errors.len() as f64;
    let mean = errors.iter().sum::<f64>() / count;
    let squares: f64 = errors.iter().map(|error| (error - mean).powi(2)).sum();
    [mean, f64::sqrt(squares / (count - 1.0) / count)]
}

/// The slope of the logarithm of the error over that of time, without the first, which is rounding.
fn exponent(times: &[f64], errors: &[f64]) -> f64 {
    let Some((rounding, errors)) = errors.split_first() else {
        return f64::NAN;
    };
    let grown = errors
        .iter()
        .map(|error| error * error - rounding * rounding);
    let points: Vec<[f64; 2]> = times[1..]
        .iter()
        .zip(grown)
        .filter(|(_, square)| *square > 0.0)
        .map(|(time, square)| [time.ln(), 0.5 * square.ln()])
        .collect();
    #[allow(clippy::cast_precision_loss)] // Some points.
    let count = points.len() as f64;
    let mean = |component: usize| points.iter().map(|point| point[component]).sum::<f64>() / count;
    let [x, y] = [mean(0), mean(1)];
    let (mut products, mut squares) = (0.0, 0.0);
    for point in &points {
        products += (point[0] - x) * (point[1] - y);
        squares += (point[0] - x).powi(2);
    }
    products / squares
}
