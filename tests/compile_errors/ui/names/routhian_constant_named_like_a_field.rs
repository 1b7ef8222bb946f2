use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * p_phi * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    routhian(Reduced),
)]
struct Model {
    p_phi: f64,
}

fn main() {}
