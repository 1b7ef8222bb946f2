//! Bodies as parameters of declarations: what they cost, and that they move as the formulas of rigid bodies say.

use lagrangian::prelude::*;
use lagrangian::rigid_body::{InertiaTensor, RigidMotion};
use lagrangian::rotation::{EulerAngles, EulerSequence};
use lagrangian_tests::{Dual, assert_close};
use nalgebra::Rotation3;

/// A top about a fixed point, by a body.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi)),
    body(top = (r, [0.0, 0.0, 0.0])),
    gravity = [0.0, 0.0, -g],
)]
struct Top {
    top: SymmetricBody,
    g: f64,
}

/// The same by as many numbers.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(phi, theta, psi),
    define(
        r = rotation_zxz(phi, theta, psi),
        c = r * [0.0, 0.0, l],
        w = angular_velocity(r),
    ),
    kinetic = 0.5 * m * dot(c).norm_squared() + 0.5 * w.dot(diagonal([i, i, i_s]) * w),
    potential = m * g * c.z,
)]
struct TopByNumbers {
    m: f64,
    l: f64,
    i: f64,
    i_s: f64,
    g: f64,
}

/// A general body about a fixed point.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi)),
    body(top = (r, [0.0, 0.0, 0.0])),
    gravity = [0.0, 0.0, -g],
)]
struct General<S: Scalar = f64> {
    top: RigidBody<S>,
    g: f64,
}

#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        r = rotation_zxz(phi, theta, psi),
        c = r * center,
        w = angular_velocity(r),
    ),
    kinetic = 0.5 * m * dot(c).norm_squared() + 0.5 * w.dot([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]] * w),
    potential = m * g * c.z,
)]
struct GeneralByNumbers {
    m: f64,
    center: Vector3<f64>,
    xx: f64,
    yy: f64,
    zz: f64,
    xy: f64,
    xz: f64,
    yz: f64,
    g: f64,
}

/// A free body in its principal axes.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(x: Vector3, phi, theta, psi),
    body(free = (rotation_zxz(phi, theta, psi), x)),
    gravity = [0.0, 0.0, -g],
)]
struct Free {
    free: PrincipalBody,
    g: f64,
}

#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(x: Vector3, phi, theta, psi),
    define(w = angular_velocity(rotation_zxz(phi, theta, psi))),
    kinetic = 0.5 * m * dot(x).norm_squared() + 0.5 * w.dot(moments.component_mul(w)),
    potential = m * g * x.z,
)]
struct FreeByNumbers {
    m: f64,
    moments: Vector3<f64>,
    g: f64,
}

/// Two bodies in an array, a vehicle and what hangs from it, with the energies as functions.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(x: Vector3, a[3], b[3]),
    define(
        r[0] = rotation_zyx(a[0], a[1], a[2]),
        r[1] = r[0] * rotation_xyz(b[0], b[1], b[2]),
        p[0] = x,
        p[1] = x + r[0] * hook,
    ),
    kinetic = (0..parts.len()).map(|i| parts[i].kinetic_energy(r[i], p[i])).sum(),
    potential = (0..2).map(|i| potential_energy(parts[i], r[i], p[i], gravity)).sum(),
    output(masses = [parts[0].mass, parts[1].mass], center = parts[1].center, inertia = parts[1].inertia),
)]
struct Vehicle {
    parts: [RigidBody; 2],
    hook: Vector3<f64>,
    gravity: Vector3<f64>,
}

/// Numbers in (−1, 1) that look random: Weyl's sequence.
fn scattered(index: u32) -> f64 {
    2.0 * (f64::from(index + 1) * 0.618_033_988_749_894_9).fract() - 1.0
}

fn scattered_vector<const N: usize>(first: u32) -> SVector<f64, N> {
    SVector::from_fn(|i, _| scattered(first + u32::try_from(i).unwrap()))
}

/// A body of eight particles.
fn scattered_body(index: u32) -> RigidBody {
    let particles = (0..8).map(|i| {
        let mass = 1.2 + scattered(7 * index + i);
        RigidBody::particle(mass, scattered_vector(24 * index + 3 * i)).unwrap()
    });
    RigidBody::composed(particles).unwrap()
}

fn scattered_state<const N: usize>(index: u32) -> State<f64, N> {
    let first = 41 * index;
    State::new(
        scattered(first),
        scattered_vector(first + 1),
        scattered_vector(first + 20),
    )
}

