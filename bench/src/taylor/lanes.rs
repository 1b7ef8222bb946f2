//! Eight trajectories at once, whose starts differ in the second coordinate.

use crate::verdict::Verdict;

use super::{DEFAULT, HEYOKA, NATIVE, Sheet, fewest, table};

/// Ours have steps of their own, or common ones.
const OURS: [&str; 4] = [OWN_STEPS, DEFAULT, "Taylor 16, own steps", "Taylor 16"];
const OWN_STEPS: &str = "Taylor, own steps";

/// heyoka takes eight at once, or four and then four; each has steps of its own.
const THEIRS: [&str; 3] = ["hand", "hand, fast math", "hand, batches of 4"];

pub(super) fn compare(sheet: &mut Sheet, verdicts: &mut Vec<Verdict>) -> Result<(), String> {
    let count = 8;
    let starts = sheet.trajectory.starts(count);
    let entries = sheet.contest(&OURS, &THEIRS, &starts)?;
    let lines = sheet.lines(&entries)?;
    println!("  {count} trajectories at once, the time of each:");
    print!("{}", table::table(&lines));
    let theirs = fewest(&entries, HEYOKA, |_| true);
    if theirs.is_finite() {
        verdicts.push(Verdict {
            what: format!("{}, time over heyoka's, {count} at once", sheet.model),
            figure: fewest(&entries, NATIVE, |method| {
                [OWN_STEPS, DEFAULT].contains(&method)
            }) / theirs,
            target: 0.7,
            limit: 1.0,
        });
    }
    Ok(())
}
