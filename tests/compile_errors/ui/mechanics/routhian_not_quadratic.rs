use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi),
    lagrangian = 0.5 * m * dot(r).powi(2) + dot(phi).powi(2) + r.powi(2) * dot(phi).powi(4),
    routhian(Reduced),
)]
struct Model {
    m: f64,
}

fn main() {}
