//! A four-bar linkage as a closed loop: assembled, driven at a constant speed, with the forces in its joint and in its motor.
//!
//! `cargo run --release --example four_bar` follows Hoecken's linkage for one turn of its crank, compares the point that it
//! guides with the closed form, and writes `four_bar.svg`: the curve of this point, the force in the joint that closes the
//! loop, and the torque of the motor.

use std::error::Error;
use std::f64::consts::PI;

use lagrangian::prelude::*;
use lagrangian_examples::{Panel, Svg, extent};

/// A crank, a coupler and a rocker in a vertical plane, uniform bars with the angles of their axes to the horizontal. The
/// coupler reaches beyond its joint with the rocker by as much again, to the point that the linkage guides.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(crank, coupler, rocker),
    define(
        pin = a * [cos(crank), sin(crank)],
        arm = b * [cos(coupler), sin(coupler)],
        support = [d, 0.0],
        end = support + b * [cos(rocker), sin(rocker)],
    ),
    kinetic = (m * a / b) * a.powi(2) * dot(crank).powi(2) / 6.0,
    kinetic = m * (dot(pin + arm).norm_squared() + b.powi(2) * dot(coupler).powi(2) / 3.0),
    kinetic = m * b.powi(2) * dot(rocker).powi(2) / 6.0,
    potential = m * g * (a / b * pin.y / 2.0 + 2.0 * (pin + arm).y + end.y / 2.0),
    // The reaction is the force on the coupler, the body of the first term.
    constraint(joint = pin + arm - end),
    // A constraint that contains the time. The reaction is the torque on the crank.
    constraint(motor = crank - speed * t),
    output(point = pin + 2.0 * arm, force = reaction(joint), torque = reaction(motor)),
)]
struct FourBar {
    /// The lengths of the crank, of the rocker and of either half of the coupler, and the distance of the supports.
    a: f64,
    b: f64,
    d: f64,
    /// The mass of the rocker; the other bars weigh as much by length.
    m: f64,
    g: f64,
    speed: f64,
}

const HOECKEN: FourBar = FourBar {
    a: 0.1,
    b: 0.25,
    d: 0.2,
    m: 0.5,
    g: 9.81,
    speed: 4.0 * PI,
};

/// The guided point: the joint is as far from the pin as from the support, and the point twice as far.
fn closed_form(crank: f64) -> [f64; 2] {
    let FourBar { a, b, d, .. } = HOECKEN;
    let (x, y) = (a * crank.cos(), a * crank.sin());
    let half = 0.5 * (d - x).hypot(y);
    let height = (b * b - half * half).sqrt();
    [d + height * y / half, height * (d - x) / half]
}

fn main() -> Result<(), Box<dyn Error>> {
    // The crank is held; the other angles are guesses.
    let guess = State::new(0.0, [0.0, 1.2, 1.8], [HOECKEN.speed, 0.0, 0.0]);
    let start = HOECKEN
        .assemble(guess)
        .hold([FourBar::CRANK])
        .hold_velocities([FourBar::CRANK])
        .solve()?;
    let angles = start.state.q.map(f64::to_degrees);
    println!(
        "Assembled at a crank angle of {:.0}°: coupler {:.3}°, rocker {:.3}°\n",
        angles[0], angles[1], angles[2]
    );

    let turn = 2.0 * PI / HOECKEN.speed;
    let motion = Problem::new(&HOECKEN, start.state)
        .save(Every(turn / 360.0))
        .solve(turn, Taylor::new())?;
    let samples = motion.samples();

    report(samples);
    std::fs::write("four_bar.svg", figure(samples))?;
    println!("Wrote four_bar.svg.");
    Ok(())
}

