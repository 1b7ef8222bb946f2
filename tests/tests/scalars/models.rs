//! The models, and states of them.

use std::array;

use lagrangian::prelude::*;
use lagrangian::quantities::StateJacobian;

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
pub(crate) struct HeavyTop<T: Scalar> {
    pub(crate) i1: T,
    pub(crate) i2: T,
    pub(crate) i3: T,
    pub(crate) m: T,
    pub(crate) g: T,
    pub(crate) l: T,
}

/// A double pendulum by the angles of its links with the vertical.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    coordinates(alpha, beta),
    define(
        x = l1 * sin(alpha) + l2 * sin(beta),
        y = -l1 * cos(alpha) - l2 * cos(beta),
    ),
    kinetic = 0.5 * m1 * (l1 * dot(alpha)).powi(2) + 0.5 * m2 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = -m1 * g * l1 * cos(alpha) + m2 * g * y,
)]
pub(crate) struct DoublePendulum<T: Scalar> {
    pub(crate) m1: T,
    pub(crate) m2: T,
    pub(crate) l1: T,
    pub(crate) l2: T,
    pub(crate) g: T,
}

/// The same pendulum by the angle of the first link and the one between the two.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    coordinates(alpha, bend),
    kinetic = 0.5 * (m1 + m2) * l1.powi(2) * dot(alpha).powi(2)
        + 0.5 * m2 * l2.powi(2) * (dot(alpha) + dot(bend)).powi(2)
        + m2 * l1 * l2 * cos(bend) * dot(alpha) * (dot(alpha) + dot(bend)),
    potential = -(m1 + m2) * g * l1 * cos(alpha) - m2 * g * l2 * cos(alpha + bend),
)]
pub(crate) struct BentPendulum<T: Scalar> {
    pub(crate) m1: T,
    pub(crate) m2: T,
    pub(crate) l1: T,
    pub(crate) l2: T,
    pub(crate) g: T,
}

/// A cart with a pendulum, a spring that hardens, drag of two kinds and a motor, with functions of many
/// kinds.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    coordinates(x, theta),
    define(height = -l * cos(theta), speed = dot(x) + l * cos(theta) * dot(theta)),
    kinetic = 0.5 * cart * dot(x).powi(2) + 0.5 * bob * (speed.powi(2) + dot(height).powi(2)),
    potential = bob * g * height + stiffness * (sqrt(1.0 + x.powi(2)) - 1.0) + 0.1 * ln(cosh(x)),
    dissipation = 0.5 * drag * dot(x).powi(2) + 0.25 * drag * dot(theta).powi(4),
    force(
        x = motor * exp(-0.1 * t) * cos(rate * t) - friction * tanh(dot(x)),
        theta = 0.01 * atan2(dot(x), 2.0) - 0.02 * asinh(dot(theta)),
    ),
    output(height = height, felt = dot(speed) + g * sin(theta)),
)]
pub(crate) struct DampedCart<T: Scalar> {
    pub(crate) cart: T,
    pub(crate) bob: T,
    pub(crate) l: T,
    pub(crate) g: T,
    pub(crate) stiffness: T,
    pub(crate) drag: T,
    pub(crate) friction: T,
    pub(crate) rate: T,
    #[lagrangian(input)]
    pub(crate) motor: T,
}

/// Rotors each of which is geared to all others: its mass matrix is factored numerically.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    coordinates(a, b, c, d, e, f),
    define(
        turning = dot(a).powi(2) + dot(b).powi(2) + dot(c).powi(2) + dot(d).powi(2) + dot(e).powi(2)
            + dot(f).powi(2),
        geared = dot(a) * (dot(b) * cos(a - b) + dot(c) * sin(a) + dot(d) * c + dot(e) * cos(e) + dot(f))
            + dot(b) * (dot(c) * cos(b) + dot(d) + dot(e) * sin(d) + dot(f) * cos(a + f))
            + dot(c) * (dot(d) * sin(c + d) + dot(e) * cos(c) + dot(f) * sin(f))
            + dot(d) * (dot(e) * cos(d - e) + dot(f) * sin(b))
            + dot(e) * dot(f) * cos(e * f),
    ),
    kinetic = 0.5 * inertia * turning + coupling * geared,
    potential = stiffness * (cos(a - b) + cos(c - d) + cos(e - f) + sin(b * c)),
)]
pub(crate) struct Gearbox<T: Scalar> {
    pub(crate) inertia: T,
    pub(crate) coupling: T,
    pub(crate) stiffness: T,
}

