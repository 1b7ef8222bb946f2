//! Euler's equations by all methods: against the equations of the text, momenta, Lagrange models and published motions.

use crate::common::{assert_close, in_lanes};
use lagrangian::prelude::*;
use lagrangian::rigid_body::{
    BodyError, ConstantForce, ConstantMoment, Damping, EulerEquations, InertiaTensor, Moment,
    MomentSeries, ProductsOfInertia, RigidBody, RotationState, Solid,
};
use lagrangian::rotation::{EulerAngles, EulerSequence, unit_quaternion};
use lagrangian::{DoubleDouble, Series, SingleNumber, TaylorCoefficients};

type D = DoubleDouble;
type V = Vector3<f64>;

fn d(value: f64) -> D {
    D::from_f64(value)
}

fn vector<S: Scalar>(x: f64, y: f64, z: f64) -> Vector3<S> {
    Vector3::new(x, y, z).map(S::from_f64)
}

/// A tensor in axes that are not principal axes.
fn oblique<S: SingleNumber>() -> InertiaTensor<S> {
    let [xy, xz, yz] = [0.2, -0.3, 0.1].map(S::from_f64);
    let products = ProductsOfInertia { xy, xz, yz };
    InertiaTensor::from_moments_and_products([2.0, 2.5, 3.0].map(S::from_f64), products)
}

fn state<S: Scalar>() -> RotationState<S> {
    let components = [0.8, -0.3, 0.4, 0.2].map(S::from_f64);
    RotationState::new(
        &unit_quaternion(components).unwrap(),
        vector(1.1, -0.7, 1.9),
    )
}

/// Its motion begins there.
fn start<S: Scalar>() -> At<S, RotationState<S>> {
    At {
        t: S::zero(),
        x: state(),
    }
}

#[test]
fn equations_of_the_text() {
    let [i1, i2, i3] = [1.2, 2.0, 2.7];
    let n = V::new(0.4, -0.3, 0.9);
    let body = EulerEquations::principal([i1, i2, i3]).unwrap();
    let rates = body
        .with_moment(ConstantMoment(n))
        .derivative(0.0, &state());
    let [w1, w2, w3]: [f64; 3] = state().angular_velocity.into();
    let [a1, a2, a3]: [f64; 3] = rates.angular_velocity.into();
    assert_close(i1 * a1 - (i2 - i3) * w2 * w3, n.x, 1e-15);
    assert_close(i2 * a2 - (i3 - i1) * w3 * w1, n.y, 1e-15);
    assert_close(i3 * a3 - (i1 - i2) * w1 * w2, n.z, 1e-15);
}

#[test]
fn equations_in_any_axes() {
    let n = V::new(0.4, -0.3, 0.9);
    let body = RigidBody::new(2.0, V::new(0.1, 0.2, 0.3), oblique()).unwrap();
    let point = V::new(0.5, -0.2, 0.4);
    let about_point = RigidBody::new(2.0, body.center(), body.inertia_about(&point)).unwrap();
    let omega = state::<f64>().angular_velocity;
    let [center, fixed] = [
        EulerEquations::about_center(&body),
        EulerEquations::about_fixed_point(&body, &point),
    ];
    for (equations, body) in [(center, body), (fixed, about_point)] {
        let driven = equations
            .unwrap()
            .with_moment(|_: f64, _: &RotationState| n);
        let found = driven.derivative(0.0, &state()).angular_velocity;
        let expected = body.angular_acceleration(&omega, &n).unwrap();
        assert_close((found - expected).norm(), 0.0, 1e-15);
        // N = I α + ω × I ω.
        let tensor = driven.inertia();
        let moment = tensor * found + omega.cross(&(tensor * omega));
        assert_close((moment - n).norm(), 0.0, 4e-15);
    }
}

