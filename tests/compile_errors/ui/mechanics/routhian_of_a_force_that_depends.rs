use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    force(r = m * sin(phi)),
    routhian(Reduced),
)]
struct Model {
    m: f64,
}

fn main() {}
