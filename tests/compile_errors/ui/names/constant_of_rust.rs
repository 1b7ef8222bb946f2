use lagrangian::Lagrangian;

const G: f64 = 9.81;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = m * G * x + m * G * l * g,
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {
    let _ = G;
}
