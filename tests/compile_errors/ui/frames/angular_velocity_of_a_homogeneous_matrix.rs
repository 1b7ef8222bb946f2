use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q),
    define(a = homogeneous(rotation_z(q), [1.0, 0.0, 0.0]), w = angular_velocity(a)),
    kinetic = 0.5 * m * w.norm_squared(),
)]
struct Model {
    m: f64,
}

fn main() {}
