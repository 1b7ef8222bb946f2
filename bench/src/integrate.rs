//! Our side of a contest of integrators.

use std::process::ExitCode;

use lagrangian::prelude::*;
use lagrangian::quantities::{MembersInLanes, MotionSeries};
use lagrangian::{DoubleDouble, EquationsOfMotion, Lanes, OperationCount};

use crate::energy_errors::{drift, energy, energy_errors};
use crate::motions::{LANES, Motions, rows, state};
use crate::question::{Integrated, Integration, Question, answer, answer_questions};
use crate::thread_time::fewest_seconds;

/// A model without inputs, on the scalars on which it is integrated here.
pub trait Contestant<const N: usize>:
    MembersInLanes<LANES, InLanes = Self>
    + MotionSeries<N, Inputs = SVector<f64, 0>>
    + MotionSeries<N, Lanes<LANES>, Inputs = SVector<Lanes<LANES>, 0>>
    + Lagrangian<N, Model = Self>
    + Lagrangian<N, Lanes<LANES>, Model = Self>
    + Lagrangian<N, DoubleDouble>
    + Sync
{
}

impl<M, const N: usize> Contestant<N> for M where
    M: MembersInLanes<LANES, InLanes = M>
        + MotionSeries<N, Inputs = SVector<f64, 0>>
        + MotionSeries<N, Lanes<LANES>, Inputs = SVector<Lanes<LANES>, 0>>
        + Lagrangian<N, Model = Self>
        + Lagrangian<N, Lanes<LANES>, Model = Self>
        + Lagrangian<N, DoubleDouble>
        + Sync
{
}

/// The `main` of a model crate that is measured by integrating it, one motion at a time or several at once.
pub fn integrate<const N: usize, M: Contestant<N>>(model: &M, _: OperationCount) -> ExitCode {
    answer_questions(|question| match question {
        Question::Integrate(integration) => answer(&match integration.starts.len() {
            1 => alone(model, &integration)?,
            _ => together(model, &integration)?,
        }),
        Question::EnergyDrifts(states) => answer(&drifts(model, &states)?),
        Question::EnergyErrors(question) => answer(&energy_errors(model, &question)?),
        Question::Throughput(_) => Err("only ensembles have a throughput".to_owned()),
    })
}

/// The same for models that take long to compile: one motion at a time.
pub fn integrate_alone<
    const N: usize,
    M: Lagrangian<N, Model: MotionSeries<N>> + Lagrangian<N, DoubleDouble>,
>(
    model: &M,
    _: OperationCount,
) -> ExitCode {
    answer_questions(|question| match question {
        Question::Integrate(integration) => answer(&alone(model, &integration)?),
        Question::EnergyDrifts(states) => answer(&drifts(model, &states)?),
        _ => Err("one motion at a time".to_owned()),
    })
}

/// In double-double alone: references.
pub fn integrate_precisely<
    const N: usize,
    M: Lagrangian<N, DoubleDouble, Model: MotionSeries<N, DoubleDouble>>,
>(
    model: &M,
    _: OperationCount,
) -> ExitCode {
    answer_questions(|question| match question {
        Question::Integrate(integration) => {
            let method = Taylor::order_40();
            answer(&by::<DoubleDouble, _, _, N>(model, &method, &integration)?)
        }
        _ => Err("references alone".to_owned()),
    })
}

/// One motion, by a method with this name.
fn alone<const N: usize, M: Lagrangian<N, Model: MotionSeries<N>>>(
    model: &M,
    integration: &Integration,
) -> Result<Integrated, String> {
    match integration.method.as_str() {
        "Taylor" => by::<f64, _, _, N>(model, &taylor(Taylor::new(), integration), integration),
        "Taylor 12" => {
            by::<f64, _, _, N>(model, &taylor(Taylor::order_12(), integration), integration)
        }
        "Taylor 16" => {
            by::<f64, _, _, N>(model, &taylor(Taylor::order_16(), integration), integration)
        }
        "Dop853" => {
            let mut method = Dop853::new();
            if let Some(tolerance) = integration.tolerance {
                method = method
                    .relative_tolerance(tolerance)
                    .absolute_tolerance(tolerance);
            }
            by::<f64, _, _, N>(model, &method, integration)
        }
        other => Err(format!("there is no method `{other}`")),
    }
}

