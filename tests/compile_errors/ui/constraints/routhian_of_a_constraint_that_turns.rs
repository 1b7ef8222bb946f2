use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(psi, x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)) + 0.5 * i * dot(psi).powi(2),
    potential = k * (x - y).powi(2),
    nonholonomic(blade = dot(x) * sin(psi) - dot(y) * cos(psi)),
    routhian(Blade),
)]
struct Model {
    m: f64,
    i: f64,
    k: f64,
}

fn main() {}
