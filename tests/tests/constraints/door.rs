//! A door on three hinges, which has 6 coordinates and 15 constraints, and others with more constraints than degrees of freedom at
//! almost all configurations.

use lagrangian::Lanes;
use lagrangian::prelude::*;
use lagrangian::rigid_body::InertiaTensor;
use nalgebra::{SMatrix, SVector};

/// Each hinge holds a point and an axis of the leaf; gravity is inclined towards x.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(r: Vector3, psi, theta, phi),
    define(
        turn = rotation_zyx(psi, theta, phi),
        pin[k] = r + turn * pins[k] for k in 0..3,
        axis[k] = turn * axes[k] for k in 0..3,
    ),
    body(leaf = (turn, r)),
    gravity = [g * sin(lean), 0.0, -g * cos(lean)],
    constraint(
        point[k] = pin[k] - eyes[k] for k in 0..3,
        edge[k] = [axis[k].x, axis[k].y] for k in 0..3,
    ),
)]
struct Door {
    leaf: RigidBody,
    pins: [Vector3<f64>; 3],
    axes: [Vector3<f64>; 3],
    eyes: [Vector3<f64>; 3],
    g: f64,
    lean: f64,
}

/// The leaf by its rotation alone, with two points of its axis held.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(psi, theta, phi),
    define(turn = rotation_zyx(psi, theta, phi)),
    body(body = (turn, turn * center)),
    gravity = [g * sin(lean), 0.0, -g * cos(lean)],
    constraint(point[k] = turn * pins[k] - eyes[k] for k in 0..2),
)]
struct Leaf {
    body: RigidBody,
    center: Vector3<f64>,
    pins: [Vector3<f64>; 2],
    eyes: [Vector3<f64>; 2],
    g: f64,
    lean: f64,
}

/// The pendulum as which both move.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(psi),
    kinetic = 0.5 * moment * dot(psi).powi(2),
    potential = -m * c * g * sin(lean) * cos(psi),
)]
struct Pendulum {
    m: f64,
    c: f64,
    moment: f64,
    g: f64,
    lean: f64,
}

/// Four bars of equal lengths carry a platform, which may turn in the plane, on a trolley.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    coordinates(s, x, y, phi),
    define(foot[k] = [x + b[k] * cos(phi) - s - b[k], y + b[k] * sin(phi)] for k in 0..4),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2) + dot(s).powi(2)) + 0.5 * i * dot(phi).powi(2),
    potential = m * g * y,
    constraint(bar[k] = foot[k].norm() - l for k in 0..4),
)]
struct Trolley {
    m: f64,
    i: f64,
    g: f64,
    l: f64,
    b: [f64; 4],
}

/// The heights of the hinges, and the distance of the centre of mass from their axis.
const HEIGHTS: [f64; 3] = [0.7, 0.1, -0.8];
const WIDTH: f64 = 0.45;
const PENDULUM: Pendulum = Pendulum {
    m: 20.0,
    c: WIDTH,
    moment: 1.2 + 20.0 * WIDTH * WIDTH,
    g: 9.81,
    lean: 0.2,
};

fn leaf() -> RigidBody {
    let moments = Matrix3::from_diagonal(&Vector3::new(8.0, 9.0, 1.2));
    let inertia = InertiaTensor::from_matrix(&moments).expect("moments of a body");
    RigidBody::new(PENDULUM.m, Vector3::zeros(), inertia).expect("a body")
}

fn door() -> Door {
    let Pendulum { g, lean, .. } = PENDULUM;
    Door {
        leaf: leaf(),
        pins: HEIGHTS.map(|height| Vector3::new(-WIDTH, 0.0, height)),
        axes: [Vector3::z(); 3],
        eyes: HEIGHTS.map(|height| Vector3::new(0.0, 0.0, height)),
        g,
        lean,
    }
}

