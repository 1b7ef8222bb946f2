//! Motions that begin after more than 5·10⁸ turns: as many steps as before, and the same angles.

use std::f64::consts::TAU;

use lagrangian::prelude::*;
use lagrangian::{DoubleDouble, Lanes};

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta),
    kinetic = 0.5 * dot(phi).powi(2) + 0.5 * dot(theta).powi(2) + 0.3 * cos(phi - theta / 2) * dot(phi) * dot(theta),
    potential = -cos(phi) - 0.4 * cos(theta / 2),
)]
struct Rotors;

fn motion<S: Scalar>(q: [f64; 2]) -> (State<S, 2>, u64) {
    let number = S::from_f64;
    let start = State::new(number(0.0), q.map(number), [3.0, -5.0].map(number));
    let end = Problem::new(&Rotors, start)
        .solve(20.0, Dop853::new())
        .unwrap();
    (end.last, end.statistics.steps)
}

/// An angle less whole periods of two turns, in numbers of more digits.
fn reduced(angle: f64) -> f64 {
    let period = DoubleDouble::pi() * DoubleDouble::from(4.0);
    let count = (angle / (2.0 * TAU)).round();
    (DoubleDouble::from(angle) - period * DoubleDouble::from(count)).to_f64()
}

#[test]
fn as_many_steps_and_the_same_angles() {
    for turns in [0.0, 1e5, 4e8, 6e8, 1e10, -3e12, 7e14] {
        let far = [turns * TAU + 0.4, 0.9 - 0.7 * turns * TAU];
        let near = far.map(reduced);
        let ((there, steps), (here, expected)) = (motion::<f64>(far), motion::<f64>(near));
        assert!(
            steps.abs_diff(expected) <= 2,
            "{turns:e}: {steps} steps, {expected} near zero"
        );
        for i in 0..2 {
            // The state itself has the digits of its size.
            let ulp = f64::EPSILON * far[i].abs();
            let error = (there.v[i] - here.v[i]).abs();
            assert!(error < 1e-8, "{turns:e}: {error:e}");
            let change = (there.q[i] - far[i]) - (here.q[i] - near[i]);
            assert!(change.abs() < 1e-8 + 4.0 * ulp, "{turns:e}: {change:e}");
        }
    }
}

#[test]
fn in_lanes() {
    let far = [6e9 * TAU + 0.4, 0.9 - 5e11 * TAU];
    let (alone, _) = motion::<f64>(far);
    let (lanes, _) = motion::<Lanes<4>>(far);
    for i in 0..2 {
        assert!((lanes.v[i].lane(1) - alone.v[i]).abs() < 1e-9);
    }
}