#[test]
fn a_body_costs_what_as_many_numbers_cost() {
    assert_eq!(Top::OPERATIONS, TopByNumbers::OPERATIONS);
    assert_eq!(<General>::OPERATIONS, GeneralByNumbers::OPERATIONS);
    assert_eq!(Free::OPERATIONS, FreeByNumbers::OPERATIONS);
    // What is zero in a body is not computed.
    let cost = |operations: lagrangian::Operations| {
        let count = operations.accelerations;
        count.additions + count.multiplications + count.divisions
    };
    let [symmetric, general] = [Top::OPERATIONS, <General>::OPERATIONS].map(cost);
    assert!(3 * symmetric < general, "{symmetric}, {general}");
}

#[test]
fn bodies_move_as_their_numbers_do() {
    for index in 0..20 {
        let state = scattered_state(index);
        let body = scattered_body(index);
        let [xx, yy, zz] = body.inertia().moments();
        let matrix = body.inertia().matrix();
        let numbers = GeneralByNumbers {
            m: body.mass(),
            center: body.center(),
            xx,
            yy,
            zz,
            xy: matrix[(0, 1)],
            xz: matrix[(0, 2)],
            yz: matrix[(1, 2)],
            g: 9.81,
        };
        let general = General { top: body, g: 9.81 };
        assert_eq!(general.accelerations(&state), numbers.accelerations(&state));

        let principal = PrincipalBody::of(&body);
        let free = Free {
            free: principal,
            g: 9.81,
        };
        let numbers = FreeByNumbers {
            m: body.mass(),
            moments: principal.moments().into(),
            g: 9.81,
        };
        let state = scattered_state(index);
        assert_eq!(free.accelerations(&state), numbers.accelerations(&state));

        let [m, l, i] = [0, 1, 2].map(|k| 1.1 + scattered(3 * index + k));
        let top = Top {
            top: SymmetricBody::new(m, l, i, 0.6 * i).unwrap(),
            g: 9.81,
        };
        let numbers = TopByNumbers {
            m,
            l,
            i,
            i_s: 0.6 * i,
            g: 9.81,
        };
        let state = scattered_state(index);
        assert_eq!(top.accelerations(&state), numbers.accelerations(&state));
    }
}

/// (4.1) and (4.3), by the formulas of rigid bodies.
#[test]
fn energies_and_momenta_are_those_of_bodies() {
    for index in 0..20 {
        let parts = [1, 2].map(|i| scattered_body(3 * index + i));
        let vehicle = Vehicle {
            parts,
            hook: scattered_vector(index + 5),
            gravity: scattered_vector::<3>(index + 9) * 9.0,
        };
        let state: State<f64, 9> = scattered_state(index);
        let angles = |sequence, first: usize| {
            let angles = EulerAngles::new(sequence, [0, 1, 2].map(|i| state.q[first + i]));
            let rates = state.v.fixed_rows::<3>(first).into_owned();
            (angles.rotation(), angles.angular_velocity(&rates))
        };
        let (first, first_velocity) = angles(EulerSequence::Zyx, 3);
        let (relative, relative_velocity) = angles(EulerSequence::Xyz, 6);
        let second = first * relative;
        let second_velocity = relative.inverse() * first_velocity + relative_velocity;
        let origin = state.q.fixed_rows::<3>(0).into_owned();
        let velocity = state.v.fixed_rows::<3>(0).into_owned();
        let turning = first_velocity.cross(&vehicle.hook);
        // In axes of each body.
        let motions = [
            (first, first_velocity, origin, first.inverse() * velocity),
            (
                second,
                second_velocity,
                origin + first * vehicle.hook,
                second.inverse() * velocity + relative.inverse() * turning,
            ),
        ];
        let [mut kinetic, mut potential] = [0.0; 2];
        let mut momentum = Vector3::zeros();
        for (body, (rotation, omega, origin, velocity)) in parts.iter().zip(motions) {
            kinetic += body.kinetic_energy(&Vector3::zeros(), &velocity, &omega);
            let center = origin + rotation * body.center();
            potential -= body.mass() * vehicle.gravity.dot(&center);
            let motion = RigidMotion {
                velocity,
                angular_velocity: omega,
                ..RigidMotion::rest()
            };
            momentum += rotation * body.linear_momentum(&motion.velocity_of(&body.center()));
        }
        let found = [
            vehicle.kinetic_energy(&state),
            vehicle.potential_energy(&state),
        ];
        assert_close("energies", &found, &[kinetic, potential], 1e-13);
        let momenta = vehicle.momenta(&state);
        let found = momenta.fixed_rows::<3>(0).into_owned();
        assert_close("momentum", found.as_slice(), momentum.as_slice(), 1e-13);
        let outputs = vehicle.outputs(&state);
        assert_eq!(outputs.masses, SVector::from(parts.map(|body| body.mass())));
        assert_eq!(outputs.center, parts[1].center());
        assert_eq!(outputs.inertia, parts[1].inertia().matrix());
    }
}

