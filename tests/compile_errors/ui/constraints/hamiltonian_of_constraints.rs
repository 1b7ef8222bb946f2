use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    constraint(rod = x.powi(2) + y.powi(2) - l.powi(2)),
    hamiltonian,
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
