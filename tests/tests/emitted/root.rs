//! Models whose crate finds `lagrangian` elsewhere than at `::lagrangian`.
#![deny(
    warnings,
    clippy::all,
    clippy::pedantic,
    clippy::nursery,
    unused_qualifications,
    missing_docs
)]
// It asks for the opposite of `unreachable_pub`.
#![allow(clippy::redundant_pub_crate)]

/// A crate that hands `lagrangian` on under another name.
mod facade {
    pub(crate) use lagrangian as mechanics;

    /// A macro of that crate, which writes the derive for its users.
    macro_rules! oscillator {
        ($root:path, $name:ident) => {
            #[derive(crate::root::facade::mechanics::Lagrangian)]
            #[lagrangian(
                                                    crate = $root,
                                                    coordinates(x),
                                                    kinetic = 0.5 * m * dot(x).powi(2),
                                                    potential = 0.5 * stiffness * x.powi(2),
                                                )]
            struct $name {
                m: f64,
                stiffness: f64,
            }
        };
    }

    /// As a macro that is exported writes it.
    macro_rules! particle {
        ($name:ident) => {
            #[derive($crate::root::facade::mechanics::Lagrangian)]
            #[lagrangian(
                                                                coordinates(x),
                                                                kinetic = 0.5 * m * dot(x).powi(2),
                                                                potential = m * x,
                                                                crate = $crate::root::facade::mechanics
                                                            )]
            struct $name {
                m: f64,
            }
        };
    }

    pub(crate) use {oscillator, particle};
}

/// Models that are declared with the path, beside all names that emitted paths end in: a path that is
/// longer than it has to be is none of the user's.
mod user {
    use super::facade::mechanics::prelude::*;
    #[allow(unused_imports)]
    use super::facade::mechanics::{
        Factorization, GeneralizedCoordinates, Linearization, OperationCount, Operations, Scalar,
        State, quantities,
    };

    /// A double pendulum with a motor, by whose declaration everything is emitted that there is.
    #[derive(Lagrangian, Debug)]
    #[lagrangian(
        crate = "crate::root::facade::mechanics",
        coordinates(theta1, theta2),
        define(
            x = l * sin(theta1) + l * sin(theta2),
            y = -l * cos(theta1) - l * cos(theta2),
        ),
        kinetic = 0.5 * m * l.powi(2) * dot(theta1).powi(2) + 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
        potential = -m * g * l * cos(theta1) + m * g * y,
        dissipation = 0.5 * drag * dot(theta1).powi(2),
        force(theta1 = torque),
        output(x = x, sensed = dot(dot(y))),
    )]
    pub(crate) struct Pendulum {
        pub(crate) m: f64,
        pub(crate) l: f64,
        pub(crate) g: f64,
        pub(crate) drag: f64,
        #[lagrangian(input)]
        pub(crate) torque: f64,
    }

    /// The path may be relative.
    pub(crate) mod nested {
        use super::super::facade as front;

        /// ẋẏ: the mass matrix is indefinite.
        #[derive(front::mechanics::Lagrangian, Debug)]
        #[lagrangian(crate = front::mechanics, coordinates(x, y), lagrangian = m * dot(x) * dot(y) - x)]
        pub(crate) struct Indefinite {
            pub(crate) m: f64,
        }
    }
}

#[test]
fn a_crate_may_hand_lagrangian_on() {
    use facade::mechanics::prelude::*;

    let pendulum = user::Pendulum {
        m: 2.0,
        l: 0.5,
        g: 9.81,
        drag: 0.0,
        torque: 0.0,
    };
    let state = State::new(0.0, [1e-9, 0.0], [0.0, 0.0]);
    // (2 θ̈₁ + θ̈₂) l = −2 g θ₁, (θ̈₁ + θ̈₂) l = −g θ₂ = 0.
    let accelerations: [f64; 2] = pendulum.accelerations(&state).into();
    let expected = -2.0 * 9.81 * 1e-9 / 0.5;
    assert!(
        (accelerations[0] - expected).abs() < 1e-20,
        "{accelerations:?}"
    );
    assert!(
        (accelerations[1] + expected).abs() < 1e-20,
        "{accelerations:?}"
    );
    assert!((pendulum.outputs(&state).x - 0.5e-9).abs() < 1e-20);
    assert!(pendulum.input_jacobian(&state)[(0, 0)] > 0.0);

    let indefinite = user::nested::Indefinite { m: 2.0 };
    let accelerations: [f64; 2] = indefinite.accelerations(&state).into();
    assert!((accelerations[1] + 0.5).abs() < 1e-15, "{accelerations:?}");
}

#[test]
fn a_macro_may_write_the_path() {
    use facade::mechanics::prelude::*;

    facade::oscillator!(crate::root::facade::mechanics, Oscillator);
    facade::particle!(Particle);
    let state = State::new(0.0, [0.5], [0.0]);
    let oscillator = Oscillator {
        m: 2.0,
        stiffness: 8.0,
    };
    assert!((oscillator.accelerations(&state)[0] + 2.0).abs() < 1e-15);
    assert!((Particle { m: 2.0 }.accelerations(&state)[0] + 1.0).abs() < 1e-15);
}
