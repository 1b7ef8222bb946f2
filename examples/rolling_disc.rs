//! A disc that rolls on a plane without slipping: a contact that holds, a nonholonomic constraint, and their reactions.
//!
//! `cargo run --release --example rolling_disc` lets a disc roll steadily in a circle, compares this motion with its closed
//! form, disturbs it, and writes `rolling_disc.svg`: the paths of the point of contact, and the forces of the plane on the disc.
//!
//! The model is the disc of C. Le Saux, R. I. Leine & C. Glocker, *Dynamics of a rolling disk in the presence of dry friction*,
//! J. Nonlinear Sci. **15** (2005) 27–61, while it rolls.

use std::error::Error;

use lagrangian::prelude::*;
use lagrangian_examples::{Panel, Svg, extent};

/// A thin disc: its centre, and z-x-z Euler angles of which θ inclines the axis of the disc, so that it stands upright at 90°.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(p: Vector3, phi, theta, psi),
    define(
        w = angular_velocity_zxz(phi, theta, psi),
        // From the centre to the point of contact, the lowest of the rim.
        arm = -r * (rotation_z(phi) * [0.0, cos(theta), sin(theta)]),
        // The velocity of the material point there.
        slip = dot(p) + angular_velocity_zxz_inertial(phi, theta, psi).cross(arm),
    ),
    kinetic = 0.5 * m * dot(p).norm_squared() + 0.125 * m * r.powi(2) * w.dot(diagonal([1.0, 1.0, 2.0]) * w),
    potential = m * g * p.z,
    constraint(ground = p.z - r * sin(theta)),
    nonholonomic(rolling = [slip.x, slip.y]),
    output(contact = p + arm, normal = reaction(ground), friction = reaction(rolling)),
)]
struct Disc {
    m: f64,
    r: f64,
    g: f64,
}

const DISC: Disc = Disc {
    m: 0.4,
    r: 0.04,
    g: 9.81,
};

