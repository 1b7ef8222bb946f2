//! Studies on the ranks of MPI: the same bytes for any number of them, and after the death of one.
#![cfg(feature = "mpi")]

use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::path::Path;
use std::process::{self, Command, Stdio};

use lagrangian::prelude::*;
use lagrangian_ensembles::mpi::traits::Communicator as _;
use lagrangian_ensembles::{Folder, Parameter, Results, Sample, Study, mpi};
use tempfile::TempDir;

#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(theta),
    kinetic = 0.5 * dot(theta).powi(2),
    potential = -g * cos(theta),
)]
struct Pendulum {
    g: f64,
}

/// The variables that tell this program to be a rank: its folder, and after how many members rank 1 dies.
const FOLDER: &str = "LAGRANGIAN_ENSEMBLES_FOLDER";
const DIES: &str = "LAGRANGIAN_ENSEMBLES_DIES";

/// Computes the study into a folder, on the ranks if this is one.
fn study(folder: Folder, threads: usize, ended: impl Fn(usize) + Sync) -> Results {
    let starts = Sample::new(400, [Parameter::uniform("theta", 0.1, 3.0).unit("rad")]).halton();
    let problem = |theta| Problem::new(Pendulum { g: 9.81 }, State::new(0.0, theta, [0.0]));
    let study = Study::new(starts, problem, 5.0, Taylor::new())
        .chunk(10)
        .threads(threads);
    let study = study.each_member(|progress| ended(progress.ended));
    study
        .write(folder, ["end", "speed"], |motion| {
            [motion.q[0], motion.v[0]]
        })
        .unwrap()
}

/// What a rank does.
fn be_a_rank(folder: &Path) {
    let universe = mpi::initialize().unwrap();
    let world = universe.world();
    let dies: usize = env::var(DIES).map_or(usize::MAX, |count| count.parse().unwrap());
    let rank = world.rank();
    let ranks = Folder::new(folder).ranks(&world);
    let ended = move |count| {
        if rank == 1 && count >= dies {
            process::abort();
        }
    };
    let results = study(ranks, 2, ended);
    // All chunks are there when a rank returns, those of the others, too.
    assert!(results.is_complete());
}

/// Runs this test on some ranks; `None` if there is no `mpirun`.
fn on_ranks(ranks: usize, folder: &Path, dies: Option<usize>) -> Option<bool> {
    let mut command = Command::new("mpirun");
    command
        .args([
            "--allow-run-as-root",
            "--oversubscribe",
            "-n",
            &ranks.to_string(),
        ])
        .arg(env::current_exe().unwrap())
        .args(["--exact", "the_same_bytes_for_any_number_of_ranks"])
        .env(FOLDER, folder)
        .stdout(Stdio::null())
        .stderr(Stdio::null());
    if let Some(count) = dies {
        command.env(DIES, count.to_string());
    }
    command.status().ok().map(|status| status.success())
}

/// The bytes of all files of a folder but those that were never finished.
fn bytes(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let files = fs::read_dir(folder).unwrap().map(Result::unwrap);
    files
        .map(|file| (file.file_name().into_string().unwrap(), file.path()))
        .filter(|(name, _)| !name.starts_with(".unfinished-"))
        .map(|(name, path)| (name, fs::read(path).unwrap()))
        .collect()
}

#[test]
fn the_same_bytes_for_any_number_of_ranks() {
    if let Some(folder) = env::var_os(FOLDER) {
        be_a_rank(Path::new(&folder));
        return;
    }
    let whole = TempDir::new().unwrap();
    study(Folder::new(whole.path()), 1, |_| ());
    for ranks in [1, 2, 4] {
        let folder = TempDir::new().unwrap();
        match on_ranks(ranks, folder.path(), None) {
            None => return println!("SKIPPED: there is no mpirun"),
            Some(succeeds) => assert!(succeeds, "{ranks} ranks"),
        }
        assert!(bytes(folder.path()) == bytes(whole.path()), "{ranks} ranks");
    }
    // A rank that dies ends all; three others go on behind the finished chunks.
    let folder = TempDir::new().unwrap();
    assert_eq!(on_ranks(4, folder.path(), Some(25)), Some(false));
    let before = bytes(folder.path()).len();
    assert!((2..41).contains(&before), "{before} files");
    assert_eq!(on_ranks(3, folder.path(), None), Some(true));
    assert!(bytes(folder.path()) == bytes(whole.path()));
}
