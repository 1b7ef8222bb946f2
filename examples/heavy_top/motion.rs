//! The integrated motion: its samples, and its nutation from the points where the tilt turns.

use std::time::{Duration, Instant};

use lagrangian::Partial;
use lagrangian::prelude::*;
use lagrangian::rigid_body::Nutation;
use lagrangian_examples::extent;

use crate::model::HeavyTop;
use crate::options::{Method, Options};
use crate::progress::ProgressBar;

/// A sample of the motion, and what (4.8) and (4.10) say should not change with it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sample {
    /// Time in s, angles in rad, rates in rad/s.
    pub(crate) state: State<f64, 3>,
    /// The energy in J, from the height of the pivot, and the angular momenta `C_φ` about the vertical and `C_ψ` about the
    /// third principal axis in kg m²/s.
    pub(crate) constants: [f64; 3],
    /// How far these three are from their first values. They are relative to what does not vanish where terms of opposite sign
    /// cancel: the energy to T + |V|, both momenta to the larger of the two.
    pub(crate) errors: [f64; 3],
}

impl Sample {
    /// θ in rad.
    pub(crate) fn tilt(&self) -> f64 {
        self.state.q[HeavyTop::THETA]
    }
}

/// A motion.
#[derive(Clone, Debug)]
pub(crate) struct Motion {
    /// The samples, as far as the integration came; the first one is the start.
    pub(crate) samples: Vec<Sample>,
    /// The states in which the tilt turns, θ̇ = 0.
    turns: Vec<State<f64, 3>>,
    /// Why it ended before the time span did.
    pub(crate) failure: Option<IntegrationError>,
    /// What it has cost.
    pub(crate) statistics: Statistics,
    /// How long it took on the clock.
    pub(crate) duration: Duration,
}

/// What a whole nutation does.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cycle {
    /// The least and the greatest tilt in rad.
    pub(crate) tilts: [f64; 2],
    /// The angle in rad by which φ grows.
    pub(crate) precession: f64,
    /// The period in s.
    pub(crate) period: f64,
}

impl From<&Nutation> for Cycle {
    fn from(closed: &Nutation) -> Self {
        Self {
            tilts: [closed.least_inclination(), closed.greatest_inclination()],
            precession: closed.precession(),
            period: closed.period(),
        }
    }
}

/// Integrates the motion that the options ask for. One that fails is kept as far as it came, if it came further than the
/// start.
pub(crate) fn integrate(top: &HeavyTop, options: &Options) -> Result<Motion, IntegrationError> {
    let began = Instant::now();
    let (start, asked) = (options.start.state(), &options.integration);
    let mut bar = ProgressBar::new();
    let problem = Problem::new(top, start)
        .on(HeavyTop::TURN)
        .record()
        .each_step(|progress| bar.show(progress.fraction()))
        .save(asked.times());
    let (end, tolerance) = (asked.time, asked.tolerance());
    let result = match asked.method {
        Method::Taylor => {
            let method = Taylor::new().relative_tolerance(tolerance);
            problem.solve(end, method.absolute_tolerance(tolerance))
        }
        Method::Dop853 => {
            let method = Dop853::new().relative_tolerance(tolerance);
            problem.solve(end, method.absolute_tolerance(tolerance))
        }
        Method::RungeKutta => problem.solve(end, RungeKutta::classical(asked.step)),
    };
    let failure = result.as_ref().err().map(Partial::error);
    let solution = result.unwrap_or_else(Partial::into_solution);
    if let (Some(error), []) = (failure, solution.samples()) {
        return Err(error);
    }
    // A turning point at the start is not crossed.
    let first = (start.v[HeavyTop::THETA] == 0.0).then_some(start);
    let crossed = solution.events().iter().filter(|turn| turn.t > 0.0);
    let crossed = crossed.map(|turn| At::from((turn.t, turn.x)));
    Ok(Motion {
        samples: samples(top, &start, solution.samples()),
        turns: first.into_iter().chain(crossed).collect(),
        failure,
        statistics: solution.statistics,
        duration: began.elapsed(),
    })
}

/// The states with their constants.
fn samples(top: &HeavyTop, start: &State<f64, 3>, states: &[State<f64, 3>]) -> Vec<Sample> {
    let constants = |state: &State<f64, 3>| {
        let momenta = top.momenta(state);
        let [c_phi, c_psi] = [momenta[HeavyTop::PHI], momenta[HeavyTop::PSI]];
        [top.energy(state), c_phi, c_psi]
    };
    let initial = constants(start);
    let energy = top.kinetic_energy(start) + top.potential_energy(start).abs();
    let momentum = initial[1].abs().max(initial[2].abs());
    // 1 where nothing moves and nothing weighs.
    let scales = [energy, momentum, momentum].map(|scale| if scale > 0.0 { scale } else { 1.0 });
    let sample = |state: &State<f64, 3>| {
        let constants = constants(state);
        Sample {
            state: *state,
            constants,
            errors: std::array::from_fn(|i| (constants[i] - initial[i]) / scales[i]),
        }
    };
    states.iter().map(sample).collect()
}

