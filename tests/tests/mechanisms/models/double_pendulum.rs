//! The double pendulum in vectors, against the references.

use lagrangian::prelude::*;
use lagrangian_tests::{Figures, motions};

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a, b),
    define(
        upper = l1 * [sin(a), -cos(a)],
        lower = upper + l2 * [sin(b), -cos(b)],
    ),
    kinetic = 0.5 * m1 * dot(upper).norm_squared() + 0.5 * m2 * dot(lower).norm_squared(),
    potential = -(m1 * upper + m2 * lower).dot(gravity),
)]
pub(super) struct DoublePendulum {
    m1: f64,
    m2: f64,
    l1: f64,
    l2: f64,
    gravity: [f64; 2],
}

#[test]
fn it_moves_as_the_references() {
    let mut figures = Figures::new();
    for motion in motions("double_pendulum") {
        let [m1, m2, l1, l2, g] = motion.parameters(["m1", "m2", "l1", "l2", "g"]);
        let model = DoublePendulum {
            m1,
            m2,
            l1,
            l2,
            gravity: [0.0, -g],
        };
        motion.compare("double pendulum", &model.dynamics(), 1e-10, &mut figures);
    }
    figures.finish();
}
