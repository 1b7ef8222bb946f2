//! Constraints of which some follow from others where all hold.

use lagrangian::prelude::*;

use crate::mechanisms;

/// A platform that hangs on three parallel bars of equal length: its angle stays 0, though three bars hold three coordinates.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    coordinates(x, y, phi),
    define(
        arm = [b * cos(phi), b * sin(phi)],
        left = [x, y] - arm,
        right = [x, y] + arm,
    ),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)) + 0.5 * inertia * dot(phi).powi(2),
    potential = m * g * y,
    constraint(
        left_bar = (left - [-b, 0.0]).norm_squared() - l.powi(2),
        middle_bar = [x, y].norm_squared() - l.powi(2),
        right_bar = (right - [b, 0.0]).norm_squared() - l.powi(2),
    ),
    taylor,
)]
struct Platform {
    m: f64,
    inertia: f64,
    b: f64,
    l: f64,
    g: f64,
}

/// The pendulum as which the platform moves.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    coordinates(theta),
    kinetic = 0.5 * m * (l * dot(theta)).powi(2),
    potential = -m * g * l * cos(theta),
    taylor,
)]
struct Pendulum {
    m: f64,
    l: f64,
    g: f64,
}

const PLATFORM: Platform = Platform {
    m: 3.0,
    inertia: 0.7,
    b: 0.5,
    l: 1.25,
    g: 9.81,
};

fn start() -> State<f64, 3> {
    let (theta, rate) = (0.8_f64, 1.1);
    let l = PLATFORM.l;
    let (sin, cos) = theta.sin_cos();
    State::new(
        0.0,
        [l * sin, -l * cos, 0.0],
        [l * rate * cos, l * rate * sin, 0.0],
    )
}

fn expected(t: f64) -> [f64; 2] {
    let Platform { m, l, g, .. } = PLATFORM;
    let pendulum = Pendulum { m, l, g };
    let start = State::new(0.0, [0.8], [1.1]);
    let end = Problem::new(&pendulum, start).solve(t, Taylor::new().relative_tolerance(1e-15));
    let end = end.expect("a pendulum swings");
    [l * end.q[0].sin(), -l * end.q[0].cos()]
}

#[test]
fn a_platform_on_three_parallel_bars_moves_as_a_pendulum() -> Result<(), IntegrationError> {
    let start = start();
    let expected = expected(10.0);
    let taylor =
        Problem::new(&PLATFORM, start).solve(10.0, Taylor::new().relative_tolerance(1e-13))?;
    let dop853 =
        Problem::new(&PLATFORM, start).solve(10.0, Dop853::new().relative_tolerance(1e-12))?;
    for end in [taylor.last, dop853.last] {
        println!("{end:?} {expected:?}");
        assert!((end.q[0] - expected[0]).abs() < 1e-9);
        assert!((end.q[1] - expected[1]).abs() < 1e-9);
        assert!(end.q[2].abs() < 1e-12);
    }
    // Each bar carries a third: λ of least norm.
    let multipliers = PLATFORM.multipliers(&start);
    println!("{multipliers:?}");
    Ok(())
}

/// Its angle is zero, and so are the accelerations of the angle but for rounding errors, which do not shorten steps.
#[test]
fn what_a_redundant_constraint_keeps_at_zero_does_not_shorten_steps() {
    for index in [0, 1, 3, 4] {
        let (platform, start) = mechanisms::Platform::numbered(index);
        for tolerance in [1e-6, 1e-10, 1e-14] {
            let problem = Problem::new(&platform, start);
            let motion = problem.solve(2.0, Taylor::new().relative_tolerance(tolerance));
            let statistics = motion.expect("a motion").statistics;
            assert!(statistics.rejected <= statistics.steps, "{statistics:?}");
        }
    }
}

/// Three bars that are not parallel hold it, whatever its weight.
#[test]
fn a_structure_that_is_held_stays_at_rest() -> Result<(), IntegrationError> {
    let (platform, start) = mechanisms::Platform::numbered(2);
    let end = Problem::new(&platform, start).solve(10.0, Taylor::new())?;
    assert!((end.q - start.q).amax() < 1e-15 && end.v.amax() < 1e-15);
    let method = || Dop853::new().absolute_tolerance(1e-12);
    let end = Problem::new(&platform, start).solve(10.0, method())?;
    assert!((end.q - start.q).amax() < 1e-15 && end.v.amax() < 1e-15);
    Ok(())
}
