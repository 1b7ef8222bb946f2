/// A rigid body that turns about a fixed point, in vectors.
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), w = angular_velocity(r)),
    kinetic = 0.5 * w.dot(inertia * w),
    potential = m * g * (r * center).z,
)]
struct Body { inertia: Matrix3<f64>, center: Vector3<f64>, m: f64, g: f64 }
