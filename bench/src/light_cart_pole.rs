//! A pendulum on a cart whose mass is a millionth of the pendulum's: the cart is thrown from side to side where the pendulum passes
//! the bottom, in a time that is short beside its swing.
//!
//! Input: nothing. Output: how far the ends of the motion are from a reference in double-double numbers, by our methods and by
//! the solvers of `SciPy`, all at their default tolerances.

use lagrangian::DoubleDouble;
use lagrangian::prelude::*;
use serde::Deserialize;

use crate::folders::Folders;
use crate::python::Python;

/// A pendulum that hangs from a cart.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, theta),
    define(p = [x + length * sin(theta), -length * cos(theta)]),
    kinetic = 0.5 * cart * dot(x).powi(2) + 0.5 * pole * dot(p).norm_squared(),
    potential = pole * gravity * p.y,
)]
struct CartPole {
    cart: f64,
    pole: f64,
    length: f64,
    gravity: f64,
}

const LIGHT: CartPole = CartPole {
    cart: 1e-6,
    pole: 1.0,
    length: 1.0,
    gravity: 9.81,
};

/// The angle at which it starts from rest.
const ANGLE: f64 = 1.0;

const END: f64 = 10.0;

/// The end of a motion by a solver of `SciPy`.
#[derive(Deserialize)]
struct Solved {
    method: String,
    steps: u64,
    end: [f64; 2],
}

/// Prints the errors.
pub(crate) fn run() -> Result<(), String> {
    let from_rest = State::new(0.0, [0.0, ANGLE], [0.0, 0.0]);
    let exact = State::new(
        DoubleDouble::from_f64(0.0),
        from_rest.q.map(DoubleDouble::from_f64),
        from_rest.v.map(DoubleDouble::from_f64),
    );
    let failed = |error: IntegrationError| error.to_string();
    let reference = Problem::new(&LIGHT, exact).solve(END, Taylor::order_40());
    let reference = reference.map_err(|error| failed(error.into()))?;
    let reference = reference.q.map(Scalar::largest);

    println!("{:>8} {:>8} {:>12}", "method", "steps", "error");
    let row = |method: &str, steps: u64, end: [f64; 2]| {
        let error = (SVector::from(end) - reference).amax();
        println!("{method:>8} {steps:>8} {error:>12.1e}");
    };
    let motion = Problem::new(&LIGHT, from_rest);
    let end = motion.clone().solve(END, Taylor::new());
    let end = end.map_err(|error| failed(error.into()))?;
    row("Taylor", end.statistics.steps, end.q.into());
    let end = motion.solve(END, Dop853::new());
    let end = end.map_err(|error| failed(error.into()))?;
    row("Dop853", end.statistics.steps, end.q.into());

    let python = Python::new(&Folders::new()?)?;
    python.install(&["scipy"])?;
    let numbers = [
        LIGHT.cart,
        LIGHT.pole,
        LIGHT.length,
        LIGHT.gravity,
        ANGLE,
        END,
    ];
    let arguments = numbers.map(|number| number.to_string());
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let solved: Vec<Solved> = python.run("light_cart_pole.py", &arguments)?;
    for Solved { method, steps, end } in solved {
        row(&method, steps, end);
    }
    Ok(())
}
