/// Five equal rods, each of which hangs on the one before.
#[lagrangian(
    coordinates(theta[5]),
    define(p[i] = (0..i).map(|k| l * [sin(theta[k]), -cos(theta[k])]).sum() + l / 2 * [sin(theta[i]), -cos(theta[i])] for i in 0..5),
    kinetic = (0..5).map(|i| 0.5 * m * dot(p[i]).norm_squared() + m * l.powi(2) / 24 * dot(theta[i]).powi(2)).sum(),
    potential = (0..5).map(|i| m * g * p[i].y).sum(),
)]
struct Rods { m: f64, l: f64, g: f64 }
