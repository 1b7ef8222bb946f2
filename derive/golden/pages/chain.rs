/// Twenty point masses on massless rods, each of which hangs on the one before.
#[lagrangian(
    coordinates(theta[20]),
    define(p[i] = (0..=i).map(|k| l[k] * [sin(theta[k]), -cos(theta[k])]).sum() for i in 0..20),
    kinetic = (0..20).map(|i| 0.5 * m[i] * dot(p[i]).norm_squared()).sum(),
    potential = (0..20).map(|i| m[i] * g * p[i].y).sum(),
)]
struct Chain { m: [f64; 20], l: [f64; 20], g: f64 }
