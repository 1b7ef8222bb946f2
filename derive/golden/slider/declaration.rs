/// A slider on a spring, under dry friction and a load that are computed in Rust.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(
        friction(v, load) = v.tanh() * load,
        derivative(v) = load / cosh(v).powi(2),
        derivative(load) = friction(v, 1.0),
    ),
    function(side(x) = x.signum(), derivative(x) = 0.0),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = 0.5 * k * x.powi(2),
    force(x = -friction(dot(x) / width, weight) - 0.1 * weight * side(x)),
)]
pub struct Slider {
    pub m: f64,
    pub k: f64,
    pub weight: f64,
    pub width: f64,
}
