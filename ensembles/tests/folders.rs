//! Studies in folders: interrupted, shared among processes, damaged, confused.
#![cfg(feature = "parquet")]

use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::ops::ControlFlow;
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread;
use std::time::Duration;

use lagrangian::prelude::*;
use lagrangian_ensembles::{Axis, Error, Folder, Grid, Parameter, Results, Sample, Shard, Study};
use tempfile::TempDir;

#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(theta),
    kinetic = 0.5 * dot(theta).powi(2),
    potential = -g * cos(theta),
    event(bottom = theta),
)]
struct Pendulum {
    g: f64,
}

const MEMBERS: usize = 500;
const COLUMNS: [&str; 2] = ["t", "v"];

/// A study whose members pass the bottom once each, except for one that fails.
macro_rules! study {
    ($seed:expr, $g:expr) => {
        study!($seed, $g, 1e-12)
    };
    ($seed:expr, $g:expr, $tolerance:expr) => {{
        let parameter = Parameter::uniform("theta", 0.1, 3.0).unit("rad");
        let starts = Sample::new(MEMBERS, [parameter])
            .latin_hypercube()
            .seed($seed);
        let problem = |[theta]: [f64; 1]| {
            let theta = if theta > 2.995 { f64::NAN } else { theta };
            Problem::new(Pendulum { g: $g }, State::new(0.0, [theta], [0.0]))
                .on(Pendulum::BOTTOM)
                .stop()
        };
        let method = Taylor::new().relative_tolerance($tolerance);
        Study::new(starts, problem, 10.0, method)
            .chunk(37)
            .metadata("g", "9.81 m/s²")
    }};
}

/// The rows of a motion.
macro_rules! row {
    () => {
        |motion| [motion.t, motion.v[0]]
    };
}

fn folder() -> TempDir {
    TempDir::new().unwrap()
}

/// The bytes of all files of a folder.
fn bytes(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let files = fs::read_dir(folder).unwrap().map(Result::unwrap);
    files
        .map(|file| {
            (
                file.file_name().into_string().unwrap(),
                fs::read(file.path()).unwrap(),
            )
        })
        .collect()
}

#[test]
fn a_folder_contains_what_a_table_contains() {
    let folder = folder();
    let study = study!(1, 9.81);
    let results = study.write(folder.path(), COLUMNS, row!()).unwrap();
    assert!(results.is_complete());
    assert_eq!(results.finished(), MEMBERS);
    let table = study.table(COLUMNS, row!()).unwrap();
    let read = results.table().unwrap();
    assert_eq!(read.members(), table.members());
    assert_eq!(format!("{read:?}"), format!("{table:?}"));
    assert_eq!(table.failures().len(), 1);
    assert_eq!(read.failures(), table.failures());
    let summaries = [
        results.summary().unwrap(),
        study.summary(COLUMNS, row!()).unwrap(),
    ];
    assert_eq!(format!("{:?}", summaries[0]), format!("{:?}", summaries[1]));
}

/// One member of a `Vec`, of which no description tells.
#[test]
fn a_folder_of_other_points() {
    let folder = folder();
    let write = |points: Vec<f64>| {
        let problem = |theta| Problem::new(Pendulum { g: 9.81 }, State::new(0.0, [theta], [0.0]));
        let study = Study::new(points, problem, 1.0, Taylor::new());
        study.write(folder.path(), ["end"], |motion| [motion.q[0]])
    };
    let points: Vec<f64> = (0..50).map(|n| 0.01 * f64::from(n)).collect();
    write(points.clone()).unwrap();
    write(points.clone()).unwrap();
    let mut others = points;
    others[17] += 1e-9;
    let complaint = write(others).unwrap_err().to_string();
    assert!(
        complaint.contains("the fingerprint of parameters, initial states and ends: "),
        "{complaint}"
    );
}

#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = 0.5 * (x.powi(2) + y.powi(2)) + k * (x - y).powi(4),
    dissipation = 0.5 * c * dot(x).powi(2),
)]
struct Coupled {
    k: f64,
    c: f64,
}

