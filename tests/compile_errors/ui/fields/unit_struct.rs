use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(coordinates(theta), kinetic = 0.5 * m * dot(theta).powi(2))]
struct Model;

fn main() {}