impl Motion {
    /// The number of whole nutations, with their extremes and means; none if the motion does not contain any.
    pub(crate) fn nutation(&self) -> Option<(usize, Cycle)> {
        let periods = self.turns.len().checked_sub(1)? / 2;
        let (first, last) = (self.turns.first()?, self.turns.get(2 * periods)?);
        let tilts = self.turns.iter().map(|state| state.q[HeavyTop::THETA]);
        // The counts of a motion that fits into memory are exact in f64.
        #[allow(clippy::cast_precision_loss)]
        let count = periods as f64;
        let cycle = Cycle {
            tilts: extent(tilts),
            precession: (last.q[HeavyTop::PHI] - first.q[HeavyTop::PHI]) / count,
            period: (last.t - first.t) / count,
        };
        (periods > 0).then_some((periods, cycle))
    }
}

#[cfg(test)]
mod tests {
    use clap::Parser;
    use lagrangian::IntegrationError;

    use super::{Cycle, Motion, integrate};
    use crate::model::HeavyTop;
    use crate::options::Options;
    use crate::tests::close;

    /// The motion of a command line.
    fn motion(line: &str) -> (Options, Motion) {
        let options = Options::parse_from(line.split(' '));
        let motion = integrate(&options.body.top(), &options).expect("a start");
        (options, motion)
    }

    /// A whole nutation, integrated and in closed form.
    fn cycles(line: &str) -> [Cycle; 2] {
        let (options, motion) = motion(line);
        let (_, integrated) = motion.nutation().expect("several periods");
        let closed = options.body.top().nutation(&options.start.state());
        [integrated, Cycle::from(&closed.expect("a closed form"))]
    }

    #[test]
    fn samples_are_at_the_times_asked_for() {
        for method in ["taylor", "dop853", "runge-kutta"] {
            let (_, motion) = motion(&format!("heavy_top --time=1 --samples=5 --method={method}"));
            let times: Vec<f64> = motion.samples.iter().map(|sample| sample.state.t).collect();
            assert_eq!(times, [0.0, 0.25, 0.5, 0.75, 1.0]);
            assert!(motion.failure.is_none());
        }
    }

    #[test]
    fn what_came_before_a_failure_is_kept() {
        for method in ["taylor", "dop853"] {
            // With I (1 + cos θ) φ̇ = I₃ (ψ̇ + φ̇ cos θ) both momenta are equal: the axis reaches the vertical.
            let line = "heavy_top --i1=1.5 --tilt=60 --spin=16 --precession=4 --method=";
            let (options, motion) = motion(&format!("{line}{method}"));
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
            let last = motion.samples.last().expect("samples").state;
            assert!(last.t > 0.4 && last.t < options.integration.time);
            assert!(last.q[HeavyTop::THETA] < 0.1);
        }
    }

    /// Integrated and closed-form nutation agree, whose equations have nothing in common.
    #[test]
    fn nutation_is_that_of_the_closed_form() {
        for (method, tolerance) in [
            ("taylor", 1e-13),
            // The tolerance is 1e-12 in each of some 250 steps.
            ("dop853", 3e-11),
            ("runge-kutta", 1e-8),
        ] {
            for line in [
                "heavy_top --samples=2",
                "heavy_top --precession=-0.5 --nutation=0.3",
                "heavy_top --tilt=100 --spin=-5 --samples=101",
            ] {
                let [integrated, closed] = cycles(&format!("{line} --method={method}"));
                for (integrated, closed) in integrated.tilts.into_iter().zip(closed.tilts) {
                    close(integrated, closed, tolerance);
                }
                close(integrated.period, closed.period, tolerance);
                close(integrated.precession, closed.precession, tolerance);
            }
        }
    }

    /// Close to the vertical the tilt turns within a small part of the time between two samples.
    #[test]
    fn sharp_turns_are_found() {
        for method in ["taylor", "dop853"] {
            let line = "heavy_top --i1=1.5 --tilt=60 --spin=16 --precession=4.01 --method=";
            let [integrated, closed] = cycles(&format!("{line}{method}"));
            close(integrated.tilts[0], closed.tilts[0], 1e-10);
            close(integrated.period, closed.period, 1e-10);
        }
    }

    #[test]
    fn a_motion_that_cannot_begin_is_an_error() {
        let options = Options::parse_from(["heavy_top", "--tilt=1e-320"]);
        assert!(integrate(&options.body.top(), &options).is_err());
    }

    #[test]
    fn less_than_a_period_measures_nothing() {
        let (_, motion) = motion("heavy_top --time=1.1");
        assert!(motion.nutation().is_none());
    }
}
