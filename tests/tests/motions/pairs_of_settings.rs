//! All pairs of settings of a problem; `runtime/tests/integrators/problem_settings.rs` has some of them.

use lagrangian::prelude::*;

use crate::settings::all_pairs;

#[test]
fn all_pairs_of_settings_count_under_taylor() {
    all_pairs!((first, Taylor::new().max_step(0.05)));
}

#[test]
fn all_pairs_of_settings_count_under_dop853() {
    all_pairs!((first, Dop853::new().max_step(0.05)));
}

#[test]
fn all_pairs_of_settings_count_under_runge_kutta() {
    all_pairs!((both, RungeKutta::classical(0.05)));
}
