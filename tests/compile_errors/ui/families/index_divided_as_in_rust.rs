use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[4]),
    kinetic = (0..4).map(|i| 0.5 * m * dot(q[i]).powi(2)).sum(),
    potential = (0..4).map(|i| q[i] * q[(i + 1) - 4 * ((i + 1) / 4)]).sum(),
)]
struct Ring {
    m: f64,
}

fn main() {}
