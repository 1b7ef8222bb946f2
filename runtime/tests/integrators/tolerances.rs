//! Tolerances of which one is zero, and the errors where no step meets them.

use crate::common::{assert_close, equation};
use lagrangian::prelude::*;
use lagrangian::{ComponentName, Partial};

/// A point that falls, beside one on a spring.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(height, x),
    kinetic = 0.5 * m * (dot(height).powi(2) + dot(x).powi(2)),
    potential = m * g * height + 0.5 * k * x.powi(2),
)]
struct Falling {
    m: f64,
    g: f64,
    k: f64,
}

const FALLING: Falling = Falling {
    m: 0.3,
    g: 9.81,
    k: 0.3,
};

/// The error with which an integration ends.
fn error<T>(solved: Result<T, Partial<T>>) -> IntegrationError {
    solved.map(|_| ()).unwrap_err().error()
}

/// From rest at the origin, where every component is zero, and from near it.
#[test]
fn a_relative_tolerance_alone_starts_from_rest() {
    for absolute in [0.0, 1e-300] {
        let method = Dop853::new()
            .relative_tolerance(1e-11)
            .absolute_tolerance(absolute);
        for x in [0.0, 1.0] {
            let start = State::new(0.0, [0.0, x], [0.0, 0.0]);
            let end = Problem::new(&FALLING, start).max_steps(60);
            let end = end.solve(1.25, method).unwrap();
            let fall = -0.5 * 9.81 * 1.25 * 1.25;
            assert_close(end.q[0], fall, 1e-10);
            assert_close(end.v[0], -9.81 * 1.25, 1e-10);
            assert_close(end.q[1], x * 1.25_f64.cos(), 1e-10);
        }
    }
}

/// At an equilibrium any step meets the tolerance.
#[test]
fn a_relative_tolerance_alone_keeps_an_equilibrium() {
    let method = Dop853::new().absolute_tolerance(0.0);
    let still = Falling { g: 0.0, ..FALLING };
    let start = State::new(0.0, [0.0, 0.0], [0.0, 0.0]);
    let end = Problem::new(&still, start).max_steps(60);
    assert_eq!(end.solve(10.0, method).unwrap().q, start.q);
}

#[test]
fn an_absolute_tolerance_alone_is_enough() {
    for relative in [0.0, 1e-300] {
        let method = Dop853::new()
            .relative_tolerance(relative)
            .absolute_tolerance(1e-11);
        for x in [0.0, 1.0] {
            let start = State::new(0.0, [1.0, x], [0.0, 0.0]);
            let end = Problem::new(&FALLING, start).max_steps(60);
            let end = end.solve(1.25, method).unwrap();
            assert_close(end.q[0], 1.0 - 0.5 * 9.81 * 1.25 * 1.25, 1e-10);
            assert_close(end.q[1], x * 1.25_f64.cos(), 1e-10);
        }
    }
}

#[test]
fn zero_and_nan_tolerances_are_errors() {
    let start = State::new(0.0, [0.0, 0.0], [0.0, 0.0]);
    for (relative, absolute) in [
        (0.0, 0.0),
        (-0.0, 0.0),
        (-1e-10, 1e-10),
        (1e-10, -1e-10),
        (f64::NAN, 1e-10),
        (1e-10, f64::NAN),
        (f64::INFINITY, 1e-10),
    ] {
        let method = Dop853::new()
            .relative_tolerance(relative)
            .absolute_tolerance(absolute);
        let error = error(Problem::new(&FALLING, start).solve(1.0, method));
        assert!(
            matches!(error, IntegrationError::InvalidTolerance { .. }),
            "{error}"
        );
        assert!(error.to_string().contains("not both zero"), "{error}");
    }
}

#[test]
fn sizes_are_positive_numbers() {
    let start = State::new(0.0, [0.0, 0.0], [0.0, 0.0]);
    let dynamics = FALLING.dynamics();
    for size in [-1.0, f64::NAN, f64::NEG_INFINITY] {
        let sized = (&dynamics).with_sizes([1.0, size]);
        for error in [
            error(Problem::new(&sized, start).solve(1.0, Dop853::new())),
            error(Problem::new(&sized, start).solve(1.0, RungeKutta::classical(0.1))),
        ] {
            assert!(
                matches!(error, IntegrationError::InvalidSize { .. }),
                "{error}"
            );
            assert!(
                error.to_string().contains("the size of the coordinate x"),
                "{error}"
            );
        }
    }
    let left_out = (&dynamics).with_sizes([f64::INFINITY, 1.0]);
    let end = Problem::new(left_out, start).solve(1.0, Dop853::new());
    assert!(end.is_ok());
}

