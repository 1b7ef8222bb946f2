use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(coordinates(theta), kinetic = 0.5 * m * dot(theta).powi(2))]
struct Model(f64);

fn main() {
    let _ = Model(1.0);
}
