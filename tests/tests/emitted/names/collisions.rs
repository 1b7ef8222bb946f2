//! Fields, structs and constants that are called like what is emitted.

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
    use lagrangian::Lagrangian as _;

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
