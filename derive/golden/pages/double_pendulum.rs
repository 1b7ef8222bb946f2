/// Two point masses on massless rods.
#[lagrangian(
    coordinates(theta1, theta2),
    define(
        x1 = l1 * sin(theta1), y1 = -l1 * cos(theta1),
        x2 = x1 + l2 * sin(theta2), y2 = y1 - l2 * cos(theta2),
    ),
    kinetic = 0.5 * m1 * (dot(x1).powi(2) + dot(y1).powi(2)) + 0.5 * m2 * (dot(x2).powi(2) + dot(y2).powi(2)),
    potential = m1 * g * y1 + m2 * g * y2,
)]
struct DoublePendulum { m1: f64, m2: f64, l1: f64, l2: f64, g: f64 }
