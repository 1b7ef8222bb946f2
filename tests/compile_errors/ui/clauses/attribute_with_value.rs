use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian = "theta"]
struct Model {
    m: f64,
}

fn main() {}