/// The Taylor polynomial satisfies the equations: its derivative is that of its values.
fn check_series<M: MomentSeries<D>>(moment: M) {
    const HALF: usize = 20;
    let body = EulerEquations::new(oblique::<D>())
        .unwrap()
        .with_moment(moment);
    let mut polynomial = TaylorCoefficients::<_, HALF>::new(state());
    let unit = d(0.5);
    body.series((d(0.3), &state()), unit, &mut polynomial, None);
    for tau in [0.0, 0.0625, -0.0625] {
        let tau = d(tau);
        let mut x = state::<D>();
        x.add_scaled(d(1.0), &polynomial.change(tau));
        let slope = polynomial.derivative(tau);
        let expected = body.derivative(d(0.3) + unit * tau, &x);
        for (found, expected) in slope.components().zip(expected.components()) {
            assert_close((found / unit - expected).to_f64(), 0.0, 1e-28);
        }
    }
}

#[test]
fn series_satisfy_the_equations() {
    let constant = ConstantMoment(vector(0.4, -0.3, 0.9));
    let weight = ConstantForce {
        point: vector(0.2, 0.3, 0.9),
        force: vector(1.0, -2.0, -9.0),
    };
    let friction = Damping(Matrix3::new(0.3, 0.1, 0.0, 0.0, 0.2, 0.0, 0.05, 0.0, 0.4).map(d));
    check_series(lagrangian::rigid_body::NoMoment);
    check_series(constant);
    check_series(weight);
    check_series(friction);
    check_series((constant, (weight, friction)));
}

#[test]
fn moments_are_those_of_their_forces() {
    // r × Rᵀ F by the rotation matrix.
    let weight = ConstantForce {
        point: V::new(0.2, 0.3, 0.9),
        force: V::new(1.0, -2.0, -9.0),
    };
    let expected = weight.point.cross(&state().to_body(&weight.force));
    assert_close((weight.moment(0.0, &state()) - expected).norm(), 0.0, 1e-14);
    let there_and_back = state().to_space(&state().to_body(&weight.force));
    assert_close((there_and_back - weight.force).norm(), 0.0, 1e-14);
    let friction = Damping(Matrix3::from_diagonal(&V::new(1.0, 2.0, 3.0)));
    let expected = -V::new(1.1, -1.4, 5.7);
    assert_close(
        (friction.moment(0.0, &state()) - expected).norm(),
        0.0,
        1e-15,
    );
}

#[test]
fn all_methods_and_scalars_agree() {
    let weight = ConstantForce {
        point: V::new(0.2, 0.3, 0.9),
        force: V::new(1.0, -2.0, -9.0),
    };
    let body = EulerEquations::new(oblique()).unwrap().with_moment(weight);
    let to = 5.0;
    let problem = Problem::new(&body, start());
    let taylor = problem.clone().solve(to, Taylor::new()).unwrap();
    let precise = body.map(d, |weight| ConstantForce {
        point: weight.point.map(d),
        force: weight.force.map(d),
    });
    let precise = Problem::new(&precise, start())
        .solve(to, Taylor::order_40())
        .unwrap();
    let close = |found: &RotationState, tolerance: f64| {
        for (found, expected) in found.components().zip(precise.components()) {
            assert_close(found, expected.to_f64(), tolerance);
        }
    };
    close(&taylor, 1e-12);
    let method = Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-12);
    close(&problem.clone().solve(to, method).unwrap(), 1e-10);
    // Of fourth order: half the step has a sixteenth of the error.
    let error = |step: f64| {
        let end = problem
            .clone()
            .solve(to, RungeKutta::classical(step))
            .unwrap();
        let pairs = end.components().zip(taylor.components());
        pairs.map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt()
    };
    assert_close((error(0.01) / error(0.005)).log2(), 4.0, 0.1);
    // The norm of the quaternion is kept.
    let norm = precise
        .quaternion
        .iter()
        .fold(d(0.0), |sum, x| sum + *x * *x);
    assert_close((norm - d(1.0)).to_f64(), 0.0, 1e-25);
}

