//! The integration.

use std::time::{Duration, Instant};

use lagrangian::prelude::*;

use crate::model::HeavyTop;
use crate::options::Options;
use crate::progress::ProgressBar;

/// A sampled motion.
#[derive(Clone, Debug)]
pub(crate) struct Motion {
    /// The samples, as far as the integration came.
    pub(crate) states: Vec<State<f64, 3>>,
    /// Why it ended before the time span did.
    pub(crate) failure: Option<IntegrationError>,
    /// What it has cost.
    pub(crate) statistics: Statistics,
    /// How long it took on the clock.
    pub(crate) duration: Duration,
}

/// Integrates the motion that the options ask for.
pub(crate) fn integrate(top: &HeavyTop, options: &Options) -> Motion {
    let began = Instant::now();
    let mut bar = ProgressBar::new();
    let result = Problem::new(top, options.start())
        .each_step(|progress| bar.show(progress.fraction()))
        .save(options.times())
        .solve(options.time, method(options.tolerance));
    let (solution, failure) = match result {
        Ok(solution) => (solution, None),
        Err(interrupted) => {
            let error = interrupted.error();
            (interrupted.into_solution(), Some(error))
        }
    };
    Motion {
        statistics: solution.statistics,
        states: solution.into_iter().collect(),
        failure,
        duration: began.elapsed(),
    }
}

/// The first state after `from` in which the tilt turns, θ̇ = 0, if that is before the time `end`.
pub(crate) fn turn(
    top: &HeavyTop,
    from: &State<f64, 3>,
    end: f64,
    tolerance: f64,
) -> Option<State<f64, 3>> {
    let turning = Problem::new(top, *from).when(|x| x.v[HeavyTop::THETA]);
    let solution = turning.stop().solve(end, method(tolerance)).ok()?;
    (solution.reason == StopReason::Condition).then_some(solution.last)
}

/// The method of integration.
fn method(tolerance: f64) -> Dop853 {
    Dop853::new()
        .relative_tolerance(tolerance)
        .absolute_tolerance(tolerance)
}

#[cfg(test)]
mod tests {
    use clap::Parser;
    use lagrangian::IntegrationError;

    use super::integrate;
    use crate::model::HeavyTop;
    use crate::options::Options;

    #[test]
    fn samples_are_at_the_times_asked_for() {
        let options = Options::parse_from(["heavy_top", "--time=1", "--samples=5"]);
        let motion = integrate(&options.top(), &options);
        let times: Vec<f64> = motion.states.iter().map(|state| state.t).collect();
        assert_eq!(times, [0.0, 0.25, 0.5, 0.75, 1.0]);
        assert!(motion.failure.is_none());
    }

    #[test]
    fn what_came_before_a_failure_is_kept() {
        // With I (1 + cos θ) φ̇ = I₃ (ψ̇ + φ̇ cos θ) both momenta are equal: the axis reaches the vertical.
        let line = "heavy_top --i1=1.5 --tilt=60 --spin=16 --precession=4";
        let options = Options::parse_from(line.split(' '));
        let motion = integrate(&options.top(), &options);
        let error = motion.failure.expect("a singular configuration");
        let at_the_pole = matches!(
            error,
            IntegrationError::SingularConfiguration { .. }
                | IntegrationError::VanishingInertia { .. }
        );
        assert!(
            at_the_pole && error.to_string().contains("theta = "),
            "{error}"
        );
        let last = motion.states.last().expect("samples");
        assert!(last.t > 0.4 && last.t < options.time);
        assert!(last.q[HeavyTop::THETA] < 0.1);
    }
}
