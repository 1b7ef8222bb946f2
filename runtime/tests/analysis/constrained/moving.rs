//! A mechanism whose constraints move and accelerate.

use lagrangian::analysis::{StateSpace, TangentSpace};
use lagrangian::prelude::*;

use super::{checked, same_matrix};

/// A load on the rope of a crane, whose trolley is driven to and fro while a winch shortens the rope.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(s, x, y),
    kinetic = 0.5 * trolley * dot(s).powi(2) + 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    dissipation = 0.5 * c * (dot(x).powi(2) + dot(y).powi(2)),
    constraint(
        drive = s - reach * sin(rate * t),
        rope = [x - s, y].norm() - (length - hoisting * t + lift * t.powi(2)),
    ),
)]
struct Crane {
    trolley: f64,
    m: f64,
    g: f64,
    c: f64,
    reach: f64,
    rate: f64,
    length: f64,
    hoisting: f64,
    lift: f64,
}

const CRANE: Crane = Crane {
    trolley: 3.0,
    m: 0.6,
    g: 9.81,
    c: 0.2,
    reach: 0.4,
    rate: 2.5,
    length: 1.7,
    hoisting: 0.3,
    lift: 0.1,
};

/// The load of [`Crane`] by the angle of its rope.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi),
    define(
        s = reach * sin(rate * t),
        rope = length - hoisting * t + lift * t.powi(2),
        p = [s + rope * sin(phi), -rope * cos(phi)],
    ),
    kinetic = 0.5 * m * dot(p).norm_squared(),
    potential = m * g * p.y,
    dissipation = 0.5 * c * dot(p).norm_squared(),
)]
struct CraneAlone {
    m: f64,
    g: f64,
    c: f64,
    reach: f64,
    rate: f64,
    length: f64,
    hoisting: f64,
    lift: f64,
}

const ALONE: CraneAlone = CraneAlone {
    m: 0.6,
    g: 9.81,
    c: 0.2,
    reach: 0.4,
    rate: 2.5,
    length: 1.7,
    hoisting: 0.3,
    lift: 0.1,
};

/// x = s + l sin φ at the same time t: δx = u δφ and δẋ = u δφ̇ + u̇ δφ with u = l cos φ, so that δẍ = u δφ̈ + 2 u̇ δφ̇ + ü δφ.
#[test]
fn a_load_on_a_crane() {
    for (time, angle, turning) in [(0.0, 0.3, -0.8), (0.7, -0.5, 1.4), (1.9, 0.9, 0.4)] {
        let swinging = State::new(time, [angle], [turning]);
        let turned = ALONE.accelerations(&swinging)[0];
        let (sine, cosine) = f64::sin_cos(angle);
        let (trolley, speed) = (f64::sin(2.5 * time), f64::cos(2.5 * time));
        let [s, ds, dds] = [0.4 * trolley, 0.4 * 2.5 * speed, -0.4 * 6.25 * trolley];
        let [l, dl, ddl] = [1.7 - 0.3 * time + 0.1 * time * time, -0.3 + 0.2 * time, 0.2];
        let [u, w] = [l * cosine, l * sine];
        let [du, dw] = [dl * cosine - w * turning, dl * sine + u * turning];
        let ddu = ddl * cosine - dl * sine * turning - dw * turning - w * turned;
        let ddw = ddl * sine + dl * cosine * turning + du * turning + u * turned;

        let state = State::new(time, [s, s + w, -u], [ds, ds + dw, -du]);
        assert!((CRANE.accelerations(&state)[Crane::X] - dds - ddw).abs() < 1e-12);
        let tangent = TangentSpace::at(&CRANE, &state)
            .coordinates([Crane::X])
            .velocities([Crane::X])
            .along_motion();
        let found = StateSpace::<f64, 2, 0, 2>::reduced_free(&tangent).expect("regular");
        let mut minimal = StateSpace::<f64, 2, 0, 2>::free(&ALONE, &swinging);
        let accelerations = minimal.a.row(1) * u + SMatrix::<f64, 1, 2>::new(ddu, 2.0 * du);
        let rates = Matrix2::new(du, u, accelerations[0], accelerations[1]);
        let variables = Matrix2::new(u, 0.0, du, u);
        minimal.a = rates * variables.try_inverse().expect("the rope is not level");
        same_matrix(&found, &minimal);
        checked::<_, 3, 2, 2>(&CRANE, &state, [&[]; 2]);
    }
}
