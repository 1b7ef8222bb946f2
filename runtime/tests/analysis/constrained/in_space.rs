//! Bodies that turn in space.

use lagrangian::analysis::{StateSpace, TangentSpace};
use lagrangian::prelude::*;

use super::{checked, same_matrix};

/// A body that is held at one of its points, by the place of its centre of mass and three angles.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(p: Vector3, a, b, c),
    define(r = rotation_x(a) * rotation_y(b) * rotation_z(c), w = angular_velocity(r)),
    kinetic = 0.5 * m * dot(p).norm_squared() + 0.5 * w.dot(diagonal(inertia) * w),
    potential = m * g * p.z,
    constraint(point = p - r * center),
)]
struct Hung {
    m: f64,
    g: f64,
    inertia: Vector3<f64>,
    center: Vector3<f64>,
}

/// The body of [`Hung`] by its angles.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a, b, c),
    define(
        r = rotation_x(a) * rotation_y(b) * rotation_z(c),
        w = angular_velocity(r),
        p = r * center,
    ),
    kinetic = 0.5 * m * dot(p).norm_squared() + 0.5 * w.dot(diagonal(inertia) * w),
    potential = m * g * p.z,
)]
struct HungAlone {
    m: f64,
    g: f64,
    inertia: Vector3<f64>,
    center: Vector3<f64>,
}

const INERTIA: [f64; 3] = [0.3, 0.5, 0.4];
const CENTER: [f64; 3] = [0.2, -0.1, -0.6];

/// The body of [`Hung`] by the axes that are fixed in it: nine numbers of which six relations make a rotation, with Euler's matrix
/// ∫ ξ ξᵀ dm in place of the moments of inertia.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(e: Vector3, f: Vector3, h: Vector3),
    define(p = center.x * e + center.y * f + center.z * h),
    kinetic = 0.5 * m * dot(p).norm_squared(),
    kinetic = 0.5 * (euler.x * dot(e).norm_squared() + euler.y * dot(f).norm_squared() + euler.z * dot(h).norm_squared()),
    potential = m * g * p.z,
    constraint(
        length = 0.5 * [e.norm_squared() - 1.0, f.norm_squared() - 1.0, h.norm_squared() - 1.0],
        angle = [f.dot(h), h.dot(e), e.dot(f)],
    ),
)]
struct Axes {
    m: f64,
    g: f64,
    euler: Vector3<f64>,
    center: Vector3<f64>,
}

impl Axes {
    /// At a rotation with an angular velocity in the axes of the body.
    fn at(rotation: &Matrix3<f64>, angular: &Vector3<f64>) -> State<f64, 9> {
        let rates = rotation * angular.cross_matrix();
        State::new(
            0.0,
            core::array::from_fn(|i| rotation[(i % 3, i / 3)]),
            core::array::from_fn(|i| rates[(i % 3, i / 3)]),
        )
    }
}

fn bodies() -> (Hung, HungAlone, Axes) {
    let (m, g, inertia, center) = (0.7, 9.81, INERTIA.into(), CENTER.into());
    let trace = INERTIA.iter().sum::<f64>();
    (
        Hung {
            m,
            g,
            inertia,
            center,
        },
        HungAlone {
            m,
            g,
            inertia,
            center,
        },
        Axes {
            m,
            g,
            euler: INERTIA.map(|moment| 0.5 * trace - moment).into(),
            center,
        },
    )
}

#[test]
fn a_body_that_is_held_at_a_point() {
    let (hung, alone, _) = bodies();
    let angles = [Hung::A, Hung::B, Hung::C];
    let motions = [
        ([0.4, -0.7, 1.1], [1.0, -2.0, 3.0]),
        ([-2.0, 0.5, 0.2], [0.0; 3]),
        ([0.0, 1.0, -0.4], [5.0, 0.3, -4.0]),
    ];
    for (q, v) in motions {
        let guess = State::new(
            0.0,
            core::array::from_fn(|i| if i < 3 { 0.0 } else { q[i - 3] }),
            core::array::from_fn(|i| if i < 3 { 0.0 } else { v[i - 3] }),
        );
        let state = hung.assemble(guess).hold(angles).hold_velocities(angles);
        let state = state.solve().expect("any angles do").state;
        let tangent = TangentSpace::at(&hung, &state)
            .coordinates(angles)
            .velocities(angles)
            .along_motion();
        let found = StateSpace::<f64, 6, 0, 6>::reduced_free(&tangent).expect("regular");
        let minimal = StateSpace::<f64, 6, 0, 6>::free(&alone, &State::new(0.0, q, v));
        same_matrix(&found, &minimal);
        checked::<_, 6, 3, 6>(&hung, &state, [&[]; 2]);
    }
}

/// It hangs with its centre of mass below the point, where nothing restores a turn about the vertical.
#[test]
fn a_body_by_its_axes() {
    let (_, alone, axes) = bodies();
    let center = Vector3::from(CENTER);
    let down = nalgebra::Rotation3::rotation_between(&center, &-Vector3::z());
    let rotation = down.expect("not upright").into_inner();
    let found = checked::<_, 9, 6, 6>(&axes, &Axes::at(&rotation, &Vector3::zeros()), [&[]; 2]);
    // r = Rx(a) Ry(b) Rz(c).
    let b = rotation[(0, 2)].asin();
    let a = (-rotation[(1, 2)]).atan2(rotation[(2, 2)]);
    let c = (-rotation[(0, 1)]).atan2(rotation[(0, 0)]);
    let hanging = State::new(0.0, [a, b, c], [0.0; 3]);
    assert!(alone.accelerations(&hanging).amax() < 1e-13);
    let minimal = StateSpace::<f64, 6, 0, 6>::free(&alone, &hanging);
    // Of the accelerations by the coordinates, for the mode that nothing restores is a double pole.
    let [found, minimal] = [&found, &minimal].map(|plant| {
        let stiffness = plant.a.fixed_view::<3, 3>(3, 0).into_owned();
        let squares = stiffness.complex_eigenvalues();
        let mut squares: [f64; 3] = core::array::from_fn(|i| squares[i].re);
        squares.sort_by(f64::total_cmp);
        Vector3::from(squares)
    });
    let error = (found - minimal).amax() / minimal.amax();
    assert!(error < 1e-11 && minimal[0] < -5.0, "{found} {minimal}");
    // Turned and turning.
    let turned = rotation * nalgebra::Rotation3::from_euler_angles(0.3, -0.5, 0.9).into_inner();
    checked::<_, 9, 6, 6>(
        &axes,
        &Axes::at(&turned, &Vector3::new(1.0, -2.0, 0.5)),
        [&[]; 2],
    );
}
