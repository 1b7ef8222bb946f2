//! A top that spins upright: it sleeps if `(I_s ω₃)² > 4 I m g l`, and falls if it spins more slowly.
//!
//! `cargo run --release --example sleeping_top` derives the motion of the inclination θ alone, by Routh's reduction in half
//! angles, which has a value at θ = 0 itself; compares frequencies and rates of growth there with the formula, and how far the
//! top falls with the turning point of its energy; and writes `sleeping_top.svg`.

use std::error::Error;

use lagrangian::prelude::*;
use lagrangian_examples::{Panel, Svg, extent};

/// A symmetric top about its fixed point, and its motion without the ignorable angles.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(w = angular_velocity_zxz(phi, theta, psi)),
    kinetic = 0.5 * w.dot(diagonal([i, i, i_s]) * w),
    potential = weight * cos(theta),
    taylor,
    routhian(Inclination, half_angles),
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

/// The motion of the inclination with this spin ω₃, where φ and ψ have the same momentum: the top can stand upright.
fn upright(spin: f64) -> Inclination {
    let state = State::new(0.0, [0.0; 3], [0.0, 0.0, spin]);
    let (mut motion, _) = TOP.reduce(&state);
    motion.p_phi = motion.p_psi;
    motion
}

fn at(theta: f64) -> State<f64, 1> {
    State::new(0.0, theta, 0.0)
}

/// The inclination at which a top that leaves θ = 0 slowly turns back: cos θ = 2 (ω₃/ω₀)² − 1.
fn turning_point(ratio: f64) -> f64 {
    (2.0 * ratio * ratio - 1.0).acos()
}

fn main() -> Result<(), Box<dyn Error>> {
    let Top { i, i_s, weight } = TOP;
    let least = 2.0 * (i * weight).sqrt() / i_s;
    println!("The top sleeps from ω₃ = 2 √(I m g l)/I_s = {least:.4} rad/s on.\n");
    println!("  ω₃/least     θ̈/θ at θ = 0       formula   upright it is");
    for ratio in [0.7, 0.9, 0.99, 1.0, 1.01, 1.2, 2.0] {
        let motion = upright(ratio * least);
        let stiffness = -motion.linearize(&at(0.0)).position[0];
        let formula = (i_s * ratio * least / (2.0 * i)).powi(2) - weight / i;
        let verdict = match stiffness {
            x if x.abs() < 1e-9 * weight / i => {
                "stable by the term θ⁴ of the effective potential".into()
            }
            x if x > 0.0 => format!("asleep: it wobbles with {:.3} rad/s", x.sqrt()),
            x => format!("unstable: θ grows by e in {:.4} s", 1.0 / (-x).sqrt()),
        };
        println!(
            "  {ratio:8.2} {:16.6} {:13.6}   {verdict}",
            -stiffness, -formula
        );
    }

    println!("\nFrom θ = 10⁻⁴ rad, to the greatest inclination:");
    println!("  ω₃/least   θ / degrees     2 (ω₃/ω₀)² − 1 = cos θ");
    let mut curves = Vec::new();
    for (class, ratio) in CURVES {
        let motion = upright(ratio * least);
        let points: Vec<_> = Problem::new(&motion, at(1e-4))
            .save(Every(2e-3))
            .solve(6.0, Taylor::new())?
            .into_iter()
            .map(|state| [state.t, state.q[0].abs().to_degrees()])
            .collect();
        // The first turning point of θ behind the start.
        let turned = Problem::new(&motion, at(1e-4)).when(|x| x.v[0]).stop();
        let turned = turned.solve(10.0, Taylor::new())?;
        let formula = if ratio < 1.0 {
            turning_point(ratio)
        } else {
            0.0
        };
        let found = turned.q[0].abs();
        println!(
            "  {ratio:8.2} {:13.4} {:13.4}",
            found.to_degrees(),
            formula.to_degrees()
        );
        curves.push((class, ratio, points));
    }
    std::fs::write("sleeping_top.svg", figure(least, &curves))?;
    println!("Wrote sleeping_top.svg.");
    Ok(())
}

/// The curves of the figure, and their spins over the least one.
const CURVES: [(&str, f64); 4] = [
    ("curve", 0.8),
    ("second", 0.95),
    ("third", 1.0),
    ("limit", 1.1),
];

type Curve = (&'static str, f64, Vec<[f64; 2]>);

/// The effective potential above that of the upright top, and the inclination in time.
fn figure(least: f64, curves: &[Curve]) -> String {
    let title = "A top that spins upright";
    let subtitle =
        format!("It sleeps from ω₃ = {least:.1} rad/s on: V_eff is least at θ = 0 then.");
    let mut svg = Svg::titled(1100.0, 470.0, title, &subtitle);
    let potential = |ratio: f64| {
        let motion = upright(ratio * least);
        let ground = motion.effective_potential(&at(0.0));
        let points = (-300..=300).map(|k| f64::from(k) * 0.004);
        let points = points.map(move |theta| {
            let value = motion.effective_potential(&at(theta)) - ground;
            [theta.to_degrees(), 1e3 * value]
        });
        points.collect::<Vec<_>>()
    };
    let potentials: Vec<_> = curves
        .iter()
        .map(|(class, ratio, _)| (class, potential(*ratio)))
        .collect();
    let all = || potentials.iter().flat_map(|(_, points)| points);
    let valley = Panel::new(
        [84.0, 470.0, 112.0, 400.0],
        (extent(all().map(|x| x[0])), [-30.0, 40.0]),
        [7.0, 6.0],
    );
    let heading = "Effective potential";
    valley.draw(
        &mut svg,
        heading,
        "inclination θ / degrees",
        "V_eff(θ) − V_eff(0) / mJ",
    );
    let all = || curves.iter().flat_map(|(_, _, points)| points);
    let fall = Panel::new(
        [560.0, 946.0, 112.0, 400.0],
        (extent(all().map(|x| x[0])), extent(all().map(|x| x[1]))),
        [7.0, 6.0],
    );
    fall.draw(
        &mut svg,
        "From θ = 10⁻⁴ rad",
        "time t / s",
        "inclination |θ| / degrees",
    );
    for (class, points) in &potentials {
        let inside = |x: &&[f64; 2]| (-30.0..40.0).contains(&x[1]);
        valley.curve(&mut svg, class, points.iter().filter(inside).copied());
    }
    let mut y = 130.0;
    for (class, ratio, points) in curves {
        fall.curve(&mut svg, class, points.iter().copied());
        svg.entry(class, [970.0, y], &format!("{ratio:.2} of it"));
        y += 22.0;
    }
    svg.finish()
}
