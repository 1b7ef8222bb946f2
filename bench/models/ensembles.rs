
use std::process::ExitCode;
use std::time::Instant;

use lagrangian::{EquationsOfMotion, InLanes, Partial};
use lagrangian_bench::{
    Integrated, Integration, Question, Throughput, answer, answer_questions, fewest_seconds,
};
use lagrangian_ensembles::Study;

type Start = State<f64, DEGREES>;
type End = Phase<f64, DEGREES>;
type Found<K> = Result<Solution<f64, End, K>, Partial<Solution<f64, End, K>>>;

/// What is found of an ensemble: final states in the order of the members, and sums over all of them.
struct Ends {
    states: Vec<End>,
    steps: u64,
    events: u64,
    failure: Option<String>,
}

impl Ends {
    fn put<K>(&mut self, index: usize, found: Found<K>) {
        match found {
            Ok(solution) => {
                self.steps += solution.statistics.steps;
                self.events += solution.events().len() as u64;
                self.states[index] = solution.last.x;
            }
            Err(partial) => self.failure = Some(partial.to_string()),
        }
    }
}

/// Integrates an ensemble as a user would: without events, with one that is recorded, with one that never occurs, or
/// without events by a study on two threads.
fn ends<'a, const LANES: usize, const HALF: usize>(
    method: Taylor<HALF>,
    model: &'a Model,
    starts: &[Start],
    (end, events): (f64, Option<&str>),
) -> Result<Ends, String>
where
    EquationsOfMotion<&'a Model, f64, DEGREES>: InLanes<LANES, State = End>,
{
    let nowhere = End::new([0.0; DEGREES], [0.0; DEGREES]);
    let mut ends = Ends { states: vec![nowhere; starts.len()], steps: 0, events: 0, failure: None };
    let problem = |start: &Start| Problem::new(model, *start);
    match events {
        None => {
            let problems = starts.iter().map(problem);
            Ensemble::new(problems).lanes::<LANES>().solve_each(end, method, |index, found| ends.put(index, found));
        }
        Some("recorded event") => {
            let problems = starts.iter().map(|start| problem(start).on(Model::OFTEN).record());
            Ensemble::new(problems).lanes::<LANES>().solve_each(end, method, |index, found| ends.put(index, found));
        }
        Some("absent event") => {
            let problems = starts.iter().map(|start| problem(start).on(Model::NEVER).record());
            Ensemble::new(problems).lanes::<LANES>().solve_each(end, method, |index, found| ends.put(index, found));
        }
        Some("two threads") => {
            let problem = |start| Problem::new(model, start);
            let study = Study::new(starts, problem, end, method).lanes::<LANES>().threads(2);
            for motion in study.solve().map_err(|error| error.to_string())? {
                match motion {
                    Ok(motion) => ends.put(motion.index, Ok(motion.solution)),
                    Err(failure) => ends.put(failure.index, Err(failure.partial)),
                }
            }
        }
        Some(other) => return Err(format!("there is no `{other}`")),
    }
    match ends.failure {
        Some(failure) => Err(failure),
        None => Ok(ends),
    }
}

/// By the method of a name such as `Taylor 16, 4 lanes, recorded event`.
fn integrated(model: &Model, integration: &Integration, starts: &[Start]) -> Result<Ends, String> {
    let mut words = integration.method.splitn(3, ", ");
    let (order, lanes, events) = (words.next(), words.next(), words.next());
    let wanted = (integration.end, events);
    macro_rules! by {
        ($method:expr) => {{
            let mut method = $method;
            if let Some(tolerance) = integration.tolerance {
                method = method.relative_tolerance(tolerance).absolute_tolerance(tolerance);
            }
            match lanes {
                Some("4 lanes") => ends::<4, _>(method, model, starts, wanted),
                Some("8 lanes") => ends::<8, _>(method, model, starts, wanted),
                _ => Err(format!("there is no method `{}`", integration.method)),
            }
        }};
    }
    match order {
        Some("Taylor 12") => by!(Taylor::order_12()),
        Some("Taylor 16") => by!(Taylor::order_16()),
        Some("Taylor 20") => by!(Taylor::<10>::of_half_order()),
        Some("Taylor") => by!(Taylor::new()),
        _ => Err(format!("there is no method `{}`", integration.method)),
    }
}

fn starts(integration: &Integration) -> Vec<Start> {
    let start = |row: &Vec<f64>| {
        let (q, v) = row.split_at(DEGREES);
        State::new(0.0, SVector::from_fn(|i, _| q[i]), SVector::from_fn(|i, _| v[i]))
    };
    integration.starts.iter().map(start).collect()
}

/// The fewest seconds of CPU time of the thread for an ensemble.
fn timed(model: &Model, integration: &Integration) -> Result<Integrated, String> {
    let starts = starts(integration);
    let (ends, seconds) =
        fewest_seconds(integration.at_least, || integrated(model, integration, &starts))?;
    let row = |x: &End| x.q.iter().chain(x.v.iter()).copied().collect();
    Ok(Integrated {
        seconds,
        steps: ends.steps,
        events: ends.events,
        states: ends.states.iter().map(row).collect(),
    })
}

/// Members a second by the clock: whole ensembles, one after the other, until so many seconds have passed.
fn throughput(model: &Model, question: &Throughput) -> Result<f64, String> {
    let Throughput { integration, seconds } = question;
    let starts = starts(integration);
    let (begin, mut ensembles) = (Instant::now(), 0.0);
    loop {
        integrated(model, integration, &starts)?;
        ensembles += 1.0;
        let passed = begin.elapsed().as_secs_f64();
        if passed >= *seconds {
            return Ok(ensembles * starts.len() as f64 / passed);
        }
    }
}

/// Answers questions until there are no more.
fn contest(model: &Model) -> ExitCode {
    answer_questions(|question| match question {
        Question::Integrate(integration) => answer(&timed(model, &integration)?),
        Question::Throughput(question) => answer(&throughput(model, &question)?),
        _ => Err("ensembles alone".to_owned()),
    })
}