/// Two coordinates whose mass matrix ((own, common), (common, own)) may be indefinite.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    coordinates(x, y),
    lagrangian = 0.5 * own * (dot(x).powi(2) + dot(y).powi(2)) + common * dot(x) * dot(y)
        - 0.5 * stiffness * (x.powi(2) + 2.0 * y.powi(2)) + twist * x * dot(y) * y,
)]
pub(crate) struct Joined<T: Scalar> {
    pub(crate) own: T,
    pub(crate) common: T,
    pub(crate) stiffness: T,
    pub(crate) twist: T,
}

/// A number between two others, given by an index, that is exact in single precision.
pub(crate) fn between(least: f64, most: f64, index: usize) -> f64 {
    // The golden section spreads them evenly.
    let spread = f64::from(u32::try_from(index).expect("few numbers")) * 0.618_033_988_749_895;
    let fraction = (spread.fract() * 1024.0).round() / 1024.0;
    least + (most - least) * fraction
}

/// A state whose entries are moderate, given by an index.
pub(crate) fn state<const N: usize>(index: usize) -> State<f64, N> {
    let entry =
        |offset: usize| array::from_fn(|i| between(-1.5, 1.5, 97 * index + 13 * i + offset));
    let mut state = State::new(between(0.0, 2.0, index), entry(1), entry(500));
    // Not at the pole of Euler angles.
    if N == 3 {
        state.q[1] = between(0.5, 2.5, index + 7);
    }
    state
}

/// The state on another scalar.
pub(crate) fn on<S: Scalar, const N: usize>(state: &State<f64, N>) -> State<S, N> {
    State::new(
        S::from_f64(state.t),
        state.q.map(S::from_f64),
        state.v.map(S::from_f64),
    )
}

/// Models that are made from as many numbers as they have parameters.
pub(crate) trait Numbered<T: Scalar, const P: usize>: Sized {
    /// The model with these parameters.
    fn with(parameters: [T; P]) -> Self;
}

macro_rules! numbered {
    ($($model:ident: $count:literal { $($field:ident),* };)*) => {$(
        impl<T: Scalar> Numbered<T, $count> for $model<T> {
            fn with([$($field),*]: [T; $count]) -> Self {
                Self { $($field),* }
            }
        }
    )*};
}

numbered! {
    HeavyTop: 6 { i1, i2, i3, m, g, l };
    DoublePendulum: 5 { m1, m2, l1, l2, g };
    BentPendulum: 5 { m1, m2, l1, l2, g };
    DampedCart: 9 { cart, bob, l, g, stiffness, drag, friction, rate, motor };
    Gearbox: 3 { inertia, coupling, stiffness };
    Joined: 4 { own, common, stiffness, twist };
}

/// Parameters, all positive, given by an index; the moments of inertia of a body, if there are six.
pub(crate) fn parameters<const P: usize>(index: usize) -> [f64; P] {
    array::from_fn(|i| between(0.75, 1.75, 31 * index + i))
}

/// The parameters of a gearbox with a positive definite mass matrix.
pub(crate) fn gearing(index: usize) -> [f64; 3] {
    [
        between(2.0, 3.0, index),
        between(0.125, 0.25, index + 3),
        between(1.0, 2.0, index + 5),
    ]
}

/// All that a model gives at a state, with names.
pub(crate) fn everything<S, M, const N: usize>(
    model: &M,
    state: &State<S, N>,
) -> Vec<(&'static str, Vec<S>)>
where
    S: Scalar,
    M: Lagrangian<N, S, Model: StateJacobian<N, S>>,
{
    let given = SVector::from_fn(|i, _| S::from_f64(between(-1.0, 1.0, i)));
    let prepared = model.dynamics().accelerations(state);
    let linearization = model.linearize(state);
    let vector = |entries: SVector<S, N>| entries.as_slice().to_vec();
    let matrix = |entries: SMatrix<S, N, N>| entries.as_slice().to_vec();
    vec![
        ("L", vec![model.lagrangian(state)]),
        ("h", vec![model.energy(state)]),
        ("p", vector(model.momenta(state))),
        ("M", matrix(model.mass_matrix(state))),
        ("f", vector(model.forcing(state))),
        ("Q", vector(model.generalized_forces(state))),
        ("qdd", vector(model.accelerations(state))),
        ("qdd, prepared", vector(prepared)),
        ("M a - f", vector(model.inverse_dynamics(state, &given))),
        ("dqdd_dq", matrix(linearization.position)),
        ("dqdd_dqd", matrix(linearization.velocity)),
        ("dqdd_dt", vector(linearization.time)),
    ]
}
