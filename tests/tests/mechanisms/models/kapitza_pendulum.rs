//! A pendulum whose suspension is shaken, against the references.

use lagrangian::prelude::*;
use lagrangian_tests::{Figures, motions};

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    define(bob = [l * sin(theta), a * cos(nu * t) - l * cos(theta)]),
    kinetic = 0.5 * m * dot(bob).norm_squared(),
    potential = m * g * bob.y,
)]
pub(super) struct KapitzaPendulum {
    m: f64,
    l: f64,
    g: f64,
    a: f64,
    nu: f64,
}

#[test]
fn it_moves_as_the_references() {
    let mut figures = Figures::new();
    for motion in motions("kapitza_pendulum") {
        let [m, l, g, a, nu] = motion.parameters(["m", "l", "g", "a", "nu"]);
        let model = KapitzaPendulum { m, l, g, a, nu };
        motion.compare("Kapitza's pendulum", &model.dynamics(), 1e-10, &mut figures);
    }
    figures.finish();
}
