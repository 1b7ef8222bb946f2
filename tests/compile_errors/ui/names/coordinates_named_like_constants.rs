use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(angles[2], ignorable, functions: Vector2, inputs),
    function(f(x) = x, derivative(x) = 1.0),
    kinetic = 0.5 * m * dot(inputs).powi(2),
)]
struct Model {
    m: f64,
    #[lagrangian(input)]
    u: f64,
}

fn main() {}