/// Several motions at once.
fn together<const N: usize, M: Contestant<N>>(
    model: &M,
    integration: &Integration,
) -> Result<Integrated, String> {
    match integration.method.as_str() {
        "Taylor" => by::<Lanes<LANES>, _, _, N>(model, &Taylor::new(), integration),
        "Taylor 16" => by::<Lanes<LANES>, _, _, N>(model, &Taylor::order_16(), integration),
        "Taylor, own steps" => ensemble(model, Taylor::new(), integration),
        "Taylor 16, own steps" => ensemble(model, Taylor::order_16(), integration),
        other => Err(format!("there is no method `{other}` for several motions")),
    }
}

/// At the tolerance that is asked for.
fn taylor<const HALF: usize>(method: Taylor<HALF>, integration: &Integration) -> Taylor<HALF> {
    match integration.tolerance {
        Some(tolerance) => method
            .relative_tolerance(tolerance)
            .absolute_tolerance(tolerance),
        None => method,
    }
}

/// In lanes with steps of their own.
fn ensemble<const N: usize, const HALF: usize, M: Contestant<N>>(
    model: &M,
    method: Taylor<HALF>,
    integration: &Integration,
) -> Result<Integrated, String> {
    let one = |row: &Vec<f64>| state::<f64, N>(std::slice::from_ref(row));
    let starts: Vec<State<f64, N>> = integration.starts.iter().map(one).collect();
    let (outcomes, seconds) = fewest_seconds(integration.at_least, || {
        let problems = starts.iter().map(|start| Problem::new(model, *start));
        let ensemble = Ensemble::new(problems).lanes::<LANES>();
        let outcomes = ensemble.solve(integration.end, method);
        let outcomes: Result<Vec<_>, _> = outcomes.into_iter().collect();
        outcomes.map_err(|error| error.to_string())
    })?;
    let steps = outcomes.iter().map(|outcome| outcome.statistics.steps);
    let states = outcomes
        .iter()
        .flat_map(|outcome| rows::<f64, N>(&outcome.last.x));
    Ok(Integrated {
        seconds,
        steps: steps.max().unwrap_or(0),
        events: 0,
        states: states.collect(),
    })
}

/// As a user would: one call that prepares the model, starts the method and integrates.
fn by<S: Motions, I, M, const N: usize>(
    model: &M,
    method: &I,
    integration: &Integration,
) -> Result<Integrated, String>
where
    M: Lagrangian<N, S>,
    I: Clone + for<'a> Integrator<S, EquationsOfMotion<&'a M, S, N>>,
{
    let Integration {
        starts,
        end,
        at_least,
        ..
    } = integration;
    if starts.len() != S::COUNT {
        return Err(format!("{} starts for {} motions", starts.len(), S::COUNT));
    }
    let start = state::<S, N>(starts);
    let (solution, seconds) = fewest_seconds(*at_least, || {
        let solution = Problem::new(model, start).solve(*end, method.clone());
        solution.map_err(|error| error.to_string())
    })?;
    Ok(Integrated {
        seconds,
        steps: solution.statistics.steps,
        events: 0,
        states: rows(&solution.x),
    })
}

/// The drift of each state from the first.
fn drifts<const N: usize, M: Lagrangian<N, DoubleDouble>>(
    model: &M,
    states: &[Vec<f64>],
) -> Result<Vec<f64>, String> {
    let first = energy(model, states.first().ok_or("there are no states")?);
    Ok(states.iter().map(|row| drift(model, row, first)).collect())
}
