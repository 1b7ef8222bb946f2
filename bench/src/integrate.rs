//! Our side of a contest of integrators.

use std::process::ExitCode;
use std::thread;

use lagrangian::prelude::*;
use lagrangian::{DoubleDouble, EquationsOfMotion, IntegrationMethod, Lanes, MotionSeries};
use serde::Serialize;
use serde_json::Value;

use crate::question::{EnergyErrors, Integrated, Integration, Question, answer_questions};
use crate::thread_time::fewest_seconds;

/// How many motions are integrated at once.
pub const LANES: usize = 8;

/// The scalars on which a model is integrated here.
pub trait Contestant<const N: usize>:
    MotionSeries<N> + MotionSeries<N, Lanes<LANES>> + MotionSeries<N, DoubleDouble> + Sync
{
}

impl<M, const N: usize> Contestant<N> for M where
    M: MotionSeries<N> + MotionSeries<N, Lanes<LANES>> + MotionSeries<N, DoubleDouble> + Sync
{
}

/// The `main` of a model crate that is measured by integrating it.
pub fn integrate<const N: usize, M: Contestant<N>>(
    model: &M,
    _: lagrangian::OperationCount,
) -> ExitCode {
    answer_questions(|question| match question {
        Question::Integrate(integration) => value(&integrated(model, &integration)?),
        Question::EnergyDrifts(states) => {
            let first = energy(model, states.first().ok_or("there are no states")?);
            let drifts = states.iter().map(|row| drift(model, row, first));
            value(&drifts.collect::<Vec<f64>>())
        }
        Question::EnergyErrors(question) => value(&energy_errors(model, &question)?),
    })
}

fn value(answer: &impl Serialize) -> Result<Value, String> {
    serde_json::to_value(answer).map_err(|error| error.to_string())
}

