//! A tennis racket that is thrown up with a turn about its middle principal axis: it flips, again and again.
//!
//! `cargo run --release --example tennis_racket` compares the time between two flips by the closed form, by Euler's equations
//! with a quaternion, and by the Lagrange model in angles, and writes `tennis_racket.svg`.

use std::error::Error;

use lagrangian::Series;
use lagrangian::nalgebra::Rotation3;
use lagrangian::prelude::*;
use lagrangian::rigid_body::{
    BodyError, EulerEquations, FreeRotation, RotationState, Solid, SteadyRotation,
};
use lagrangian::rotation::{EulerAngles, EulerSequence};
use lagrangian_examples::{Panel, Svg, extent};

/// A free body along its principal axes, in angles that are regular while it flips: the first is that about the middle axis.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(turn, tilt, roll),
    define(r = rotation_yxz(turn, tilt, roll)),
    body(racket = (r, [0.0, 0.0, 0.0])),
    output(omega = angular_velocity(r)),
)]
struct Racket {
    racket: PrincipalBody,
}

/// A hoop with strings and a handle: lengths in m, masses in kg. The handle is along x, the face normal to z.
fn racket() -> Result<RigidBody, BodyError> {
    let hoop = Solid::torus(0.13, 0.01)?.with_mass(0.16)?;
    let strings = Solid::disc(0.13)?.with_mass(0.02)?;
    let along_x = Rotation3::from_axis_angle(&Vector3::y_axis(), std::f64::consts::FRAC_PI_2);
    let handle = Solid::tube(0.011, 0.015, 0.4)?.with_mass(0.15)?;
    let handle = handle.turned(&along_x).moved(Vector3::new(-0.34, 0.0, 0.0));
    RigidBody::composed([hoop, strings, handle])
}

/// The time between two zeros of ω₂, as the events of an integration find them.
fn between_zeros<D, X>(
    dynamics: &D,
    start: At<f64, X>,
    middle: impl Fn(&At<f64, X>) -> f64,
) -> Result<f64, IntegrationError>
where
    D: Series<f64, State = X>,
    X: VectorSpace<f64>,
{
    let zero = |from, end| {
        let problem = Problem::new(dynamics, from).when(&middle).stop();
        problem.solve(end, Taylor::new())
    };
    let first = zero(start, 100.0)?.last;
    let t = first.t;
    Ok(zero(first, 200.0)?.t - t)
}

fn main() -> Result<(), Box<dyn Error>> {
    let whole = racket()?;
    let body = PrincipalBody::of(&whole);
    let speed = 12.0;
    describe(&body, speed);

    // A hundredth of the angular velocity is about another axis.
    let omega = Vector3::new(0.12, speed, 0.0);
    let start = RotationState::aligned(omega);
    let closed = FreeRotation::new(&body.inertia(), &start)?;
    let flip = closed.half_period().ok_or("this rotation is steady")?;
    let equations = EulerEquations::principal(body.moments())?;
    let by_quaternion =
        between_zeros(&equations, At::from((0.0, start)), |x| x.angular_velocity.y)?;
    let model = Racket { racket: body };
    // In y-x-z and at the identity, the rates are those about y, x and z.
    let state = State::new(0.0, [0.0; 3], [omega.y, omega.x, omega.z]);
    let middle = |state: &State<f64, 3>| model.outputs(state).omega.y;
    let by_angles = between_zeros(&model.dynamics(), state, middle)?;
    println!("\nTime between two flips, in s:");
    println!("  closed form, 2 K(m)/σ        {flip:.12}");
    println!(
        "  Euler's equations            {by_quaternion:.12}  beside it: {:.0e}",
        by_quaternion / flip - 1.0
    );
    println!(
        "  Lagrange's equations         {by_angles:.12}  beside it: {:.0e}",
        by_angles / flip - 1.0
    );

    let times: Vec<f64> = (0..=800)
        .map(|k| 3.0 * flip * f64::from(k) / 800.0)
        .collect();
    let motion = Problem::new(&model, state)
        .save(&times)
        .solve(times[800], Taylor::new())?;
    let samples: Vec<Sample> = motion
        .samples()
        .iter()
        .map(|state| Sample::of(&model, &closed, state))
        .collect();
    let worst = samples
        .iter()
        .map(|sample| sample.beside)
        .fold(0.0, f64::max);
    println!("\nOver three flips ω differs from its closed form by at most {worst:.0e} rad/s.");
    std::fs::write("tennis_racket.svg", figure(&samples, flip))?;
    println!("Wrote tennis_racket.svg.");
    Ok(())
}

