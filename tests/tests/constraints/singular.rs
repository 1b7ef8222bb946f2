//! Motions through singular configurations: four-bar linkages of equal lengths, which are flat twice in a turn.

use lagrangian::prelude::*;

use crate::four_bars::{OneFourBar, TwoFourBars, expected, upright};

const END: f64 = 10.0;
/// Behind two flat configurations.
const SHORT: f64 = 2.0;

/// Tolerances of the Taylor method.
const TOLERANCES: [f64; 4] = [1e-11, 1e-12, 1e-13, 1e-14];

/// Returns the allowed error of a coordinate after ten seconds, in lengths of a crank: rounding, and steps behind flat
/// configurations, which multiply errors of the last terms. The largest error of 1,200 motions for each tolerance is half of this.
fn allowed(tolerance: f64) -> f64 {
    5e-10 + 250.0 * tolerance
}

/// Compares the linkages with the pendulum for different lengths of the first step, which decide where other steps end.
fn pass(first_steps: impl Iterator<Item = u32>, tolerances: &[f64]) {
    for first in first_steps.map(|i| 0.01 + 0.003 * f64::from(i)) {
        for &tolerance in tolerances {
            let taylor = Taylor::new().relative_tolerance(tolerance);
            let taylor = taylor.pass_singular_configurations();
            let mut run = Problem::new(&OneFourBar::NEW, upright::<2, 4>(1.0))
                .start(taylor)
                .unwrap();
            run.advance(first).unwrap();
            let error = run.advance(END).unwrap().q[0] - expected(1.0, 1.0, END);
            assert!(
                error.abs() < allowed(tolerance),
                "{first} {tolerance:e} {error:e}"
            );
            let mut run = Problem::new(&TwoFourBars::NEW, upright::<3, 6>(1.0))
                .start(taylor)
                .unwrap();
            run.advance(first).unwrap();
            let error = run.advance(END).unwrap().q[0] - expected(2.0, 1.0, END);
            assert!(
                error.abs() < allowed(tolerance),
                "{first} {tolerance:e} {error:e}"
            );
        }
    }
}

#[test]
fn linkages_pass_their_flat_configurations_after_a_first_step() {
    pass([7].into_iter(), &TOLERANCES[1..2]);
}

#[test]
#[ignore = "long"]
fn linkages_pass_their_flat_configurations() {
    pass(0..20, &TOLERANCES);
}

/// Rounding errors of the coefficients hide a flat configuration ahead of one step in each of these motions, which must not end
/// there.
#[test]
fn configurations_that_are_found_late_are_passed() {
    let problem = |velocity| Problem::new(OneFourBar::NEW, upright::<2, 4>(velocity));
    let check = |velocity, end: f64| {
        let error = end - expected(1.0, velocity, END);
        assert!(error.abs() < 2e-9, "{velocity} {error:e}");
    };
    let taylor = Taylor::new().pass_singular_configurations();
    for velocity in [2.2395, 2.2845, 2.372] {
        let end = problem(velocity).solve(END, taylor.relative_tolerance(1e-14));
        check(velocity, end.unwrap().q[0]);
    }
    let velocities = [0.665, 1.6145, 3.1245];
    let ends = Ensemble::new(velocities.map(problem)).solve(END, taylor.relative_tolerance(1e-13));
    for (velocity, end) in velocities.into_iter().zip(ends) {
        check(velocity, end.unwrap().q[0]);
    }
}

#[test]
fn without_the_setting_a_flat_configuration_ends_the_motion() {
    let end = Problem::new(&OneFourBar::NEW, upright::<2, 4>(1.0)).solve(END, Taylor::new());
    let message = end.unwrap_err().to_string();
    assert!(message.contains("depends on others"), "{message}");
}

#[test]
fn linkages_in_lanes_pass_their_flat_configurations() {
    let velocities: [f64; 3] = [0.5, 1.1, 1.7];
    let problems = velocities.map(|v| Problem::new(OneFourBar::NEW, upright::<2, 4>(v)));
    let taylor = Taylor::new().pass_singular_configurations();
    let ends = Ensemble::new(problems).solve(SHORT, taylor);
    for (velocity, end) in velocities.into_iter().zip(ends) {
        let error = end.unwrap().q[0] - expected(1.0, velocity, SHORT);
        assert!(error.abs() < 1e-9, "{velocity} {error:e}");
    }
}

#[test]
fn explicit_methods_pass_flat_configurations() {
    let start = upright::<2, 4>(1.0);
    let problem = Problem::new(&OneFourBar::NEW, start);
    let fixed = RungeKutta::classical(1e-3).pass_singular_configurations();
    let error = problem.clone().solve(SHORT, fixed).unwrap().q[0] - expected(1.0, 1.0, SHORT);
    assert!(error.abs() < 1e-9, "{error:e}");
    let adaptive = Dop853::new().pass_singular_configurations();
    let error = problem.solve(END, adaptive).unwrap().q[0] - expected(1.0, 1.0, END);
    assert!(error.abs() < 1e-6, "{error:e}");
}

/// Steps that are short beside the distance at which digits are lost. Without the setting, this motion ends in an error.
#[test]
#[ignore = "long"]
fn short_fixed_steps_pass_flat_configurations() {
    let fixed = RungeKutta::classical(1e-4).pass_singular_configurations();
    let start = upright::<2, 4>(1.0);
    let end = Problem::new(&OneFourBar::NEW, start).solve(END, fixed);
    let error = end.unwrap().q[0] - expected(1.0, 1.0, END);
    assert!(error.abs() < 1e-11, "{error:e}");
}

/// Linkages that are nearly flat are not singular: they turn, and no step passes over that.
#[test]
fn near_singular_configurations_are_followed() {
    for difference in [0.1, -0.01, 1e-3] {
        let linkage = OneFourBar {
            coupler: 1.0 + difference,
            ..OneFourBar::NEW
        };
        let start = linkage
            .assemble(upright::<2, 4>(1.0))
            .solve()
            .unwrap()
            .state;
        let taylor = Taylor::new().relative_tolerance(1e-11);
        let problem = Problem::new(&linkage, start);
        let passed = problem
            .clone()
            .solve(2.0, taylor.pass_singular_configurations());
        let tolerance = 1e-12;
        let dop853 = Dop853::new()
            .relative_tolerance(tolerance)
            .absolute_tolerance(tolerance);
        let followed = problem.solve(2.0, dop853).unwrap();
        let distance = (passed.unwrap().q - followed.q).abs().max();
        assert!(distance < 1e-9, "{difference} {distance:e}");
    }
}

/// Constraints are met to rounding at the ends of steps, and energy is kept.
#[test]
fn passing_keeps_constraints_and_energy() {
    let linkage = OneFourBar::NEW;
    let start = upright::<2, 4>(1.0);
    let taylor = Taylor::new().relative_tolerance(1e-13);
    let mut run = Problem::new(&linkage, start)
        .start(taylor.pass_singular_configurations())
        .unwrap();
    let mut flat = 0;
    let mut below = false;
    while let Some(step) = run.step(END).unwrap() {
        let state = State::new(step.t, step.q, step.v);
        let (g, w) = linkage.constraint_residuals(&state);
        assert!(g.abs().max() < 1e-14 && w.abs().max() < 1e-13);
        let change = linkage.energy(&state) - linkage.energy(&start);
        assert!(change.abs() < 1e-9, "{change:e}");
        if (step.q[2] < 0.0) != below {
            below = !below;
            flat += 1;
        }
    }
    assert_eq!(flat, 10);
}
