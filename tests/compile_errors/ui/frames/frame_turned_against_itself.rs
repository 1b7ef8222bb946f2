use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[2]),
    define(
        r = r * rotation_z(q[0]),
        s[0] = rotation_z(q[0]),
        s[i] = s[i] * rotation_y(q[i]) for i in 1..2,
    ),
    kinetic = 0.5 * m * (dot(q[0]).powi(2) + dot(q[1]).powi(2)),
)]
struct Model {
    m: f64,
}

fn main() {}
