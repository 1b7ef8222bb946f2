use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = 0.5 * k * x.powi(2),
    dissipation = c * dot(x),
)]
struct Mass {
    m: f64,
    c: f64,
    k: f64,
}

fn main() {}
