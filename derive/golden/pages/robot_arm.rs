/// Yaw, shoulder and elbow.
#[lagrangian(
    coordinates(q[3]),
    define(
        turn = rotation_z(q[0]),
        upper = turn * [cos(q[1]), 0.0, sin(q[1])],
        lower = turn * [cos(q[1] + q[2]), 0.0, sin(q[1] + q[2])],
        elbow = length * upper,
        tip = elbow + length * lower,
    ),
    kinetic = 0.5 * column * dot(q[0]).powi(2),
    kinetic = 0.5 * m * (dot(elbow / 2).norm_squared() + dot(elbow).norm_squared() / 12),
    kinetic = 0.5 * m * (dot((elbow + tip) / 2).norm_squared() + dot(tip - elbow).norm_squared() / 12),
    kinetic = 0.5 * load * dot(tip).norm_squared(),
    potential = g * (m * elbow.z / 2 + m * (elbow + tip).z / 2 + load * tip.z),
    force(q[i] = torque[i] for i in 0..3),
)]
struct RobotArm { column: f64, m: f64, load: f64, length: f64, g: f64, #[lagrangian(input)] torque: Vector3<f64> }
