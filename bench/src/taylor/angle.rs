//! What a cyclic angle that has turned far costs: θ(1000) of the symmetric top from ψ = 0 and from ψ = 10⁶.

use crate::contest::Entry;
use crate::folders::Folders;
use crate::trajectories::END;
use crate::verdict::Verdict;

use super::{DEFAULT, HEYOKA, NATIVE, Sheet, truths};

/// θ and ψ in the state.
const THETA: usize = 1;
const PSI: usize = 2;
const FAR: f64 = 1e6;

/// The error of θ is taken over so many starts, root mean square: that of one may be small by chance.
const STARTS: u32 = 8;

pub(super) fn compare(
    sheet: &mut Sheet,
    folders: &Folders,
    verdicts: &mut Vec<Verdict>,
) -> Result<(), String> {
    let starts = sheet.trajectory.starts(STARTS);
    // ψ is cyclic: θ does not depend on it.
    let truths = truths(folders, sheet.model, &starts)?;
    println!("  θ(1000), root of the mean square error over {STARTS} starts:");
    for (side, name, method) in [(NATIVE, "lagrangian", DEFAULT), (HEYOKA, "heyoka", "hand")] {
        if side >= sheet.contestants.len() {
            continue;
        }
        let mut error = |psi: f64| -> Result<f64, String> {
            let mut sum = 0.0;
            for (start, truth) in starts.iter().zip(&truths) {
                let mut start = start.clone();
                start[PSI] = psi;
                let entry = Entry::new(side, method, &[start], END);
                let end = sheet.contestants[side].integrate(&entry.integration)?;
                sum += (end.states[0][THETA] - truth[THETA]).powi(2);
            }
            Ok(f64::sqrt(sum / f64::from(STARTS)))
        };
        let (near, far) = (error(0.0)?, error(FAR)?);
        let lost = f64::log10(far / near);
        println!(
            "  {name:<12} from ψ = 0: {near:.0e}, from ψ = 10⁶: {far:.0e}, {lost:.1} digits lost"
        );
        if side == NATIVE {
            verdicts.push(Verdict {
                what: "digits of θ(1000) lost where ψ begins at 10⁶".to_owned(),
                figure: lost,
                target: 0.5,
                limit: 0.5,
            });
        }
    }
    Ok(())
}
