/// A pendulum with a motor and friction at its pivot, whose height and acceleration are observed.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    define(x = l * sin(theta), y = -l * cos(theta)),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    dissipation = 0.5 * friction * dot(theta).powi(2),
    force(theta = torque),
    output(height = y, acceleration = dot(dot(x))),
)]
pub struct DrivenPendulum {
    pub m: f64,
    pub g: f64,
    pub l: f64,
    pub friction: f64,
    #[lagrangian(input)]
    pub torque: f64,
}
