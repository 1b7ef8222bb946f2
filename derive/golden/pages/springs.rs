/// Twelve masses between springs, with dampers and an input at the end.
#[lagrangian(
    coordinates(x[12]),
    kinetic = (0..12).map(|i| 0.5 * m[i] * dot(x[i]).powi(2)).sum(),
    potential = 0.5 * k[0] * x[0].powi(2) + (1..12).map(|i| 0.5 * k[i] * (x[i] - x[i - 1]).powi(2)).sum(),
    dissipation = (0..12).map(|i| 0.5 * c * dot(x[i]).powi(2)).sum(),
    force(x[11] = pull),
)]
struct Springs { m: [f64; 12], k: [f64; 12], c: f64, #[lagrangian(input)] pull: f64 }
