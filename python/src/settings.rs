//! The settings of integrations, from Python.

use pyo3::prelude::*;
use pyo3::types::{PyDict, PyString};

use crate::arrays::Numbers;
use crate::description::Description;
use crate::errors::value_error;
use crate::integrated::Reached;
use crate::method::{Method, Settings};
use crate::request::Law;
use crate::states::States;
use crate::watch::Watch;

/// The start of one motion.
pub(crate) fn start(
    description: &Description,
    q: &Bound<'_, PyAny>,
    v: &Bound<'_, PyAny>,
    t: f64,
) -> PyResult<Reached> {
    let states = States::read(description, [q, v], None, None)?;
    if states.count.is_some() {
        return Err(value_error(format!(
            "q is a list of states: one motion starts at an array of the shape ({},), and `ensemble` integrates many",
            description.coordinates.len()
        )));
    }
    let instant = states.instant(0);
    Ok(Reached {
        t: finite("t", t)?,
        q: instant.q.to_vec(),
        v: instant.v.to_vec(),
    })
}

/// A number that is finite.
pub(crate) fn finite(name: &str, number: f64) -> PyResult<f64> {
    if number.is_finite() {
        Ok(number)
    } else {
        Err(value_error(format!("{name} is {number}")))
    }
}

/// Refuses a setting that is not positive and finite.
fn positive(name: &str, number: Option<f64>) -> PyResult<()> {
    match number {
        Some(number) if !(number > 0.0 && number.is_finite()) => {
            Err(value_error(format!("{name} is positive, not {number}")))
        }
        _ => Ok(()),
    }
}

/// The times of samples: a number of them, a list, or both ends.
pub(crate) fn samples(
    samples: Option<&Bound<'_, PyAny>>,
    t: f64,
    until: f64,
) -> PyResult<Vec<f64>> {
    let Some(samples) = samples else {
        return Ok(spaced(2, t, until));
    };
    if let Ok(count) = samples.extract::<usize>() {
        return if (2..=MAX_SAMPLES).contains(&count) {
            Ok(spaced(count, t, until))
        } else {
            Err(value_error(format!(
                "samples is a number from 2, for both ends, to {MAX_SAMPLES}, not {count}"
            )))
        };
    }
    let read = Numbers::read("samples", samples)?;
    let [_] = *read.shape.as_slice() else {
        return Err(value_error(
            "samples is a number of samples, at least 2, or an array of times",
        ));
    };
    let advances = |from: f64, to: f64| if until < t { to <= from } else { to >= from };
    let mut before = t;
    for time in &read.numbers {
        if !advances(before, *time) || !advances(*time, until) {
            return Err(value_error(format!(
                "samples advance from t={t} to until={until}, but {time} comes after {before}"
            )));
        }
        before = *time;
    }
    Ok(read.numbers)
}

/// More samples find no place in the memory of a computer.
const MAX_SAMPLES: usize = 100_000_000;

/// Equally spaced times with both ends.
fn spaced(count: usize, t: f64, until: f64) -> Vec<f64> {
    #[allow(clippy::cast_precision_loss)] // So many samples have no place.
    let time = |i: usize| match i {
        0 => t,
        i if i + 1 == count => until,
        i => t + (until - t) * (i as f64 / (count - 1) as f64),
    };
    let mut times: Vec<_> = (0..count).map(time).collect();
    times.dedup();
    times
}

/// The method by its name, or the default.
pub(crate) fn method(
    description: &Description,
    name: Option<&str>,
    law: &Law,
    tolerance: Option<f64>,
    step: Option<f64>,
) -> PyResult<Settings> {
    positive("tolerance", tolerance)?;
    positive("step", step)?;
    let is_continuous = matches!(law, Law::Feedback(_));
    let method = match name {
        None if description.has_taylor && !is_continuous => Method::Taylor,
        None | Some("dop853") => Method::Dop853,
        Some("runge_kutta") if step.is_none() => {
            return Err(value_error(
                "runge_kutta has a fixed step: write step=0.001",
            ));
        }
        Some("runge_kutta") => Method::RungeKutta,
        Some("taylor") if !description.has_taylor => {
            return Err(value_error(format!(
                "{} has no Taylor series: write the clause `taylor` in its declaration, or method=\"dop853\"",
                description.name
            )));
        }
        Some("taylor") if is_continuous => {
            return Err(value_error(
                "a function of Python has no Taylor series: write method=\"dop853\", or a period for sampled feedback",
            ));
        }
        Some("taylor") => Method::Taylor,
        Some(other) => {
            return Err(value_error(format!(
                "the method {other} is not known: write \"taylor\", \"dop853\" or \"runge_kutta\""
            )));
        }
    };
    Ok(Settings {
        method,
        tolerance,
        step,
    })
}

