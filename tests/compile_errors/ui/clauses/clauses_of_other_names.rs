use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic_energy = 0.5 * m * dot(x).powi(2),
    potential = 0.5 * k * x.powi(2),
    damping = 0.5 * c * dot(x).powi(2),
)]
struct Mass {
    m: f64,
    c: f64,
    k: f64,
}

fn main() {}
