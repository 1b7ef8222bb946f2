//! Structs with parameters of any scalar, `struct Top<T: Scalar>`, in all the shapes that structs have.
#![deny(
    warnings,
    clippy::all,
    clippy::pedantic,
    clippy::nursery,
    missing_copy_implementations,
    missing_debug_implementations,
    missing_docs,
    nonstandard_style,
    rust_2018_idioms,
    single_use_lifetimes,
    trivial_casts,
    unreachable_pub,
    unused,
    unused_lifetimes,
    unused_qualifications,
    unused_results
)]
// It asks for the opposite of `unreachable_pub`.
#![allow(clippy::redundant_pub_crate)]

use core::fmt::Debug;

use lagrangian::prelude::*;
use lagrangian::quantities;
use lagrangian_tests::assert_close;

/// Everything that is emitted for a model, on one struct: energies, an input, outputs, preparation, and
/// a plain number beside the scalars.
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
    force(theta1 = torque - exp(-t) * l1),
    output(x = x, y = y, sensed = dot(dot(x)) + torque),
)]
struct Driven<T: Scalar = f64> {
    m1: T,
    m2: T,
    l1: T,
    l2: T,
    g: f64,
    drag: f32,
    #[lagrangian(input)]
    torque: T,
}

/// The same on plain numbers.
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
    force(theta1 = torque - exp(-t) * l1),
    output(x = x, y = y, sensed = dot(dot(x)) + torque),
)]
struct Plain {
    m1: f64,
    m2: f64,
    l1: f64,
    l2: f64,
    g: f64,
    drag: f32,
    #[lagrangian(input)]
    torque: f64,
}

const PLAIN: Plain = Plain {
    m1: 1.5,
    m2: 0.75,
    l1: 1.25,
    l2: 0.8,
    g: 9.81,
    drag: 0.125,
    torque: 0.3,
};

const DRIVEN: Driven = Driven {
    m1: 1.5,
    m2: 0.75,
    l1: 1.25,
    l2: 0.8,
    g: 9.81,
    drag: 0.125,
    torque: 0.3,
};

/// All that a model with outputs and an input gives at a state.
fn numbers<M>(model: &M, observe: impl Fn(&M, &State<f64, 2>) -> [f64; 6]) -> Vec<f64>
where
    M: Lagrangian<
            2,
            Model: quantities::Energies<2>
                       + quantities::Inputs<2, 1>
                       + quantities::StateJacobian<2>,
        >,
{
    let state = State::new(0.7, [0.4, -0.9], [1.3, 0.6]);
    let inputs = SVector::from([0.1]);
    let linearization = model.linearize(&state);
    let mut numbers = vec![
        model.lagrangian(&state),
        model.energy(&state),
        model.kinetic_energy(&state),
        model.potential_energy(&state),
        model.with_inputs(inputs).lagrangian(&state),
        model.inputs()[0],
    ];
    for vector in [
        model.momenta(&state),
        model.forcing(&state),
        model.generalized_forces(&state),
        model.accelerations(&state),
        model.dynamics().accelerations(&state),
        model.with_inputs(inputs).accelerations(&state),
        model.inverse_dynamics(&state, &SVector::from([0.2, 0.3])),
        model.relative_pivots(&state),
        model.input_jacobian(&state),
        linearization.time,
    ] {
        numbers.extend(vector.iter());
    }
    for matrix in [
        model.mass_matrix(&state),
        linearization.position,
        linearization.velocity,
    ] {
        numbers.extend(matrix.iter());
    }
    numbers.extend(observe(model, &state));
    numbers
}

#[test]
fn parameters_of_a_scalar_give_what_plain_numbers_give() {
    let inputs = SVector::from([0.1]);
    let driven = numbers(&DRIVEN, |model, state| {
        let (held, under) = (
            model.outputs(state),
            model.with_inputs(inputs).outputs(state),
        );
        [held.x, held.y, held.sensed, under.x, under.y, under.sensed]
    });
    let plain = numbers(&PLAIN, |model, state| {
        let (held, under) = (
            model.outputs(state),
            model.with_inputs(inputs).outputs(state),
        );
        [held.x, held.y, held.sensed, under.x, under.y, under.sensed]
    });
    for (driven, plain) in driven.iter().zip(&plain) {
        assert_eq!(driven.to_bits(), plain.to_bits(), "{driven} is not {plain}");
    }
    assert_eq!(driven.len(), plain.len());
}