/// The state of the door at an angle and its rate.
fn at([psi, rate]: [f64; 2]) -> State<f64, 6> {
    let along = Vector3::new(psi.cos(), psi.sin(), 0.0);
    let across = Vector3::new(-psi.sin(), psi.cos(), 0.0);
    let [r, v] = [WIDTH * along, WIDTH * rate * across];
    let rotation = |x| [x, 0.0, 0.0];
    let joined = |x: Vector3<f64>, angles: [f64; 3]| {
        SVector::<f64, 6>::from_fn(|i, _| if i < 3 { x[i] } else { angles[i - 3] })
    };
    State::new(0.0, joined(r, rotation(psi)), joined(v, rotation(rate)))
}

fn pendulum_after(t: f64, start: [f64; 2]) -> [f64; 2] {
    let start = State::new(0.0, [start[0]], [start[1]]);
    let method = Taylor::new().relative_tolerance(1e-15);
    let end = Problem::new(&PENDULUM, start).solve(t, method);
    let end = end.expect("a pendulum swings");
    [end.q[0], end.v[0]]
}

#[test]
fn a_door_on_three_hinges_moves_as_a_pendulum() -> Result<(), IntegrationError> {
    let (door, start) = (door(), [0.9, 0.7]);
    let freedom = door.degrees_of_freedom(&at(start));
    assert_eq!((freedom.coordinates, freedom.velocities), (1, 1));
    assert_eq!(freedom.redundant_constraints().count(), 10);
    let problem = || Problem::new(&door, at(start));
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    for (end, tolerance) in [
        (problem().solve(2.0, Taylor::new())?, 1e-12),
        (problem().solve(2.0, method)?, 1e-11),
        (problem().solve(0.3, RungeKutta::classical(0.01))?, 1e-9),
    ] {
        let expected = at(pendulum_after(end.t, start));
        let [q, v] = [end.q - expected.q, end.v - expected.v].map(|x| x.amax());
        println!("{q:.1e} {v:.1e} within {tolerance:.1e}");
        assert!(q < tolerance && v < 10.0 * tolerance);
        let (positions, velocities) = door.constraint_residuals(&end);
        assert!(positions.amax() < 1e-15 && velocities.amax() < 1e-15);
    }
    Ok(())
}

/// λ with the reactions that the pendulum needs, of least norm: by a singular value decomposition of Gᵀ.
#[test]
fn hinges_share_a_load_by_the_pseudo_inverse() {
    let door = door();
    for state in [[0.9, 0.7], [0.0, -1.5], [-2.5, 0.0], [1e-9, 3.0]] {
        let alone = State::new(0.0, [state[0]], [state[1]]);
        let second = PENDULUM.accelerations(&alone)[0];
        let state = at(state);
        let (psi, rate) = (state.q[Door::PSI], state.v[Door::PSI]);
        let along = Vector3::new(psi.cos(), psi.sin(), 0.0);
        let across = Vector3::new(-psi.sin(), psi.cos(), 0.0);
        let center = WIDTH * (second * across - rate * rate * along);
        let mut expected = SVector::<f64, 6>::zeros();
        expected.fixed_rows_mut::<3>(0).copy_from(&center);
        expected[Door::PSI] = second;
        let found = door.accelerations(&state);
        assert!((found - expected).amax() < 1e-12 * expected.amax());

        let jacobian: SMatrix<f64, 15, 6> = door.constraint_jacobian(&state);
        let reactions = door.inverse_dynamics(&state, &expected);
        let inverse = jacobian.transpose().pseudo_inverse(1e-10);
        let expected = inverse.expect("a tolerance") * reactions;
        let found = door.multipliers(&state);
        let error = (found - expected).amax() / expected.amax();
        println!("{error:.1e} of {:.3e}", expected.norm());
        assert!(error < 1e-12);
        // Each lane has the multipliers of its own state.
        let beside = at([psi + 0.4, 0.3]);
        let pair = |x: f64, y: f64| Lanes([x, y]);
        let lanes = State::new(
            Lanes::<2>::from_f64(0.0),
            beside.q.zip_map(&state.q, pair),
            beside.v.zip_map(&state.v, pair),
        );
        let both = door.multipliers(&lanes);
        for (lane, alone) in [door.multipliers(&beside), found].iter().enumerate() {
            assert!((0..15).all(|j| both[j].in_lane(lane).to_bits() == alone[j].to_bits()));
        }
    }
}

