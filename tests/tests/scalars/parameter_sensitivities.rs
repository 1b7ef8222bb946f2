//! The derivatives of accelerations by parameters, against dual numbers and against differences of double-doubles.

use lagrangian::prelude::*;
use lagrangian_tests::{DoubleDouble, Dual, Random, assert_close};

/// A double pendulum on a cart, with friction and an input; all of its parameters are of one scalar.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(x, theta[2]),
    define(
        p[0] = [x, 0.0] + l[0] * [sin(theta[0]), -cos(theta[0])],
        p[1] = p[0] + l[1] * [sin(theta[1]), -cos(theta[1])],
    ),
    kinetic = 0.5 * cart * dot(x).powi(2) + (0..2).map(|i| 0.5 * m[i] * dot(p[i]).norm_squared()).sum(),
    potential = (0..2).map(|i| m[i] * g * p[i].y).sum() + 0.5 * k * (x - a * sin(w * t)).powi(2),
    dissipation = 0.5 * d * dot(x).powi(2),
    force(x = gain * push),
    sensitivities,
)]
struct DoublePendulum<T: Scalar> {
    cart: T,
    m: [T; 2],
    l: [T; 2],
    g: T,
    k: T,
    a: T,
    w: T,
    d: T,
    gain: T,
    #[lagrangian(input)]
    push: T,
}

/// A body whose inertia is a matrix: only some parameters, in the order in which they are named.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), w = angular_velocity(r)),
    kinetic = 0.5 * w.dot(inertia * w),
    potential = m * g * (r * center).z,
    sensitivities(center, inertia),
)]
struct Body<T: Scalar> {
    inertia: Matrix3<T>,
    center: Vector3<T>,
    m: T,
    g: T,
}

/// Eight coordinates that are all coupled: M is factored numerically.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(q[8]),
    kinetic = 0.5 * (0..8).map(|i| m[i] * dot(q[i]).powi(2)).sum()
        + 0.5 * (0..8).map(|i| (0..8).map(|j| c * cos(q[i] - q[j]) * sin(q[i]) * dot(q[i]) * dot(q[j])).sum()).sum(),
    potential = (0..8).map(|i| k * q[i].powi(2)).sum(),
    sensitivities,
)]
struct Coupled<T: Scalar> {
    m: [T; 8],
    c: T,
    k: T,
}

fn pendulum<T: Scalar>(values: [T; 12]) -> DoublePendulum<T> {
    let [cart, m0, m1, l0, l1, g, k, a, w, d, gain, push] = values;
    let (m, l) = ([m0, m1], [l0, l1]);
    DoublePendulum {
        cart,
        m,
        l,
        g,
        k,
        a,
        w,
        d,
        gain,
        push,
    }
}

fn body<T: Scalar>(values: [T; 14]) -> Body<T> {
    Body {
        center: Vector3::new(values[0], values[1], values[2]),
        inertia: Matrix3::from_fn(|i, j| values[3 + i + 3 * j]),
        m: values[12],
        g: values[13],
    }
}

fn coupled<T: Scalar>(values: [T; 10]) -> Coupled<T> {
    Coupled {
        m: std::array::from_fn(|i| values[i]),
        c: values[8],
        k: values[9],
    }
}

fn on<S: Scalar, const N: usize>(state: &State<f64, N>) -> State<S, N> {
    State::new(
        S::from_f64(state.t),
        state.q.map(S::from_f64),
        state.v.map(S::from_f64),
    )
}

