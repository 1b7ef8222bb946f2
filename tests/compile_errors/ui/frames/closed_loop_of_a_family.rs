use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[3]),
    define(
        p = h[0] + [0.0, 0.0, q[0]],
        h[i] = p + [i, 0.0, 0.0] for i in 0..3,
    ),
    kinetic = 0.5 * m * (0..3).map(|i| dot(q[i]).powi(2)).sum(),
)]
struct Model {
    m: f64,
}

fn main() {}
