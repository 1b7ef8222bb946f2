//! Merges the results of a study, in its folder or in those of its shards, into one Parquet file.

use std::env;
use std::process::ExitCode;

use lagrangian_ensembles::{Error, Results};

fn main() -> ExitCode {
    let mut arguments = env::args().skip(1);
    let (Some(whole), folders) = (arguments.next(), arguments.collect::<Vec<_>>()) else {
        return usage();
    };
    if folders.is_empty() || whole.starts_with('-') {
        return usage();
    }
    match merge(&whole, &folders) {
        Ok(summary) => {
            println!("{summary}");
            ExitCode::SUCCESS
        }
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

/// Merges the folders, and returns the statistics of all members as text.
fn merge(whole: &str, folders: &[String]) -> Result<String, Error> {
    let results = Results::open(folders)?;
    results.merge_into(whole)?;
    Ok(results.summary()?.to_string())
}

fn usage() -> ExitCode {
    eprintln!("usage: lagrangian-merge WHOLE.parquet FOLDER...");
    ExitCode::from(2)
}
