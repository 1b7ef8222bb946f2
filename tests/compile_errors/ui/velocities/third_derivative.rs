use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * m * dot(theta).powi(2),
    output(jerk = dot(dot(dot(theta)))),
)]
struct Model {
    m: f64,
}

fn main() {}
