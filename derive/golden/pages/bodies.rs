/// Five bodies under gravitation.
#[lagrangian(
    coordinates(r[5]: Vector3),
    kinetic = (0..5).map(|i| 0.5 * m[i] * dot(r[i]).norm_squared()).sum(),
    potential = (0..5).map(|i| (0..i).map(|j| -g * m[i] * m[j] / (r[i] - r[j]).norm()).sum()).sum(),
)]
struct Bodies { m: [f64; 5], g: f64 }
