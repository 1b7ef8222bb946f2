use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r: Vector3, s[2]: Vector3, q[2][3]: Vector2, x),
    kinetic = 0.5 * m * (dot(r).norm_squared() + dot(x).powi(2)),
    force(r = [g, l]),
    force(r[3] = g),
    force(r.w = g),
    force(r.up = g),
    force(r.x = g, r = [g, g, g]),
    force(s = [g, g, g]),
    force(s[2] = [g, g, g]),
    force(s[1] = g),
    force(q[0] = [g, l]),
    force(q[0][3] = [g, l]),
    force(x.x = g),
)]
struct Model {
    m: f64,
    g: f64,
    l: f64,
}

fn main() {}
