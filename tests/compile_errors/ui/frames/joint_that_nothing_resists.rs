use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[3]),
    define(
        r[0] = rotation_z(q[0]),
        r[1] = r[0] * rotation_y(q[1]),
        along = [cos(2.0 * q[2]), sin(2.0 * q[2]), 0.0],
        c[0] = r[0] * [l, 0.0, 0.0],
        c[1] = r[1] * [l, 0.0, 0.0],
        c[2] = r[1] * [l * (along.x + 2.0 * sin(q[2]).powi(2)), 0.0, along.y - 2.0 * sin(q[2]) * cos(q[2])],
    ),
    kinetic = (0..3).map(|i| 0.5 * m * dot(c[i]).norm_squared()).sum(),
)]
struct Arm {
    m: f64,
    l: f64,
}

fn main() {}
