//! Bodies that attract each other, by a sum over pairs, against Newton's law.

use lagrangian::prelude::*;
use lagrangian_tests::{Figures, Random, assert_close, relative_error};
use nalgebra::Vector3;

macro_rules! bodies {
    ($name:ident, $n:literal) => {
        #[derive(Lagrangian)]
        #[lagrangian(
            coordinates(x[$n], y[$n], z[$n]),
            define(r[i] = [x[i], y[i], z[i]] for i in 0..$n),
            kinetic = (0..$n).map(|i| 0.5 * m[i] * dot(r[i]).norm_squared()).sum(),
            potential = -(0..$n).map(|i| (0..i).map(|j| g * m[i] * m[j] / (r[i] - r[j]).norm()).sum()).sum(),
            output(
                momentum = (0..$n).map(|i| m[i] * dot(r[i])).sum(),
                angular_momentum = (0..$n).map(|i| m[i] * r[i].cross(dot(r[i]))).sum(),
            ),
        )]
        struct $name {
            m: [f64; $n],
            g: f64,
        }
    };
}

bodies!(ThreeBodies, 3);
bodies!(FiveBodies, 5);

#[test]
fn they_attract_each_other_as_newton_says() {
    let mut figures = Figures::new();
    let mut random = Random::default();
    for _ in 0..100 {
        let model = FiveBodies {
            m: random.array(0.5, 2.0),
            g: 1.3,
        };
        let state = random.state();
        let vector = |components: &SVector<f64, 15>, i: usize| {
            let axes = [FiveBodies::X, FiveBodies::Y, FiveBodies::Z];
            Vector3::from(axes.map(|axis| components[axis[i]]))
        };
        let place = |i: usize| vector(&state.q, i);
        let mut expected = [0.0; 15];
        for i in 0..5 {
            let pull = |j: usize| {
                let distance = place(j) - place(i);
                model.g * model.m[j] * distance / distance.norm().powi(3)
            };
            let pulls: Vector3<f64> = (0..5).filter(|j| *j != i).map(pull).sum();
            for axis in 0..3 {
                expected[5 * axis + i] = pulls[axis];
            }
        }
        let found = model.accelerations(&state);
        let error = relative_error(found.as_slice(), &expected, 1e-3);
        figures.record("accelerations", &format!("{state:?}"), error, 1e-12);

        let of_one = |i: usize| model.m[i] * place(i).cross(&vector(&state.v, i));
        let expected: Vector3<f64> = (0..5).map(of_one).sum();
        let found = model.outputs(&state).angular_momentum;
        let error = relative_error(found.as_slice(), expected.as_slice(), 1.0);
        figures.record("angular momentum", &format!("{state:?}"), error, 1e-14);
    }
    figures.finish();
}

/// Three equal bodies chase each other on an eight (Chenciner and Montgomery; Simó's initial values and
/// period).
#[test]
fn they_return_on_the_eight() -> Result<(), IntegrationError> {
    let bodies = ThreeBodies {
        m: [1.0; 3],
        g: 1.0,
    };
    let ([x, y], [vx, vy]) = (
        [0.970_004_36, -0.243_087_53],
        [-0.932_407_37, -0.864_731_46],
    );
    let start = State::new(
        0.0,
        [x, -x, 0.0, y, -y, 0.0, 0.0, 0.0, 0.0],
        [
            -0.5 * vx,
            -0.5 * vx,
            vx,
            -0.5 * vy,
            -0.5 * vy,
            vy,
            0.0,
            0.0,
            0.0,
        ],
    );
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let end = Problem::new(&bodies, start).solve(6.325_913_98, method)?;
    // The initial values are given with eight digits.
    assert_close("places", end.q.as_slice(), start.q.as_slice(), 1e-6);
    assert_close("velocities", end.v.as_slice(), start.v.as_slice(), 1e-6);
    let outputs = bodies.outputs(&end);
    assert_close("momentum", outputs.momentum.as_slice(), &[0.0; 3], 1e-12);
    assert_close(
        "angular momentum",
        outputs.angular_momentum.as_slice(),
        &[0.0; 3],
        1e-7,
    );
    let energy = [bodies.energy(&start)];
    assert_close("energy", &[bodies.energy(&end)], &energy, 1e-11);
    Ok(())
}
