//! What is emitted gets along with whatever names the user's crate has.
#![deny(warnings, clippy::pedantic, missing_docs, unsafe_code)]

/// Fields that are called like things in the emitted code.
mod fields {
    use lagrangian::prelude::*;

    #[derive(Lagrangian)]
    #[lagrangian(
        coordinates(theta, x),
        define(x0 = x + state, sin_theta_ = sin(theta), factors = accelerations * dot(x0)),
        kinetic = 0.5 * S * dot(theta).powi(2) + 0.5 * __S * factors.powi(2) + theta_dot * dot(x),
        potential = x1 * cos(theta) + sin_theta * sin_theta_ + cos_theta * t + outputs * x + x_dot * x0,
        dissipation = 0.5 * mass * dot(theta).powi(2),
        force(x = inputs + parameter * u + __N),
        output(state = x0, prepared = dot(dot(x)), theta = theta),
    )]
    #[allow(non_snake_case)]
    pub(super) struct Colliding {
        pub(super) S: f64,
        pub(super) __S: f64,
        pub(super) __N: f64,
        pub(super) state: f64,
        pub(super) accelerations: f64,
        pub(super) outputs: f64,
        pub(super) parameter: f64,
        pub(super) mass: f64,
        pub(super) x1: f64,
        pub(super) sin_theta: f64,
        pub(super) cos_theta: f64,
        pub(super) theta_dot: f64,
        pub(super) x_dot: f64,
        // No input: the names of the inputs are the constant `INPUTS`.
        pub(super) inputs: f64,
        #[lagrangian(input)]
        pub(super) u: f64,
    }
}

#[test]
fn fields_may_be_called_like_emitted_locals() {
    use lagrangian::prelude::*;

    let model = fields::Colliding {
        S: 2.0,
        __S: 1.0,
        __N: 0.25,
        state: 0.5,
        accelerations: 3.0,
        outputs: 0.1,
        parameter: 0.2,
        mass: 0.3,
        x1: 0.4,
        sin_theta: 0.6,
        cos_theta: 0.7,
        theta_dot: 0.8,
        x_dot: 0.9,
        u: 1.1,
        inputs: 1.2,
    };
    let (theta, x): (f64, f64) = (0.3, 0.7);
    let state = State::new(2.0, [theta, x], [0.11, 0.13]);
    // 2 θ̈ = 0.4 sin θ − 0.6 cos θ − 0.3 θ̇, and 9 ẍ = 1.2 + 0.2·1.1 + 0.25 − 0.1 − 0.9.
    let expected = [
        (0.4 * theta.sin() - 0.6 * theta.cos() - 0.3 * 0.11) / 2.0,
        (1.2 + 0.22 + 0.25 - 1.0) / 9.0,
    ];
    let accelerations = model.accelerations(&state);
    for (derived, expected) in accelerations.iter().zip(expected) {
        assert!(
            (derived - expected).abs() < 1e-15,
            "{derived} is not {expected}"
        );
    }
    let outputs = model.outputs(&state);
    assert!((outputs.state - 1.2).abs() < 1e-15);
    assert!((outputs.prepared - expected[1]).abs() < 1e-15);
    assert!((outputs.theta - theta).abs() < 1e-15);
}

/// Structs that are called like the traits and types that emitted code names.
mod structs {
    #[derive(lagrangian::Lagrangian)]
    #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), output(p = m * dot(x)))]
    pub(super) struct State {
        pub(super) m: f64,
    }

    #[derive(lagrangian::Lagrangian)]
    #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), force(x = u))]
    pub(super) struct Scalar {
        pub(super) m: f64,
        #[lagrangian(input)]
        pub(super) u: f64,
    }

    #[derive(lagrangian::Lagrangian)]
    #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
    pub(super) struct Option {
        pub(super) m: f64,
    }

    #[derive(lagrangian::Lagrangian)]
    #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
    pub(super) struct System {
        pub(super) m: f64,
    }
}