/// Motions that begin at rest, in a symmetric state: the derivative there depends neither on the damping nor on the
/// coupling.
#[test]
fn a_folder_of_other_parameters_without_effect_at_the_start() {
    let folder = folder();
    let write = |k: f64, c: f64| {
        let problem = |x| Problem::new(Coupled { k, c }, State::new(0.0, [x, x], [0.0; 2]));
        let study = Study::new(vec![0.1, 0.2], problem, 1.0, Taylor::new());
        study.write(folder.path(), ["end"], |motion| [motion.q[0]])
    };
    write(1.0, 0.1).unwrap();
    write(1.0, 0.1).unwrap();
    for (k, c) in [(1.0, 0.2), (1.1, 0.1)] {
        let complaint = write(k, c).unwrap_err().to_string();
        assert!(complaint.contains("the fingerprint of "), "{complaint}");
    }
}

/// Shards of different studies are no study.
#[test]
fn folders_of_two_studies() {
    let folders = [folder(), folder()];
    for (seed, folder) in (1..).zip(&folders) {
        study!(seed, 9.81)
            .write(folder.path(), COLUMNS, row!())
            .unwrap();
    }
    let complaint = Results::open(&folders).unwrap_err().to_string();
    assert!(
        complaint.contains("another study than")
            && complaint.contains("name the folders of one study"),
        "{complaint}"
    );
}

/// Ends are functions, of which no description tells.
#[test]
fn a_folder_of_other_ends() {
    let folder = folder();
    let write = |longer: f64| {
        let problem = |theta| Problem::new(Pendulum { g: 9.81 }, State::new(0.0, theta, [0.0]));
        let starts = Grid::new([Axis::linear("theta", 0.1, 0.2, 9)]);
        let end = |[theta]: [f64; 1]| theta + longer;
        let study = Study::new(starts, problem, end, Taylor::new());
        study.write(folder.path(), ["end"], |motion| [motion.t])
    };
    let ends = write(1.0).unwrap().table().unwrap();
    assert!((ends.column("end").unwrap()[8] - 1.2).abs() < 1e-15);
    let complaint = write(1.1).unwrap_err().to_string();
    assert!(
        complaint.contains("the fingerprint of parameters, initial states and ends: "),
        "{complaint}"
    );
}

/// Members without rows are members.
#[test]
fn members_without_rows() {
    let folder = folder();
    let problem = |index: usize| {
        #[allow(clippy::cast_precision_loss)]
        let speed = index as f64;
        Problem::new(Pendulum { g: 9.81 }, State::new(0.0, [0.1], [speed]))
    };
    let study = Study::new(0..100, problem, 0.1, Taylor::new()).chunk(9);
    let rows = |motion: &lagrangian_ensembles::Motion<usize, _>| match motion.index % 3 {
        0 => vec![[1.0]],
        _ => Vec::new(),
    };
    let results = study.write(folder.path(), ["a"], rows).unwrap();
    let summaries = [
        results.summary().unwrap(),
        study.summary(["a"], rows).unwrap(),
    ];
    assert_eq!(summaries.map(|summary| summary.members()), [100, 100]);
    assert_eq!(results.table().unwrap().finished(), 100);
    assert_eq!(results.table().unwrap().members().len(), 34);
}

#[test]
fn an_interrupted_study_goes_on() {
    let [whole, interrupted] = [folder(), folder()];
    study!(1, 9.81)
        .write(whole.path(), COLUMNS, row!())
        .unwrap();
    let mut runs = 0;
    loop {
        let mut ended = 0;
        let study = study!(1, 9.81).threads(2).each_member(|progress| {
            ended = progress.ended;
            if ended < 150 {
                ControlFlow::Continue(())
            } else {
                ControlFlow::Break(())
            }
        });
        let results = study.write(interrupted.path(), COLUMNS, row!()).unwrap();
        runs += 1;
        if results.is_complete() {
            break;
        }
    }
    assert!((4..=6).contains(&runs), "{runs}");
    assert_eq!(bytes(whole.path()), bytes(interrupted.path()));
}

