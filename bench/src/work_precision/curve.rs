//! The time of a method by its error.

/// A run at a tolerance.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Point {
    pub(crate) tolerance: f64,
    pub(crate) seconds: f64,
    pub(crate) error: f64,
}

/// A method at all tolerances, from the largest.
#[derive(Clone, Debug)]
pub(crate) struct Curve {
    pub(crate) name: &'static str,
    pub(crate) points: Vec<Point>,
}

impl Curve {
    /// The time to reach an error, interpolated in logarithms between the runs that nothing else is both
    /// faster and more precise than. If the coarsest of them is more precise already, its time; if none is precise enough, not a number.
    pub(crate) fn seconds_to(&self, error: f64) -> f64 {
        let efficient = self.efficient();
        let Some(after) = efficient.iter().position(|point| point.error <= error) else {
            return f64::NAN;
        };
        let precise = efficient[after];
        let Some(coarse) = after.checked_sub(1).map(|before| efficient[before]) else {
            return precise.seconds;
        };
        let [from, to, at] = [coarse.error, precise.error, error].map(f64::ln);
        let fraction = (at - from) / (to - from);
        let [from, to] = [coarse.seconds, precise.seconds].map(f64::ln);
        (from + fraction * (to - from)).exp()
    }

    /// The runs that no other beats in both, by falling error. None is on it that is not a number.
    pub(crate) fn efficient(&self) -> Vec<Point> {
        let beaten = |point: &Point| {
            let better = |other: &Point| {
                other.seconds <= point.seconds
                    && other.error <= point.error
                    && (other.seconds < point.seconds || other.error < point.error)
            };
            !point.error.is_finite() || self.points.iter().any(better)
        };
        let efficient = self.points.iter().filter(|point| !beaten(point));
        let mut efficient: Vec<Point> = efficient.copied().collect();
        efficient.sort_by(|a, b| b.error.total_cmp(&a.error));
        efficient
    }
}
