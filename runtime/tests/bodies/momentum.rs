//! Velocities, momenta, energies and moments of rigid bodies against those of their particles, on a path whose
//! derivatives are difference quotients in double-doubles.

use lagrangian::DoubleDouble;
use lagrangian::prelude::*;
use lagrangian::rigid_body::{BodyError, Resultant, RigidBody, RigidMotion, Solid, rate_in_space};
use nalgebra::Rotation3;

type D = DoubleDouble;
type V = Vector3<D>;
type M = Matrix3<D>;

fn d(value: f64) -> D {
    D::from_f64(value)
}

fn vector(x: f64, y: f64, z: f64) -> V {
    V::new(d(x), d(y), d(z))
}

/// The orientation on the path, by angles about z, x and y.
fn orientation(t: D) -> M {
    let turn = |axis: usize, angle: D| {
        let (s, c) = angle.sin_cos();
        let mut matrix = M::identity();
        let [j, k] = [(axis + 1) % 3, (axis + 2) % 3];
        (matrix[(j, j)], matrix[(k, k)]) = (c, c);
        (matrix[(k, j)], matrix[(j, k)]) = (s, -s);
        matrix
    };
    let [a, b] = [(d(1.3) * t).sin(), d(0.7) * t * t];
    turn(2, d(0.9) * t) * turn(0, a) * turn(1, b)
}

/// The position of the origin of the body's axes.
fn origin(t: D) -> V {
    V::new(t.sin(), d(0.5) * t * t, (d(2.0) * t).cos())
}

/// Sixth-order central difference quotients: an error of some h⁶ and 10⁻³²/h.
fn derivative<T>(t: D, f: impl Fn(D) -> T) -> T
where
    T: std::ops::Sub<Output = T> + std::ops::Add<Output = T> + std::ops::Mul<D, Output = T>,
{
    let h = d(1.0 / 65_536.0);
    let pair = |k: f64| f(t + d(k) * h) - f(t - d(k) * h);
    let weight = |n: f64, m: f64| d(n) / (d(m) * h);
    pair(1.0) * weight(3.0, 4.0) + pair(2.0) * weight(-3.0, 20.0) + pair(3.0) * weight(1.0, 60.0)
}

/// **ω** in space, from Ṙ Rᵀ.
fn angular_velocity(t: D) -> V {
    let spin = derivative(t, orientation) * orientation(t).transpose();
    V::new(spin[(2, 1)], spin[(0, 2)], spin[(1, 0)])
}

fn particles() -> Vec<(D, V)> {
    let numbers = (1_u32..12).map(f64::from);
    let scattered = |x: f64| 2.0 * (x * 0.618_033_988_749_894_9).fract() - 1.0;
    numbers
        .map(|i| {
            let r = vector(scattered(i), scattered(i * i), scattered(3.0 * i * i + 0.3));
            (d(1.2 + scattered(7.0 * i)), r)
        })
        .collect()
}

fn body() -> RigidBody<D> {
    let parts = particles().into_iter();
    RigidBody::composed(parts.map(|(m, r)| RigidBody::particle(m, r).unwrap())).unwrap()
}

/// The body with its components in axes of space, its origin still that of its axes.
fn body_in_space(t: D) -> RigidBody<D> {
    body().turned(&Rotation3::from_matrix_unchecked(orientation(t)))
}

/// Positions of a particle over the time.
fn path(r: V) -> impl Fn(D) -> V {
    move |t| origin(t) + orientation(t) * r
}

fn motion_of_origin(t: D) -> RigidMotion<D> {
    RigidMotion {
        position: origin(t),
        velocity: derivative(t, origin),
        acceleration: derivative(t, |t| derivative(t, origin)),
        angular_velocity: angular_velocity(t),
        angular_acceleration: derivative(t, angular_velocity),
    }
}

#[track_caller]
fn close(found: V, expected: V) {
    let error = (found - expected).map(D::to_f64);
    assert!(error.norm() < 1e-18, "{error}");
}