#[test]
fn structs_may_be_called_like_what_is_emitted() {
    use lagrangian::{Inputs as _, Lagrangian as _, Outputs as _};

    let state = lagrangian::State::new(0.0, [1.0], [2.0]);
    assert!(structs::State { m: 3.0 }.outputs(&state).p > 5.9);
    assert!(structs::Scalar { m: 2.0, u: 1.0 }.input_jacobian(&state)[0] < 0.6);
    assert!(structs::Option { m: 2.0 }.momenta(&state)[0] > 3.9);
    assert!(structs::System { m: 2.0 }.momenta(&state)[0] > 3.9);
}

/// Everything that emitted code might name has another meaning here.
mod shadowed {
    #![allow(dead_code, non_camel_case_types, unused_macros)]

    mod core {}
    mod std {}
    mod alloc {}
    mod nalgebra {}
    mod lagrangian {}
    mod symbolic {}
    struct Vec;
    struct String;
    struct Box;
    struct Self_;
    struct SVector;
    struct SMatrix;
    struct Linearization;
    struct Operations;
    struct Factorization;
    enum Result {}
    trait Clone {}
    trait Copy {}
    trait Debug {}
    trait PartialEq {}
    trait From {}
    trait Into {}
    trait Iterator {}
    trait Scalar {}
    trait State {}
    trait Sqrt {
        fn sqrt(self);
        fn sin_cos(self);
        fn solve(&self);
    }
    impl<T> Sqrt for T {
        fn sqrt(self) {}
        fn sin_cos(self) {}
        fn solve(&self) {}
    }
    fn parameter() {}
    macro_rules! unreachable {
        () => {};
    }

    #[derive(::lagrangian::Lagrangian)]
    #[lagrangian(
        coordinates(theta, x),
        kinetic = 0.5 * m * l.powi(2) * dot(theta).powi(2) + 0.5 * m * dot(x).powi(2),
        potential = -m * g * l * cos(theta) + sqrt(1.0 + x.powi(2)),
        force(x = u),
        output(x = x, height = -l * cos(theta)),
    )]
    pub(super) struct Pendulum {
        pub(super) m: f64,
        pub(super) g: f64,
        pub(super) l: f64,
        #[lagrangian(input)]
        pub(super) u: f64,
    }
}

#[test]
fn shadowed_names_do_not_matter() {
    use lagrangian::prelude::*;

    let model = shadowed::Pendulum {
        m: 1.0,
        g: 9.81,
        l: 1.0,
        u: 0.0,
    };
    let state = State::new(0.0, [0.3, 0.0], [0.0, 0.0]);
    let expected = -9.81 * 0.3_f64.sin();
    assert!((model.accelerations(&state)[0] - expected).abs() < 1e-14);
    assert_eq!(model.outputs(&state), model.outputs(&state).clone());
}

/// Constants and statics whose names are those of fields: a local variable may not become a pattern.
mod constants {
    #![allow(dead_code, non_snake_case)]

    const G: &str = "not a number";
    const I1: &str = "not a number";
    const THETA: &str = "not an index";
    struct S;

    #[derive(lagrangian::Lagrangian)]
    #[lagrangian(
        coordinates(theta),
        kinetic = 0.5 * I1 * dot(theta).powi(2),
        potential = -G * S * cos(theta),
    )]
    pub(super) struct Rotor {
        pub(super) I1: f64,
        pub(super) G: f64,
        pub(super) S: f64,
    }
}

#[test]
fn constants_beside_the_model_do_not_matter() {
    use lagrangian::prelude::*;

    let model = constants::Rotor {
        I1: 2.0,
        G: 3.0,
        S: 4.0,
    };
    let state = State::new(0.0, [0.5], [0.0]);
    let expected = -6.0 * 0.5_f64.sin();
    assert!((model.accelerations(&state)[constants::Rotor::THETA] - expected).abs() < 1e-14);
}

#[test]
fn a_model_may_stand_in_a_function() {
    use lagrangian::prelude::*;

    #[derive(Lagrangian)]
    #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), potential = m * x, output(x = x))]
    struct Local {
        m: f64,
    }

    let state = State::new(0.0, [0.5], [0.0]);
    assert!((Local { m: 2.0 }.accelerations(&state)[Local::X] + 1.0).abs() < 1e-15);
}