#[test]
fn the_same_body_in_other_axes_moves_the_same() {
    let body = scattered_body(4);
    let general = |top| General { top, g: 9.81 };
    let state = State::new(0.0, [0.3, 0.8, -0.4], [0.5, 1.2, -0.7]);
    let expected = general(body).accelerations(&state);
    // Turned by an angle about the axis of the last rotation, and back by that.
    let turned = body.turned(&Rotation3::from_axis_angle(&Vector3::z_axis(), 0.9));
    let mut back = state;
    back.q[General::<f64>::PSI] -= 0.9;
    let found = general(turned).accelerations(&back);
    assert_close("turned", found.as_slice(), expected.as_slice(), 1e-13);
    // A symmetric body as a general one.
    let symmetric = SymmetricBody::new(1.5, 0.4, 0.7, 0.3).unwrap();
    let found = Top {
        top: symmetric,
        g: 9.81,
    }
    .accelerations(&state);
    let expected = general(symmetric.into()).accelerations(&state);
    assert_close("symmetric", found.as_slice(), expected.as_slice(), 1e-13);
}

/// The derivative of the accelerations by the mass, by dual numbers and by differences.
#[test]
fn bodies_on_dual_numbers_have_derivatives() {
    let body = scattered_body(2);
    let with_mass = |mass| RigidBody::new(mass, body.center(), body.inertia()).unwrap();
    let state = State::new(0.0, [0.3, 0.8, -0.4], [0.5, 1.2, -0.7]);
    let at = |mass| {
        General {
            top: with_mass(mass),
            g: 9.81,
        }
        .accelerations(&state)
    };
    let step = 1e-3;
    let sides = [-2.0, -1.0, 1.0, 2.0].map(|k| at(body.mass() + k * step));
    let expected = (sides[0] - sides[3] + 8.0 * (sides[2] - sides[1])) / (12.0 * step);

    let mut is_mass = true;
    let top = body.map(|value| {
        let derivative = if core::mem::take(&mut is_mass) {
            1.0
        } else {
            0.0
        };
        Dual::new(value, derivative)
    });
    let state = State::new(
        Dual::constant(0.0),
        state.q.map(Dual::constant),
        state.v.map(Dual::constant),
    );
    let found = General { top, g: 9.81 }.accelerations(&state);
    let found: Vec<f64> = found.iter().map(|x| x.derivative()).collect();
    assert_close("∂q̈/∂m", &found, expected.as_slice(), 1e-8);
}

#[test]
fn a_body_that_is_changed_is_prepared_again() {
    let state = State::new(0.0, [0.3, 0.8, -0.4], [0.5, 1.2, -0.7]);
    let [light, heavy] = [1.0, 3.0].map(|m| Top {
        top: SymmetricBody::new(m, 0.4, 0.02, 0.01).unwrap(),
        g: 9.81,
    });
    let expected = heavy.accelerations(&state);
    assert!((light.accelerations(&state) - expected).norm() > 0.1);
    let mut dynamics = light.into_dynamics();
    dynamics.change(|top| top.top = heavy.top);
    let found = dynamics.derivative(0.0, &state).v;
    assert_close("changed", found.as_slice(), expected.as_slice(), 1e-14);
}

#[test]
fn energy_is_kept_by_series() {
    let top = Top {
        top: SymmetricBody::new(1.2, 0.3, 0.05, 0.02).unwrap(),
        g: 9.81,
    };
    let start = State::new(0.0, [0.0, 0.5, 0.0], [0.3, 0.0, 60.0]);
    let end = Problem::new(&top, start).solve(3.0, Taylor::new()).unwrap();
    let energies = [top.energy(&end), top.energy(&start)];
    assert_close("energy", &energies[..1], &energies[1..], 1e-13);
    let inertia = InertiaTensor::principal([0.05, 0.05, 0.02]);
    assert_eq!(top.top.inertia(), inertia);
}
