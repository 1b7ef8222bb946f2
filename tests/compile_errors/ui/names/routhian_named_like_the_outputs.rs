use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    output(speed = dot(r)),
    routhian(ModelOutputs),
)]
struct Model {
    m: f64,
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    output(speed = dot(r)),
    routhian(Radial),
)]
struct RadialOutputs {
    m: f64,
}

fn main() {}
