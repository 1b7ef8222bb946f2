//! Dual numbers, against derived derivatives and against differences.

use lagrangian::prelude::*;
use lagrangian::{DoubleDouble, Dual};

/// A pendulum on a cart, with functions of several kinds.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, theta),
    define(px = x + l * sin(theta), py = -l * cos(theta)),
    kinetic = 0.5 * cart * dot(x).powi(2) + 0.5 * bob * (dot(px).powi(2) + dot(py).powi(2)),
    potential = bob * g * py + sqrt(1.0 + x.powi(2)),
    force(x = push * exp(-0.1 * t) - tanh(dot(x)), theta = 0.01 * atan2(dot(x), 2.0)),
)]
struct HangingBob<T: Scalar> {
    cart: T,
    bob: T,
    l: T,
    g: T,
    #[lagrangian(input)]
    push: T,
}

fn hanging_bob<T: Scalar>() -> HangingBob<T> {
    let [cart, bob, l, g, push] = [1.5, 0.5, 0.75, 9.75, 2.0].map(T::from_f64);
    HangingBob {
        cart,
        bob,
        l,
        g,
        push,
    }
}

const T: f64 = 0.5;
const Q: [f64; 2] = [0.3, -0.7];
const V: [f64; 2] = [1.25, 0.6];

fn state<S: Scalar>() -> State<S, 2> {
    State::new(S::from_f64(T), Q.map(S::from_f64), V.map(S::from_f64))
}

#[track_caller]
fn assert_close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs();
    assert!(
        error <= tolerance,
        "{what}: {found} is not {expected}: {error:e}"
    );
}

#[test]
fn dual_accelerations_have_the_derivatives_of_linearize() {
    let linearization = hanging_bob::<f64>().linearize(&state());
    let jacobian = hanging_bob::<f64>().input_jacobian(&state());
    let derivatives = |model: &HangingBob<Dual>, state: &State<Dual, 2>| {
        let accelerations = model.accelerations(state);
        accelerations.map(|acceleration| acceleration.derivative[0])
    };
    let variable = |constant: Dual| Dual::variable(constant.value, 0);
    for j in 0..2 {
        let mut moved = state::<Dual>();
        moved.q[j] = variable(moved.q[j]);
        let by_position = derivatives(&hanging_bob(), &moved);
        let mut moved = state::<Dual>();
        moved.v[j] = variable(moved.v[j]);
        let by_velocity = derivatives(&hanging_bob(), &moved);
        for i in 0..2 {
            assert_close(
                "by position",
                by_position[i],
                linearization.position[(i, j)],
                1e-13,
            );
            assert_close(
                "by velocity",
                by_velocity[i],
                linearization.velocity[(i, j)],
                1e-13,
            );
        }
    }
    let mut moved = state::<Dual>();
    moved.t = variable(moved.t);
    let by_time = derivatives(&hanging_bob(), &moved);
    let mut pushed = hanging_bob::<Dual>();
    pushed.push = variable(pushed.push);
    let by_input = derivatives(&pushed, &state());
    for i in 0..2 {
        assert_close("by time", by_time[i], linearization.time[i], 1e-13);
        assert_close("by input", by_input[i], jacobian[i], 1e-13);
    }
}

#[test]
fn a_gradient_is_as_many_derivatives_at_once() {
    let mut moved = state::<Dual<f64, 4>>();
    for j in 0..2 {
        moved.q[j] = Dual::variable(Q[j], j);
        moved.v[j] = Dual::variable(V[j], 2 + j);
    }
    let linearization = hanging_bob::<f64>().linearize(&state());
    let accelerations = hanging_bob::<Dual<f64, 4>>().accelerations(&moved);
    for i in 0..2 {
        let gradient = accelerations[i].derivative;
        for j in 0..2 {
            assert_close(
                "by position",
                gradient[j],
                linearization.position[(i, j)],
                1e-13,
            );
            assert_close(
                "by velocity",
                gradient[2 + j],
                linearization.velocity[(i, j)],
                1e-13,
            );
        }
    }
}

