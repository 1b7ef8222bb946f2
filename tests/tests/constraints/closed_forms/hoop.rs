//! A bead on a hoop that is turned by a drive, whose angle is a constraint in time: against the motion with one coordinate, and the
//! torque and the power of the drive.

use lagrangian::EnergyResidual;
use lagrangian::prelude::*;
use lagrangian_tests::{Figures, Random, array, list, motions, number, rows};

use super::{TOLERANCE, by_both_methods, compare};

/// A bead on a hoop that turns about its vertical diameter.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    energy_balance,
    coordinates(theta, phi),
    define(p = r * [sin(theta) * cos(phi), sin(theta) * sin(phi), -cos(theta)]),
    kinetic = 0.5 * m * dot(p).norm_squared(),
    potential = m * g * p.z,
    dissipation = 0.5 * c * dot(theta).powi(2),
    constraint(drive = phi - w * t - e * sin(nu * t)),
    output(torque = reaction(drive)),
)]
struct DrivenHoop {
    m: f64,
    r: f64,
    g: f64,
    w: f64,
    e: f64,
    nu: f64,
    c: f64,
}

impl DrivenHoop {
    /// The angle of the hoop, its rate and its acceleration.
    fn drive(&self, t: f64) -> [f64; 3] {
        let Self { w, e, nu, .. } = *self;
        let (sine, cosine) = (nu * t).sin_cos();
        [w * t + e * sine, w + e * nu * cosine, -e * nu * nu * sine]
    }

    /// The state of a bead at this angle.
    fn at(&self, t: f64, theta: f64, rate: f64) -> State<f64, 2> {
        let [phi, speed, _] = self.drive(t);
        State::new(t, [theta, phi], [rate, speed])
    }

    /// The rate of the angular momentum m r² sin²θ φ̇ about the axis.
    fn torque(&self, state: &State<f64, 2>) -> f64 {
        let [_, speed, acceleration] = self.drive(state.t);
        let (sine, cosine) = state.q[0].sin_cos();
        let rate = 2.0 * sine * cosine * state.v[0] * speed + sine * sine * acceleration;
        self.m * self.r * self.r * rate
    }
}

#[test]
fn a_driven_hoop_turns_as_if_its_angle_were_given() {
    let mut figures = Figures::new();
    for motion in motions("bead_rotating_hoop") {
        let names = ["m", "r", "g", "w", "e", "nu", "c"];
        let [m, r, g, w, e, nu, c] = motion.parameters(names);
        #[rustfmt::skip]
        let hoop = DrivenHoop { m, r, g, w, e, nu, c };
        let [theta] = array(&motion.system["init"]["q"]);
        let [rate] = array(&motion.system["init"]["qd"]);
        let start = hoop.at(0.0, theta, rate);
        // The samples are at multiples of ½.
        for (tolerance, states) in by_both_methods(&hoop, start, (10.0, 20)) {
            for sample in list(&motion.system["samples"]) {
                let t = number(&sample["t"]);
                let state = states.iter().find(|state| (state.t - t).abs() < 1e-9);
                let state = state.expect("a state at this time");
                check(&mut figures, &hoop, state, (t, tolerance), sample);
            }
        }
    }
    figures.finish();
}

fn check(
    figures: &mut Figures,
    hoop: &DrivenHoop,
    state: &State<f64, 2>,
    at: (f64, f64),
    sample: &serde_json::Value,
) {
    let [theta, rate, acceleration] = ["q", "qd", "qdd"].map(|name| array::<1>(&sample[name])[0]);
    let [phi, speed, change] = hoop.drive(at.0);
    compare(figures, "angles", at, &rows(&state.q), &[theta, phi]);
    compare(figures, "rates", at, &rows(&state.v), &[rate, speed]);
    let found = rows(&hoop.accelerations(state));
    compare(
        figures,
        "accelerations",
        at,
        &found,
        &[acceleration, change],
    );
    let torque = hoop.torque(&hoop.at(at.0, theta, rate));
    let found = hoop.outputs(state).torque;
    compare(figures, "torque", at, &[found], &[torque]);
}

/// dh/dt = Q·q̇ − ∂L/∂t − λᵀ ∂g/∂t.
#[test]
fn the_rate_of_the_energy_has_the_power_of_the_drive() {
    let mut random = Random::default();
    let mut figures = Figures::new();
    for _ in 0..100 {
        let [m, r, g, w, e, nu, c] = random.array(0.2, 3.0);
        #[rustfmt::skip]
        let hoop = DrivenHoop { m, r, g, w, e, nu, c };
        let [t, theta, rate] = random.array(-3.0, 3.0);
        let state = hoop.at(t, theta, rate);
        let expected = hoop.torque(&state) * state.v[DrivenHoop::PHI] - c * rate * rate;
        let found = hoop.energy_rate(&state);
        compare(&mut figures, "power", (t, TOLERANCE), &[found], &[expected]);
    }
    figures.finish();
}

#[test]
fn the_drive_pays_for_the_energy() {
    #[rustfmt::skip]
    let hoop = DrivenHoop { m: 1.0, r: 0.5, g: 9.81, w: 6.0, e: 0.3, nu: 2.0, c: 0.05 };
    let problem = Problem::new(&hoop, hoop.at(0.0, 0.9, 0.4)).save(Dense);
    let motion = problem.solve(20.0, Taylor::new()).expect("a motion");
    let residual = EnergyResidual::along(&hoop, &motion).expect("a balance");
    let relative = residual.largest.abs() / residual.exchanged;
    assert!(relative < 1e-12, "{relative:e}");
}
