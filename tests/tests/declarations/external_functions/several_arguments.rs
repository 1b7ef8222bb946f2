//! Functions of several arguments, of parameters and inputs, and of none.

use lagrangian::prelude::*;
use lagrangian_tests::assert_close;

use super::{STATES, TOLERANCE, computed};

/// Lift by pitch and speed, of which the library knows nothing else.
fn lift(alpha: f64, speed: f64) -> f64 {
    alpha.sin() * speed * speed
}

/// A glider, whose lift depends on its pitch and its speed, and on the air.
#[derive(Lagrangian)]
#[lagrangian(
    scalar = f64,
    coordinates(x, z, pitch),
    function(
        lift(alpha, speed) = lift(alpha, speed),
        derivative(alpha) = turned(alpha, speed),
        derivative(speed) = 2.0 * speed * sin(alpha),
    ),
    function(turned(alpha, speed) = alpha.cos() * speed * speed),
    function(density() = self.air * 1.25),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(z).powi(2)) + 0.5 * i * dot(pitch).powi(2),
    potential = m * g * z,
    dissipation = density() * lift(0.1 * m, dot(x)),
    force(
        z = density() * pitch.lift(dot(x)),
        pitch = -lift(rudder - dot(pitch), dot(x)),
    ),
)]
struct Glider {
    m: f64,
    i: f64,
    g: f64,
    #[lagrangian(skip)]
    air: f64,
    #[lagrangian(input)]
    rudder: f64,
}

/// The same in elementary functions, with parameters of any scalar.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, z, pitch),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(z).powi(2)) + 0.5 * i * dot(pitch).powi(2),
    potential = m * g * z,
    dissipation = 1.25 * air * sin(0.1 * m) * dot(x).powi(2),
    force(
        z = 1.25 * air * sin(pitch) * dot(x).powi(2),
        pitch = -sin(rudder - dot(pitch)) * dot(x).powi(2),
    ),
)]
struct ElementaryGlider<T: Scalar> {
    m: T,
    i: T,
    g: T,
    air: T,
    #[lagrangian(input)]
    rudder: T,
}

#[test]
fn functions_have_as_many_arguments_as_they_like() {
    let (m, i, g, air, rudder) = (2.0, 0.3, 9.81, 0.9, 0.2);
    let glider = Glider {
        m,
        i,
        g,
        air,
        rudder,
    };
    let elementary = ElementaryGlider {
        m,
        i,
        g,
        air,
        rudder,
    };
    let accelerations = SVector::from([0.3, -1.2, 0.7]);
    for [t, x, v] in STATES {
        let state = State::new(t, [x, 0.4, 0.7 - x], [v, 0.3, 1.0 - v]);
        let found = computed(&glider, &state, &accelerations);
        let expected = computed(&elementary, &state, &accelerations);
        assert_close("glider", &found, &expected, TOLERANCE);
        let inputs = [-0.3];
        let found = glider.with_inputs(inputs).input_jacobian(&state);
        let expected = elementary.with_inputs(inputs).input_jacobian(&state);
        assert_close("inputs", found.as_slice(), expected.as_slice(), TOLERANCE);
    }
    assert_eq!(
        glider.check_derivatives("lift", [-1.0..=1.0, 0.0..=30.0]),
        Ok(())
    );
    let alone = glider.check_derivatives("density", []);
    assert_eq!(
        alone.unwrap_err().to_string(),
        "no derivative of `density` is declared"
    );
}

#[test]
fn what_depends_on_parameters_alone_is_evaluated_once() {
    // The density; what is left is the lift at two angles.
    assert_eq!(Glider::OPERATIONS.prepare.functions, 1);
    assert_eq!(Glider::OPERATIONS.accelerations.functions, 2);
}
