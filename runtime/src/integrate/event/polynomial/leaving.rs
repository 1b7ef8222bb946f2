//! The point at which a polynomial that is zero to rounding becomes distinguishable from zero.

use super::Polynomial;
use crate::scalar::DoubleDouble;

impl Polynomial {
    /// Returns the first argument from `from` on at which the value exceeds `least`, with its sign there; `None` if
    /// there is none up to 1.
    pub(in crate::integrate::event) fn leaves(&self, from: f64, least: f64) -> Option<(f64, f64)> {
        let value = self.value(from);
        if value.abs() > least + self.uncertainty(from) {
            return Some((from, value.signum()));
        }
        let beyond = |sign: f64| {
            let mut above = *self;
            if let Some(constant) = above.coefficients.first_mut() {
                *constant -= DoubleDouble::from(sign * least);
            }
            let root = above.next_root(from, -sign)?;
            Some((root.until, sign))
        };
        let [up, down] = [1.0, -1.0].map(beyond);
        let pair = up.into_iter().chain(down);
        pair.min_by(|a, b| a.0.total_cmp(&b.0))
    }
}
