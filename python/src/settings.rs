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
            "q has more than one row: one motion starts at an array of the shape ({},), and `ensemble` integrates many",
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
        return if count < 2 {
            Err(value_error("samples is at least 2: both ends are sampled"))
        } else {
            Ok(spaced(count, t, until))
        };
    }
    let read = Numbers::read("samples", samples)?;
    let count = read.numbers.len();
    read.of_shape("samples", &[count])
}

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
    let mut names: Vec<(String, String)> = Vec::new();
    if let Ok(directions) = written.cast::<PyDict>() {
        for (name, direction) in directions {
            names.push((name.extract()?, direction.extract()?));
        }
    } else if let Ok(name) = written.cast::<PyString>() {
        names.push((name.extract()?, "either".to_owned()));
    } else {
        for name in written.try_iter()? {
            names.push((name?.extract()?, "either".to_owned()));
        }
    }
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

/// What is said if a model does not have what was checked before.
pub(crate) fn impossible(description: &Description) -> PyErr {
    value_error(format!(
        "{} cannot be integrated in this way",
        description.name
    ))
}