impl Disc {
    /// The state in which the disc rolls steadily in a circle about the origin, with this inclination and precession Ω, and
    /// the velocity of its centre.
    ///
    /// With the moments A = ¼ m r² and C = ½ m r² the angular velocity about the axis follows from
    /// (C + m r²) ω₃ Ω sin θ − A Ω² sin θ cos θ + m g r cos θ = 0.
    fn circle(&self, theta: f64, rate: f64) -> (State<f64, 6>, f64) {
        let Self { r, g, .. } = *self;
        let (sin, cos) = theta.sin_cos();
        let axial = cos * (0.25 * r * rate * rate * sin - g) / (1.5 * r * rate * sin);
        let speed = -r * axial;
        let q = [0.0, -speed / rate, r * sin, 0.0, theta, 0.0];
        let v = [speed, 0.0, 0.0, rate, 0.0, axial - rate * cos];
        (State::new(0.0, q, v), speed)
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let (theta, rate) = (60_f64.to_radians(), 6.0);
    let (steady, speed) = DISC.circle(theta, rate);
    let roll = |start: State<f64, 6>| {
        Problem::new(&DISC, start)
            .save(Every(0.005))
            .solve(5.0, Dop853::new().relative_tolerance(1e-12))
    };

    let circle = roll(steady)?;
    report_circle(&circle.last, speed);

    // What turns the disc up disturbs the circle, and the disc nods while it rolls on.
    let mut pushed = steady;
    pushed.v[Disc::THETA] = 2.0;
    let pushed = DISC
        .assemble(pushed)
        .hold_velocities([Disc::THETA])
        .solve()?
        .state;
    let nodding = roll(pushed)?;
    report_nodding(nodding.samples());
    std::fs::write(
        "rolling_disc.svg",
        figure(circle.samples(), nodding.samples()),
    )?;
    println!("Wrote rolling_disc.svg.");
    Ok(())
}

/// Compares a steady motion with the closed form.
fn report_circle(end: &State<f64, 6>, speed: f64) {
    let rate = end.v[Disc::PHI];
    let radius = speed / rate;
    let forces = DISC.outputs(end);
    // The disc leans by 30° towards the centre of its circle, on which friction keeps it.
    let friction = DISC.m * (speed * rate).abs();
    let rows = [
        ("radius [m]", radius, end.q[0].hypot(end.q[1])),
        ("inclination [°]", 60.0, end.q[Disc::THETA].to_degrees()),
        ("normal force [N]", DISC.m * DISC.g, forces.normal),
        ("friction [N]", friction, forces.friction.norm()),
    ];
    println!("Steady rolling in a circle, after {} s:\n", end.t);
    println!("                       closed form     integrated");
    for (name, expected, found) in rows {
        println!("  {name:17} {expected:14.9} {found:14.9}");
        assert!((found - expected).abs() < 1e-9 * expected.abs());
    }
}

/// Says how well energy and constraints are kept, and what friction the motion needs.
fn report_nodding(motion: &[State<f64, 6>]) {
    let energies: Vec<f64> = motion.iter().map(|x| DISC.energy(x)).collect();
    let errors = energies.iter().map(|x| (x / energies[0] - 1.0).abs());
    let error = errors.fold(0.0, f64::max);
    let residuals = motion.iter().map(|x| DISC.constraint_residuals(x));
    let [gap, slip] = residuals.fold([0.0_f64; 2], |[gap, slip], (g, w)| {
        [gap.max(g.amax()), slip.max(w.amax())]
    });
    let grips = motion.iter().map(|x| DISC.outputs(x));
    let grip = grips.fold(0.0_f64, |most, x| most.max(x.friction.norm() / x.normal));
    println!("\nDisturbed, with θ̇ = 2 rad/s:\n");
    println!("  the energy is kept to {error:.1e}, the contact to {gap:.0e} m and {slip:.0e} m/s");
    println!("  the coefficient of friction is to be at least {grip:.3}");
    assert!(error < 1e-10 && gap < 1e-9 && slip < 1e-9);
}

/// The paths of the point of contact, and the forces of the plane in the first second.
fn figure(circle: &[State<f64, 6>], nodding: &[State<f64, 6>]) -> String {
    let subtitle = "In a steady circle, and disturbed.";
    let mut svg = Svg::titled(
        1100.0,
        520.0,
        "A disc that rolls without slipping",
        subtitle,
    );
    let outputs = |states: &[State<f64, 6>]| -> Vec<_> {
        states
            .iter()
            .map(|state| (state.t, DISC.outputs(state)))
            .collect()
    };
    let motions = [("second", outputs(circle)), ("curve", outputs(nodding))];

    let places = motions.iter().flat_map(|(_, motion)| motion);
    let [low, high] = extent(places.flat_map(|(_, x)| [x.contact.x, x.contact.y]));
    let range = [1e2 * low - 1.0, 1e2 * high + 1.0];
    let path = Panel::new([84.0, 422.0, 112.0, 450.0], (range, range), [6.0, 6.0]);
    path.draw(&mut svg, "Path of the point of contact", "x / cm", "y / cm");
    for (class, motion) in &motions {
        let points = motion
            .iter()
            .map(|(_, x)| [1e2 * x.contact.x, 1e2 * x.contact.y]);
        path.curve(&mut svg, class, points);
    }

    let panel = |svg: &mut Svg, top: f64, heading: &str, force: fn(&DiscOutputs<f64>) -> f64| {
        let first = |motion: &[(f64, DiscOutputs<f64>)]| -> Vec<[f64; 2]> {
            let first = motion.iter().take_while(|(t, _)| *t <= 1.0);
            first.map(|(t, x)| [*t, force(x)]).collect()
        };
        let [_, high] = extent(motions.iter().flat_map(|x| first(&x.1)).map(|[_, y]| y));
        let range = ([0.0, 1.0], [0.0, 1.1 * high]);
        let panel = Panel::new([560.0, 946.0, top, top + 130.0], range, [6.0, 4.0]);
        panel.draw(svg, heading, "time t / s", "force / N");
        for (class, motion) in &motions {
            panel.curve(svg, class, first(motion).into_iter());
        }
    };
    panel(&mut svg, 112.0, "Normal force", |x| x.normal);
    panel(&mut svg, 320.0, "Friction", |x| x.friction.norm());
    svg.entry("second", [970.0, 130.0], "circle");
    svg.entry("curve", [970.0, 152.0], "disturbed");
    svg.finish()
}
