//! A gyroscope in gimbals, with a weight on the frame of its rotor: it precesses, and nutates while it does.
//!
//! `cargo run --release --example gyroscope` compares rates with the formulas of gyroscopes whose gimbals have inertia, and
//! writes `gyroscope.svg`: the path of the rotor's axis, released in three ways.

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};

use lagrangian::nalgebra::Rotation3;
use lagrangian::prelude::*;
use lagrangian::rigid_body::{BodyError, Solid, SteadyPrecession};
use lagrangian_examples::{Anchor, Panel, Svg, extent};
use lagrangian_models::Gyroscope;

/// Two rings of brass and a rotor of steel; lengths in m, densities in kg/m³. The weight, in kg, hangs on the inner gimbal at
/// this distance from the centre.
fn gyroscope(weight: f64, distance: f64) -> Result<Gyroscope, BodyError> {
    let ring = |radius: f64| Solid::torus(radius, 0.003)?.with_density(8500.0);
    let upright = Rotation3::from_axis_angle(&Vector3::x_axis(), FRAC_PI_2);
    let inner = ring(0.055)?.turned(&upright);
    let weight = RigidBody::particle(weight, Vector3::new(0.0, 0.0, distance))?;
    let disc = Solid::cylinder(0.04, 0.012)?.with_density(7850.0)?;
    let shaft = Solid::cylinder(0.003, 0.11)?.with_density(7850.0)?;
    Ok(Gyroscope {
        outer: ring(0.065)?.turned(&upright),
        inner: inner.plus(&weight),
        rotor: SymmetricBody::of(&disc.plus(&shaft))?,
        g: 9.81,
    })
}

/// The constants of the reduced motion of θ: T = ½ B(θ) φ̇² + ½ N θ̇² + ½ `I_s` ω₃² with B = A sin²θ + C cos²θ, V = m g l cos θ.
struct Reduced {
    /// About the vertical with the rotor's axis horizontal, A.
    across: f64,
    /// About the vertical with the rotor's axis vertical, without the rotor's spin, C.
    along: f64,
    /// About the axis of the inner gimbal, N.
    nodding: f64,
    /// Of the rotor about its axis, `I_s`.
    axial: f64,
    /// m g l.
    weight: f64,
}

impl Reduced {
    fn of(model: &Gyroscope) -> Self {
        let about_center = |body: &RigidBody| body.inertia_about(&Vector3::zeros()).moments();
        let [nodding, across, along] = about_center(&model.inner);
        let [_, _, outer] = about_center(&model.outer);
        let rotor = model.rotor.transverse_moment();
        Self {
            across: outer + across + rotor,
            along: outer + along,
            nodding: nodding + rotor,
            axial: model.rotor.axial_moment(),
            weight: model.inner.mass() * model.g * model.inner.center().z,
        }
    }

    /// The rates of steady precession: (4.11), where the gimbals' inertia takes the place of I by A − C.
    fn steady(&self, spin: f64, theta: f64) -> SteadyPrecession {
        let slope = -self.weight * theta.sin();
        SteadyPrecession::of_top(self.across - self.along, self.axial, spin, theta, slope)
    }

    /// The frequency of small nutations about a steady precession, `√(V_eff″/N)`, with `V_eff = u²/(2 B) + m g l cos θ` and
    /// `u = C_φ − C_ψ cos θ` (4.8).
    fn nutation(&self, spin: f64, theta: f64, precession: f64) -> f64 {
        let (sin, cos) = theta.sin_cos();
        let excess = self.across - self.along;
        let inertia = self.along + excess * sin * sin;
        let [slope, curvature] = [2.0 * excess * sin * cos, 2.0 * excess * (2.0 * theta).cos()];
        // B φ̇ is u at the steady precession.
        let momentum = inertia * precession;
        let [u_slope, u_curvature] = [self.axial * spin * sin, self.axial * spin * cos];
        let stiffness = (u_slope * u_slope + momentum * u_curvature) / inertia
            - 2.0 * precession * u_slope * slope / inertia
            - 0.5 * precession * precession * curvature
            + precession * precession * slope * slope / inertia
            - self.weight * cos;
        (stiffness / self.nodding).sqrt()
    }
}