/// Mᵢⱼ = ∂²L/∂q̇ᵢ∂q̇ⱼ, all at once.
#[test]
fn the_mass_matrix_is_the_hessian_of_the_lagrangian() {
    type Twice = Dual<Dual<f64, 2>, 2>;
    let mass = hanging_bob::<f64>().mass_matrix(&state());
    let mut moved = state::<Twice>();
    moved.v = Dual::variables(Dual::variables(V)).into();
    let found = hanging_bob::<Twice>().lagrangian(&moved).derivative;
    for i in 0..2 {
        for j in 0..2 {
            assert_close("mass", found[i].derivative[j], mass[(i, j)], 1e-14);
        }
    }
}

/// Second derivatives of the accelerations, against differences of the first ones.
#[test]
fn nested_duals_have_the_second_derivatives_of_accelerations() {
    type Twice = Dual<Dual<f64, 4>, 4>;
    let x = [Q[0], Q[1], V[0], V[1]];
    let at = |[x, theta, u, omega]: [f64; 4]| {
        let linearization = hanging_bob().linearize(&State::new(T, [x, theta], [u, omega]));
        move |i: usize, j: usize| match j.checked_sub(2) {
            None => linearization.position[(i, j)],
            Some(j) => linearization.velocity[(i, j)],
        }
    };
    let [p, theta, u, omega] = Twice::variables(Dual::variables(x));
    let state = State::new(Twice::from_f64(T), [p, theta], [u, omega]);
    let found = hanging_bob::<Twice>().accelerations(&state);
    let step = 1e-3;
    for k in 0..4 {
        let moved = |parts: f64| {
            let mut moved = x;
            moved[k] += parts * step;
            at(moved)
        };
        let [one, two, back, far_back] = [1.0, 2.0, -1.0, -2.0].map(moved);
        for i in 0..2 {
            for j in 0..4 {
                let near = 8.0 * (one(i, j) - back(i, j));
                let expected = (near - (two(i, j) - far_back(i, j))) / (12.0 * step);
                let second = found[i].derivative[j].derivative[k];
                assert_close("a second derivative", second, expected, 1e-8);
            }
        }
    }
}

/// The sensitivity of a motion to a parameter, against the difference of two motions in double-double arithmetic.
#[test]
fn a_dual_integration_has_the_sensitivity() -> Result<(), IntegrationError> {
    fn end<S: Scalar>(bob: S) -> Result<SVector<S, 2>, IntegrationError> {
        let model = HangingBob {
            bob,
            ..hanging_bob()
        };
        let method = RungeKutta::classical(0.02);
        let end = Problem::new(&model, state()).solve(T + 1.0, method)?;
        Ok(end.q)
    }
    let h = DoubleDouble::from(1e-10);
    let (more, less) = (
        end(DoubleDouble::from(0.5) + h)?,
        end(DoubleDouble::from(0.5) - h)?,
    );
    let found = end(Dual::new(0.5, [1.0]))?;
    for i in 0..2 {
        let expected = ((more[i] - less[i]) / (h + h)).to_f64();
        assert_close("bob", found[i].derivative[0], expected, 1e-13);
    }
    Ok(())
}

/// The functions of the declaration language, of one number and of two.
fn functions<S: Scalar>(x: S) -> Vec<(&'static str, S)> {
    let two = S::from_f64(2.0);
    let half = S::from_f64(0.5);
    vec![
        ("sin", x.sin()),
        ("cos", x.cos()),
        ("sin of both", x.sin_cos().0),
        ("cos of both", x.sin_cos().1),
        ("tan", x.tan()),
        ("asin", x.asin()),
        ("acos", x.acos()),
        ("atan", x.atan()),
        ("sinh", x.sinh()),
        ("cosh", x.cosh()),
        ("tanh", x.tanh()),
        ("asinh", x.asinh()),
        ("acosh", (x + two).acosh()),
        ("atanh", x.atanh()),
        ("exp", x.exp()),
        ("ln", (x + two).ln()),
        ("sqrt", (x + two).sqrt()),
        ("abs", (x * x).abs()),
        ("abs of a negative", (-(x * x)).abs()),
        ("signum", (x + two).signum()),
        ("atan2", x.atan2(x * x - half)),
        ("atan2 behind", (x * half).atan2(x - two)),
        ("power", (x + two).powf(half)),
        ("power of a negative", (x - two).powf(S::from_f64(3.0))),
        ("power to a variable", (x + two).powf(x * x)),
        ("min", (x * x).min(x - two)),
        ("max", (x * x).max(x - two)),
        ("quotient", x / (x * x + half)),
        ("fused", x.mul_add(x, half)),
    ]
}