/// Steps that are limited to nothing are the setting's fault.
#[test]
fn a_longest_step_that_is_too_short_is_named() {
    let start = State::new(0.0, [0.0, 0.0], [0.0, 0.0]);
    let method = Dop853::new().max_step(1e-300);
    let error = error(Problem::new(&FALLING, start).solve(0.01, method));
    assert!(
        matches!(
            error,
            IntegrationError::StepTooSmall {
                step: 1e-300,
                component: None,
                ..
            }
        ),
        "{error}"
    );
}

/// A smallest step is a time, like the largest: no step between the ends is shorter, and one that does not meet the
/// tolerance is an error.
#[test]
fn a_smallest_step_is_a_time() {
    let spring = || {
        let spring = equation::<2, _>(|_, x| SVector::from([x[1], -x[0]]));
        Problem::new(spring, At::from((0.0, SVector::from([1.0, 0.0]))))
    };
    let tight = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let shortest = |method: Dop853, end: f64| {
        let mut run = spring().start(method)?;
        let mut shortest = f64::INFINITY;
        while let Some(step) = run.step(end)? {
            if step.t < end {
                shortest = f64::min(shortest, step.t - run.previous_time());
            }
        }
        Ok::<_, IntegrationError>(shortest)
    };
    let free = shortest(tight, 10.0).unwrap();
    assert!(free < 0.2, "{free}");
    let loose = Dop853::new().min_step(0.3).initial_step(0.3);
    assert!(shortest(loose, 10.0).unwrap() >= 0.3);
    // The error of a step of 1 s is larger than 1e-13.
    let error = shortest(tight.min_step(1.0), 10.0).unwrap_err();
    let IntegrationError::SmallestStep { time, step, .. } = error else {
        panic!("{error}")
    };
    assert!(time < 10.0 && (step - 1.0).abs() < 1e-15);
    let message = error.to_string();
    let expected =
        "a step of 1e0, which `min_step` does not let be shortened, does not meet the tolerance";
    assert!(message.contains(expected), "{message}");
    // The only step of a short integration may be shorter.
    let end = spring().solve(0.01, tight.min_step(1.0)).unwrap();
    assert_close(end[0], f64::cos(0.01), 1e-14);
}

#[test]
fn a_smallest_step_that_is_none_is_refused() {
    let fall = |method: Dop853| {
        let start = State::new(0.0, [0.0, 0.0], [0.0, 0.0]);
        error(Problem::new(&FALLING, start).solve(0.01, method))
    };
    for step in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = fall(Dop853::new().min_step(step));
        assert!(
            matches!(error, IntegrationError::InvalidStep { .. }),
            "{error}"
        );
    }
    let error = fall(Dop853::new().max_step(0.1).min_step(0.2));
    assert_eq!(
        error,
        IntegrationError::InvalidStepRange { min: 0.2, max: 0.1 }
    );
    assert_eq!(
        error.to_string(),
        "the smallest step size, 0.2, must not be larger than the largest, 0.1"
    );
}

/// What rounding leaves of times that are 2⁻¹³ to 2 apart is part of the motion: the end is reached, or steps are too small.
#[test]
fn the_end_is_reached_where_times_are_rounded() {
    let spring = equation::<2, _>(|_, x| SVector::from([x[1], -x[0]]));
    let method = Dop853::new().relative_tolerance(1e-10);
    for (from, duration) in [
        (1e12, 64.0),
        (1e15, 64.0),
        (1e15, 8.0),
        (1e16, 8.0),
        (-1e16, 6.0),
    ] {
        let start = At::from((from, SVector::from([1.0, 0.0])));
        let end = Problem::new(&spring, start).solve(from + duration, method);
        match end.map_err(IntegrationError::from) {
            Ok(end) => assert_close(end[0], f64::cos(duration), 1e-8),
            Err(IntegrationError::StepTooSmall { .. }) => assert!(f64::abs(from) > 1e14),
            Err(error) => panic!("{error}"),
        }
    }
}

