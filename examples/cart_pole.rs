//! A pole that is balanced on a cart by state feedback.
//!
//! `cargo run --release --example cart_pole`

use lagrangian::prelude::*;

/// A cart on a rail, and on it a point mass at the end of a massless pole.
#[derive(Lagrangian)]
#[lagrangian(
    // The position of the cart, and the angle of the pole from upright.
    coordinates(x, theta),
    define(px = x + l * sin(theta), py = l * cos(theta)),
    kinetic = 0.5 * cart * dot(x).powi(2) + 0.5 * pole * (dot(px).powi(2) + dot(py).powi(2)),
    potential = pole * g * py,
    force(x = push),
)]
struct CartPole {
    /// Mass of the cart in kg.
    cart: f64,
    /// Mass at the end of the pole in kg.
    pole: f64,
    /// Length of the pole in m.
    l: f64,
    /// Acceleration of gravity in m/s².
    g: f64,
    /// Force on the cart in N, which the controller sets.
    #[lagrangian(input)]
    push: f64,
}

fn main() -> Result<(), IntegrationError> {
    let model = CartPole {
        cart: 1.0,
        pole: 0.2,
        l: 0.5,
        g: 9.81,
        push: 0.0,
    };

    // The gains put the eigenvalues of the linearized loop at −2, −2.5, −3 and −3.5 1/s.
    let feedback = |state: &State<f64, 2>| {
        let (x, theta) = (state.q[CartPole::X], state.q[CartPole::THETA]);
        let (x_dot, theta_dot) = (state.v[CartPole::X], state.v[CartPole::THETA]);
        2.6758 * x + 35.4849 * theta + 4.0647 * x_dot + 7.5324 * theta_dot
    };

    // The law is evaluated at every stage of every step, as a continuous controller would be.
    let start = State::new(0.0, [0.0, 0.4], [0.0, 0.0]);
    let motion = Problem::new(&model, start)
        .feedback(feedback)
        .save(Every(0.5))
        .solve(6.0, Dop853::new())?;

    println!("  t [s]   x [m]  θ [degrees]  force [N]");
    for state in motion {
        let (x, theta) = (state.q[CartPole::X], state.q[CartPole::THETA].to_degrees());
        println!(
            "{:7.1} {x:7.3} {theta:12.3} {:10.3}",
            state.t,
            feedback(&state)
        );
    }
    Ok(())
}
