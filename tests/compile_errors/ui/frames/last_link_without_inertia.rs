use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[3]),
    define(
        r[0] = rotation_z(q[0]),
        r[1] = r[0] * rotation_y(q[1]),
        r[2] = r[1] * rotation_x(q[2]),
        c[i] = r[i] * [l, 0.0, 0.0] for i in 0..3,
        w = angular_velocity(r[2]),
    ),
    kinetic = (0..3).map(|i| 0.5 * m * dot(c[i]).norm_squared()).sum() + 0.5 * w.dot(diagonal([0, i2, i2]) * w),
)]
struct Arm {
    m: f64,
    l: f64,
    i2: f64,
}

fn main() {}