#[test]
fn what_is_known_of_the_model_is_known_for_every_scalar() {
    assert_eq!(Driven::<f64>::EQUATIONS, Plain::EQUATIONS);
    assert_eq!(Driven::<f32>::OPERATIONS, Plain::OPERATIONS);
    assert_eq!(<Driven>::COORDINATES, ["theta1", "theta2"]);
    assert_eq!(<Driven>::THETA2, 1);
    assert_eq!(
        <Driven as GeneralizedCoordinates<2>>::ANGLES,
        <Plain as GeneralizedCoordinates<2>>::ANGLES
    );
    assert_eq!(
        <Driven<f32> as quantities::Inputs<2, 1, f32>>::INPUTS,
        <Plain as quantities::Inputs<2, 1>>::INPUTS
    );
    assert_eq!(<Driven>::INPUTS, Plain::INPUTS);
    assert_eq!((<Driven>::TORQUE, Plain::TORQUE), (0, 0));
}

#[test]
fn a_control_law_is_of_the_scalar() -> Result<(), IntegrationError> {
    let driven = Driven {
        m1: 1.5_f32,
        m2: 0.75,
        l1: 1.25,
        l2: 0.8,
        g: 9.81,
        drag: 0.125,
        torque: 0.3,
    };
    let start = State::new(0.0, [0.4, -0.9], [0.0, 0.0]);
    let method = RungeKutta::classical(1e-3);
    let damped = Problem::new(&driven, start).feedback(|state| -state.v[0].sin());
    let end = damped.solve(1.0, method)?;
    // The fields are plain numbers, on which the law is of the scalar of the state.
    let other = Problem::new(&PLAIN, start).feedback(|state| -state.v[0].sin());
    let other = other.solve(1.0, method)?;
    let start = State::new(0.0, [0.4, -0.9], [0.0, 0.0]);
    let damped = Problem::new(&PLAIN, start).feedback(|state| -state.v[0].sin());
    let expected = damped.solve(1.0, method)?;
    for found in [end, other] {
        let found = found.q.map(f64::from);
        assert_close("q", found.as_slice(), expected.q.as_slice(), 1e-5);
    }
    Ok(())
}

/// Lifetimes, numbers and types beside the scalar, which comes last.
#[derive(Lagrangian, Debug)]
#[lagrangian(
    coordinates(x, y),
    lagrangian = m * dot(x) * dot(y) - 0.5 * stiffness * x.powi(2),
    output(p = m * dot(x)),
)]
struct Labelled<'a, K, const N: usize, T>
where
    K: Debug,
    T: Debug + Scalar,
{
    m: T,
    #[lagrangian(skip)]
    labels: &'a [K; N],
    stiffness: T,
}

#[test]
fn a_scalar_may_stand_beside_other_parameters() {
    let labels = ["a", "b"];
    let model = Labelled {
        m: 2.0,
        labels: &labels,
        stiffness: 3.0,
    };
    let state = State::new(0.0, [0.5, 0.0], [1.0, 0.0]);
    // m ÿ = −k x.
    assert!((model.accelerations(&state)[Labelled::<&str, 2, f64>::Y] + 0.75).abs() < 1e-15);
    assert!((model.outputs(&state).p - 2.0).abs() < 1e-15);
    assert_eq!(model.labels.len(), 2);
}

/// A type parameter that the equations do not see: the model is one on every scalar.
#[derive(Lagrangian, Debug)]
#[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), potential = m * x)]
struct Tagged<K: Scalar> {
    m: f64,
    #[lagrangian(skip)]
    tag: K,
}

#[test]
fn a_parameter_of_skipped_fields_is_not_the_scalar() {
    let model = Tagged { m: 2.0, tag: 1.0 };
    let single = State::new(0.0_f32, [0.5], [1.0]);
    let double = State::new(0.0_f64, [0.5], [1.0]);
    assert!((model.accelerations(&single)[0] + 1.0).abs() < 1e-6);
    assert!((model.accelerations(&double)[0] + model.tag).abs() < 1e-15);
}

/// A scalar of which more is asked, by traits that have functions of the same names.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    coordinates(theta, x),
    kinetic = 0.5 * m * l.powi(2) * dot(theta).powi(2) + 0.5 * m * dot(x).powi(2)
        + m * l * dot(theta) * dot(x) * cos(theta),
    potential = -m * g * l * cos(theta) + sqrt(1.0 + x.powi(2)) + max(x, 0.1) * abs(sin(theta)),
    force(x = -tanh(dot(x)) * atan2(x, 2.0) + PI),
)]
struct Bounded<T>
where
    T: Scalar + nalgebra::RealField + num_traits::FromPrimitive + num_traits::Float,
{
    m: T,
    l: T,
    #[lagrangian(input)]
    g: T,
}

