//! The equations of a cart with a pole, as LaTeX.

use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, theta),
    kinetic = 0.5 * m_c * dot(x).powi(2)
        + 0.5 * m * dot([x + l * sin(theta), l * cos(theta)]).norm_squared(),
    potential = m * g * l * cos(theta),
    force(x = push),
)]
#[allow(dead_code)] // Only its equations are printed.
struct CartPole {
    m_c: f64,
    m: f64,
    l: f64,
    g: f64,
    #[lagrangian(input)]
    push: f64,
}

fn main() {
    print!("{}", CartPole::LATEX);
}
