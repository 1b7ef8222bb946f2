//! The tolerance at which a method has an error that is wanted.

/// The errors that are taken for one that is wanted: from this part of it up to it.
const LEAST: f64 = 0.85;

/// What is aimed at within this range.
const AIM: f64 = 0.93;

/// So many tolerances are tried.
const TRIES: usize = 10;

/// Returns the tolerance at which the error is the wanted one or a little less; if none is found, the one of the greatest error
/// that is not greater. The secant method in logarithms, where an error is nearly a power of the tolerance; `error` measures it.
pub(super) fn tolerance_for(
    wanted: f64,
    mut error: impl FnMut(f64) -> Result<f64, String>,
) -> Result<f64, String> {
    let aim = f64::ln(AIM * wanted);
    let mut tolerance = wanted;
    let mut before: Option<[f64; 2]> = None;
    let mut best: Option<[f64; 2]> = None;
    for _ in 0..TRIES {
        let found = error(tolerance)?;
        if found <= wanted && best.is_none_or(|[_, most]| found > most) {
            best = Some([tolerance, found]);
        }
        if (LEAST * wanted..=wanted).contains(&found) {
            break;
        }
        let here = [tolerance, found].map(f64::ln);
        let slope = before.map_or(1.0, |[x, y]| (here[1] - y) / (here[0] - x));
        before = Some(here);
        // Where the order changes with the tolerance, the error is no power of it.
        let slope = if slope.is_finite() {
            slope.clamp(0.5, 2.0)
        } else {
            1.0
        };
        tolerance = f64::exp(here[0] + (aim - here[1]) / slope);
    }
    best.map(|[tolerance, _]| tolerance)
        .ok_or_else(|| format!("no tolerance has an error of {wanted:e}"))
}
