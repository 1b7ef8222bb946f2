use lagrangian::Lagrangian;

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q),
    define(
        r = rotation_z(q),
        a = r.view((1, 1), (3, 3)),
        b = r.view(0, 3),
        c = r.rows(2),
        d = r.columns(-1, 2),
        e = r.xyz(),
        f = r.push(1.0),
        g = q.rows(0, 1),
        h = r.fixed_view(0, 0),
    ),
    kinetic = 0.5 * m * dot(q).powi(2),
)]
struct Model {
    m: f64,
}

fn main() {}
