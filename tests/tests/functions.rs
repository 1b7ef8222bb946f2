//! Functions from outside: the same motion as with their formulas, and derivatives that are checked.

use lagrangian::DerivativeError;
use lagrangian::prelude::*;
use lagrangian_tests::{Dual, assert_close};

const TOLERANCE: f64 = 1e-13;

/// A friction curve on every scalar: tanh(v) (0.4 + 0.2 exp(−v²)), which falls from rest to sliding.
mod friction {
    use lagrangian::Scalar;

    pub(super) fn stribeck<S: Scalar>(v: S) -> S {
        v.tanh() * (S::from_f64(0.4) + falling(v))
    }

    pub(super) fn slope<S: Scalar>(v: S) -> S {
        let steep = S::one() - v.tanh() * v.tanh();
        steep * (S::from_f64(0.4) + falling(v)) - v.tanh() * v * (falling(v) + falling(v))
    }

    fn falling<S: Scalar>(v: S) -> S {
        S::from_f64(0.2) * (-v * v).exp()
    }
}

/// A slider on a spring, under friction that is computed outside.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(stribeck(v) = friction::stribeck(v), derivative(v) = slope(v)),
    function(slope(v) = friction::slope(v)),
    function(half() = Scalar::from_f64(0.5)),
    kinetic = half() * m * dot(x).powi(2),
    potential = half() * k * x.powi(2),
    force(x = -load * stribeck(dot(x))),
    output(friction = load * stribeck(dot(x)), rate = dot(stribeck(dot(x)))),
)]
struct Slider {
    m: f64,
    k: f64,
    load: f64,
}

/// The same in elementary functions.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    define(stribeck = tanh(dot(x)) * (0.4 + 0.2 * exp(-dot(x).powi(2)))),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = 0.5 * k * x.powi(2),
    force(x = -load * stribeck),
    output(friction = load * stribeck, rate = dot(stribeck)),
)]
struct ElementarySlider {
    m: f64,
    k: f64,
    load: f64,
}

const STATES: [[f64; 3]; 4] = [
    [0.0, 0.3, 0.7],
    [1.0, -0.4, -0.2],
    [2.0, 1.1, 2.5],
    [0.5, 0.0, 0.0],
];

/// All that a model computes of its motion, one after the other.
fn computed<const N: usize>(
    model: &impl Lagrangian<N>,
    state: &State<f64, N>,
    accelerations: &SVector<f64, N>,
) -> Vec<f64> {
    let linearization = model.linearize(state);
    let mut values = vec![model.lagrangian(state), model.energy(state)];
    values.extend(&model.momenta(state));
    values.extend(&model.mass_matrix(state));
    values.extend(&model.forcing(state));
    values.extend(&model.generalized_forces(state));
    values.extend(&model.accelerations(state));
    values.extend(&model.accelerations_prepared(state, &model.prepare()));
    values.extend(&model.inverse_dynamics(state, accelerations));
    values.extend(&linearization.position);
    values.extend(&linearization.velocity);
    values.extend(&linearization.time);
    values
}

#[test]
fn a_friction_curve_is_a_force() {
    let (m, k, load) = (2.0, 3.0, 9.81);
    let slider = Slider { m, k, load };
    let elementary = ElementarySlider { m, k, load };
    for [t, x, v] in STATES {
        let state = State::new(t, [x], [v]);
        let accelerations = SVector::from([0.3]);
        assert_close(
            "slider",
            &computed(&slider, &state, &accelerations),
            &computed(&elementary, &state, &accelerations),
            TOLERANCE,
        );
        let (found, expected) = (slider.outputs(&state), elementary.outputs(&state));
        assert_close(
            "outputs",
            &[found.friction, found.rate],
            &[expected.friction, expected.rate],
            TOLERANCE,
        );
    }
}