#[test]
fn shards_are_the_whole() {
    let [whole, together, first, others] = std::array::from_fn(|_| folder());
    study!(1, 9.81)
        .write(whole.path(), COLUMNS, row!())
        .unwrap();
    for k in 1..=3 {
        let shard = Shard::new(k, 3).unwrap();
        let shards = [
            together.path(),
            if k == 1 { first.path() } else { others.path() },
        ];
        for path in shards {
            let results = study!(1, 9.81)
                .write(Folder::new(path).shard(shard), COLUMNS, row!())
                .unwrap();
            assert_eq!(results.is_complete(), k == 3 && path == together.path());
        }
    }
    assert_eq!(bytes(whole.path()), bytes(together.path()));

    let files = folder();
    let [one, other] = ["one.parquet", "other.parquet"].map(|name| files.path().join(name));
    Results::open([whole.path()])
        .unwrap()
        .merge_into(&one)
        .unwrap();
    Results::open([first.path(), others.path()])
        .unwrap()
        .merge_into(&other)
        .unwrap();
    assert_eq!(fs::read(one).unwrap(), fs::read(other).unwrap());

    let incomplete = Results::open([first.path()]).unwrap();
    let complaint = incomplete
        .merge_into(files.path().join("none"))
        .unwrap_err()
        .to_string();
    let expected = "9 of 14 chunks are missing, the first is chunk-000001.parquet: run the study again, or name the folders of all shards";
    assert!(complaint.ends_with(expected), "{complaint}");
}

/// The variable that tells this program to be the process that is ended.
const VICTIM: &str = "LAGRANGIAN_ENSEMBLES_VICTIM";

#[test]
fn a_process_that_is_ended_leaves_finished_chunks() {
    if let Some(folder) = env::var_os(VICTIM) {
        let study = study!(1, 9.81).each_member(|_| thread::sleep(Duration::from_millis(2)));
        study.write(Path::new(&folder), COLUMNS, row!()).unwrap();
        return;
    }
    let [whole, interrupted] = [folder(), folder()];
    study!(1, 9.81)
        .write(whole.path(), COLUMNS, row!())
        .unwrap();
    let mut victim = Command::new(env::current_exe().unwrap())
        .args(["--exact", "a_process_that_is_ended_leaves_finished_chunks"])
        .env(VICTIM, interrupted.path())
        .stdout(Stdio::null())
        .spawn()
        .unwrap();
    while fs::read_dir(interrupted.path()).unwrap().count() < 5 {
        assert!(
            victim.try_wait().unwrap().is_none(),
            "it has ended by itself"
        );
        thread::sleep(Duration::from_millis(1));
    }
    victim.kill().unwrap();
    victim.wait().unwrap();
    let before = Results::open([interrupted.path()]).unwrap().finished();
    assert!((1..MEMBERS).contains(&before), "{before}");

    let mut computed = 0;
    let study = study!(1, 9.81).each_member(|progress| computed = progress.ended);
    study.write(interrupted.path(), COLUMNS, row!()).unwrap();
    drop(study);
    assert_eq!(computed, MEMBERS - before);
    let mut found = bytes(interrupted.path());
    found.retain(|name, _| !name.starts_with(".unfinished-"));
    assert_eq!(bytes(whole.path()), found);
}

