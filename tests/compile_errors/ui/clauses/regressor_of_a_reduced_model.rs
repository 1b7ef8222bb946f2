use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)) + 0.5 * i * dot(phi).powi(2),
    potential = 0.5 * k * r.powi(2),
    regressor(m, i),
    routhian(Radial),
)]
struct Slider {
    m: f64,
    i: f64,
    k: f64,
}

fn main() {
    let slider = Slider { m: 1.0, i: 0.1, k: 3.0 };
    let (radial, start) = slider.reduce(&State::new(0.0, [1.0, 0.0], [0.0, 1.1]));
    let _ = (radial.accelerations(&start), radial.p_phi, Slider::BASE_PARAMETERS);
}
