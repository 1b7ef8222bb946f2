use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a, b, c),
    kinetic = 0.5 * m * (dot(a).powi(2) + dot(b).powi(2) + dot(c).powi(2)),
    potential = m * rotation_zzx(a, b, c).trace(),
)]
struct Model {
    m: f64,
    k: f64,
}

fn main() {}