/// A state at rest but for the spin ω₃ = ψ̇ + φ̇ cos θ and the precession.
fn released(theta: f64, spin: f64, precession: f64) -> State<f64, 3> {
    let rates = [precession, 0.0, spin - precession * theta.cos()];
    State::new(0.0, [0.0, theta, 0.0], rates)
}

/// The mean rates of precession and of nutation between turning points of θ, a whole nutation apart.
fn rates(model: &Gyroscope, start: State<f64, 3>) -> Result<[f64; 2], IntegrationError> {
    let next = |from: State<f64, 3>| -> Result<State<f64, 3>, IntegrationError> {
        let turning = Problem::new(model, from).when(|x| x.v[Gyroscope::THETA]);
        Ok(turning.stop().solve(from.t + 5.0, Taylor::new())?.last)
    };
    let from = next(start)?;
    let to = next(next(from)?)?;
    let period = to.t - from.t;
    let turned = to.q[Gyroscope::PHI] - from.q[Gyroscope::PHI];
    Ok([turned / period, 2.0 * PI / period])
}

fn main() -> Result<(), Box<dyn Error>> {
    let model = gyroscope(0.03, 0.06)?;
    let reduced = Reduced::of(&model);
    let spin = 150.0;
    let theta: f64 = 1.1;
    println!(
        "A rotor of {:.3} kg turns with {spin} rad/s; the axis is {theta} rad from the vertical.",
        model.rotor.mass()
    );
    let SteadyPrecession::Two { slow, fast } = reduced.steady(spin, theta) else {
        return Err("the rotor spins too slowly for a steady precession".into());
    };
    let simple = reduced.weight / (reduced.axial * spin);
    println!("\nRates of steady precession in rad/s, (4.11) with the inertia of the gimbals:");
    println!("  slow {slow:.6}, fast {fast:.3}; m g l/(I_s ω₃) is {simple:.6}");
    let balance = model.accelerations(&released(theta, spin, slow))[Gyroscope::THETA];
    println!("  in the slow one θ̈ is {balance:.0e} rad/s²");

    print_rates(&model, &reduced, (spin, theta, slow))?;
    let motions = motions(&model, (spin, theta, slow))?;
    std::fs::write("gyroscope.svg", figure(&model, theta, slow, &motions))?;
    println!("Wrote gyroscope.svg.");
    Ok(())
}

/// Rates of precession and nutation next to the steady precession, beside the formula.
fn print_rates(
    model: &Gyroscope,
    reduced: &Reduced,
    (spin, theta, slow): (f64, f64, f64),
) -> Result<(), IntegrationError> {
    println!("\nAt rates next to the steady one, in rad/s:");
    println!("  φ̇ at the start   mean φ̇     nutation    √(V_eff″/N)");
    let formula = reduced.nutation(spin, theta, slow);
    for excess in [0.3, 0.03, 0.003] {
        let start = released(theta, spin, slow * (1.0 + excess));
        let [precession, nutation] = rates(model, start)?;
        println!(
            "  {:12.6} {precession:12.6} {nutation:12.6} {formula:12.6}",
            start.v[Gyroscope::PHI]
        );
    }
    println!();
    Ok(())
}

/// The motions after each release.
fn motions(
    model: &Gyroscope,
    (spin, theta, slow): (f64, f64, f64),
) -> Result<Vec<Motion>, IntegrationError> {
    let times: Vec<f64> = (0..=4000).map(|k| 1.2 * f64::from(k) / 4000.0).collect();
    let mut motions = Vec::new();
    for (class, factor, name) in RELEASES {
        let start = released(theta, spin, slow * factor);
        let problem = Problem::new(model, start).save(&times);
        let states: Vec<_> = problem.solve(1.2, Taylor::new())?.into_iter().collect();
        let drift = states
            .iter()
            .map(|state| (model.energy(state) / model.energy(&start) - 1.0).abs());
        let drift = drift.fold(0.0, f64::max);
        println!("{name}: energy kept to {drift:.0e}");
        motions.push((class, name, states));
    }
    Ok(motions)
}