#[test]
fn folders_of_other_studies() {
    let folder = folder();
    study!(1, 9.81)
        .write(folder.path(), COLUMNS, row!())
        .unwrap();
    let before = bytes(folder.path());
    let complain = |result: Result<Results, Error>| {
        let complaint = result.unwrap_err().to_string();
        assert!(
            complaint.contains("choose another folder, or remove this one to compute all anew"),
            "{complaint}"
        );
        complaint
    };
    let path = folder.path();
    let seed = complain(study!(2, 9.81).write(path, COLUMNS, row!()));
    assert!(
        seed.contains("the points: \"Latin hypercube of 500, seed 1: "),
        "{seed}"
    );
    let parameter = complain(study!(1, 9.8).write(path, COLUMNS, row!()));
    assert!(
        parameter.contains("the fingerprint of parameters, initial states and ends: "),
        "{parameter}"
    );
    let method = complain(study!(1, 9.81, 1e-9).write(path, COLUMNS, row!()));
    assert!(method.contains("the method: \"Taylor"), "{method}");
    let column = complain(study!(1, 9.81).write(path, ["t", "speed"], row!()));
    assert!(column.contains("the columns: "), "{column}");
    let chunk = complain(study!(1, 9.81).chunk(40).write(path, COLUMNS, row!()));
    assert!(
        chunk.contains("the number of members in a chunk: 37 there, 40 in this study"),
        "{chunk}"
    );
    let metadata = complain(
        study!(1, 9.81)
            .metadata("by", "us")
            .write(path, COLUMNS, row!()),
    );
    assert!(metadata.contains("the metadata: "), "{metadata}");
    // A version that does not exist.
    let manifest = path.join("_manifest.json");
    let text = fs::read_to_string(&manifest).unwrap();
    let version = format!("\"lagrangian\": \"{}\"", env!("CARGO_PKG_VERSION"));
    fs::write(
        &manifest,
        text.replace(&version, "\"lagrangian\": \"0.0.9\""),
    )
    .unwrap();
    let version = complain(study!(1, 9.81).write(path, COLUMNS, row!()));
    assert!(
        version.contains("the version of lagrangian: \"0.0.9\" there"),
        "{version}"
    );
    fs::write(&manifest, &text[..100]).unwrap();
    let broken = study!(1, 9.81)
        .write(path, COLUMNS, row!())
        .unwrap_err()
        .to_string();
    assert!(
        broken.contains("_manifest.json could not be read"),
        "{broken}"
    );
    // Nothing was lost.
    fs::write(&manifest, text).unwrap();
    assert_eq!(bytes(path), before);
}

#[test]
fn folders_of_something_else() {
    let folder = folder();
    fs::write(folder.path().join("letter.txt"), "dear").unwrap();
    let complaint = study!(1, 9.81)
        .write(folder.path(), COLUMNS, row!())
        .unwrap_err()
        .to_string();
    assert!(complaint.ends_with("it exists and has no _manifest.json, so it is not of a study; choose another folder, or an empty one"));
    let complaint = Results::open([folder.path()]).unwrap_err().to_string();
    assert!(
        complaint.ends_with("it has no _manifest.json: it does not contain the results of a study"),
        "{complaint}"
    );
    let file = folder.path().join("letter.txt");
    let complaint = study!(1, 9.81)
        .write(&*file, COLUMNS, row!())
        .unwrap_err()
        .to_string();
    assert!(
        complaint.contains("letter.txt could not be created: "),
        "{complaint}"
    );
    let nowhere = study!(1, 9.81)
        .table(COLUMNS, row!())
        .unwrap()
        .write_parquet(file.join("a.parquet"));
    assert!(
        nowhere
            .unwrap_err()
            .to_string()
            .contains("a.parquet could not be written: ")
    );
}

#[test]
fn truncated_files() {
    let folder = folder();
    study!(1, 9.81)
        .write(folder.path(), COLUMNS, row!())
        .unwrap();
    let before = bytes(folder.path());
    let path = folder.path().join("chunk-000003.parquet");
    let whole = fs::read(&path).unwrap();
    for length in [0, 4, whole.len() / 2, whole.len() - 1] {
        fs::write(&path, &whole[..length]).unwrap();
        let complaint = study!(1, 9.81)
            .write(folder.path(), COLUMNS, row!())
            .unwrap_err()
            .to_string();
        assert!(
            complaint.contains(
                "chunk-000003.parquet could not be read: it is truncated or not a Parquet file"
            ),
            "{complaint}"
        );
        assert!(
            complaint
                .ends_with("remove it, and run the study again, which computes this chunk anew"),
            "{complaint}"
        );
    }
    fs::remove_file(&path).unwrap();
    study!(1, 9.81)
        .write(folder.path(), COLUMNS, row!())
        .unwrap();
    assert_eq!(bytes(folder.path()), before);
}
