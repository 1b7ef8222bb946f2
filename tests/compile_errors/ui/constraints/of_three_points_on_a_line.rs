use lagrangian::Lagrangian;

/// Three hinges on a line: if two hold, so does the third.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(p: Vector2, angle),
    define(along = [cos(angle), sin(angle)]),
    kinetic = 0.5 * m * dot(p).norm_squared() + 0.5 * i * dot(angle).powi(2),
    potential = m * g * p.y,
    constraint(hinge[k] = p + d[k] * along - [d[k], 0.0] for k in 0..3),
)]
struct Model {
    m: f64,
    i: f64,
    g: f64,
    d: [f64; 3],
}

fn main() {}
