//! The nutation as the integrated motion has it, from the points where the tilt turns.

use lagrangian::State;

use crate::model::HeavyTop;
use crate::motion::turn;

/// Extremes and means of a nutation over the whole motion.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Measured {
    /// The least tilt of all in rad.
    pub(crate) least_tilt: f64,
    /// The greatest tilt of all in rad.
    pub(crate) greatest_tilt: f64,
    /// The mean period in s.
    pub(crate) period: f64,
    /// The mean growth of φ in a period in rad.
    pub(crate) precession: f64,
    /// The count of whole periods.
    pub(crate) periods: usize,
}

/// Measures the nutation of a sampled motion; none if it does not contain a whole period.
pub(crate) fn measure(
    top: &HeavyTop,
    states: &[State<f64, 3>],
    tolerance: f64,
) -> Option<Measured> {
    let turns = turning_points(top, states, tolerance);
    let tilts = || turns.iter().map(|state| state.q[HeavyTop::THETA]);
    let periods = turns.len().checked_sub(1)? / 2;
    let (first, last) = (turns.first()?, turns.get(2 * periods)?);
    // The counts of a motion that fits into memory are exact in f64.
    #[allow(clippy::cast_precision_loss)]
    let count = periods as f64;
    (periods > 0).then(|| Measured {
        least_tilt: tilts().fold(f64::INFINITY, f64::min),
        greatest_tilt: tilts().fold(f64::NEG_INFINITY, f64::max),
        period: (last.t - first.t) / count,
        precession: (last.q[HeavyTop::PHI] - first.q[HeavyTop::PHI]) / count,
        periods,
    })
}

/// The states in which θ̇ = 0, between samples on both sides of it.
fn turning_points(top: &HeavyTop, states: &[State<f64, 3>], tolerance: f64) -> Vec<State<f64, 3>> {
    let rate = |state: &State<f64, 3>| state.v[HeavyTop::THETA];
    let mut turns = Vec::new();
    for pair in states.windows(2) {
        let (before, after) = (&pair[0], &pair[1]);
        if rate(before) == 0.0 {
            turns.push(*before);
        } else if rate(before) * rate(after) < 0.0 {
            turns.extend(turn(top, before, after.t, tolerance));
        }
    }
    turns
}

#[cfg(test)]
mod tests {
    use clap::Parser;

    use super::measure;
    use crate::close;
    use crate::motion::integrate;
    use crate::nutation::Nutation;
    use crate::options::Options;
    use crate::symmetric_top::SymmetricTop;

    /// Integrated and closed-form nutation agree, whose equations have nothing in common.
    #[test]
    fn nutation_is_that_of_the_closed_form() {
        for line in [
            "heavy_top",
            "heavy_top --precession=-0.5 --nutation=0.3",
            "heavy_top --tilt=100 --spin=-5 --samples=101",
        ] {
            let options = Options::parse_from(line.split(' '));
            let top = options.top();
            let states = integrate(&top, &options).states;
            let measured = measure(&top, &states, options.tolerance).expect("several periods");
            let closed = SymmetricTop::of(&top)
                .and_then(|top| Nutation::through(&top, &options.start()))
                .expect("a closed form");
            // The tolerance is 1e-12 in each of some 250 steps.
            close(measured.least_tilt, closed.least_tilt(), 3e-11);
            close(measured.greatest_tilt, closed.greatest_tilt(), 3e-11);
            close(measured.period, closed.period(), 3e-11);
            close(measured.precession, closed.precession(), 3e-11);
        }
    }

    /// Close to the vertical the tilt turns within a small part of the time between two samples.
    #[test]
    fn sharp_turns_are_found() {
        let line = "heavy_top --i1=1.5 --tilt=60 --spin=16 --precession=4.01";
        let options = Options::parse_from(line.split(' '));
        let top = options.top();
        let states = integrate(&top, &options).states;
        let measured = measure(&top, &states, options.tolerance).expect("several periods");
        let closed = SymmetricTop::of(&top)
            .and_then(|top| Nutation::through(&top, &options.start()))
            .expect("a closed form");
        close(measured.least_tilt, closed.least_tilt(), 1e-10);
        close(measured.period, closed.period(), 1e-10);
    }

    #[test]
    fn less_than_a_period_measures_nothing() {
        let options = Options::parse_from(["heavy_top", "--time=1.1"]);
        let states = integrate(&options.top(), &options).states;
        assert!(measure(&options.top(), &states, options.tolerance).is_none());
    }
}