/// The second component is rounding noise about zero, which meets no relative tolerance.
#[test]
fn noise_about_zero_needs_an_absolute_tolerance() {
    let noisy =
        || equation::<2, _>(|_, x| SVector::from([x[1].cos() + 1.0, ((1.0 + x[0]) - 1.0) - x[0]]));
    let start = At::from((0.0, SVector::from([0.1, 0.0])));
    let relative = Dop853::new().absolute_tolerance(0.0);
    let limited = Problem::new(noisy(), start).max_steps(50_000);
    let error = error(limited.solve(1.0, relative));
    let IntegrationError::StepTooSmall {
        component,
        relative_only,
        step,
        ..
    } = error
    else {
        panic!("{error}")
    };
    assert_eq!(
        (component, relative_only),
        (Some(ComponentName::Index(1)), true)
    );
    assert!(step > 0.0);
    assert!(
        error.to_string().contains("set an absolute tolerance"),
        "{error}"
    );
    let both = relative.absolute_tolerance(1e-12);
    let end = Problem::new(noisy(), start).solve(1.0, both).unwrap();
    assert_close(end[0], 2.1, 1e-10);
}

/// ẋ = x² is infinite at t = 1: the component that is too steep is named, and no absolute tolerance is suggested.
#[test]
fn the_component_that_is_too_steep_is_named() {
    let steep = equation::<2, _>(|_, x| SVector::from([0.0, x[1] * x[1]]));
    let start = At::from((0.0, SVector::from([0.1, 1.0])));
    let error = error(Problem::new(steep, start).solve(2.0, Dop853::new()));
    let IntegrationError::StepTooSmall { component, .. } = error else {
        panic!("{error}")
    };
    assert_eq!(component, Some(ComponentName::Index(1)));
    let text = error.to_string();
    assert!(text.contains("component 1 of the state"), "{text}");
    assert!(!text.contains("set an absolute"), "{text}");
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, phi),
    kinetic = 0.5 * m * l.powi(2) * (dot(theta).powi(2) + sin(theta).powi(2) * dot(phi).powi(2)),
    potential = -m * g * l * cos(theta),
)]
struct SphericalPendulum {
    m: f64,
    g: f64,
    l: f64,
}

/// With hardly any angular momentum the pendulum passes the pole so closely that φ turns by π within less than
/// the resolution of time.
#[test]
fn a_passage_too_near_to_the_pole_names_its_coordinate() {
    let pendulum = SphericalPendulum {
        m: 1.0,
        g: 9.81,
        l: 1.0,
    };
    for (rate, tolerance) in [(1e-13, 1e-12), (1e-12, 1e-13), (1e-14, 1e-13)] {
        let start = State::new(0.0, [0.5, 0.0], [0.0, rate]);
        let method = Dop853::new()
            .relative_tolerance(tolerance)
            .absolute_tolerance(tolerance);
        let limited = Problem::new(&pendulum, start).max_steps(20_000);
        let error = error(limited.solve(10.0, method));
        let IntegrationError::VanishingInertia { singularity, .. } = error else {
            panic!("{error}")
        };
        assert_eq!(singularity.coordinate(), "phi");
        let (name, theta) = singularity.coordinates().next().unwrap();
        assert!(name == "theta" && theta.abs() < 1e-10, "{error}");
        // sin²θ over sin²1, the largest of the reference inertias.
        let ratio = theta.sin().powi(2) / 1.0_f64.sin().powi(2);
        assert_close(singularity.relative_pivot() / ratio, 1.0, 1e-9);
        assert!(error.to_string().contains("phi moves too fast"), "{error}");
    }
}

/// A force that is infinite at x = 1, on two links whose inertias depend on their angle and never vanish.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * dot(x).powi(2) + 0.5 * dot(y).powi(2) + 0.5 * cos(x - y) * dot(x) * dot(y),
    potential = ln(1.0 - x),
)]
struct Steep;

#[test]
fn a_steep_force_is_no_singularity_of_the_coordinates() {
    let start = State::new(0.0, [0.0, 0.0], [0.0, 0.0]);
    let error = error(Problem::new(&Steep, start).solve(10.0, Dop853::new()));
    let named = match error {
        IntegrationError::StepTooSmall { component, .. } => component,
        IntegrationError::NonFiniteState { component, .. } => Some(component),
        _ => panic!("{error}"),
    };
    let x = [ComponentName::Coordinate("x"), ComponentName::Velocity("x")];
    assert!(named.is_some_and(|named| x.contains(&named)), "{error}");
}

#[test]
fn an_error_of_a_setting_does_not_speak_of_a_solution() {
    let error = Problem::new(&FALLING, State::new(0.0, [0.0; 2], [0.0; 2]))
        .solve(1.0, Dop853::new().relative_tolerance(-1.0))
        .unwrap_err();
    assert_eq!(error.to_string(), error.error().to_string());
}
