use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(coordinates(x), kinetic = 1e200 * m * (1e200 * dot(x)).powi(2))]
struct Heavy {
    m: f64,
}

fn main() {}
