//! What the clause `taylor` costs when a model is compiled, and what long models do.
//!
//! The time of the derivation with and without the clause, in a debug build of the macro, as users have it; and the time
//! of `cargo build --release` of a crate that declares the model and integrates it once, by `Taylor` with the clause
//! and by `Dop853` without, dependencies built. Both are by the clock and the fewest of some, since cargo's threads
//! have no common CPU time; a busy machine shows.

use crate::arguments::Arguments;
use crate::cargo::{build, build_dependencies, derive_times};
use crate::declaration::Calls;
use crate::flags::Flags;
use crate::folders::Folders;
use crate::long_models;
use crate::model::Model;
use crate::verdict::{Verdict, judge};

/// How often each crate is built.
const BUILDS: usize = 3;

/// Seconds that a release build may take.
const BUILD_LIMIT: f64 = 15.0;

/// Prints the times, and is an error where one is over its limit.
pub(crate) fn run(arguments: &Arguments) -> Result<(), String> {
    let folders = Folders::new()?;
    eprintln!("building what the models depend on");
    let empty = build_dependencies(&folders)?;
    let mut verdicts = Vec::new();
    println!("derivation, ms         without      with     ratio");
    let times = derive_times(&folders)?;
    for model in &arguments.models {
        let time = |name: String| times.get(&name).copied();
        let with = time(format!("{model} with taylor"));
        let (Some(without), Some(with)) = (time(model.to_string()), with) else {
            continue;
        };
        println!(
            "  {:<20} {without:>7.1} {with:>9.1} {:>9.2}",
            model.to_string(),
            with / without
        );
        verdicts.push(Verdict {
            what: format!("{model}, derivation with the clause over that without"),
            figure: with / without,
            target: 2.0,
            limit: 2.0,
        });
    }
    println!("release build, s       without      with     (a crate without a model: {empty:.2})");
    let builds = if arguments.quick { 1 } else { BUILDS };
    for &model in &arguments.models {
        let [without, with] = release_builds(&folders, model, builds)?;
        println!("  {:<20} {without:>7.2} {with:>9.2}", model.to_string());
        verdicts.push(Verdict {
            what: format!("{model}, seconds of a release build with the clause"),
            figure: with,
            target: BUILD_LIMIT,
            limit: BUILD_LIMIT,
        });
    }
    verdicts.extend(long_models::verdicts(&folders)?);
    judge(&verdicts)
}

/// Without the clause and with it, in turn.
fn release_builds(folders: &Folders, model: Model, builds: usize) -> Result<[f64; 2], String> {
    let mut fewest = [f64::INFINITY; 2];
    for _ in 0..builds {
        for (calls, fewest) in [Calls::Dop853, Calls::Taylor].into_iter().zip(&mut fewest) {
            let built = build(folders, model, calls, Flags::Default)?;
            *fewest = fewest.min(built.seconds);
        }
    }
    Ok(fewest)
}
