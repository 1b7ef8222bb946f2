use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    define(w = dot(x) + signum(dot(x))),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(w = f),
)]
struct Model {
    m: f64,
    f: f64,
}

fn main() {}
