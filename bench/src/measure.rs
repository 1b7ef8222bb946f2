//! What a model crate does: check that all agree, then measure them in turn.

use std::process::ExitCode;
use std::{env, fs};

use lagrangian::{Lagrangian, OperationCount};

use crate::agreement::difference;
use crate::derived::Derived;
use crate::protocol::{Measurement, Report, Request};
use crate::shared_object::SharedObject;
use crate::stopwatch::{Measured, Stopwatch};

/// The `main` of a model crate: its argument is the path of a [`Request`], and it prints a [`Report`].
pub fn measure<const N: usize, M: Lagrangian<N>>(
    model: &M,
    operations: OperationCount,
) -> ExitCode {
    let report = request().and_then(|request| {
        let ours = Stopwatch::new(Derived::new(model), &request.states);
        let theirs = shared_objects::<N>(&request)?;
        report(&request, operations, Box::new(ours), theirs)
    });
    match report.map(|report| serde_json::to_string(&report)) {
        Ok(Ok(report)) => {
            println!("{report}");
            ExitCode::SUCCESS
        }
        Ok(Err(error)) => failure(&error.to_string()),
        Err(error) => failure(&error),
    }
}

fn failure(error: &str) -> ExitCode {
    eprintln!("{error}");
    ExitCode::FAILURE
}

fn request() -> Result<Request, String> {
    let path = env::args()
        .nth(1)
        .ok_or("the path of a request is missing")?;
    let text = fs::read_to_string(&path).map_err(|error| format!("{path}: {error}"))?;
    serde_json::from_str(&text).map_err(|error| format!("{path}: {error}"))
}

fn shared_objects<const N: usize>(request: &Request) -> Result<Vec<Box<dyn Measured>>, String> {
    let load = |path: &str| -> Result<Box<dyn Measured>, String> {
        let side = SharedObject::<N>::load(path).map_err(|error| format!("{path}: {error}"))?;
        Ok(Box::new(Stopwatch::new(side, &request.states)))
    };
    let libraries = request.libraries.iter();
    libraries.map(|library| load(&library.path)).collect()
}

fn report<'a>(
    request: &Request,
    operations: OperationCount,
    ours: Box<dyn Measured + 'a>,
    theirs: Vec<Box<dyn Measured + 'a>>,
) -> Result<Report, String> {
    let reference = ours.accelerations();
    let agreement = |name: &str, accelerations: &[Vec<f64>]| {
        difference(&reference, accelerations).map_err(|error| {
            format!(
                "{name} and lagrangian disagree on {}: {error}",
                request.model
            )
        })
    };
    let mut differences = vec![("lagrangian", 0.0)];
    for (library, side) in request.libraries.iter().zip(&theirs) {
        let name = library.name.as_str();
        differences.push((name, agreement(name, &side.accelerations())?));
    }
    let mut elsewhere = Vec::new();
    for answers in &request.answers {
        let difference = agreement(&answers.name, &answers.accelerations)?;
        elsewhere.push(measurement(&answers.name, None, difference));
    }
    let mut sides = vec![ours];
    sides.extend(theirs);
    for _ in 0..request.rounds {
        for side in &mut sides {
            side.round();
        }
    }
    let measured = differences.iter().zip(&sides);
    let measurements = measured
        .map(|((name, difference), side)| measurement(name, Some(side.fastest()), *difference))
        .chain(elsewhere)
        .collect();
    let operations = operations.into();
    Ok(Report {
        operations,
        measurements,
    })
}

fn measurement(name: &str, fastest: Option<(f64, f64)>, difference: f64) -> Measurement {
    Measurement {
        name: name.to_owned(),
        throughput: fastest.map(|fastest| fastest.0),
        latency: fastest.map(|fastest| fastest.1),
        difference,
    }
}