#[test]
fn functions_of_every_scalar_are_evaluated_on_every_scalar() {
    let slider = Slider {
        m: 2.0,
        k: 3.0,
        load: 9.81,
    };
    let derivative = slider.linearize(&State::new(0.0, [0.3], [0.7])).velocity[0];
    let [t, x] = [0.0, 0.3].map(Dual::constant);
    let state = State::new(t, [x], [Dual::new(0.7, 1.0)]);
    let found = slider.accelerations(&state)[0].derivative();
    assert_close("dual", &[found], &[derivative], TOLERANCE);
    let single: State<f32, 1> = State::new(0.0, [0.3], [0.7]);
    let single = f64::from(slider.accelerations(&single)[0]);
    let double = slider.accelerations(&State::new(0.0, [0.3], [0.7]))[0];
    assert!(
        (single - double).abs() < 1e-5 * double.abs(),
        "{single} for {double}"
    );
}

/// Values and slopes at equidistant points, with a cubic between each two.
struct Table {
    step: f64,
    values: Vec<[f64; 2]>,
}

impl Table {
    /// The table of a function and its slope from 0 on.
    fn of(step: f64, count: usize, function: impl Fn(f64) -> [f64; 2]) -> Self {
        let points = (0..count).scan(-step, |x, _| {
            *x += step;
            Some(*x)
        });
        Self {
            step,
            values: points.map(function).collect(),
        }
    }

    /// The cubic's derivative of some order at `x`.
    fn derivative(&self, order: usize, x: f64) -> f64 {
        let (mut piece, mut from) = (0, 0.0);
        while x > from + self.step && piece + 2 < self.values.len() {
            from += self.step;
            piece += 1;
        }
        let [[a, b], [c, d]] = [self.values[piece], self.values[piece + 1]];
        let (h, s) = (self.step, (x - from) / self.step);
        let (b, d) = (b * h, d * h);
        let coefficients = [a, b, 3.0 * (c - a) - 2.0 * b - d, 2.0 * (a - c) + b + d];
        match order {
            0 => coefficients.iter().rev().fold(0.0, |sum, c| sum * s + c),
            1 => (coefficients[1] + s * (2.0 * coefficients[2] + 3.0 * s * coefficients[3])) / h,
            _ => (2.0 * coefficients[2] + 6.0 * s * coefficients[3]) / (h * h),
        }
    }
}

/// A bead on a wire whose height is a table.
#[derive(Lagrangian)]
#[lagrangian(
    scalar = f64,
    coordinates(x, y),
    function(height(x) = self.height.derivative(0, x), derivative(x) = rise(x)),
    function(rise(x) = self.height.derivative(1, x), derivative(x) = bend(x)),
    function(bend(x) = self.height.derivative(2, x), derivative(x) = 6.0 * cubic),
    define(z = height(x + y)),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2) + dot(z).powi(2)),
    potential = m * g * z,
)]
struct Bead {
    m: f64,
    g: f64,
    cubic: f64,
    #[lagrangian(skip)]
    height: Table,
}

/// The same on the curve of which the table is made, a cubic.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    define(z = cubic * (x + y).powi(3) - (x + y)),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2) + dot(z).powi(2)),
    potential = m * g * z,
)]
struct ElementaryBead {
    m: f64,
    g: f64,
    cubic: f64,
}

#[test]
fn a_table_is_a_field() {
    let (m, g, cubic) = (2.0, 9.81, 0.25);
    let curve = |x: f64| [cubic * x.powi(3) - x, 3.0 * cubic * x * x - 1.0];
    let bead = Bead {
        m,
        g,
        cubic,
        height: Table::of(0.5, 12, curve),
    };
    let elementary = ElementaryBead { m, g, cubic };
    let states = [
        [0.3, 0.4, 0.7, -0.2],
        [1.1, 1.9, 2.5, 1.6],
        [0.0, 0.0, 1.0, 1.0],
    ];
    let accelerations = SVector::from([0.3, -1.2]);
    for [x, y, u, v] in states {
        let state = State::new(0.0, [x, y], [u, v]);
        let found = computed(&bead, &state, &accelerations);
        let expected = computed(&elementary, &state, &accelerations);
        assert_close("bead", &found, &expected, TOLERANCE);
    }
    // A cubic bends evenly, and a table whose pieces do not is found out.
    for function in ["height", "rise", "bend"] {
        assert_eq!(bead.check_derivatives(function, [0.0..=5.5]), Ok(()));
    }
    let sine = Bead {
        height: Table::of(0.5, 12, |x| [x.sin(), x.cos()]),
        ..bead
    };
    assert_eq!(sine.check_derivatives("height", [0.0..=5.5]), Ok(()));
    assert_eq!(sine.check_derivatives("rise", [0.0..=5.5]), Ok(()));
    let bends = sine.check_derivatives("bend", [0.0..=5.5]);
    assert!(
        matches!(
            bends,
            Err(DerivativeError::Wrong {
                function: "bend",
                ..
            })
        ),
        "{bends:?}"
    );
}

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
        let inputs = [-0.3].into();
        let found = glider.input_jacobian_with(&state, &inputs);
        let expected = elementary.input_jacobian_with(&state, &inputs);
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

