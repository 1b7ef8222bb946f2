//! A step of the Taylor series method on the symmetric top and on the same top reduced by Routh's procedure: nanoseconds,
//! the fewest of many integrations in turn, in one process.

use std::process::Command;

use crate::cargo::{build, build_dependencies};
use crate::declaration::Calls;
use crate::flags::Flags;
use crate::folders::Folders;
use crate::model::Model;
use crate::verdict::{Verdict, judge};

/// The time of a step of the reduced top over that of the full one.
const LIMIT: f64 = 0.6;

/// Measures with both flags, and is an error where the limit is missed.
pub(crate) fn run() -> Result<(), String> {
    let folders = Folders::new()?;
    eprintln!("building what the models depend on");
    build_dependencies(&folders)?;
    let mut verdicts = Vec::new();
    for flags in Flags::ALL {
        let built = build(&folders, Model::SymmetricTop, Calls::CompareReduced, flags)?;
        let report = crate::command::output(&mut Command::new(built.program()))?;
        let times: Result<Vec<f64>, _> = report.split_whitespace().map(str::parse).collect();
        let Ok([full, reduced]) = times.as_deref() else {
            return Err(format!("no times: {report}"));
        };
        println!(
            "{}: a step of the full top {full:.0} ns, of the reduced one {reduced:.0} ns",
            flags.name()
        );
        verdicts.push(Verdict {
            what: format!(
                "reduced top, {} flags, time of a step over the full one's",
                flags.name()
            ),
            figure: reduced / full,
            target: LIMIT,
            limit: LIMIT,
        });
    }
    judge(&verdicts)
}
