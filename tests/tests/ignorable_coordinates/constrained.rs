//! Reduced models of mechanisms: constraints that do not touch the ignorable coordinates remain.

use lagrangian::prelude::*;
use lagrangian_tests::{Random, assert_close};

/// A spherical pendulum by the place of its bob in cylindrical coordinates, whose rod is a constraint.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, r, z),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2) + dot(z).powi(2)),
    potential = m * g * z,
    constraint(rod = r.powi(2) + z.powi(2) - l.powi(2)),
    output(tension = -2.0 * l * reaction(rod), outward = dot(dot(r)), spin = dot(phi), turned = phi),
    routhian(Meridian, without(turned)),
    taylor,
)]
struct Pendulum {
    m: f64,
    g: f64,
    l: f64,
}

const PENDULUM: Pendulum = Pendulum {
    m: 0.7,
    g: 9.81,
    l: 1.3,
};

/// A trolley whose wheel rolls, with a rotor on the axle of the wheel.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(psi, x, theta),
    kinetic = 0.5 * m * dot(x).powi(2) + 0.5 * i * dot(theta).powi(2)
        + 0.5 * j * (1.0 + 0.3 * cos(x)) * (dot(psi) + dot(theta)).powi(2),
    potential = m * g * sin(x),
    nonholonomic(roll = dot(x) - radius * dot(theta) + (dot(psi) - dot(psi)) * sin(x + psi - psi)),
    output(grip = reaction(roll), torque = reaction(roll, theta), spin = dot(dot(psi))),
    routhian(TrolleyAlone),
)]
#[allow(deprecated)] // It rolls along a line, which is holonomic in disguise.
struct Trolley {
    m: f64,
    i: f64,
    j: f64,
    g: f64,
    radius: f64,
}

#[test]
fn reduced_mechanisms_move_as_the_full_ones() {
    let mut random = Random::default();
    for _ in 0..100 {
        let mut state: State<f64, 3> = random.state();
        state.q[1] = 1.2 + 0.5 * state.q[1].sin();
        state.q[2] = 1.2 + 0.5 * state.q[2].sin();
        let (reduced, start) = PENDULUM.reduce(&state);
        let (full, found) = (
            PENDULUM.accelerations(&state),
            reduced.accelerations(&start),
        );
        assert_close(
            "accelerations",
            found.as_slice(),
            &full.as_slice()[1..],
            1e-12,
        );
        let multipliers = PENDULUM.multipliers(&state);
        let found = reduced.multipliers(&start);
        assert_close("λ", found.as_slice(), multipliers.as_slice(), 1e-12);
        let (full, found) = (PENDULUM.outputs(&state), reduced.outputs(&start));
        let full = [full.tension, full.outward, full.spin];
        let found = [found.tension, found.outward, found.spin];
        assert_close("outputs", &found, &full, 1e-12);
        let (position, velocity) = PENDULUM.constraint_residuals(&state);
        let found = reduced.constraint_residuals(&start);
        let found = [found.0[0], found.1[0]];
        assert_close("residuals", &found, &[position[0], velocity[0]], 1e-13);
    }
}

#[test]
fn a_reduced_trolley_rolls_as_the_full_one() {
    let trolley = Trolley {
        m: 2.0,
        i: 0.3,
        j: 0.4,
        g: 9.81,
        radius: 0.2,
    };
    let mut random = Random::default();
    for _ in 0..100 {
        let mut state: State<f64, 3> = random.state();
        state.v[1] = 0.2 * state.v[2];
        let (reduced, start) = trolley.reduce(&state);
        let (full, found) = (trolley.accelerations(&state), reduced.accelerations(&start));
        assert_close(
            "accelerations",
            found.as_slice(),
            &full.as_slice()[1..],
            1e-12,
        );
        let (full, found) = (trolley.outputs(&state), reduced.outputs(&start));
        let full = [full.grip, full.torque, full.spin];
        let found = [found.grip, found.torque, found.spin];
        assert_close("outputs", &found, &full, 1e-12);
    }
}

/// On a cone the bob stays where φ̇² = g/|z|: an equilibrium of the reduced model (Whittaker, Analytical Dynamics, 1937, 55).
#[test]
fn a_conical_motion_is_an_equilibrium_of_the_reduced_pendulum() -> Result<(), IntegrationError> {
    let (r, z) = (0.5, -1.2_f64);
    let spin = (9.81 / 1.2_f64).sqrt();
    let state = State::new(0.0, [0.3, r, z], [spin, 0.0, 0.0]);
    let (reduced, start) = PENDULUM.reduce(&state);
    assert_eq!(reduced.constants().as_slice(), [0.7 * 0.25 * spin]);
    let rest = reduced.accelerations(&start);
    assert!(rest.norm() < 1e-14, "{rest}");
    let tension = reduced.outputs(&start).tension;
    assert!(
        (tension - 0.7 * 9.81 * 1.3 / 1.2).abs() < 1e-13,
        "{tension}"
    );
    // Beside it, the full and the reduced pendulum move alike, with the same lengths of the rod.
    let beside = State::new(0.0, [0.3, r, z], [0.8 * spin, 0.0, 0.0]);
    let (reduced, start) = PENDULUM.reduce(&beside);
    let full = Problem::new(&PENDULUM, beside)
        .solve(5.0, Taylor::new())?
        .last;
    let found = Problem::new(&reduced, start)
        .solve(5.0, Taylor::new())?
        .last;
    assert_close("motion", found.q.as_slice(), &full.q.as_slice()[1..], 1e-11);
    assert!((found.q.norm() - 1.3).abs() < 1e-14);
    Ok(())
}
