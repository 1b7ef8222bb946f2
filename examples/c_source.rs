//! Writes the equations of motion of a cart with a pole as C, for a microcontroller or a simulator of others.
//!
//! `cargo run --example c_source -- FOLDER` writes `cart_pole.c` and `cart_pole.h`, and `cart_pole_casadi.c` for `CasADi`.

use lagrangian::prelude::*;

/// A pole on a cart that a motor pushes.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, theta),
    define(tip = [x + l * sin(theta), l * cos(theta)]),
    kinetic = 0.5 * cart * dot(x).powi(2) + 0.5 * pole * dot(tip).norm_squared(),
    potential = pole * g * tip.y,
    dissipation = 0.5 * friction * dot(theta).powi(2),
    force(x = push),
    output(tip = tip),
    c,
)]
struct CartPole {
    /// The mass of the cart in kg.
    cart: f64,
    /// The mass at the tip of the pole in kg.
    pole: f64,
    /// The length of the pole in m.
    l: f64,
    /// The acceleration of gravity in m/s².
    g: f64,
    /// The friction of the joint in N m s.
    friction: f64,
    /// The force of the motor in N.
    #[lagrangian(input)]
    push: f64,
}

fn main() -> std::io::Result<()> {
    let folder = std::env::args().nth(1).unwrap_or_else(|| ".".to_owned());
    let folder = std::path::Path::new(&folder);
    std::fs::write(folder.join("cart_pole.c"), CartPole::C_SOURCE)?;
    std::fs::write(folder.join("cart_pole.h"), CartPole::C_HEADER)?;
    std::fs::write(folder.join("cart_pole_casadi.c"), CartPole::C_CASADI)?;
    println!("cc -std=c99 -O2 -ffp-contract=off -c cart_pole.c");
    Ok(())
}
