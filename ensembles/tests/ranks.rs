//! Studies on the ranks of MPI: the same bytes for any number of them, and after the death of one.
#![cfg(feature = "mpi")]

use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::ops::ControlFlow;
use std::path::Path;
use std::process::{self, Command, Stdio};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::thread;
use std::time::Duration;

use lagrangian::prelude::*;
use lagrangian_ensembles::mpi::traits::Communicator as _;
use lagrangian_ensembles::{Folder, Parameter, Progress, Results, Sample, Study, mpi};
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

/// The variables that tell this program to be a rank: its folder, and what happens after some members.
const FOLDER: &str = "LAGRANGIAN_ENSEMBLES_FOLDER";
const EVENT: &str = "LAGRANGIAN_ENSEMBLES_EVENT";

const MEMBERS: usize = 400;

/// The number of members after which it happens: of a rank that dies or panics, or of all ranks.
const AFTER: usize = 25;

/// Computes the study into a folder, on the ranks if this is one. Calls `begins` before each member, and `observer` as
/// the study does.
fn study(
    folder: Folder,
    threads: usize,
    begins: impl Fn() + Sync,
    observer: impl FnMut(&Progress) -> ControlFlow<()> + Send,
) -> Results {
    let starts = Sample::new(MEMBERS, [Parameter::uniform("theta", 0.1, 3.0).unit("rad")]).halton();
    let problem = |theta| {
        begins();
        Problem::new(Pendulum { g: 9.81 }, State::new(0.0, theta, [0.0]))
    };
    let study = Study::new(starts, problem, 5.0, Taylor::new()).chunk(10);
    let study = study.threads(threads).each_member(observer);
    let rows = |motion: &lagrangian_ensembles::Motion<_, Phase<f64, 1>>| [motion.q[0], motion.v[0]];
    study.write(folder, ["end", "speed"], rows).unwrap()
}

/// What a rank does.
fn be_a_rank(folder: &Path) {
    let (universe, _) = mpi::initialize_with_threading(mpi::Threading::Funneled).unwrap();
    let world = universe.world();
    let (rank, event) = (world.rank(), env::var(EVENT).unwrap_or_default());
    let cancels = event == "rank 0 cancels";
    let begun = AtomicUsize::new(0);
    let begins = || {
        // Each problem is made once before the study begins, to compare it with the folder.
        let Some(begun) = begun.fetch_add(1, Ordering::Relaxed).checked_sub(MEMBERS) else {
            return;
        };
        match (&*event, rank) {
            ("rank 1 dies", 1) if begun == AFTER => process::abort(),
            ("rank 1 panics", 1) if begun == AFTER => panic!("of the caller"),
            // All are far from the end then.
            ("rank 0 cancels", _) => thread::sleep(Duration::from_millis(5)),
            _ => (),
        }
    };
    let mut last = Progress::default();
    let observer = |progress: &Progress| {
        assert!(progress.ended > last.ended, "{progress:?} after {last:?}");
        last = *progress;
        if cancels && progress.ended >= AFTER {
            return ControlFlow::Break(());
        }
        ControlFlow::Continue(())
    };
    let results = study(Folder::new(folder).ranks(&world), 2, begins, observer);
    // When a rank returns, the chunks of all ranks are there.
    assert_eq!(results.is_complete(), !cancels);
    // Only rank 0 calls the observer, for the members of all ranks.
    match rank {
        0 if !cancels => assert_eq!(last.ended, last.members),
        0 => assert!((AFTER..last.members).contains(&last.ended), "{last:?}"),
        _ => assert_eq!(last, Progress::default()),
    }
}

/// Runs this test on some ranks; `None` if there is no `mpirun`.
fn on_ranks(ranks: usize, folder: &Path, event: &str) -> Option<bool> {
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
        .env(EVENT, event)
        .stdout(Stdio::null())
        .stderr(Stdio::null());
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
    let go_on = |_: &Progress| ControlFlow::Continue(());
    study(Folder::new(whole.path()), 1, || (), go_on);
    for ranks in [1, 2, 4] {
        let folder = TempDir::new().unwrap();
        match on_ranks(ranks, folder.path(), "") {
            None => return println!("SKIPPED: there is no mpirun"),
            Some(succeeds) => assert!(succeeds, "{ranks} ranks"),
        }
        assert!(bytes(folder.path()) == bytes(whole.path()), "{ranks} ranks");
    }
    // A rank that dies or panics ends all, and rank 0 stops all if it cancels. Three others continue after the finished
    // chunks.
    for event in ["rank 1 dies", "rank 1 panics", "rank 0 cancels"] {
        let folder = TempDir::new().unwrap();
        let succeeds = on_ranks(4, folder.path(), event);
        assert_eq!(succeeds, Some(event.ends_with("cancels")), "{event}");
        let before = bytes(folder.path()).len();
        let most = if event.ends_with("cancels") { 25 } else { 41 };
        assert!((2..most).contains(&before), "{event}: {before} files");
        assert_eq!(on_ranks(3, folder.path(), ""), Some(true), "{event}");
        assert!(bytes(folder.path()) == bytes(whole.path()), "{event}");
    }
}