#[track_caller]
fn close_numbers(found: D, expected: D) {
    let error = (found - expected).to_f64();
    assert!(error.abs() < 1e-18, "{error:e}");
}

const TIME: f64 = 0.8;

#[test]
fn points_of_the_body() {
    let t = d(TIME);
    let r = vector(0.3, -1.2, 0.5);
    let motion = motion_of_origin(t);
    let relative = orientation(t) * r;
    close(motion.position_of(&relative), path(r)(t));
    close(motion.velocity_of(&relative), derivative(t, path(r)));
    let acceleration = derivative(t, |t| derivative(t, path(r)));
    close(motion.acceleration_of(&relative), acceleration);
    // Described at another point, it is the same motion.
    let again = motion.at(&relative).at(&-relative);
    close(again.velocity, motion.velocity);
    close(again.acceleration, motion.acceleration);
    let rest = RigidMotion::<D>::rest();
    assert_eq!(rest.acceleration_of(&r), V::zeros());
}

/// Σ mᵢ (rᵢ − r) × vᵢ over the particles, with absolute velocities.
fn momentum_of_particles(t: D, about: V) -> V {
    particles().into_iter().fold(V::zeros(), |sum, (m, r)| {
        let velocity = derivative(t, path(r));
        sum + (path(r)(t) - about).cross(&velocity) * m
    })
}

#[test]
fn momenta() {
    let t = d(TIME);
    let (body, motion) = (body_in_space(t), motion_of_origin(t));
    let center = body.center();
    let velocity_of_center = motion.velocity_of(&center);
    let linear = particles()
        .into_iter()
        .fold(V::zeros(), |sum, (m, r)| sum + derivative(t, path(r)) * m);
    close(body.linear_momentum(&velocity_of_center), linear);

    // (3.1), about a point of the body that moves.
    let point = orientation(t) * vector(0.4, 0.3, -0.9);
    let omega = motion.angular_velocity;
    let expected = momentum_of_particles(t, origin(t) + point);
    close(
        body.angular_momentum(&point, &motion.velocity_of(&point), &omega),
        expected,
    );
    // (3.2), about the centre of gravity.
    let expected = momentum_of_particles(t, origin(t) + center);
    close(body.angular_momentum_about_center(&omega), expected);
    // And about a point that rests at the moment: any point of the instantaneous axis of a rotation.
    let at_rest = body.angular_momentum(&point, &V::zeros(), &omega);
    close(
        body.angular_momentum_about_fixed_point(&point, &omega),
        at_rest,
    );
}

#[test]
fn kinetic_energies() {
    let t = d(TIME);
    let (body, motion) = (body_in_space(t), motion_of_origin(t));
    let expected = particles().into_iter().fold(d(0.0), |sum, (m, r)| {
        let velocity = derivative(t, path(r));
        sum + d(0.5) * m * velocity.dot(&velocity)
    });
    let omega = motion.angular_velocity;
    let point = orientation(t) * vector(0.4, 0.3, -0.9);
    close_numbers(
        body.kinetic_energy(&point, &motion.velocity_of(&point), &omega),
        expected,
    );
    let of_center = motion.velocity_of(&body.center());
    close_numbers(body.kinetic_energy_of_center(&of_center, &omega), expected);
    // (4.2): with the point at rest.
    let expected = particles().into_iter().fold(d(0.0), |sum, (m, r)| {
        let velocity = omega.cross(&(orientation(t) * r - point));
        sum + d(0.5) * m * velocity.dot(&velocity)
    });
    close_numbers(
        body.kinetic_energy_about_fixed_point(&point, &omega),
        expected,
    );
}