/// How the inputs are set.
pub(crate) fn law(
    description: &Description,
    feedback: Option<&Bound<'_, PyAny>>,
    period: Option<f64>,
) -> PyResult<Law> {
    let Some(feedback) = feedback else {
        return match period {
            None => Ok(Law::Held),
            Some(_) => Err(value_error(
                "period is the period of a feedback, which is missing",
            )),
        };
    };
    if description.inputs.is_empty() {
        return Err(value_error(format!(
            "{} has no inputs that a feedback could set: mark fields `#[lagrangian(input)]` in its declaration",
            description.name
        )));
    }
    if !feedback.is_callable() {
        return Err(value_error("feedback is a function of t, q and v"));
    }
    positive("period", period)?;
    let function = feedback.clone().unbind();
    Ok(match period {
        None => Law::Feedback(function),
        Some(period) => Law::Sampled(function, period),
    })
}

/// The events that are recorded, and those that stop; the latter are recorded, too.
pub(crate) fn watch(
    description: &Description,
    record: Option<&Bound<'_, PyAny>>,
    stop: Option<&Bound<'_, PyAny>>,
) -> PyResult<Watch> {
    let count = 2 * description.events.len();
    let (mut recorded, mut stops) = (vec![false; count], vec![false; count]);
    mark(description, "record", record, &mut recorded)?;
    mark(description, "stop", stop, &mut stops)?;
    for (recorded, stops) in recorded.iter_mut().zip(&stops) {
        *recorded |= stops;
    }
    Ok(Watch { recorded, stops })
}

/// Marks events by their names, where they rise in the first half of the list and where they fall in the second half.
fn mark(
    description: &Description,
    setting: &str,
    written: Option<&Bound<'_, PyAny>>,
    marks: &mut [bool],
) -> PyResult<()> {
    let Some(written) = written else {
        return Ok(());
    };
    let names = names(written).map_err(|_| {
        value_error(format!(
            "{setting} is the name of an event, a list of names, or a dict of names and directions"
        ))
    })?;
    let events = description.events;
    for (name, direction) in names {
        let Some(event) = events.iter().position(|event| *event == name) else {
            return Err(value_error(format!(
                "{setting}: {} has no event {name}; its events are {}",
                description.name,
                Description::listed(events)
            )));
        };
        let [rises, falls] = match direction.as_str() {
            "rising" => [true, false],
            "falling" => [false, true],
            "either" => [true, true],
            other => {
                return Err(value_error(format!(
                    "{setting}: the direction of {name} is \"rising\", \"falling\" or \"either\", not {other:?}"
                )));
            }
        };
        for (place, is_marked) in [(event, rises), (event + events.len(), falls)] {
            if let Some(mark) = marks.get_mut(place) {
                *mark |= is_marked;
            }
        }
    }
    Ok(())
}

/// Names of events with their directions.
fn names(written: &Bound<'_, PyAny>) -> PyResult<Vec<(String, String)>> {
    let either = || "either".to_owned();
    if let Ok(directions) = written.cast::<PyDict>() {
        let pairs = directions.iter();
        return pairs
            .map(|(name, direction)| Ok((name.extract()?, direction.extract()?)))
            .collect();
    }
    if let Ok(name) = written.cast::<PyString>() {
        return Ok(vec![(name.extract()?, either())]);
    }
    written
        .try_iter()?
        .map(|name| Ok((name?.extract()?, either())))
        .collect()
}

/// What is said if a model does not have what was checked before.
pub(crate) fn impossible(description: &Description) -> PyErr {
    value_error(format!(
        "{} cannot be integrated in this way",
        description.name
    ))
}
