//! A heavy gyroscope in two gimbals with friction, against the references.

use lagrangian::prelude::*;
use lagrangian_tests::{Figures, motions};

/// The outer gimbal turns about the vertical, the inner one in it, and the rotor in that.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(alpha, beta, gamma),
    define(
        inner = angular_velocity_zx(alpha, beta),
        rotor = angular_velocity_zxz(alpha, beta, gamma),
    ),
    kinetic = 0.5 * outer_gimbal * dot(alpha).powi(2)
        + 0.5 * inner.dot(diagonal(inner_gimbal) * inner)
        + 0.5 * rotor.dot(diagonal([a, a, c]) * rotor),
    potential = m * g * l * cos(beta),
    dissipation = 0.5 * friction.dot([dot(alpha).powi(2), dot(beta).powi(2), dot(gamma).powi(2)]),
)]
pub(super) struct Gyroscope {
    outer_gimbal: f64,
    inner_gimbal: [f64; 3],
    a: f64,
    c: f64,
    m: f64,
    g: f64,
    l: f64,
    friction: [f64; 3],
}

#[test]
fn it_moves_as_the_references() {
    let mut figures = Figures::new();
    for motion in motions("gimbal_gyroscope") {
        let [outer_gimbal, a, c, m, g, l] = motion.parameters(["jo", "a", "c", "m", "g", "l"]);
        let model = Gyroscope {
            outer_gimbal,
            inner_gimbal: motion.parameters(["ai", "bi", "ci"]),
            a,
            c,
            m,
            g,
            l,
            friction: motion.parameters(["f1", "f2", "f3"]),
        };
        motion.compare("gyroscope", &model.dynamics(), 1e-10, &mut figures);
    }
    figures.finish();
}
