use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(coordinates(theta), kinetic = 0.5 * m * dot(theta).powi(2))]
union Model {
    m: f64,
}

fn main() {}
