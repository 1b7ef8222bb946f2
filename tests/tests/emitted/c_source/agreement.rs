//! How nearly results in C and in Rust are the same.

/// How nearly results are the same.
#[derive(Clone, Copy, Debug)]
pub(super) enum Agreement {
    /// To the bit.
    Bits,
    /// So many units in the last place of the largest result of a function.
    Units(f64),
}

impl Agreement {
    /// By how many units in the last place of the largest expected result others differ.
    pub(super) fn units(found: &[f64], expected: &[f64]) -> f64 {
        let largest = expected.iter().fold(0.0, |most, x| f64::max(most, x.abs()));
        let differences = found.iter().zip(expected).map(|(x, y)| (x - y).abs());
        let most = differences.fold(0.0, f64::max);
        if most == 0.0 {
            0.0
        } else {
            most / (f64::EPSILON * largest)
        }
    }

    pub(super) fn holds(self, found: &[f64], expected: &[f64]) -> bool {
        let mut pairs = found.iter().zip(expected);
        match self {
            Self::Bits => {
                pairs.all(|(x, y)| x.to_bits() == y.to_bits() || (x.is_nan() && y.is_nan()))
            }
            Self::Units(units) => {
                let finite = expected.iter().filter(|x| x.is_finite());
                let largest = finite.fold(0.0, |most, x| f64::max(most, x.abs()));
                pairs.all(|(x, y)| {
                    (x - y).abs() <= units * f64::EPSILON * largest
                        || (x.is_nan() && y.is_nan())
                        || x.to_bits() == y.to_bits()
                })
            }
        }
    }
}