/// Prints the moments of inertia, and the steady rotations about their axes.
fn describe(body: &PrincipalBody, speed: f64) {
    let [i1, i2, i3] = body.moments();
    println!(
        "A racket of {:.3} kg; principal moments of inertia in kg m²:",
        body.mass()
    );
    println!(
        "  I₁ = {i1:.6} about the handle\n  I₂ = {i2:.6} across the handle, in the face\n  I₃ = {i3:.6} normal to the face"
    );

    println!("\nSteady rotations at {speed} rad/s, (3.8):");
    for (k, steady) in SteadyRotation::about_axes(body.moments(), speed)
        .iter()
        .enumerate()
    {
        println!("  about axis {}: {steady:?}", k + 1);
    }
}

/// Where a sample lies in a panel.
type Place = fn(&Sample) -> [f64; 2];

/// What is drawn at one time.
struct Sample {
    time: f64,
    /// The angular velocity in axes of the body.
    omega: Vector3<f64>,
    /// The direction of the handle in space.
    handle: Vector3<f64>,
    /// By how much the angular velocity differs from its closed form.
    beside: f64,
}

impl Sample {
    fn of(model: &Racket, closed: &FreeRotation, state: &State<f64, 3>) -> Self {
        let omega = model.outputs(state).omega;
        let angles = EulerAngles::new(EulerSequence::Yxz, state.q.into());
        Self {
            time: state.t,
            omega,
            handle: angles.rotation() * -Vector3::x(),
            beside: (omega - closed.at(state.t).angular_velocity).norm(),
        }
    }
}

/// The components of ω against time, the path of ω in the body, and that of the end of the handle in space.
fn figure(samples: &[Sample], flip: f64) -> String {
    let subtitle =
        format!("Thrown with 12 rad/s about its middle axis; it flips every {flip:.3} s.");
    let mut svg = Svg::titled(1100.0, 620.0, "A tennis racket turns over", &subtitle);

    let times = extent(samples.iter().map(|sample| sample.time));
    let panel = Panel::new(
        [84.0, 1072.0, 112.0, 280.0],
        (times, [-14.0, 14.0]),
        [8.0, 5.0],
    );
    panel.draw(
        &mut svg,
        "Angular velocity in axes of the body",
        "time t / s",
        "ω / (rad/s)",
    );
    for (k, class) in ["second", "curve", "third"].into_iter().enumerate() {
        let values = samples.iter().map(|sample| [sample.time, sample.omega[k]]);
        panel.curve(&mut svg, class, values);
        let left = 700.0 + 130.0 * f64::from(u8::try_from(k).unwrap_or(0));
        let name = ["ω₁, handle", "ω₂, middle", "ω₃, face"][k];
        svg.entry(class, [left, 101.0], name);
    }
    paths(&mut svg, samples);
    svg.finish()
}

/// The paths of ω in the body, from two sides, and that of the end of the handle.
fn paths(svg: &mut Svg, samples: &[Sample]) {
    let panels: [(_, _, _, _, Place, _); 3] = [
        (
            [84.0, 324.0, 360.0, 560.0],
            "Path of ω in the body",
            "ω₂ / (rad/s)",
            "ω₁ / (rad/s)",
            |s| [s.omega.y, s.omega.x],
            14.0,
        ),
        (
            [456.0, 696.0, 360.0, 560.0],
            "The same from another side",
            "ω₂ / (rad/s)",
            "ω₃ / (rad/s)",
            |s| [s.omega.y, s.omega.z],
            14.0,
        ),
        (
            [832.0, 1072.0, 360.0, 560.0],
            "The end of the handle in space",
            "x",
            "z",
            |s| [s.handle.x, s.handle.z],
            1.1,
        ),
    ];
    for (pixels, heading, x, y, point, most) in panels {
        let panel = Panel::new(pixels, ([-most, most], [-most, most]), [5.0, 5.0]);
        panel.draw(svg, heading, x, y);
        panel.curve(svg, "curve", samples.iter().map(point));
        if let Some([x, y]) = samples.first().map(point) {
            svg.circle("start", panel.at(x, y), 4.0);
        }
    }
}