/// How the axis is released: the class of its curve, and its precession as a multiple of the slow steady one.
const RELEASES: [(&str, f64, &str); 3] = [
    ("curve", 0.0, "released at rest: cusps"),
    ("second", -3.0, "thrown backwards: loops"),
    ("third", 1.6, "thrown forwards: waves"),
];

type Motion = (&'static str, &'static str, Vec<State<f64, 3>>);

/// The panels of the figure: the path of the axis, its inclination over time, and the path from above.
struct Panels {
    path: Panel,
    inclination: Panel,
    above: Panel,
}

impl Panels {
    /// Panels that all motions fit into, drawn.
    fn draw(svg: &mut Svg, motions: &[Motion]) -> Self {
        let all = || motions.iter().flat_map(|(_, _, states)| states);
        let degrees = |i: usize| extent(all().map(|state| state.q[i].to_degrees()));
        let [low, high] = degrees(Gyroscope::THETA);
        let margin = 0.08 * (high - low);
        let inclinations = [low - margin, high + margin];
        let panel = |place, x, y| Panel::new(place, (x, y), [8.0, 5.0]);
        let azimuths = degrees(Gyroscope::PHI);
        let times = extent(all().map(|state| state.t));
        let panels = Self {
            path: panel([84.0, 690.0, 112.0, 330.0], azimuths, inclinations),
            inclination: panel([84.0, 690.0, 410.0, 628.0], times, inclinations),
            above: Panel::new(
                [764.0, 1072.0, 112.0, 420.0],
                ([-1.1, 1.1], [-1.1, 1.1]),
                [5.0, 5.0],
            ),
        };
        let inclination = "inclination θ / degrees";
        let azimuth = "azimuth φ / degrees";
        panels
            .path
            .draw(svg, "Path of the axis", azimuth, inclination);
        panels
            .inclination
            .draw(svg, "Nutation", "time t / s", inclination);
        panels.above.draw(svg, "From above", "x", "y");
        panels
    }

    /// The steady precession.
    fn draw_steady(&self, svg: &mut Svg, theta: f64) {
        let center = self.above.at(0.0, 0.0);
        let radius = self.above.at(theta.sin(), 0.0)[0] - center[0];
        svg.circle("limit", center, radius);
        for panel in [&self.path, &self.inclination] {
            let [from, to] = panel.x.range.map(|x| panel.at(x, theta.to_degrees()));
            svg.line("limit", from, to);
        }
    }

    /// A motion in all panels.
    fn draw_motion(&self, svg: &mut Svg, model: &Gyroscope, (class, _, states): &Motion) {
        let degrees = |state: &State<f64, 3>, i: usize| state.q[i].to_degrees();
        let path = states.iter().map(|state| {
            let azimuth = degrees(state, Gyroscope::PHI);
            [azimuth, degrees(state, Gyroscope::THETA)]
        });
        self.path.curve(svg, class, path);
        let inclination = states.iter();
        let inclination = inclination.map(|state| [state.t, degrees(state, Gyroscope::THETA)]);
        self.inclination.curve(svg, class, inclination);
        let above = states.iter().map(|state| {
            let axis = model.outputs(state).axis;
            [axis.x, axis.y]
        });
        self.above.curve(svg, class, above);
    }
}

/// The path of the axis, inclination against azimuth, and the inclination against time.
fn figure(model: &Gyroscope, theta: f64, slow: f64, motions: &[Motion]) -> String {
    let title = "A gyroscope in gimbals under a weight";
    let subtitle = format!(
        "Steady precession {slow:.3} rad/s at θ = {:.1}°.",
        theta.to_degrees()
    );
    let mut svg = Svg::titled(1100.0, 690.0, title, &subtitle);
    let panels = Panels::draw(&mut svg, motions);
    panels.draw_steady(&mut svg, theta);
    let mut y = 490.0;
    let steady = [("limit", "steady precession")];
    for motion in motions {
        panels.draw_motion(&mut svg, model, motion);
    }
    let named = motions.iter().map(|(class, name, _)| (*class, *name));
    for (class, name) in named.chain(steady) {
        svg.line(class, [764.0, y - 5.0], [796.0, y - 5.0]);
        svg.text("tick", Anchor::Start, [806.0, y], name);
        y += 22.0;
    }
    svg.finish()
}
