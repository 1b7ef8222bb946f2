//! A double pendulum by three methods, and what each of them keeps of its energy.

// ANCHOR: model
use lagrangian::DoubleDouble;
use lagrangian::prelude::*;
use lagrangian_guide::{Curve, Figure};

/// Two masses on rods without mass, with angles from the vertical.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(a, b),
    define(
        elbow = l * [sin(a), -cos(a)],
        tip = elbow + l * [sin(b), -cos(b)],
    ),
    kinetic = 0.5 * m * (dot(elbow).norm_squared() + dot(tip).norm_squared()),
    potential = m * g * (elbow.y + tip.y),
    output(tip = tip),
)]
struct DoublePendulum {
    m: f64,
    l: f64,
    g: f64,
}
// ANCHOR_END: model

// ANCHOR: program
const PENDULUM: DoublePendulum = DoublePendulum {
    m: 1.0,
    l: 1.0,
    g: 9.81,
};

/// Prints what a method keeps of the energy, and how far its end is from the true one.
fn report(method: &str, start: &State<f64, 2>, end: &State<f64, 2>, truth: &State<f64, 2>) {
    let drift = (PENDULUM.energy(end) / PENDULUM.energy(start) - 1.0).abs();
    let error = (end.q - truth.q).norm();
    // The next power of ten, for rounding errors differ from one processor to another.
    let bound = |x: f64| 10_f64.powf(x.log10().ceil());
    let (drift, error) = (bound(drift.max(1e-14)), bound(error.max(1e-12)));
    println!("{method:26} {drift:9.0e} {error:17.0e}");
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let start = State::new(0.0, [1.5, 2.0], [0.0, 0.0]);
    let problem = Problem::new(&PENDULUM, start);

    let motion = problem.clone().save(Dense).solve(10.0, Taylor::new())?;
    println!("kept to less than:         energy     angles at 10 s");
    let digits_32 = precise(&start)?;
    report("Taylor", &start, &motion, &digits_32);
    let end = problem.clone().solve(10.0, Dop853::new())?;
    report("Dop853", &start, &end, &digits_32);
    let strict = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let end = problem.clone().solve(10.0, strict)?;
    report("Dop853, tolerances 1e-13", &start, &end, &digits_32);
    let end = problem.solve(10.0, RungeKutta::classical(1e-3))?;
    report("RungeKutta, steps of 1 ms", &start, &end, &digits_32);

    let t = 3.21;
    let tip = PENDULUM.outputs(&motion.at(t)?).tip;
    println!("At {t} s the tip is at ({:.6}, {:.6}) m.", tip.x, tip.y);
    let mut path = Vec::new();
    for t in (0..=2000).map(|i| 0.005 * f64::from(i)) {
        path.push(PENDULUM.outputs(&motion.at(t)?).tip.into());
    }
    Figure::new("simulate", "x in m", "y in m").draw(&[Curve::new("", path)])
}

/// The end of the motion with 32 digits, rounded.
fn precise(start: &State<f64, 2>) -> Result<State<f64, 2>, Box<dyn std::error::Error>> {
    let [q, v] = [start.q, start.v].map(|x| x.map(DoubleDouble::from_f64));
    let start = State::new(DoubleDouble::from_f64(start.t), q, v);
    let end = Problem::new(&PENDULUM, start).solve(10.0, Taylor::order_40())?;
    let [q, v] = [end.q, end.v].map(|x| x.map(DoubleDouble::to_f64));
    Ok(State::new(10.0, q, v))
}
// ANCHOR_END: program
