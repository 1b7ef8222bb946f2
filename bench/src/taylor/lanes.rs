//! Eight trajectories at once, whose starts differ in the second coordinate.

use crate::verdict::Verdict;

use super::{DEFAULT, HEYOKA, METHODS, NATIVE, Sheet, fewest, table};

/// heyoka takes eight at once, or four and then four.
const THEIRS: [&str; 3] = ["hand", "hand, fast math", "hand, batches of 4"];

pub(super) fn compare(sheet: &mut Sheet, verdicts: &mut Vec<Verdict>) -> Result<(), String> {
    let count = 8;
    let starts = sheet.trajectory.starts(count);
    let truths = sheet.truths(&starts)?;
    let entries = sheet.contest(&METHODS[..2], &THEIRS, &starts)?;
    let lines = sheet.lines(&entries, [&truths, &truths])?;
    println!("  {count} trajectories at once, the time of each:");
    print!("{}", table::table(&lines));
    let theirs = fewest(&entries, HEYOKA, |_| true);
    if theirs.is_finite() {
        verdicts.push(Verdict {
            what: format!("{}, time over heyoka's, {count} at once", sheet.model),
            figure: fewest(&entries, NATIVE, |method| method == DEFAULT) / theirs,
            target: 0.7,
            limit: 1.0,
        });
    }
    Ok(())
}
