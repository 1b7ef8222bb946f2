//! The tolerance at which a method has an error that is wanted.

/// The greatest tolerance that is tried, its negative exponent.
const FIRST: i32 = 7;

/// The least one.
const LAST: i32 = 15;

/// So many tolerances are tried in a decade.
const IN_A_DECADE: i32 = 8;

/// Returns the greatest tolerance, in eighths of a decade, at which the error is not greater than what is wanted, below a
/// decade at which it is: first by decades, then by eighths. An error need not fall with the tolerance where the order of a method
/// depends on it, so that tolerances are tried in turn. `error` measures it.
pub(super) fn tolerance_for(
    wanted: f64,
    mut error: impl FnMut(f64) -> Result<f64, String>,
) -> Result<f64, String> {
    let at = |eighths: i32| 10_f64.powf(-f64::from(eighths) / f64::from(IN_A_DECADE));
    let mut first = |eighths: &mut dyn Iterator<Item = i32>| {
        for eighths in eighths {
            if error(at(eighths))? <= wanted {
                return Ok(Some(eighths));
            }
        }
        Ok::<_, String>(None)
    };
    let decade = first(&mut (FIRST..=LAST).map(|digits| digits * IN_A_DECADE))?;
    let decade = decade.ok_or_else(|| format!("no tolerance has an error of {wanted:e}"))?;
    let mut before = (decade - IN_A_DECADE + 1)..decade;
    let found = first(&mut before)?;
    Ok(at(found.unwrap_or(decade)))
}
