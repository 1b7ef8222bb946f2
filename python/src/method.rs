//! Methods of integration and their settings.

use lagrangian::{Dop853, RungeKutta, Taylor};

/// The method of an integration.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// Taylor series.
    Taylor,
    /// Dormand–Prince 8(5,3).
    Dop853,
    /// The classical method of fixed step.
    RungeKutta,
}

/// The settings of a method.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// The method.
    pub method: Method,
    /// The relative tolerance, if it is set.
    pub tolerance: Option<f64>,
    /// The step of a method of fixed step, or the largest one.
    pub step: Option<f64>,
}

impl Settings {
    /// The Taylor method.
    #[must_use]
    pub fn taylor(&self) -> Taylor {
        let mut method = Taylor::new();
        if let Some(tolerance) = self.tolerance {
            method = method
                .relative_tolerance(tolerance)
                .absolute_tolerance(tolerance);
        }
        if let Some(step) = self.step {
            method = method.max_step(step);
        }
        method
    }

    /// The method of Dormand and Prince.
    #[must_use]
    pub fn dop853(&self) -> Dop853 {
        let mut method = Dop853::new();
        if let Some(tolerance) = self.tolerance {
            method = method
                .relative_tolerance(tolerance)
                .absolute_tolerance(tolerance);
        }
        if let Some(step) = self.step {
            method = method.max_step(step);
        }
        method
    }

    /// The classical Runge–Kutta method; without a step its step is NaN, which is an error.
    #[must_use]
    pub fn runge_kutta(&self) -> RungeKutta<4> {
        RungeKutta::classical(self.step.unwrap_or(f64::NAN))
    }
}
