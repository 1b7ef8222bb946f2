use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = sqrt(-1.0) * k * x + c * ln(0) * x,
)]
struct Mass {
    m: f64,
    c: f64,
    k: f64,
}

fn main() {}
