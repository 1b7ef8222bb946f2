//! A snakeboard that is rowed by its rotor, against an integration of its equations with 24 digits (`data/README.md`).

use lagrangian::prelude::*;
use lagrangian_tests::{Figures, array, list, number, numbers, snakeboard};

use super::compare;

/// Of a motion that is enlarged little: DOP853 is given 1e-13.
const MOTION_TOLERANCE: f64 = 1e-10;

/// A board with a rotor at its middle, which a torque turns to and fro, and two axles on springs that do not slip sideways.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, y, theta, psi, back, front),
    define(p = [x, y], along = l * [cos(theta), sin(theta)]),
    kinetic = 0.5 * (m * dot(p).norm_squared() + j * dot(theta).powi(2) + jr * dot(theta + psi).powi(2)),
    kinetic = 0.5 * jw * (dot(theta + back).powi(2) + dot(theta + front).powi(2)),
    potential = 0.5 * k * (back.powi(2) + front.powi(2)),
    force(psi = torque * cos(w * t)),
    nonholonomic(
        back_axle = dot(p - along).dot([-sin(theta + back), cos(theta + back)]),
        front_axle = dot(p + along).dot([-sin(theta + front), cos(theta + front)]),
    ),
)]
struct Snakeboard {
    m: f64,
    j: f64,
    jr: f64,
    jw: f64,
    l: f64,
    k: f64,
    torque: f64,
    w: f64,
}

#[test]
fn the_snakeboard_goes_where_it_is_rowed() {
    let document = snakeboard();
    let names = ["m", "j", "jr", "jw", "l", "k", "torque", "w"];
    let [m, j, jr, jw, l, k, torque, w] = names.map(|name| number(&document["params"][name]));
    #[rustfmt::skip]
    let board = Snakeboard { m, j, jr, jw, l, k, torque, w };
    let samples = list(&document["samples"]);
    let state_of = |sample: &serde_json::Value| {
        State::new(
            number(&sample["t"]),
            array(&sample["q"]),
            array(&sample["qd"]),
        )
    };
    let start: State<f64, 6> = state_of(&samples[0]);
    let mut figures = Figures::new();
    for sample in samples {
        let exact = state_of(sample);
        check(&mut figures, &board, &exact, sample, 1e-12);
        let problem = || Problem::new(&board, start);
        if exact.t > 0.0 {
            let end = problem().solve(exact.t, Taylor::new());
            check(
                &mut figures,
                &board,
                &end.expect("by Taylor"),
                sample,
                MOTION_TOLERANCE,
            );
            let method = Dop853::new()
                .relative_tolerance(1e-13)
                .absolute_tolerance(1e-13);
            let end = problem().solve(exact.t, method);
            check(
                &mut figures,
                &board,
                &end.expect("by DOP853"),
                sample,
                MOTION_TOLERANCE,
            );
        }
    }
    figures.finish();
}

fn check(
    figures: &mut Figures,
    board: &Snakeboard,
    state: &State<f64, 6>,
    sample: &serde_json::Value,
    tolerance: f64,
) {
    let at = (state.t, tolerance);
    compare(figures, "q", at, state.q.as_slice(), &numbers(&sample["q"]));
    compare(
        figures,
        "qd",
        at,
        state.v.as_slice(),
        &numbers(&sample["qd"]),
    );
    let found = board.accelerations(state);
    compare(
        figures,
        "qdd",
        at,
        found.as_slice(),
        &numbers(&sample["qdd"]),
    );
    let found = board.multipliers(state);
    compare(
        figures,
        "lambda",
        at,
        found.as_slice(),
        &numbers(&sample["lambda"]),
    );
}