#[test]
fn a_door_is_assembled_from_a_guess() -> Result<(), Box<dyn core::error::Error>> {
    let door = door();
    let guess = State::new(0.0, at([0.9, 0.7]).q.add_scalar(0.05), [0.5; 6]);
    let found = door
        .assemble(guess)
        .hold([Door::PSI])
        .hold_velocities([Door::PSI])
        .solve()?;
    let expected = at([0.95, 0.5]);
    assert!((found.state.q - expected.q).amax() < 1e-14);
    assert!((found.state.v - expected.v).amax() < 1e-14);
    // It is a start of a motion.
    let end = Problem::new(&door, found.state).solve(1.0, Taylor::new())?;
    let expected = at(pendulum_after(1.0, [0.95, 0.5]));
    assert!((end.q - expected.q).amax() < 1e-12);
    // Hinges in other places of the frame do not fit.
    let misfit = Door {
        eyes: [0.7, 0.2, -0.8].map(|height| Vector3::new(0.0, 0.0, height)),
        ..door
    };
    let error = misfit
        .assemble(guess)
        .solve()
        .expect_err("the hinges do not fit");
    assert!(error.to_string().contains("point["), "{error}");
    Ok(())
}

#[test]
fn six_constraints_of_three_angles_leave_one_of_them_free() -> Result<(), IntegrationError> {
    let Pendulum { g, lean, .. } = PENDULUM;
    let points = [HEIGHTS[0], HEIGHTS[2]].map(|height| Vector3::new(0.0, 0.0, height));
    let leaf = Leaf {
        body: leaf(),
        center: Vector3::new(WIDTH, 0.0, 0.0),
        pins: points,
        eyes: points,
        g,
        lean,
    };
    let start = State::new(0.0, [0.9, 0.0, 0.0], [0.7, 0.0, 0.0]);
    assert_eq!(leaf.degrees_of_freedom(&start).velocities, 1);
    let end = Problem::new(&leaf, start).solve(5.0, Taylor::new())?;
    let [psi, rate] = pendulum_after(5.0, [0.9, 0.7]);
    assert!((end.q[Leaf::PSI] - psi).abs() < 1e-12 && (end.v[Leaf::PSI] - rate).abs() < 1e-11);
    assert!(end.q[Leaf::THETA].abs() < 1e-15 && end.q[Leaf::PHI].abs() < 1e-15);
    Ok(())
}

/// Trolley and platform have equal masses, so that their centre stays below its start, and the platform is raised as a pendulum of
/// half the mass.
#[test]
fn bars_on_a_trolley_carry_a_platform() -> Result<(), Box<dyn core::error::Error>> {
    let trolley = Trolley {
        m: 1.5,
        i: 0.3,
        g: 9.81,
        l: 0.5,
        b: [-0.4, -0.1, 0.2, 0.5],
    };
    let (sine, cosine) = 0.8_f64.sin_cos();
    let offset = 0.5 * sine;
    let start = State::new(0.0, [0.1, 0.1 + offset, -0.5 * cosine, 0.0], [0.0; 4]);
    assert_eq!(trolley.degrees_of_freedom(&start).velocities, 2);
    let method = || {
        Dop853::new()
            .relative_tolerance(1e-12)
            .absolute_tolerance(1e-12)
    };
    let end = Problem::new(&trolley, start).solve(2.0, method())?;
    assert!((end.q[0] + end.q[1] - (0.2 + offset)).abs() < 1e-11);
    assert!(end.q[3].abs() < 1e-14);
    let energy = trolley.energy(&end) - trolley.energy(&start);
    assert!(energy.abs() < 1e-10, "{energy:e}");
    let guess = State::new(0.0, start.q.add_scalar(0.01), [0.0; 4]);
    let found = trolley.assemble(guess).solve()?.state;
    assert!(found.q[3].abs() < 1e-7, "{}", found.q[3]);
    Ok(())
}