/// Prints what the linkage does in a turn, and what checks it.
fn report(samples: &[State<f64, 3>]) {
    println!("  crank [°]   guided point [m]    force on the coupler [N]   torque [N m]");
    let mut errors = Vec::new();
    let mut torques = Vec::new();
    for (i, state) in samples.iter().enumerate() {
        let FourBarOutputs {
            point,
            force,
            torque,
        } = HOECKEN.outputs(state);
        let [x, y] = closed_form(state.q[FourBar::CRANK]);
        errors.push((point.x - x).hypot(point.y - y));
        torques.push(torque);
        if i % 30 == 0 {
            println!(
                "{:11.1} {:9.4} {:8.4} {:13.3} {:10.3} {:14.4}",
                state.q[FourBar::CRANK].to_degrees(),
                point.x,
                point.y,
                force.x,
                force.y,
                torque
            );
        }
    }
    let error = errors.iter().fold(0.0_f64, |most, x| most.max(*x));
    println!("\nThe guided point agrees with the closed form to {error:.0e} m.");
    // From a quarter to three quarters of the turn the point moves along a straight line, nearly.
    let heights = samples[90..=270]
        .iter()
        .map(|state| HOECKEN.outputs(state).point.y);
    let [low, high] = extent(heights);
    println!(
        "Half a turn long its height changes by {:.2} mm.",
        1e3 * (high - low)
    );
    // Nothing is lost in the joints: over a turn the motor does no work.
    let mean = torques[1..].iter().sum::<f64>() / 360.0;
    println!("The mean torque of the motor is {mean:.0e} N m.");
    assert!(error < 1e-12 && mean.abs() < 1e-11);
}

/// The curve of the guided point with the linkage, the force in the joint, and the torque of the motor.
fn figure(samples: &[State<f64, 3>]) -> String {
    let subtitle = format!("A turn of the crank in {:.2} s.", 2.0 * PI / HOECKEN.speed);
    let mut svg = Svg::titled(1100.0, 520.0, "Hoecken's linkage", &subtitle);
    let outputs: Vec<_> = samples.iter().map(|state| HOECKEN.outputs(state)).collect();

    linkage(&mut svg, samples);
    let degrees = || {
        samples
            .iter()
            .map(|state| state.q[FourBar::CRANK].to_degrees())
    };
    let panel = |svg: &mut Svg, top: f64, curves: &[(&str, Vec<f64>)], text: [&str; 2]| {
        let [low, high] = extent(curves.iter().flat_map(|(_, values)| values.iter().copied()));
        let margin = 0.06 * (high - low);
        let range = ([0.0, 360.0], [low - margin, high + margin]);
        let panel = Panel::new([560.0, 946.0, top, top + 130.0], range, [6.0, 4.0]);
        panel.draw(svg, text[0], "crank angle / degrees", text[1]);
        panel.level(svg, "zero", 0.0);
        for (class, values) in curves {
            let points = degrees().zip(values).map(|(x, y)| [x, *y]);
            panel.curve(svg, class, points);
        }
    };
    let forces = [
        ("curve", outputs.iter().map(|x| x.force.x).collect()),
        ("second", outputs.iter().map(|x| x.force.y).collect()),
    ];
    panel(
        &mut svg,
        112.0,
        &forces,
        ["Force on the coupler", "force / N"],
    );
    svg.entry("curve", [970.0, 130.0], "along x");
    svg.entry("second", [970.0, 152.0], "along y");
    let torques = [("curve", outputs.iter().map(|x| x.torque).collect())];
    panel(
        &mut svg,
        320.0,
        &torques,
        ["Torque of the motor", "torque / (N m)"],
    );
    svg.finish()
}

/// The curve of the guided point, and the bars.
fn linkage(svg: &mut Svg, samples: &[State<f64, 3>]) {
    let points = samples.iter().map(|state| HOECKEN.outputs(state).point);
    let path = Panel::new(
        [84.0, 452.0, 112.0, 450.0],
        ([-0.15, 0.45], [-0.05, 0.5]),
        [6.0, 6.0],
    );
    path.draw(svg, "Curve of the guided point", "x / m", "y / m");
    path.curve(svg, "curve", points.map(|x| [x.x, x.y]));
    // The bars where the crank has turned by 60°.
    let (state, place) = (&samples[60], HOECKEN.outputs(&samples[60]).point);
    let [crank, _, rocker] = [0, 1, 2].map(|i| state.q[i].sin_cos());
    let pin = [HOECKEN.a * crank.1, HOECKEN.a * crank.0];
    let end = [HOECKEN.d + HOECKEN.b * rocker.1, HOECKEN.b * rocker.0];
    let bars = [[0.0, 0.0], pin, [place.x, place.y]];
    path.curve(svg, "frame", bars.into_iter());
    path.curve(svg, "frame", [[HOECKEN.d, 0.0], end].into_iter());
    for [x, y] in [[0.0, 0.0], pin, end, [HOECKEN.d, 0.0], [place.x, place.y]] {
        svg.circle("start", path.at(x, y), 4.0);
    }
}
