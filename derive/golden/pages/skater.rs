/// A skater in a bowl of ice, whose edge does not move sideways.
#[lagrangian(
    coordinates(x, y, z, phi),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2) + dot(z).powi(2)) + 0.5 * i * dot(phi).powi(2),
    potential = m * g * z,
    force(phi = turn),
    constraint(ice = z - 0.5 * c * (x.powi(2) + y.powi(2))),
    nonholonomic(edge = dot(x) * sin(phi) - dot(y) * cos(phi)),
)]
struct Skater { m: f64, i: f64, g: f64, c: f64, #[lagrangian(input)] turn: f64 }
