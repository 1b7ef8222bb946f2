//! What is emitted is nothing that the user's lints would flag: models of all kinds, under lints that
//! allow nothing. That this file compiles, and passes clippy, is the test.
#![deny(
    warnings,
    clippy::all,
    clippy::pedantic,
    clippy::nursery,
    let_underscore,
    missing_copy_implementations,
    missing_debug_implementations,
    missing_docs,
    nonstandard_style,
    rust_2018_idioms,
    single_use_lifetimes,
    trivial_casts,
    trivial_numeric_casts,
    unreachable_pub,
    unsafe_code,
    unused,
    unused_lifetimes,
    unused_qualifications,
    unused_results,
    variant_size_differences
)]
// It asks for the opposite of `unreachable_pub`.
#![allow(clippy::redundant_pub_crate)]

use lagrangian::prelude::*;

/// A heavy top; z-x-z Euler angles.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        w1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        w2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        w3 = dot(phi) * cos(theta) + dot(psi),
    ),
    kinetic = 0.5 * (i1 * w1.powi(2) + i2 * w2.powi(2) + i3 * w3.powi(2)),
    potential = m * g * l * cos(theta),
)]
pub struct HeavyTop {
    /// The first moment of inertia.
    pub i1: f64,
    /// The second.
    pub i2: f64,
    /// The third.
    pub i3: f64,
    /// Mass.
    pub m: f64,
    /// Gravity.
    pub g: f64,
    /// The distance of the centre of mass.
    pub l: f64,
}

/// A double pendulum with a motor at its pivot, drag, and outputs.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    coordinates(theta1, theta2),
    define(
        x = l1 * sin(theta1) + l2 * sin(theta2),
        y = -l1 * cos(theta1) - l2 * cos(theta2),
    ),
    kinetic = 0.5 * m1 * l1.powi(2) * dot(theta1).powi(2)
        + 0.5 * m2 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = -m1 * g * l1 * cos(theta1) + m2 * g * y,
    dissipation = 0.5 * drag * (dot(theta1).powi(2) + (dot(theta2) - dot(theta1)).powi(2)),
    force(theta1 = torque * (1.0 - abs(dot(theta1)) / limit)),
    output(x = x, y = y, sensed = dot(dot(x)) + gain * torque),
    c,
)]
pub struct DrivenDoublePendulum {
    /// Upper mass.
    pub m1: f64,
    /// Lower mass.
    pub m2: f64,
    /// Upper length.
    pub l1: f64,
    /// Lower length.
    pub l2: f64,
    /// Gravity.
    pub g: f64,
    /// Friction of the joints.
    pub drag: f64,
    /// The speed at which the motor has no torque left.
    pub limit: f64,
    /// Of a sensor.
    pub gain: f32,
    /// The torque of the motor.
    #[lagrangian(input)]
    pub torque: f64,
}

/// A bead on a wire that turns, so that the time occurs.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(s),
    define(x = s * cos(rate * t), y = s * sin(rate * t)),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = 0.5 * stiffness * (s - 1e-3 * exp(-t)).powi(2),
    force(s = 123456.789 * m * sin(t)),
)]
pub(crate) struct RotatingWire {
    pub(crate) m: f64,
    pub(crate) rate: f64,
    pub(crate) stiffness: f64,
    #[lagrangian(skip)]
    pub(crate) name: &'static str,
}

/// A charge in a magnetic field, by a general Lagrangian with a potential that contains velocities.
#[derive(Lagrangian, Debug)]
#[lagrangian(
    coordinates(x, y),
    lagrangian = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2))
        + 0.5 * charge * field * (x * dot(y) - y * dot(x)),
)]
struct ChargeInField {
    m: f64,
    charge: f64,
    field: f64,
}

/// A model without any parameter.
#[derive(Lagrangian, Debug)]
#[lagrangian(coordinates(x), kinetic = 0.5 * dot(x).powi(2), potential = x.powi(4) / 4.0)]
struct Quartic;

/// A model of which nothing but one number is asked.
#[derive(Lagrangian, Debug)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = atan2(x, 1.0) + max(x, 0.0) + x.abs().powf(2.5) + tanh(x),
    output(height = x),
)]
struct Barely;

/// A slider under external friction, on every scalar.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    coordinates(x),
    function(friction(v, load) = v.tanh() * load, derivative(v) = load * slope(v), derivative(load) = tanh(v)),
    function(slope(v) = v.signum(), derivative(v) = 0.0),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = -friction(dot(x), m)),
)]
pub struct Slider {
    /// Mass.
    pub m: f64,
}

/// A cart with series of its motion and of its events, of which one depends on neither inputs nor time.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    taylor,
    coordinates(x),
    function(saturation(v) = v.tanh(), derivative(v) = 1.0 - saturation(v).powi(2)),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = push - saturation(dot(x))),
    event(still = saturation(dot(x))),
)]
pub struct Cart {
    /// Mass.
    pub m: f64,
    /// Force.
    #[lagrangian(input)]
    pub push: f64,
}

