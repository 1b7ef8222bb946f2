//! Constrained mechanisms, against solutions that are known functions or quadratures, and against their equations in other forms.

mod governor;
mod hoop;
mod one_freedom;
mod rolling_disc;
mod sleigh;
mod slider_crank;
mod snakeboard;
mod spatial_slider_crank;
mod turntable;
mod unit_quaternion;

pub(crate) use rolling_disc::RollingDisc;

use lagrangian::prelude::*;
use lagrangian::quantities::{Constraints, MotionSeries};
use lagrangian_tests::{Figures, relative_error};

/// Of motions by the Taylor method, and of what is evaluated at one state.
const TOLERANCE: f64 = 1e-12;
/// Of motions by DOP853 with the tolerance 1e-13.
const DORMAND_PRINCE_TOLERANCE: f64 = 1e-10;

/// The same motion by both methods, with so many samples to the end and what may be expected of them.
fn by_both_methods<M, const N: usize, const C: usize>(
    model: &M,
    start: State<f64, N>,
    (end, count): (f64, u32),
) -> [(f64, Vec<State<f64, N>>); 2]
where
    M: Lagrangian<N, Model: Constraints<N, C> + MotionSeries<N>>,
{
    let problem = || {
        let problem = Problem::new(model, start).max_steps(1_000_000);
        problem.save(Every(end / f64::from(count)))
    };
    let taylor = problem().solve(end, Taylor::new()).expect("by Taylor");
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let dormand_prince = problem().solve(end, method).expect("by DOP853");
    [
        (TOLERANCE, taylor.samples().to_vec()),
        (DORMAND_PRINCE_TOLERANCE, dormand_prince.samples().to_vec()),
    ]
}

/// Takes note of an error, relative to the greatest entry of what is expected, or to 1.
fn compare(
    figures: &mut Figures,
    what: &'static str,
    (t, tolerance): (f64, f64),
    found: &[f64],
    expected: &[f64],
) {
    let at = format!("t = {t}, within {tolerance:e}");
    figures.record(what, &at, relative_error(found, expected, 1.0), tolerance);
}
