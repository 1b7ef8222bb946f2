//! Disks that are full, or become full on the way: the error names the file, and what was finished is kept.
#![cfg(all(feature = "parquet", target_os = "linux"))]

use std::collections::BTreeMap;
use std::env;
use std::fs;
use std::path::Path;
use std::process::{Command, Stdio};

use lagrangian::prelude::*;
use lagrangian_ensembles::{Error, Results, Study};
use tempfile::TempDir;

#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
struct Mass {
    m: f64,
}

const MEMBERS: usize = 100;

/// The chunk for whose file there is no space.
const LARGE: usize = 7;

/// A study in chunks of ten members, all of which but one are small.
#[allow(clippy::cast_precision_loss)] // Indices are small.
fn write(folder: &Path) -> Result<Results, Error> {
    let problem = |_| Problem::new(Mass { m: 1.0 }, State::new(0.0, [0.0], [1.0]));
    let study = Study::new(0..MEMBERS, problem, 1.0, Taylor::new())
        .chunk(10)
        .threads(1);
    study.write(folder, ["x"], |motion| {
        let rows = if motion.index / 10 == LARGE { 2000 } else { 1 };
        // Numbers that cannot be compressed.
        let row = |row: usize| [(motion.index as f64 + 1.0).sqrt() / (row as f64 + 1.0)];
        (0..rows).map(row).collect::<Vec<_>>()
    })
}

/// The bytes of all files of a folder.
fn bytes(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let files = fs::read_dir(folder).unwrap().map(Result::unwrap);
    let file = |file: fs::DirEntry| {
        let name = file.file_name().into_string().unwrap();
        (name, fs::read(file.path()).unwrap())
    };
    files.map(file).collect()
}

/// The variable that tells this program to be the process without space.
const FOLDER: &str = "LAGRANGIAN_ENSEMBLES_FULL";

/// The shell limits the length of the files of the process, which then are as if the disk were full: beyond it, writing is
/// an error once the signal that would end the process is ignored.
#[test]
fn a_disk_that_becomes_full_keeps_finished_chunks() {
    if let Some(folder) = env::var_os(FOLDER) {
        let complaint = write(Path::new(&folder)).unwrap_err().to_string();
        assert!(
            complaint.contains("chunk-000007.parquet could not be written: ")
                && complaint.contains("File too large"),
            "{complaint}"
        );
        return;
    }
    let [whole, full] = [TempDir::new().unwrap(), TempDir::new().unwrap()];
    write(whole.path()).unwrap();
    let status = Command::new("sh")
        .args(["-c", "trap '' XFSZ; ulimit -f 32; exec \"$0\" \"$@\""])
        .arg(env::current_exe().unwrap())
        .args(["--exact", "a_disk_that_becomes_full_keeps_finished_chunks"])
        .env(FOLDER, full.path())
        .stdout(Stdio::null())
        .status()
        .unwrap();
    assert!(status.success());
    // Lanes begin some members of the next chunk before the large one has ended.
    let finished = Results::open([full.path()]).unwrap().finished();
    assert!((70..MEMBERS - 10).contains(&finished), "{finished}");
    assert!(bytes(full.path()).keys().all(|name| !name.starts_with('.')));
    // With space again, it goes on.
    write(full.path()).unwrap();
    assert_eq!(bytes(full.path()), bytes(whole.path()));
}

/// Files where there can be none.
#[test]
fn tables_without_space() {
    let problem = |_| Problem::new(Mass { m: 1.0 }, State::new(0.0, [0.0], [1.0]));
    let study = Study::new(0..3, problem, 1.0, Taylor::new());
    let table = study.table(["x"], |motion| [motion.q[0]]).unwrap();
    let complaint = table
        .write_parquet("/proc/a.parquet")
        .unwrap_err()
        .to_string();
    assert!(
        complaint.starts_with("/proc/a.parquet could not be written: "),
        "{complaint}"
    );
    #[cfg(feature = "csv")]
    {
        let complaint = table.write_csv("/dev/full").unwrap_err().to_string();
        assert!(
            complaint.starts_with("/dev/full could not be written: No space left on device"),
            "{complaint}"
        );
    }
}