#[test]
fn ensembles_of_bodies() {
    let weight = ConstantForce {
        point: V::new(0.2, 0.3, 0.9),
        force: V::new(1.0, -2.0, -9.0),
    };
    let body = EulerEquations::new(oblique()).unwrap().with_moment(weight);
    let start = |i: u32| {
        let omega = V::new(0.3 * f64::from(i), 1.0, -0.2);
        (
            At::from((0.0, RotationState::aligned(omega))),
            1.0 + 0.3 * f64::from(i),
        )
    };
    let together = in_lanes::<4, _, _>(Taylor::new(), &body, (0..9).map(start));
    for (found, i) in together.into_iter().zip(0..) {
        let (from, to) = start(i);
        let alone = Problem::new(&body, from).solve(to, Taylor::new()).unwrap();
        for (found, alone) in found.unwrap().last.x.components().zip(alone.components()) {
            assert_close(found, alone, 1e-12);
        }
    }
}

#[test]
fn bodies_without_inertia_about_an_axis() {
    let rod = Solid::rod(1.0).unwrap().with_mass(2.0).unwrap();
    let error = EulerEquations::about_center(&rod).unwrap_err();
    assert!(matches!(error, BodyError::NoInertia { .. }), "{error}");
    assert!(EulerEquations::principal([1.0, 0.0, 1.0]).is_err());
    assert!(EulerEquations::principal([1.0, f64::NAN, 1.0]).is_err());
    assert!(EulerEquations::principal([1.0, f64::INFINITY, 1.0]).is_err());
    // About a point beside it, the rod has inertia about every axis.
    let beside = V::new(0.1, 0.0, 0.0);
    assert!(EulerEquations::about_fixed_point(&rod, &beside).is_ok());
}

/// A heavy body with a fixed point, in two sequences of angles.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), w = angular_velocity(r)),
    kinetic = 0.5 * w.dot(inertia * w),
    potential = weight * (r * center).z,
)]
struct InZxz {
    inertia: Matrix3<f64>,
    center: Vector3<f64>,
    weight: f64,
}

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(a, b, c),
    define(r = rotation_xyz(a, b, c), w = angular_velocity(r)),
    kinetic = 0.5 * w.dot(inertia * w),
    potential = weight * (r * center).z,
)]
struct InXyz {
    inertia: Matrix3<f64>,
    center: Vector3<f64>,
    weight: f64,
}

#[test]
fn one_motion_by_a_quaternion_and_by_angles_of_two_sequences() {
    let (inertia, center, weight) = (oblique().matrix(), V::new(0.1, 0.2, 0.3), 4.0);
    let force = V::new(0.0, 0.0, -weight);
    let gravity = ConstantForce {
        point: center,
        force,
    };
    let body = EulerEquations::new(oblique()).unwrap().with_moment(gravity);
    let angles = EulerAngles::new(EulerSequence::Zxz, [0.3, 1.1, -0.4]);
    let rates = V::new(0.7, -0.3, 1.2);
    let (cardan, cardan_rates) = angles.continued(EulerSequence::Xyz, &rates).unwrap();
    let method = Taylor::new();
    let start = RotationState::new(&angles.quaternion(), angles.angular_velocity(&rates));
    let body = Problem::new(&body, At { t: 0.0, x: start });
    let zxz = InZxz {
        inertia,
        center,
        weight,
    };
    let xyz = InXyz {
        inertia,
        center,
        weight,
    };
    let zxz = Problem::new(&zxz, State::new(0.0, angles.angles, rates));
    let xyz = Problem::new(&xyz, State::new(0.0, cardan.angles, cardan_rates));
    let mut compared = [0; 2];
    for step in 1..=40 {
        let to = 0.1 * f64::from(step);
        let expected = body.clone().solve(to, method).unwrap();
        let orientation = lagrangian::rotation::rotation_of(&expected.orientation());
        let ends = [
            (EulerSequence::Zxz, zxz.clone().solve(to, method).unwrap()),
            (EulerSequence::Xyz, xyz.clone().solve(to, method).unwrap()),
        ];
        for ((sequence, end), compared) in ends.into_iter().zip(&mut compared) {
            let found = EulerAngles::new(sequence, end.q.into());
            if found.regularity() < 0.1 {
                continue;
            }
            *compared += 1;
            let difference = found.rotation().matrix() - orientation.matrix();
            assert_close(difference.norm(), 0.0, 1e-11);
            let omega = found.angular_velocity(&end.v);
            assert_close((omega - expected.angular_velocity).norm(), 0.0, 1e-10);
        }
    }
    assert!(compared.iter().all(|count| *count > 25), "{compared:?}");
}

