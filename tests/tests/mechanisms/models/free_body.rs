//! A free rigid body in all sequences of angles, against Euler's equations.

use lagrangian::prelude::*;
use lagrangian_tests::{Figures, Random, relative_error};
use nalgebra::Vector3;

/// A free body in one sequence of angles.
macro_rules! free_body {
    ($rotation:ident) => {
        #[derive(Lagrangian)]
        #[lagrangian(
                            coordinates(a, b, c),
                            define(r = $rotation(a, b, c), w = angular_velocity(r)),
                            kinetic = 0.5 * w.dot(diagonal(inertia) * w),
                            output(w = w, rate = dot(w), momentum = r * (diagonal(inertia) * w)),
                        )]
        struct FreeBody {
            inertia: [f64; 3],
        }
    };
}

/// Equations (3.5) to (3.7) without a moment.
fn euler(inertia: [f64; 3], w: &Vector3<f64>) -> Vector3<f64> {
    let [i1, i2, i3] = inertia;
    Vector3::new(
        (i2 - i3) * w[1] * w[2] / i1,
        (i3 - i1) * w[2] * w[0] / i2,
        (i1 - i2) * w[0] * w[1] / i3,
    )
}

#[test]
fn every_sequence_of_angles_has_the_equations_of_euler() {
    let mut figures = Figures::new();
    macro_rules! sequences {
        ($($rotation:ident)*) => {$({
            free_body!($rotation);
            let mut random = Random::default();
            let body = FreeBody { inertia: [1.2, 1.5, 0.7] };
            for _ in 0..100 {
                let state = random.state();
                let outputs = body.outputs(&state);
                let expected = euler(body.inertia, &outputs.w);
                let error = relative_error(outputs.rate.as_slice(), expected.as_slice(), 1.0);
                // The rates of the angles are large near their poles, and cancel in that of ω.
                let pole = body.relative_pivots(&state).min();
                figures.record(stringify!($rotation), &format!("{state:?}"), error, 1e-14 / pole);
            }
            assert_momentum_is_kept(stringify!($rotation), &body, |state| body.outputs(state).momentum, &mut figures);
        })*};
    }
    sequences!(
        rotation_zxz rotation_xyx rotation_yzy rotation_zyz rotation_xzx rotation_yxy
        rotation_xyz rotation_yzx rotation_zxy rotation_xzy rotation_zyx rotation_yxz
    );
    figures.finish();
}

/// The angular momentum in inertial axes is constant.
fn assert_momentum_is_kept(
    name: &'static str,
    body: &impl Lagrangian<3>,
    momentum: impl Fn(&State<f64, 3>) -> Vector3<f64>,
    figures: &mut Figures,
) {
    let start = State::new(0.0, [0.3, 0.8, -0.4], [0.1, 0.2, 0.15]);
    let method = Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-12);
    match Problem::new(body, start).solve(1.0, method) {
        Ok(end) => {
            let error = (momentum(&end) - momentum(&start)).norm();
            figures.record("momentum", name, error, 1e-12);
        }
        Err(error) => panic!("{name}: {error}"),
    }
}
