/// Ten equal masses between equal springs and two walls.
#[lagrangian(
    coordinates(x[10]),
    kinetic = (0..10).map(|i| 0.5 * m * dot(x[i]).powi(2)).sum(),
    potential = 0.5 * k * x[0].powi(2) + (1..10).map(|i| 0.5 * k * (x[i] - x[i - 1]).powi(2)).sum() + 0.5 * k * x[9].powi(2),
)]
struct Lattice { m: f64, k: f64 }
