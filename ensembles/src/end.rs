//! The ends of the motions.

/// When the motion of a point ends: a time, or a function of the point.
pub trait End<P> {
    /// Returns the final time of the motion of a point.
    fn of(&self, point: impl FnOnce() -> P) -> f64;
}

impl<P> End<P> for f64 {
    fn of(&self, _: impl FnOnce() -> P) -> f64 {
        *self
    }
}

impl<P, F: Fn(P) -> f64> End<P> for F {
    fn of(&self, point: impl FnOnce() -> P) -> f64 {
        self(point())
    }
}
