//! Why a bicycle stays upright: the linear equations of a nonlinear mechanism with contacts that roll.
//!
//! `cargo run --release --example bicycle` linearizes Whipple's bicycle, [`Bicycle`] of the ready models, about rolling straight on at
//! speeds up to 10 m/s, prints its eigenvalues and the speeds between which it is stable, and follows the nonlinear bicycle after a push. It
//! writes `bicycle.svg`: the eigenvalues over the speed.
//!
//! The figure follows J. P. Meijaard, J. M. Papadopoulos, A. Ruina & A. L. Schwab, *Linearized dynamics equations for the balance
//! and steer of a bicycle: a benchmark and review*, Proc. R. Soc. A **463** (2007) 1955–1982.

use std::error::Error;

use lagrangian::analysis::{StateSpace, TangentError, TangentSpace};
use lagrangian::nalgebra::Complex;
use lagrangian::prelude::*;
use lagrangian_examples::{Panel, Svg};
use lagrangian_models::Bicycle;

/// The eigenvalues for lean and steer at a speed, by ascending real parts.
fn eigenvalues(bicycle: &Bicycle, speed: f64) -> Result<[Complex<f64>; 4], TangentError> {
    let straight = bicycle.straight(speed);
    // Nothing depends on where the bicycle is, where it heads, and on the angles of its wheels.
    let tangent = TangentSpace::at(bicycle, &straight)
        .without([
            Bicycle::X,
            Bicycle::Y,
            Bicycle::YAW,
            Bicycle::REAR,
            Bicycle::FRONT,
        ])
        .coordinates([Bicycle::LEAN, Bicycle::STEER])
        .velocities([Bicycle::LEAN, Bicycle::STEER, Bicycle::REAR]);
    let plant = StateSpace::<f64, 5, 0, 5>::reduced_free(&tangent)?;
    // The speed itself stays as it is: of five eigenvalues, the smallest is 0.
    let poles = plant.poles().map(|poles| poles[1..].to_vec());
    let mut found: [Complex<f64>; 4] = poles
        .and_then(|poles| poles.try_into().ok())
        .unwrap_or([Complex::new(f64::NAN, f64::NAN); 4]);
    found.sort_by(|x, y| x.re.total_cmp(&y.re).then(y.im.total_cmp(&x.im)));
    Ok(found)
}