#[test]
fn names_may_be_raw_or_greek_or_upper_case() {
    use lagrangian::prelude::*;

    #[derive(Lagrangian)]
    #[lagrangian(
        coordinates(θ, r#type),
        define(ω = dot(θ), r#loop = dot(r#type)),
        kinetic = 0.5 * J * ω.powi(2) + 0.5 * r#move * r#loop.powi(2),
        potential = r#move * r#type,
        force(θ = -r#in * ω, r#type = r#let),
        output(r#fn = r#type, ψ = dot(ω)),
    )]
    #[allow(non_snake_case)]
    struct Names {
        J: f64,
        r#move: f64,
        r#in: f64,
        r#let: f64,
    }

    let model = Names {
        J: 2.0,
        r#move: 4.0,
        r#in: 1.0,
        r#let: 1.0,
    };
    let state = State::new(0.0, [0.5, 0.25], [1.0, 0.0]);
    assert!((model.accelerations(&state)[Names::θ] + 0.5).abs() < 1e-15);
    assert!((model.accelerations(&state)[Names::TYPE] + 0.75).abs() < 1e-15);
    assert!((model.outputs(&state).ψ + 0.5).abs() < 1e-15);
    assert!((model.outputs(&state).r#fn - 0.25).abs() < 1e-15);
    assert_eq!(Names::COORDINATES, ["θ", "type"]);
}

#[test]
fn a_skipped_field_may_have_a_reserved_name() {
    use lagrangian::prelude::*;

    #[derive(Lagrangian)]
    #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), potential = m * t * x)]
    struct Skipping {
        m: f64,
        #[lagrangian(skip)]
        t: &'static str,
    }

    let model = Skipping {
        m: 2.0,
        t: "a name",
    };
    let state = State::new(3.0, [0.5], [0.0]);
    assert!(
        (model.accelerations(&state)[0] + 3.0).abs() < 1e-15,
        "{}",
        model.t
    );
}

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

/// Functions whose names, and whose arguments' names, are those of other things.
mod functions {
    use lagrangian::prelude::*;

    #[derive(Lagrangian)]
    #[lagrangian(
        scalar = f64,
        coordinates(x),
        function(
            r#match(state, arguments, x0) = state * arguments + x0 * self.state(),
            derivative(state) = arguments,
            derivative(arguments) = state,
            derivative(x0) = prepared,
        ),
        function(mentions(r#type) = r#type * r#type, derivative(r#type) = twice(r#type)),
        function(twice(x) = twice(x), derivative(x) = twice_by_0()),
        function(twice_by_0() = 2.0),
        function(state(q) = { let state = q; self::functions_of_the_user::state(state) }, derivative(q) = 3.0),
        kinetic = 0.5 * factors * dot(x).powi(2),
        potential = r#match(x, x, t) + mentions(x) + state(x),
        force(x = x.r#match(dot(x), 1.0)),
        output(state = state(x)),
    )]
    pub(super) struct Model {
        pub(super) factors: f64,
        pub(super) prepared: f64,
        #[lagrangian(skip)]
        pub(super) state: f64,
    }

    impl Model {
        fn state(&self) -> f64 {
            self.state
        }
    }

    fn twice(x: f64) -> f64 {
        2.0 * x
    }

    mod functions_of_the_user {
        pub(super) fn state(state: f64) -> f64 {
            3.0 * state
        }
    }
}

#[test]
fn functions_meet_nothing_of_the_users() {
    use lagrangian::prelude::*;

    let model = functions::Model {
        factors: 2.0,
        prepared: 5.0,
        state: 5.0,
    };
    let state = State::new(4.0, [0.5], [3.0]);
    // V = x² + 5 t + x² + 3 x, and the force is x ẋ + 5.
    assert!((model.potential_energy(&state) - 22.0).abs() < 1e-15);
    assert!((model.accelerations(&state)[0] - (1.5 + 5.0 - 5.0) / 2.0).abs() < 1e-15);
    assert!((model.outputs(&state).state - 1.5).abs() < 1e-15);
    let regions = [-1.0..=1.0, -1.0..=1.0, -1.0..=1.0];
    assert_eq!(model.check_derivatives("match", regions), Ok(()));
    for function in ["mentions", "twice", "state"] {
        assert_eq!(model.check_derivatives(function, [-1.0..=1.0]), Ok(()));
    }
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