#[test]
fn dual_functions_have_their_derivatives() {
    for at in [-0.75, -0.3, 0.1, 0.6] {
        let h = DoubleDouble::from(1e-9);
        let x = DoubleDouble::from(at);
        let [less, middle, more] = [x - h, x, x + h].map(functions);
        let first = functions(Dual::new(at, [1.0]));
        let gradient = functions(Dual::<f64, 2>::variable(at, 1));
        let second = functions(Dual::<Dual>::variable(Dual::variable(at, 0), 0));
        let mixed = functions(Dual::<Dual<f64, 2>, 2>::variable(Dual::variable(at, 0), 1));
        for (k, (name, value)) in middle.iter().enumerate() {
            let (less, more) = (less[k].1, more[k].1);
            let value = value.to_f64();
            let slope = ((more - less) / (h + h)).to_f64();
            let bend = ((more - middle[k].1 - (middle[k].1 - less)) / (h * h)).to_f64();
            assert_close(name, first[k].1.value, value, 1e-14);
            assert_close(name, first[k].1.derivative[0], slope, 1e-13);
            assert_close(name, gradient[k].1.derivative[1], slope, 1e-13);
            assert_close(name, gradient[k].1.derivative[0], 0.0, 0.0);
            let [by_x] = second[k].1.derivative;
            assert_close(name, by_x.value, slope, 1e-13);
            assert_close(name, by_x.derivative[0], bend, 1e-11);
            let [_, by_x] = mixed[k].1.derivative;
            assert_close(name, mixed[k].1.value.derivative[0], slope, 1e-13);
            assert_close(name, by_x.value, slope, 1e-13);
            assert_close(name, by_x.derivative[0], bend, 1e-11);
            assert_close(name, by_x.derivative[1], 0.0, 0.0);
        }
    }
}

#[test]
fn angles_and_roots_have_derivatives_on_the_axes() {
    // θ′ = (x y′ − y x′)/(x² + y²) in all directions.
    for (x, y) in [
        (0.0, 2.0),
        (0.0, -2.0),
        (3.0, 0.0),
        (-3.0, 0.0),
        (-1.0, 2.0),
        (2.0, -1.0),
    ] {
        let [of_x, of_y] = Dual::variables([x, y]);
        let angle = of_y.atan2(of_x);
        assert_close("angle", angle.value, y.atan2(x), 0.0);
        let slopes = angle.derivative;
        assert_close("slope", slopes[0], -y / (x * x + y * y), 1e-16);
        assert_close("slope", slopes[1], x / (x * x + y * y), 1e-16);
        // Twice along x: θ″ = 2 x y/(x² + y²)².
        let of_x = Dual::<Dual>::variable(Dual::variable(x, 0), 0);
        let angle = Dual::from_f64(y).atan2(of_x);
        assert_close(
            "bend",
            angle.derivative[0].derivative[0],
            2.0 * x * y / (x * x + y * y).powi(2),
            1e-16,
        );
    }
    // A root of 0 whose radicand has no derivative.
    let x = Dual::<f64, 2>::variable(0.5, 1);
    let root = (x - x).sqrt();
    let parts = root.derivative_part(0) + root.derivative_part(1);
    assert_close("root", parts + root.value, 0.0, 0.0);
    let root = Dual::<Dual>::from_f64(0.0).sqrt();
    assert!(root.derivative[0].derivative[0].abs() <= 0.0);
    let root = Dual::<f64, 2>::variable(4.0, 0).sqrt();
    assert_close("root", root.derivative_part(0), 0.25, 0.0);
}

#[test]
fn powers_of_dual_numbers_have_their_slopes_at_zero() {
    for (n, expected) in [
        (0.0, [1.0, 0.0, 0.0]),
        (1.0, [0.0, 1.0, 0.0]),
        (2.0, [0.0, 0.0, 2.0]),
        (2.5, [0.0, 0.0, 0.0]),
        (3.0, [0.0, 0.0, 0.0]),
    ] {
        let base = Dual::<Dual>::variable(Dual::variable(0.0, 0), 0);
        let power = base.powf(Dual::from_f64(n));
        let [slope] = power.derivative;
        let found = [power.value.value, slope.value, slope.derivative[0]];
        assert_eq!(
            found.map(f64::to_bits),
            expected.map(f64::to_bits),
            "{n}: {found:?}"
        );
    }
}