/// A mass that slides along a whirling rod against a spring from a table, reduced by the angle of the rod.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    taylor,
    coordinates(r, phi),
    scalar = f64,
    function(spring(x) = self.table[0] * x, derivative(x) = stiffness),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    force(r = push - spring(r)),
    output(rate = dot(phi), whirling_up = dot(dot(phi)), place = phi),
    event(fast = dot(phi) - stiffness, still = dot(r), turned = sin(phi)),
    hamiltonian,
    energy_balance,
    sensitivities(m),
    regressor(m),
    routhian(SliderOnRod, without(place, turned, regressor)),
)]
pub struct WhirlingSlider {
    /// Mass.
    pub m: f64,
    /// Stiffness.
    pub stiffness: f64,
    /// The spring.
    #[lagrangian(skip)]
    pub table: [f64; 1],
    /// Force.
    #[lagrangian(input)]
    pub push: f64,
}

/// The same with events under inputs.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = push),
    event(still = dot(x), gate = x - place),
)]
pub struct Gate {
    /// Mass.
    pub m: f64,
    /// Force.
    #[lagrangian(input)]
    pub push: f64,
    /// Where the gate is.
    #[lagrangian(input)]
    pub place: f64,
}

/// A motor with a table of its torque, on one scalar alone.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    scalar = f64,
    coordinates(angle),
    function(torque(speed) = self.table.iter().fold(0.0, |sum, x| sum.mul_add(speed, *x)), derivative(speed) = slope(speed)),
    function(slope(speed) = self.table[0] * 2.0 * speed),
    function(constant() = self.table[0]),
    kinetic = 0.5 * inertia * dot(angle).powi(2),
    force(angle = torque(dot(angle)) * constant()),
    output(torque = torque(dot(angle))),
)]
pub struct Motor {
    /// Inertia.
    pub inertia: f64,
    /// Coefficients.
    #[lagrangian(skip)]
    pub table: [f64; 3],
}

mod hidden {
    //! Models that nobody outside sees.
    use super::Lagrangian;

    /// Seen by the module above.
    #[derive(Lagrangian, Debug)]
    #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), output(p = m * dot(x)))]
    pub(super) struct Particle {
        pub(super) m: f64,
    }
}

#[test]
fn models_of_all_kinds_pass_all_lints() {
    let top = HeavyTop {
        i1: 1.0,
        i2: 1.0,
        i3: 2.0,
        m: 1.0,
        g: 9.81,
        l: 0.1,
    };
    let state = State::new(0.0, [0.0, 0.5, 0.0], [0.3, 0.0, 20.0]);
    assert!(top.accelerations(&state)[HeavyTop::THETA].is_finite());

    let pendulum = DrivenDoublePendulum {
        m1: 1.0,
        m2: 1.0,
        l1: 1.0,
        l2: 1.0,
        g: 9.81,
        drag: 0.1,
        limit: 10.0,
        gain: 2.0,
        torque: 1.0,
    };
    let state = State::new(0.0, [0.1, 0.2], [0.3, 0.4]);
    assert!(pendulum.outputs(&state).sensed.is_finite());
    assert!(pendulum.input_jacobian(&state)[(0, 0)] > 0.0);

    let wire = RotatingWire {
        m: 1.0,
        rate: 2.0,
        stiffness: 3.0,
        name: "wire",
    };
    let state = State::new(0.5, [0.1], [0.3]);
    assert!(wire.linearize(&state).time[0].is_finite(), "{}", wire.name);
    assert!(Quartic.accelerations(&state)[0] < 0.0);
    assert!(Barely.accelerations(&state)[0].is_finite());
    assert!(hidden::Particle { m: 1.0 }.outputs(&state).p > 0.0);

    let slider = Slider { m: 1.0 };
    let state = State::new(0.0, [0.0], [1.0]);
    assert!(slider.linearize(&state).velocity[0] < 0.0);
    assert!(slider.check_derivatives("slope", [-1.0..=1.0]).is_ok());
    let cart = Cart { m: 1.0, push: 2.0 };
    assert!(cart.event_functions(&state)[Cart::STILL.index()] > 0.0);
    let gate = Gate {
        m: 1.0,
        push: 2.0,
        place: 0.5,
    };
    assert!(gate.event_functions(&state)[Gate::GATE.index()] < 0.0);
    let motor = Motor {
        inertia: 1.0,
        table: [1.0, 0.0, 2.0],
    };
    assert!(motor.outputs(&state).torque > 0.0);
    assert!(motor.check_derivatives("torque", [-1.0..=1.0]).is_ok());

    let charge = ChargeInField {
        m: 1.0,
        charge: 1.0,
        field: 2.0,
    };
    let state = State::new(0.0, [0.0, 0.0], [1.0, 0.0]);
    let accelerations: [f64; 2] = charge.accelerations(&state).into();
    assert!((accelerations[1] + 2.0).abs() < 1e-15);
}