/// A spring on a scalar of its own, whose derivative by the stiffness has the wrong sign.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    function(
        push(x, k) = -k * x.sinh(),
        derivative(x) = -k * cosh(x),
        derivative(k) = sinh(x),
    ),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = push(x, stiffness)),
)]
struct Spring<T: Scalar> {
    m: T,
    #[lagrangian(input)]
    stiffness: T,
}

#[test]
fn a_wrong_derivative_is_found_out() {
    let spring = Spring {
        m: 2.0,
        stiffness: 3.0,
    };
    let state = State::new(0.0, [0.5], [0.0]);
    let expected = -1.5 * 0.5_f64.sinh();
    assert_close(
        "push",
        &[spring.accelerations(&state)[0]],
        &[expected],
        TOLERANCE,
    );
    let held = spring.check_derivatives("push", [-1.0..=1.0, 3.0..=3.0]);
    assert_eq!(held, Ok(()));
    let Err(DerivativeError::Wrong {
        function,
        argument,
        point,
        declared,
        measured,
        ..
    }) = spring.check_derivatives("push", [-1.0..=1.0, 1.0..=5.0])
    else {
        panic!("the sign is right");
    };
    assert_eq!((function, argument), ("push", "k"));
    assert!(
        (declared + measured).abs() < 1e-8,
        "{declared} at {point}, not {measured}"
    );
}

/// The characteristic of a motor, in single precision.
fn torque(speed: f32, voltage: f32) -> f32 {
    voltage / (1.0 + speed * speed)
}

/// A motor on one scalar alone, with inputs and outputs on it.
#[derive(Lagrangian)]
#[lagrangian(
    scalar = f32,
    coordinates(angle),
    function(
        torque(speed, voltage) = torque(speed, voltage),
        derivative(speed) = -2.0 * speed * torque(speed, voltage) / (1.0 + speed.powi(2)),
        derivative(voltage) = 1.0 / (1.0 + speed.powi(2)),
    ),
    kinetic = 0.5 * inertia * dot(angle).powi(2),
    force(angle = torque(dot(angle), volts) - drag * signum(angle) * sin(angle)),
    output(power = dot(angle) * torque(dot(angle), volts), turned = [cos(angle), sin(angle)]),
)]
struct Motor {
    inertia: f32,
    drag: f64,
    #[lagrangian(input)]
    volts: f32,
}

#[test]
fn a_model_may_be_on_one_scalar_alone() {
    let motor = Motor {
        inertia: 2.0,
        drag: 0.5,
        volts: 12.0,
    };
    let state = State::new(0.0, [0.5], [2.0]);
    let close = |found: f32, expected: f32| assert!((found - expected).abs() < 1e-6, "{found}");
    let expected = 0.5 * (12.0 / 5.0 - 0.5 * 0.5_f32.sin());
    close(motor.accelerations(&state)[0], expected);
    close(
        motor.linearize(&state).velocity[0],
        -0.5 * 4.0 * 12.0 / 25.0,
    );
    close(motor.input_jacobian_with(&state, &motor.inputs())[0], 0.1);
    let MotorOutputs { power, turned } = motor.outputs(&state);
    close(power, 4.8);
    close(turned[0], 0.5_f32.cos());
    let checked = motor.check_derivatives("torque", [-3.0..=3.0, 0.0..=24.0]);
    assert_eq!(checked, Ok(()));
}
