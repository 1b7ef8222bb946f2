use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q),
    define(
        a = homogeneous(rotation_z(q), [1.0, 0.0]),
        b = homogeneous(diagonal([1, 1]), [1.0, 0.0, 0.0]),
        c = homogeneous(rotation_z(q)),
    ),
    kinetic = 0.5 * m * dot(q).powi(2),
)]
struct Model {
    m: f64,
}

fn main() {}
