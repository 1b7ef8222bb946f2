//! Declarations that macros write, with names of their own and of their callers.

/// A macro that writes the whole declaration: some names are its own, some are its caller's.
macro_rules! oscillator {
    ($name:ident, $coordinate:ident, $parameter:ident: $scalar:ty, $power:literal, $potential:expr) => {
        #[derive(lagrangian::Lagrangian)]
        #[lagrangian(
            coordinates($coordinate, hidden),
            define(speed = dot($coordinate)),
            kinetic = 0.5 * $parameter * speed.powi($power) + 0.5 * mass * dot(hidden).powi(2),
            potential = 2.0 * $potential + 0.5 * mass * hidden.powi(2),
            output($parameter = $parameter * speed),
        )]
        struct $name {
            $parameter: $scalar,
            mass: f64,
        }

        impl $name {
            fn new($parameter: $scalar) -> Self {
                Self { $parameter, mass: 1.0 }
            }
        }
    };
}

#[test]
fn a_macro_may_write_the_declaration() {
    use lagrangian::prelude::*;

    oscillator!(Oscillator, x, m: f64, 2, m * x + m * x.powi(2));
    let model = Oscillator::new(2.0);
    let state = State::new(0.0, [0.5, 0.25], [1.0, 0.0]);
    // The sum stays together: ẍ = −2 (1 + 2 x).
    assert!((model.accelerations(&state)[Oscillator::X] + 4.0).abs() < 1e-15);
    assert!((model.accelerations(&state)[Oscillator::HIDDEN] + 0.25).abs() < 1e-15);
    assert!((model.outputs(&state).m - 2.0).abs() < 1e-15);
}

#[test]
fn parts_may_come_from_a_macro_one_by_one() {
    use lagrangian::prelude::*;

    macro_rules! model {
        ($name:ident { $($field:ident),* } $($clause:tt)*) => {
            #[derive(Lagrangian)]
            #[lagrangian($($clause)*)]
            struct $name { $($field: f64),* }
        };
    }
    model!(Free { m } coordinates(x), kinetic = 0.5 * m * dot(x).powi(2));
    let state = State::new(0.0, [0.5], [1.0]);
    assert!((Free { m: 3.0 }.momenta(&state)[Free::X] - 3.0).abs() < 1e-15);
}

/// A macro that writes functions: `self` and arguments are its own, or its caller's.
macro_rules! driven {
    ($name:ident, $argument:ident => $value:expr, $derivative:expr) => {
        #[derive(lagrangian::Lagrangian)]
        #[lagrangian(
                    scalar = f64,
                    coordinates(x),
                    function(own(v) = self.gain * v, derivative(v) = m),
                    function(given($argument) = $value, derivative($argument) = $derivative),
                    kinetic = 0.5 * m * dot(x).powi(2),
                    force(x = own(dot(x)) + given(dot(x))),
                )]
        struct $name {
            m: f64,
            #[lagrangian(skip)]
            gain: f64,
        }
    };
}

#[test]
fn a_macro_may_write_functions() {
    use lagrangian::prelude::*;

    driven!(Driven, speed => speed * speed * self.gain, 4.0 * speed);
    let model = Driven { m: 2.0, gain: 2.0 };
    let state = State::new(0.0, [0.0], [3.0]);
    assert!((model.accelerations(&state)[0] - 12.0).abs() < 1e-15);
    for function in ["own", "given"] {
        assert_eq!(model.check_derivatives(function, [-1.0..=1.0]), Ok(()));
    }
}
