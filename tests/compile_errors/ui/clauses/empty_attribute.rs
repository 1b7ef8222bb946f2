use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian()]
struct Model {
    m: f64,
}

fn main() {}
