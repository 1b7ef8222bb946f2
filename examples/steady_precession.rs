//! Steady precession of a top (4.11): a slow and a fast one, where it spins fast enough.
//!
//! `cargo run --release --example steady_precession` finds both rates in closed form and as relative equilibria of the motion
//! of θ, which Routh's reduction derives, compares the frequency of nutation about each with the closed form, and writes
//! `steady_precession.svg`: the rates against the spin, and the valleys of the effective potential.

use std::error::Error;

use lagrangian::prelude::*;
use lagrangian::rigid_body::SteadyPrecession;
use lagrangian_examples::{Panel, Svg};

/// A symmetric top about its fixed point, and its motion without the ignorable angles.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(w = angular_velocity_zxz(phi, theta, psi)),
    kinetic = 0.5 * w.dot(diagonal([i, i, i_s]) * w),
    potential = weight * cos(theta),
    taylor,
    routhian(Nutation),
)]
struct Top {
    i: f64,
    i_s: f64,
    weight: f64,
}

const TOP: Top = Top {
    i: 0.0025,
    i_s: 0.0008,
    weight: 0.18,
};

const THETA: f64 = 0.6;

impl Top {
    /// The precession at an inclination.
    fn steady(&self, spin: f64, theta: f64) -> SteadyPrecession {
        let slope = -self.weight * theta.sin();
        SteadyPrecession::of_top(self.i, self.i_s, spin, theta, slope)
    }

    /// The motion of θ with the constants of the top that precesses with this rate.
    fn about(&self, spin: f64, rate: f64) -> (Nutation, State<f64, 1>) {
        let rates = [rate, 0.0, spin - rate * THETA.cos()];
        self.reduce(&State::new(0.0, [0.0, THETA, 0.0], rates))
    }

    /// The frequency of small nutations, √(φ̇² − 2 (m g l/I) cos θ + (m g l/(I φ̇))²).
    fn nutation(&self, rate: f64) -> f64 {
        let ratio = self.weight / self.i;
        (rate * rate - 2.0 * ratio * THETA.cos() + (ratio / rate).powi(2)).sqrt()
    }
}

/// The frequency of nutation between turning points of θ, a whole nutation apart.
fn measured(motion: &Nutation, start: State<f64, 1>) -> Result<f64, IntegrationError> {
    let next = |from: State<f64, 1>| -> Result<State<f64, 1>, IntegrationError> {
        let turning = Problem::new(motion, from).when(|x| x.v[0]).stop();
        Ok(turning.solve(from.t + 5.0, Taylor::new())?.last)
    };
    let from = next(start)?;
    let to = next(next(from)?)?;
    Ok(2.0 * std::f64::consts::PI / (to.t - from.t))
}

fn main() -> Result<(), Box<dyn Error>> {
    let Top { i, i_s, weight } = TOP;
    let least = 2.0 * (i * weight * THETA.cos()).sqrt() / i_s;
    println!("At θ = {THETA} rad the top precesses steadily from ω₃ = {least:.4} rad/s on.\n");
    println!("  ω₃       φ̇ (4.11)    θ̈ there   nutation, closed form   linearized   measured");
    for spin in [40.0, 50.0, 80.0, 160.0] {
        let (slow, fast) = match TOP.steady(spin, THETA) {
            SteadyPrecession::Two { slow, fast } => (slow, fast),
            SteadyPrecession::None {
                discriminant,
                least_axial_velocity,
            } => {
                let lack = least_axial_velocity / spin - 1.0;
                println!(
                    "{spin:5.0}   none: it spins too slowly by {:.1} %, Δ = {discriminant:.1e}",
                    100.0 * lack
                );
                continue;
            }
            other => return Err(format!("not expected: {other:?}").into()),
        };
        for rate in [slow, fast] {
            let (motion, steady) = TOP.about(spin, rate);
            let balance = motion.accelerations(&steady)[0];
            let linear = (-motion.linearize(&steady).position[0]).sqrt();
            let beside = State::new(0.0, THETA + 1e-4, 0.0);
            println!(
                "{spin:5.0} {rate:14.8} {balance:10.0e} {:23.8} {linear:12.8} {:10.6}",
                TOP.nutation(rate),
                measured(&motion, beside)?
            );
        }
    }
    std::fs::write("steady_precession.svg", figure(least)?)?;
    println!("Wrote steady_precession.svg.");
    Ok(())
}

/// The rates against the spin, and the effective potentials of a slow and a fast precession.
fn figure(least: f64) -> Result<String, Box<dyn Error>> {
    let subtitle = format!(
        "At θ = {:.1}°, from ω₃ = {least:.1} rad/s on.",
        THETA.to_degrees()
    );
    let mut svg = Svg::titled(1100.0, 470.0, "Steady precession of a top", &subtitle);
    let rates = Panel::new(
        [84.0, 470.0, 112.0, 400.0],
        ([30.0, 160.0], [0.0, 60.0]),
        [7.0, 6.0],
    );
    rates.draw(
        &mut svg,
        "Rates (4.11)",
        "spin ω₃ / (rad/s)",
        "precession φ̇ / (rad/s)",
    );
    let spins = || (0..=600).map(|k| least + (160.0 - least) * (f64::from(k) / 600.0).powi(2));
    let both = |spin: f64| match TOP.steady(spin, THETA) {
        SteadyPrecession::Two { slow, fast } => Some([slow, fast]),
        _ => None,
    };
    for (k, class) in ["curve", "second"].into_iter().enumerate() {
        let points = spins().filter_map(|spin| Some([spin, both(spin)?[k]]));
        rates.curve(&mut svg, class, points);
    }
    let [top, bottom] = [60.0, 0.0].map(|y| rates.at(least, y));
    svg.line("limit", bottom, top);
    let valleys = Panel::new(
        [560.0, 946.0, 112.0, 400.0],
        ([10.0, 70.0], [-2.0, 40.0]),
        [7.0, 6.0],
    );
    let heading = "Effective potential at ω₃ = 80 rad/s";
    valleys.draw(
        &mut svg,
        heading,
        "inclination θ / degrees",
        "V_eff(θ) − V_eff(θ₀) / mJ",
    );
    let [slow, fast] = both(80.0).ok_or("the top spins too slowly")?;
    let mut y = 130.0;
    for (class, rate, name) in [("curve", slow, "slow"), ("second", fast, "fast")] {
        let (motion, steady) = TOP.about(80.0, rate);
        let ground = motion.effective_potential(&steady);
        let points = (0..=600).map(|k| 10.0 + 0.1 * f64::from(k)).map(|degrees| {
            let state = State::new(0.0, degrees.to_radians(), 0.0);
            [degrees, 1e3 * (motion.effective_potential(&state) - ground)]
        });
        valleys.curve(&mut svg, class, points.filter(|x| x[1] < 40.0));
        svg.entry(class, [970.0, y], name);
        y += 22.0;
    }
    Ok(svg.finish())
}