/// The same on plain numbers.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    coordinates(theta, x),
    kinetic = 0.5 * m * l.powi(2) * dot(theta).powi(2) + 0.5 * m * dot(x).powi(2)
        + m * l * dot(theta) * dot(x) * cos(theta),
    potential = -m * g * l * cos(theta) + sqrt(1.0 + x.powi(2)) + max(x, 0.1) * abs(sin(theta)),
    force(x = -tanh(dot(x)) * atan2(x, 2.0) + PI),
)]
struct Unbounded {
    m: f64,
    l: f64,
    #[lagrangian(input)]
    g: f64,
}

#[test]
fn other_traits_of_the_scalar_do_not_matter() {
    let (m, l, g) = (2.0, 0.5, 9.81);
    let (bounded, unbounded) = (Bounded { m, l, g }, Unbounded { m, l, g });
    let state = State::new(0.7, [0.4, -0.9], [1.3, 0.6]);
    assert_eq!(
        bounded.accelerations(&state),
        unbounded.accelerations(&state)
    );
    assert_eq!(
        bounded.input_jacobian(&state),
        unbounded.input_jacobian(&state)
    );
    assert_eq!(bounded.linearize(&state), unbounded.linearize(&state));
}

mod named {
    //! Scalars by other names and paths.

    /// The trait by its path, under `where`, for a parameter called like what is emitted.
    #[derive(lagrangian::Lagrangian, Debug)]
    #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), potential = S * x, output(x = x))]
    #[allow(non_snake_case)]
    pub(super) struct State<S>
    where
        S: lagrangian::Scalar,
    {
        pub(super) m: S,
        pub(super) S: S,
    }
}

#[test]
fn the_trait_and_the_parameter_may_have_other_names() {
    let state = State::new(0.0, [0.5], [1.0]);
    let model = named::State { m: 2.0, S: 3.0 };
    assert!((model.accelerations(&state)[0] + 1.5).abs() < 1e-15);
    assert!((model.outputs(&state).x - 0.5).abs() < 1e-15);
}

#[test]
fn a_macro_may_write_the_parameter() {
    macro_rules! model {
        ($name:ident, $scalar:ident, $ty:ty, $path:path) => {
            #[derive(Lagrangian, Debug)]
            #[lagrangian(coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), potential = m * x)]
            struct $name<$scalar: $path> {
                m: $ty,
            }
        };
    }
    model!(Falling, F, F, Scalar);
    let state = State::new(0.0, [0.5], [1.0]);
    assert!((Falling { m: 2.0 }.accelerations(&state)[Falling::<f64>::X] + 1.0).abs() < 1e-15);
}

/// A body whose tensor, centre and springs are of any scalar, in arrays and in nalgebra's types.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zyx(phi, theta, psi), w = angular_velocity(r), angles = [phi, theta, psi]),
    kinetic = 0.5 * w.dot(inertia * w),
    potential = m * (r * center).z + 0.5 * (0..3).map(|i| k[i] * angles[i].powi(2)).sum(),
    force(psi = torque.x),
    output(spin = r * inertia * w, matrix = r),
)]
struct Body<T: Scalar> {
    m: f64,
    inertia: Matrix3<T>,
    center: Vector3<T>,
    k: [T; 3],
    #[lagrangian(input)]
    torque: Vector2<T>,
}

/// A body with values that every scalar holds exactly.
fn body<T: Scalar>() -> Body<T> {
    let number = T::from_f64;
    let [a, b, c, d] = [2.0, 3.0, 4.0, 0.25].map(number);
    Body {
        m: 1.5,
        inertia: Matrix3::new(a, d, T::zero(), d, b, d, T::zero(), d, c),
        center: Vector3::new(d, T::zero(), a),
        k: [a, b, c],
        torque: Vector2::new(d, b),
    }
}

#[test]
fn arrays_of_a_scalar_give_what_arrays_of_plain_numbers_give() {
    let state = State::new(0.0, [0.25, 0.5, -0.75], [1.0, -0.5, 0.25]);
    let single = State::new(0.0_f32, [0.25, 0.5, -0.75], [1.0, -0.5, 0.25]);
    let double = body::<f64>().accelerations(&state);
    let found = body::<f32>().accelerations(&single).map(f64::from);
    assert_close("accelerations", found.as_slice(), double.as_slice(), 1e-5);
    let spin = body::<f64>().outputs(&state).spin;
    let found = body::<f32>().outputs(&single).spin.map(f64::from);
    assert_close("spin", found.as_slice(), spin.as_slice(), 1e-5);
    let matrix = body::<f64>().outputs(&state).matrix;
    let identity = Matrix3::<f64>::identity();
    assert_close(
        "rotation",
        (matrix.transpose() * matrix).as_slice(),
        identity.as_slice(),
        1e-15,
    );
}