/// The speed between two others at which a quantity changes its sign, by bisection.
fn crossing(
    [mut low, mut high]: [f64; 2],
    quantity: impl Fn(f64) -> Result<f64, TangentError>,
) -> Result<f64, TangentError> {
    let is_positive = quantity(low)? > 0.0;
    while high - low > 1e-12 * high {
        let middle = 0.5 * (low + high);
        if (quantity(middle)? > 0.0) == is_positive {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(0.5 * (low + high))
}

fn main() -> Result<(), Box<dyn Error>> {
    let bicycle = Bicycle::benchmark()?;
    println!("Eigenvalues of lean and steer [1/s]:\n\n   v [m/s]");
    for speed in 0..=10 {
        let found = eigenvalues(&bicycle, speed.into())?;
        let columns = found.map(|x| match x.im {
            0.0 => format!("{:.5}", x.re),
            im => format!(
                "{:.5} {} {:.5}i",
                x.re,
                if im > 0.0 { '+' } else { '−' },
                im.abs()
            ),
        });
        println!(
            "   {speed:2}  {}",
            columns.map(|x| format!("{x:>23}")).concat()
        );
    }

    let speeds = report_speeds(&bicycle)?;
    let motion = push(&bicycle)?;
    report_push(&bicycle, &motion);
    std::fs::write("bicycle.svg", figure(&bicycle, speeds)?)?;
    println!("\nWrote bicycle.svg.");
    Ok(())
}

/// Prints where the modes change: where weave begins, where it becomes stable, and where capsizing begins; castering, the fastest mode,
/// is stable at all speeds. Returns the speeds between which the bicycle is stable.
fn report_speeds(bicycle: &Bicycle) -> Result<[f64; 2], TangentError> {
    // Two real eigenvalues meet.
    let onset = crossing([0.1, 1.0], |v| {
        let found = eigenvalues(bicycle, v)?;
        Ok(if found[3].im == 0.0 && found[2].im == 0.0 {
            -1.0
        } else {
            1.0
        })
    })?;
    let weave = crossing([3.0, 5.0], |v| Ok(eigenvalues(bicycle, v)?[3].re))?;
    let capsize = crossing([5.5, 7.0], |v| Ok(eigenvalues(bicycle, v)?[3].re))?;
    let frequency = eigenvalues(bicycle, weave)?[3].im.abs();
    println!("\n   weave oscillates from {onset:9.6} m/s on");
    println!(
        "   weave is stable from  {weave:9.6} m/s on, where its frequency is {frequency:.6} rad/s"
    );
    println!("   capsize is stable to  {capsize:9.6} m/s");
    println!("   castering is stable at all speeds\n");
    assert!((weave - 4.292_382_536_341).abs() < 1e-9 && (capsize - 6.024_262_015_388).abs() < 1e-9);
    Ok([weave, capsize])
}

/// The motion of the nonlinear bicycle after a push at 4.6 m/s that lets it roll over at half a radian per second.
fn push(bicycle: &Bicycle) -> Result<Vec<State<f64, 8>>, Box<dyn Error>> {
    let mut start = bicycle.straight(4.6);
    start.v[Bicycle::LEAN] = 0.5;
    let held = [Bicycle::LEAN, Bicycle::STEER, Bicycle::REAR];
    let start = bicycle.assemble(start).hold_velocities(held).solve()?.state;
    let motion = Problem::new(bicycle, start)
        .save(Every(0.02))
        .solve(10.0, Taylor::new())?;
    Ok(motion.samples().to_vec())
}

fn report_push(bicycle: &Bicycle, motion: &[State<f64, 8>]) {
    let (first, last) = (&motion[0], &motion[motion.len() - 1]);
    let energy = bicycle.energy(first);
    let errors = motion
        .iter()
        .map(|x| (bicycle.energy(x) / energy - 1.0).abs());
    let error = errors.fold(0.0, f64::max);
    let lean = motion
        .iter()
        .map(|x| x.q[Bicycle::LEAN].abs())
        .fold(0.0, f64::max);
    let [speed, heading] = [
        -bicycle.rear_radius * last.v[Bicycle::REAR],
        last.q[Bicycle::YAW],
    ];
    println!("Pushed at 4.6 m/s, so that it leans at 0.5 rad/s, the nonlinear bicycle");
    println!(
        "   leans by {:.2}° at most, and by {:.4}° after {} s",
        lean.to_degrees(),
        last.q[Bicycle::LEAN].to_degrees(),
        last.t
    );
    println!(
        "   then rolls at {speed:.4} m/s, {:.2}° off its first direction",
        heading.to_degrees()
    );
    println!("   keeps its energy to {error:.1e}");
    assert!(error < 1e-12 && last.q[Bicycle::LEAN].abs() < 0.01);
}

/// Real parts, and imaginary parts above 0.
fn figure(bicycle: &Bicycle, [weave, capsize]: [f64; 2]) -> Result<String, TangentError> {
    let subtitle = "Whipple's bicycle rolls straight on; it is stable between the dashed lines.";
    let mut svg = Svg::titled(820.0, 560.0, "Eigenvalues over the speed", subtitle);
    let panel = Panel::new(
        [84.0, 660.0, 112.0, 490.0],
        ([0.0, 10.0], [-10.0, 10.0]),
        [10.0, 8.0],
    );
    panel.draw(
        &mut svg,
        "Lean and steer",
        "speed v / (m/s)",
        "eigenvalue λ / (1/s)",
    );
    for speed in [weave, capsize] {
        panel.curve(
            &mut svg,
            "limit",
            [-10.0, 10.0].map(|y| [speed, y]).into_iter(),
        );
    }
    let speeds = (0..=2000).map(|i| f64::from(i) / 200.0);
    let rows = speeds.map(|v| Ok((v, eigenvalues(bicycle, v)?)));
    let rows: Vec<(f64, [Complex<f64>; 4])> = rows.collect::<Result<_, TangentError>>()?;
    for mode in 0..4 {
        let real = rows.iter().map(|(v, x)| [*v, x[mode].re]);
        let within: Vec<_> = real.filter(|[_, y]| y.abs() <= 10.0).collect();
        panel.curve(&mut svg, "curve", within.into_iter());
        let imaginary = rows.iter().map(|(v, x)| [*v, x[mode].im]);
        let within: Vec<_> = imaginary.filter(|[_, y]| 0.0 < *y && *y <= 10.0).collect();
        if !within.is_empty() {
            panel.curve(&mut svg, "second", within.into_iter());
        }
    }
    svg.entry("curve", [682.0, 130.0], "real part");
    svg.entry("second", [682.0, 152.0], "imaginary part");
    svg.entry("limit", [682.0, 174.0], "limits");
    Ok(svg.finish())
}