#[test]
fn resultants_are_rates_of_momenta() {
    let t = d(TIME);
    let (body, motion) = (body_in_space(t), motion_of_origin(t));
    let resultant = body.resultant(&motion);
    // (1.2): m a_C is the rate of the linear momentum.
    let center = |t: D| origin(t) + orientation(t) * self::body().center();
    let acceleration = derivative(t, |t| derivative(t, center));
    close(resultant.force, acceleration * body.mass());
    close(body.acceleration_of_center(&resultant.force), acceleration);
    // (3.3) about the centre of gravity, and about a fixed point of space.
    let rate = derivative(t, |t| momentum_of_particles(t, center(t)));
    close(resultant.moment, rate);
    let fixed = vector(0.2, 0.7, -0.4);
    let rate = derivative(t, |t| momentum_of_particles(t, fixed));
    close(resultant.about(fixed - origin(t)).moment, rate);
    // About a point that moves, dL/dt = N − v_O × m v_C.
    let r = vector(0.4, 0.3, -0.9);
    let rate = derivative(t, |t| momentum_of_particles(t, path(r)(t)));
    let relative = orientation(t) * r;
    let velocity_of_center = motion.velocity_of(&body.center());
    let carried = motion
        .velocity_of(&relative)
        .cross(&(velocity_of_center * body.mass()));
    close(resultant.about(relative).moment - carried, rate);
}

#[test]
fn rates_in_axes_of_the_body() {
    // (3.4): the same moment from components in the axes of the body, in which the tensor is constant.
    let t = d(TIME);
    let r = orientation(t);
    let in_body = |t: D| orientation(t).transpose() * angular_velocity(t);
    let momentum = |t: D| body().inertia() * in_body(t);
    let rate = rate_in_space(&derivative(t, momentum), &in_body(t), &momentum(t));
    close(
        r * rate,
        body_in_space(t).resultant(&motion_of_origin(t)).moment,
    );
    let alpha = derivative(t, in_body);
    let moment = body().moment_about_center(&in_body(t), &alpha);
    close(moment, rate);
    close(
        body().angular_acceleration(&in_body(t), &moment).unwrap(),
        alpha,
    );
    // About a fixed point it is that about the centre, and of the force there.
    let point = vector(0.4, 0.3, -0.9);
    let lever = body().center() - point;
    let rotation = RigidMotion {
        angular_velocity: in_body(t),
        angular_acceleration: alpha,
        ..RigidMotion::rest()
    };
    let force = rotation.acceleration_of(&lever) * body().mass();
    let expected = moment + lever.cross(&force);
    close(
        body().moment_about_fixed_point(&point, &in_body(t), &alpha),
        expected,
    );
}

#[test]
fn forces_make_a_resultant() {
    let forces = [
        (vector(1.0, -2.0, 0.5), vector(0.3, 0.1, 0.9)),
        (vector(0.0, 3.0, 1.5), vector(-0.3, 1.1, 0.4)),
    ];
    let couple = vector(0.1, 0.2, 0.3);
    let point = vector(0.5, 0.5, -0.5);
    let expected = forces
        .iter()
        .fold(couple, |sum, (f, at)| sum + (at - point).cross(f));
    let resultant = Resultant::of_forces(V::zeros(), forces).with_moment(couple);
    close(resultant.about(point).moment, expected);
    let [first, second] = forces.map(|(f, at)| Resultant::of_force(at, f, &at));
    assert_eq!(first.moment, V::zeros());
    let sum = (first + second).about(point).with_moment(couple);
    close(sum.moment, expected);
    close(sum.force, vector(1.0, 1.0, 2.0));
}

#[test]
fn a_thin_rod_has_no_inertia_about_its_axis() {
    let rod = Solid::rod(1.0).unwrap().with_mass(2.0).unwrap();
    let [omega, moment] = [Vector3::new(0.1, 0.2, 0.3), Vector3::new(1.0, 0.0, 0.0)];
    let error = rod.angular_acceleration(&omega, &moment).unwrap_err();
    let BodyError::NoInertia { moments } = error else {
        panic!("{error}");
    };
    assert!(moments[0].abs() < 1e-17 && (moments[2] - 1.0 / 6.0).abs() < 1e-15);
}