/// The heavy top of M. Géradin & A. Cardona, *Flexible Multibody Dynamics* (2001), with the numbers of O. Brüls & A. Cardona,
/// J. Comput. Nonlinear Dynam. **5** (2010) 031002; the state at t = 2 was computed with 30 digits. It passes within 10⁻⁶ rad of
/// the pole of z-x-z angles at each nutation.
#[test]
fn heavy_top_through_the_pole_of_its_angles() {
    let central = InertiaTensor::principal([0.234_375, 0.468_75, 0.234_375]);
    let top = RigidBody::new(15.0, V::new(0.0, 1.0, 0.0), central).unwrap();
    let equations = EulerEquations::about_fixed_point(&top, &V::zeros()).unwrap();
    let weight = ConstantForce {
        point: top.center(),
        force: V::new(0.0, 0.0, -9.81 * top.mass()),
    };
    let equations = equations.with_moment(weight);
    let x = RotationState::aligned(V::new(0.0, 150.0, -4.615_38));
    let problem = Problem::new(&equations, At { t: 0.0, x });
    let check = |end: &RotationState, tolerance: f64| {
        let center = end.to_space(&top.center());
        let expected = V::new(
            -0.150_416_822_745_641_79,
            -0.724_165_591_636_895_7,
            -0.673_022_269_560_444,
        );
        assert_close((center - expected).norm(), 0.0, tolerance);
        let expected = [
            0.122_947_135_041_533_42,
            -0.491_079_892_550_027,
            0.350_430_030_343_620_9,
            -0.787_986_887_550_485_7,
        ];
        let expected = nalgebra::Vector4::from(expected);
        let found = end.quaternion;
        assert_close(
            (found - expected).norm().min((found + expected).norm()),
            0.0,
            tolerance,
        );
        let expected = V::new(0.122_233_219_497_393_85, 150.0, -5.855_624_589_205_458);
        assert_close(
            (end.angular_velocity - expected).norm() / 150.0,
            0.0,
            tolerance,
        );
    };
    check(&problem.clone().solve(2.0, Taylor::new()).unwrap(), 1e-11);
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    check(&problem.solve(2.0, method).unwrap(), 1e-9);
}

/// Also where the steps are long and the tolerance is loose; what is no orientation is no start.
#[test]
fn quaternions_stay_units() {
    let body = EulerEquations::new(oblique()).unwrap();
    let start = At::from((0.0, RotationState::aligned(V::new(1.0, 2.0, -0.5))));
    let loose = Dop853::new()
        .relative_tolerance(1e-4)
        .absolute_tolerance(1e-4);
    let motion = Problem::new(&body, start)
        .save(StepEnds)
        .solve(200.0, loose);
    for state in motion.unwrap().samples() {
        assert_close(state.quaternion.norm(), 1.0, 4.0 * f64::EPSILON);
    }
    let end = Problem::new(&body, start).solve(200.0, Taylor::order_12());
    assert_close(end.unwrap().quaternion.norm(), 1.0, 4.0 * f64::EPSILON);
    let mut off = start;
    off.x.quaternion *= 1.01;
    let error = Problem::new(&body, off).solve(1.0, loose).unwrap_err();
    let text = error.to_string();
    assert!(text.contains("the coordinate w"), "{text}");
    assert!(
        matches!(error.error(), IntegrationError::OffManifold { .. }),
        "{text}"
    );
}
