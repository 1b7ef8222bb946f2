use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    define(p = [x, 2 * x]),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = k * p.z + c,
)]
struct Mass {
    m: f64,
    c: f64,
    k: f64,
}

fn main() {}
