//! A pole on a cart that a force pushes, against the references.

use lagrangian::prelude::*;
use lagrangian_tests::{Figures, motions};

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, theta),
    define(tip = [x + l * sin(theta), l * cos(theta)]),
    kinetic = 0.5 * mc * dot(x).powi(2) + 0.5 * mp * dot(tip).norm_squared(),
    potential = mp * g * tip.y,
    dissipation = 0.5 * (bx * dot(x).powi(2) + bt * dot(theta).powi(2)),
    force(x = push),
)]
pub(super) struct CartPole {
    mc: f64,
    mp: f64,
    l: f64,
    g: f64,
    bx: f64,
    bt: f64,
    #[lagrangian(input)]
    push: f64,
}

#[test]
fn it_moves_as_the_references() {
    let mut figures = Figures::new();
    for motion in motions("cart_pole") {
        let [mc, mp, l, g, bx, bt] = motion.parameters(["mc", "mp", "l", "g", "bx", "bt"]);
        let model = CartPole {
            mc,
            mp,
            l,
            g,
            bx,
            bt,
            push: 0.0,
        };
        let [amplitude, w] = motion.parameters(["f0", "w"]);
        let law = |state: &State<f64, 2>| amplitude * (w * state.t).sin();
        let start = State::new(0.0, [0.0; 2], [0.0; 2]);
        let controlled = Problem::new(&model, start).feedback(law);
        motion.compare("cart and pole", controlled.dynamics(), 1e-11, &mut figures);
    }
    figures.finish();
}