/// The methods by their names.
fn integrated<const N: usize, M: Contestant<N>>(
    model: &M,
    integration: &Integration,
) -> Result<Integrated, String> {
    match integration.method.as_str() {
        "Taylor 12" => taylor(model, Taylor::order_12(), integration),
        "Taylor 16" => taylor(model, Taylor::order_16(), integration),
        "Taylor 24" => taylor(model, Taylor::new(), integration),
        "Taylor 16, own steps" => ensemble(model, Taylor::order_16(), integration),
        "Taylor 24, own steps" => ensemble(model, Taylor::new(), integration),
        "Taylor 40 in double-double" => {
            by::<DoubleDouble, _, _, N>(model, &Taylor::order_40(), integration)
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

fn taylor<const N: usize, const HALF: usize, M: Contestant<N>>(
    model: &M,
    mut method: Taylor<HALF>,
    integration: &Integration,
) -> Result<Integrated, String> {
    if let Some(tolerance) = integration.tolerance {
        method = method
            .relative_tolerance(tolerance)
            .absolute_tolerance(tolerance);
    }
    if integration.starts.len() == 1 {
        by::<f64, _, _, N>(model, &method, integration)
    } else {
        by::<Lanes<LANES>, _, _, N>(model, &method, integration)
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
        let dynamics = Lagrangian::<N, Lanes<LANES>>::dynamics(model);
        let motions = starts.iter().map(|start| (*start, integration.end));
        let outcomes = method.ensemble::<LANES>().collect(&dynamics, motions);
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
        states: states.collect(),
    })
}

/// A scalar that holds the numbers of some motions.
trait Motions: Scalar {
    const COUNT: usize;

    fn new(number: impl Fn(usize) -> f64) -> Self;

    fn number(self, motion: usize) -> f64;
}

impl Motions for f64 {
    const COUNT: usize = 1;

    fn new(number: impl Fn(usize) -> f64) -> Self {
        number(0)
    }

    fn number(self, _: usize) -> f64 {
        self
    }
}

impl Motions for DoubleDouble {
    const COUNT: usize = 1;

    fn new(number: impl Fn(usize) -> f64) -> Self {
        number(0).into()
    }

    fn number(self, _: usize) -> f64 {
        self.to_f64()
    }
}

impl Motions for Lanes<LANES> {
    const COUNT: usize = LANES;

    fn new(number: impl Fn(usize) -> f64) -> Self {
        Self::from_fn(number)
    }

    fn number(self, motion: usize) -> f64 {
        self.lane(motion)
    }
}

/// As a user would: one call that prepares the model, starts the method and integrates.
fn by<S: Motions, I, M, const N: usize>(
    model: &M,
    method: &I,
    integration: &Integration,
) -> Result<Integrated, String>
where
    M: Lagrangian<N, S>,
    I: IntegrationMethod + for<'a> Integrator<S, EquationsOfMotion<'a, M, S, N>>,
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
    let (outcome, seconds) = fewest_seconds(*at_least, || {
        let outcome = method.driver().run_until(&model.dynamics(), start, *end);
        outcome.map_err(|error| error.to_string())
    })?;
    Ok(Integrated {
        seconds,
        steps: outcome.statistics.steps,
        states: rows(&outcome.last.x),
    })
}

fn state<S: Motions, const N: usize>(starts: &[Vec<f64>]) -> State<S, N> {
    let component = |index: usize| S::new(|motion| starts[motion][index]);
    State {
        t: S::zero(),
        q: SVector::from_fn(|i, _| component(i)),
        v: SVector::from_fn(|i, _| component(N + i)),
    }
}

fn rows<S: Motions, const N: usize>(phase: &Phase<S, N>) -> Vec<Vec<f64>> {
    let row = |motion| {
        let components = phase.q.iter().chain(phase.v.iter());
        components
            .map(|component| component.number(motion))
            .collect()
    };
    (0..S::COUNT).map(row).collect()
}

/// In double-double, so that what rounds is the state alone.
fn energy<const N: usize, M: Lagrangian<N, DoubleDouble>>(model: &M, row: &[f64]) -> DoubleDouble {
    model.energy(&state::<DoubleDouble, N>(&[row.to_vec()]))
}

fn drift<const N: usize, M: Lagrangian<N, DoubleDouble>>(
    model: &M,
    row: &[f64],
    initial: DoubleDouble,
) -> f64 {
    ((energy(model, row) - initial) / initial).to_f64()
}

/// All starts, as many at once as there are lanes, on two threads.
fn energy_errors<const N: usize, M: Contestant<N>>(
    model: &M,
    question: &EnergyErrors,
) -> Result<Vec<Vec<f64>>, String> {
    let chunks: Vec<&[Vec<f64>]> = question.starts.chunks_exact(LANES).collect();
    let halves = chunks.chunks(chunks.len().div_ceil(2).max(1));
    let mut errors = vec![Vec::new(); question.times.len()];
    thread::scope(|scope| {
        let threads: Vec<_> = halves
            .map(|half| {
                scope.spawn(move || {
                    let errors = half
                        .iter()
                        .map(|starts| together(model, starts, &question.times));
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
fn together<const N: usize, M: Contestant<N>>(
    model: &M,
    starts: &[Vec<f64>],
    times: &[f64],
) -> Result<Vec<Vec<f64>>, String> {
    let initial: Vec<_> = starts.iter().map(|row| energy(model, row)).collect();
    let driver = Taylor::new().driver().max_steps(u64::MAX);
    let dynamics = Lagrangian::<N, Lanes<LANES>>::dynamics(model);
    let trajectory = driver
        .sample(&dynamics, state::<Lanes<LANES>, N>(starts), times)
        .map_err(|error| error.to_string())?;
    let drifts = |phase| {
        let rows = rows(phase);
        let pairs = rows.iter().zip(&initial);
        pairs
            .map(|(row, initial)| drift(model, row, *initial))
            .collect()
    };
    Ok(trajectory
        .samples()
        .iter()
        .map(|sample| drifts(&sample.x))
        .collect())
}