/// Compares the columns with the derivatives of q̈ by the first `P` of some parameters, on dual numbers and by differences.
fn compare<const N: usize, const P: usize, const K: usize>(
    found: &SMatrix<f64, N, P>,
    values: [f64; K],
    dual: impl Fn([Dual; K]) -> SVector<Dual, N>,
    fine: impl Fn([DoubleDouble; K]) -> SVector<DoubleDouble, N>,
) {
    let scale = found.amax();
    for j in 0..P {
        let moved = std::array::from_fn(|i| Dual::new(values[i], f64::from(u8::from(i == j))));
        let expected = dual(moved).map(Dual::derivative);
        let h = DoubleDouble::from_f64(1e-10);
        let beside = |offset: DoubleDouble| {
            let mut values = values.map(DoubleDouble::from_f64);
            values[j] += offset;
            fine(values)
        };
        let quotients = (beside(h) - beside(-h)).map(|x| (x / (h + h)).to_f64());
        for (column, source) in [(expected, "dual numbers"), (quotients, "differences")] {
            let error = (found.column(j) - column).amax();
            assert!(
                error < 1e-11 * scale,
                "{j} {source}: {error:e} of {scale:e}"
            );
        }
    }
}

#[test]
fn the_derivatives_are_those_of_dual_numbers_and_of_differences() {
    let mut random = Random::default();
    for _ in 0..10 {
        let state: State<f64, 3> = random.state();
        let mut values = random.array(0.5, 2.0);
        let found: SMatrix<f64, 3, 11> = pendulum::<f64>(values).sensitivities(&state);
        let dual = |values| pendulum::<Dual>(values).accelerations(&on(&state));
        let fine = |values| pendulum::<DoubleDouble>(values).accelerations(&on(&state));
        compare(&found, values, dual, fine);
        // Under an input that is given.
        values[11] = -3.0;
        let given = pendulum::<f64>(random.array(0.5, 2.0));
        let same = DoublePendulum {
            push: -3.0,
            ..given.clone()
        }
        .sensitivities(&state);
        assert_eq!(given.with_inputs([-3.0]).sensitivities(&state), same);

        // The three moments about the axes are large enough for any products of inertia.
        let mut values = random.array(-0.3, 0.3);
        for diagonal in [3, 7, 11] {
            values[diagonal] += 3.0;
        }
        (values[12], values[13]) = (1.5, 9.81);
        let found: SMatrix<f64, 3, 12> = body::<f64>(values).sensitivities(&state);
        let dual = |values| body::<Dual>(values).accelerations(&on(&state));
        let fine = |values| body::<DoubleDouble>(values).accelerations(&on(&state));
        compare(&found, values, dual, fine);

        let state: State<f64, 8> = random.state();
        let mut values = random.array(8.0, 12.0);
        values[8] = 0.1;
        let found: SMatrix<f64, 8, 10> = coupled::<f64>(values).sensitivities(&state);
        let dual = |values| coupled::<Dual>(values).accelerations(&on(&state));
        let fine = |values| coupled::<DoubleDouble>(values).accelerations(&on(&state));
        compare(&found, values, dual, fine);
    }
}

#[test]
fn columns_have_the_names_of_their_parameters() {
    let names = DoublePendulum::<f64>::PARAMETERS;
    let expected = [
        "cart", "m[0]", "m[1]", "l[0]", "l[1]", "g", "k", "a", "w", "d", "gain",
    ];
    assert_eq!(names, expected);
    let names = Body::<f64>::PARAMETERS;
    assert_eq!(
        names[..4],
        ["center[0]", "center[1]", "center[2]", "inertia[(0, 0)]"]
    );
    assert_eq!(names.len(), 12);
}

/// A parameter without effect has a column of zeros, and m of a pendulum has none on its swing.
#[test]
fn what_has_no_effect_has_a_derivative_of_zero() {
    #[derive(Lagrangian)]
    #[lagrangian(
        coordinates(theta),
        kinetic = 0.5 * m * (l * dot(theta)).powi(2),
        potential = -m * g * l * cos(theta) + spare,
        sensitivities(m, l, spare),
    )]
    struct Pendulum {
        m: f64,
        l: f64,
        g: f64,
        spare: f64,
    }
    let pendulum = Pendulum {
        m: 1.3,
        l: 0.7,
        g: 9.81,
        spare: 2.0,
    };
    let found = pendulum.sensitivities(&State::new(0.0, [0.4], [1.0]));
    let by_length = 9.81 / 0.49 * 0.4_f64.sin();
    assert_close(
        "derivatives",
        found.as_slice(),
        &[0.0, by_length, 0.0],
        1e-15,
    );
}
