//! What a model crate does: check that all agree, then measure them in turn.

use std::process::ExitCode;
use std::{env, fs, iter};

use lagrangian::{Lagrangian, OperationCount};

use crate::agreement::difference;
use crate::derived::{Derived, InverseDynamics};
use crate::protocol::{Measurement, Report, Request};
use crate::rounding::rounding;
use crate::shared_object::SharedObject;
use crate::stopwatch::{Measured, Stopwatch};

/// The `main` of a model crate: its argument is the path of a [`Request`], and it prints a [`Report`].
pub fn measure<const N: usize, M: Lagrangian<N>>(
    model: &M,
    operations: OperationCount,
) -> ExitCode {
    answer(request().and_then(|request| measured(model, operations, &request)))
}

/// The same, with rounding errors.
pub fn measure_with_rounding<const N: usize, M: Lagrangian<N> + Lagrangian<N, f32>>(
    model: &M,
    operations: OperationCount,
) -> ExitCode {
    answer(request().and_then(|request| {
        let report = measured(model, operations, &request)?;
        Ok(Report {
            rounding: Some(rounding(model, &request.states)),
            ..report
        })
    }))
}

/// The `main` of a model crate of which inverse dynamics is measured, too: where the states of the request have accelerations.
pub fn measure_dynamics<const N: usize, M: Lagrangian<N>>(
    model: &M,
    [accelerations, inverse_dynamics]: [OperationCount; 2],
) -> ExitCode {
    answer(request().and_then(|request| {
        let has_accelerations = request.states.iter().any(|row| row.len() > 2 * N);
        if !has_accelerations {
            return measured(model, accelerations, &request);
        }
        let ours = Stopwatch::new(InverseDynamics::new(model), &request.states);
        let mut sides: Vec<Box<dyn Measured + '_>> = vec![Box::new(ours)];
        sides.extend(shared_objects::<N, 3>(&request)?);
        report(&request, inverse_dynamics, sides)
    }))
}

fn measured<const N: usize, M: Lagrangian<N>>(
    model: &M,
    operations: OperationCount,
    request: &Request,
) -> Result<Report, String> {
    let ours = Stopwatch::new(Derived::new(model), &request.states);
    let mut sides: Vec<Box<dyn Measured + '_>> = vec![Box::new(ours)];
    sides.extend(shared_objects::<N, 2>(request)?);
    report(request, operations, sides)
}

fn answer(report: Result<Report, String>) -> ExitCode {
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

fn shared_objects<const N: usize, const K: usize>(
    request: &Request,
) -> Result<Vec<Box<dyn Measured>>, String> {
    let load = |path: &str| -> Result<Box<dyn Measured>, String> {
        let side = SharedObject::<N, K>::load(path).map_err(|error| format!("{path}: {error}"))?;
        Ok(Box::new(Stopwatch::new(side, &request.states)))
    };
    let libraries = request.libraries.iter();
    libraries.map(|library| load(&library.path)).collect()
}

/// Checks first, then measures.
fn report(
    request: &Request,
    operations: OperationCount,
    mut sides: Vec<Box<dyn Measured + '_>>,
) -> Result<Report, String> {
    let mut measurements = agreements(request, &sides)?;
    for _ in 0..request.rounds {
        for side in &mut sides {
            side.round();
        }
    }
    for (measurement, side) in measurements.iter_mut().zip(&sides) {
        let (throughput, latency) = side.fastest();
        measurement.throughput = Some(throughput);
        measurement.latency = Some(latency);
    }
    Ok(Report {
        operations: operations.into(),
        accelerations: sides[0].accelerations(),
        rounding: None,
        measurements,
    })
}

/// How far each side is from ours, which is the first; after the sides come the answers. An error if any
/// has computed something else.
fn agreements(
    request: &Request,
    sides: &[Box<dyn Measured + '_>],
) -> Result<Vec<Measurement>, String> {
    let names = request
        .libraries
        .iter()
        .map(|library| library.name.as_str());
    let names = iter::once("lagrangian").chain(names);
    let called = names.zip(sides.iter().map(|side| side.accelerations()));
    let answers = request.answers.iter();
    let answers = answers.map(|answers| (answers.name.as_str(), answers.accelerations.clone()));
    let all: Vec<_> = called.chain(answers).collect();
    let (_, ours) = &all[0];
    let compare = |(name, theirs): &(&str, Vec<Vec<f64>>)| {
        let difference = difference(ours, theirs).map_err(|error| {
            let model = &request.model;
            format!("`{name}` and `lagrangian` disagree on {model}: {error}")
        })?;
        Ok(Measurement {
            name: (*name).to_owned(),
            throughput: None,
            latency: None,
            difference,
        })
    };
    all.iter().map(compare).collect()
}
