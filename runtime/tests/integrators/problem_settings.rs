//! Settings of a problem: each counts beside another one, whatever the order. All pairs take long to compile: they are in the
//! package of derived models (`motions/pairs_of_settings.rs`), with its feature `all-cases`.

use lagrangian::prelude::*;

use crate::settings::pairs;

/// Each setting beside another one.
macro_rules! some_pairs {
    ($method:tt) => {
        pairs!($method, end, [3], 0);
        pairs!($method, end, [4], 1);
        pairs!($method, end, [5], 2);
        pairs!($method, end, [6], 3);
        pairs!($method, end, [7], 4);
        pairs!($method, end, [8], 5);
        pairs!($method, end, [9], 6);
        pairs!($method, end, [10], 0);
        pairs!($method, samples, [7], 11);
        pairs!($method, samples, [8], 12);
        pairs!($method, samples, [1], 13);
    };
}

#[test]
fn some_pairs_of_settings_count_under_taylor() {
    some_pairs!((first, Taylor::new().max_step(0.05)));
}

#[test]
fn some_pairs_of_settings_count_under_dop853() {
    some_pairs!((first, Dop853::new().max_step(0.05)));
}

#[test]
fn some_pairs_of_settings_count_under_runge_kutta() {
    some_pairs!((both, RungeKutta::classical(0.05)));
}
