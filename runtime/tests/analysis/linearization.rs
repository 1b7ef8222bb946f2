//! A and B of the first-order system ẋ = A x + B u, against a closed form and against differences.

use lagrangian::DoubleDouble;
use lagrangian::analysis::StateSpace;
use lagrangian::prelude::*;
use nalgebra::Matrix4;

/// A cart on a rail, and on it a point mass at the end of a massless pole; θ from upright.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, theta),
    define(px = x + l * sin(theta), py = l * cos(theta)),
    kinetic = 0.5 * cart * dot(x).powi(2) + 0.5 * pole * (dot(px).powi(2) + dot(py).powi(2)),
    potential = pole * g * py,
    force(x = push - drag * dot(x), theta = torque * cos(theta)),
)]
struct CartPole<T: Scalar> {
    cart: T,
    pole: T,
    l: T,
    g: T,
    drag: T,
    #[lagrangian(input)]
    push: T,
    #[lagrangian(input)]
    torque: T,
}

fn model<T: Scalar>() -> CartPole<T> {
    let [cart, pole, l, g, drag] = [1.25, 0.5, 0.75, 9.75, 0.25].map(T::from_f64);
    let [push, torque] = [3.0, -0.5].map(T::from_f64);
    CartPole {
        cart,
        pole,
        l,
        g,
        drag,
        push,
        torque,
    }
}

#[track_caller]
fn assert_close(found: &[f64], expected: &[f64], tolerance: f64) {
    assert_eq!(found.len(), expected.len());
    for (found, expected) in found.iter().zip(expected) {
        let error = (found - expected).abs();
        assert!(error <= tolerance, "{found} is not {expected}: {error:e}");
    }
}

/// M ẍ = u − d ẋ − m g θ and l θ̈ = ((M + m) g θ − u + d ẋ)/M + (1/m + 1/M) τ/l about the upright pole;
/// without drag and torque they are those of the cart and pendulum in Ogata, *Modern Control Engineering*,
/// chapter 3.
#[test]
fn about_the_upright_pole_they_are_those_of_the_textbook() {
    let CartPole {
        cart,
        pole,
        l,
        g,
        drag,
        ..
    } = model::<f64>();
    let upright = State::new(0.0, [2.0, 0.0], [0.0, 0.0]);
    let model = model::<f64>();
    let rest = SVector::zeros();
    let a: Matrix4<f64> = model.with_inputs(rest).linearize(&upright).state_matrix();
    #[rustfmt::skip]
    let expected = Matrix4::new(
        0.0, 0.0, 1.0, 0.0,
        0.0, 0.0, 0.0, 1.0,
        0.0, -pole * g / cart, -drag / cart, 0.0,
        0.0, (cart + pole) * g / (cart * l), drag / (cart * l), 0.0,
    );
    assert_close(a.as_slice(), expected.as_slice(), 1e-14);
    let b = StateSpace::<f64, 4, 2, 4>::of(&model.with_inputs(rest), &upright).b;
    let turned = (1.0 / cart + 1.0 / pole) / (l * l);
    let expected = [
        [0.0, 0.0, 1.0 / cart, -1.0 / (cart * l)],
        [0.0, 0.0, -1.0 / (cart * l), turned],
    ];
    assert_close(b.as_slice(), expected.as_flattened(), 1e-14);
}

/// At any state: differences of the dynamics in double-double arithmetic, where their error of about
/// h² = 1e-20 does not exceed that of rounding.
#[test]
fn they_are_the_derivatives_of_the_dynamics() {
    let h = DoubleDouble::from_f64(1e-10);
    let fine = model::<DoubleDouble>();
    let (q, v) = ([0.3, 0.8], [-1.5, 2.25]);
    let phase = Phase::new(q.map(DoubleDouble::from), v.map(DoubleDouble::from));
    let slope = |more: Phase<DoubleDouble, 2>, less: Phase<DoubleDouble, 2>| {
        let pairs = more.components().zip(less.components());
        let quotients = pairs.map(|(more, less)| ((more - less) / (h + h)).to_f64());
        quotients.collect::<Vec<_>>()
    };

    let state = State::new(0.0, q, v);
    let a = model::<f64>().linearize(&state).state_matrix::<4>();
    let dynamics = fine.dynamics();
    for j in 0..4 {
        let at = |step: DoubleDouble| {
            let mut moved = phase;
            if j < 2 {
                moved.q[j] += step;
            } else {
                moved.v[j - 2] += step;
            }
            dynamics.derivative(DoubleDouble::from(0.0), &moved)
        };
        assert_close(a.column(j).as_slice(), &slope(at(h), at(-h)), 1e-13);
    }

    let b = StateSpace::<f64, 4, 2, 4>::of(&model::<f64>(), &state).b;
    for j in 0..2 {
        let at = |step: DoubleDouble| {
            let mut inputs = fine.inputs();
            inputs[j] += step;
            let pushed = fine.with_inputs(inputs);
            pushed
                .dynamics()
                .derivative(DoubleDouble::from(0.0), &phase)
        };
        assert_close(b.column(j).as_slice(), &slope(at(h), at(-h)), 1e-13);
    }
}

/// Rows of B are numbered by velocities, columns by inputs.
#[test]
fn inputs_are_read_by_their_constants() {
    type Model = CartPole<f64>;
    assert_eq!(Model::INPUTS, ["push", "torque"]);
    assert_eq!((Model::PUSH, Model::TORQUE), (0, 1));
    let upright = State::new(0.0, [0.0, 0.0], [0.0, 0.0]);
    let b = StateSpace::<f64, 4, 2, 4>::of(&model::<f64>(), &upright).b;
    assert_close(&[b[(2 + Model::X, Model::PUSH)]], &[1.0 / 1.25], 1e-15);
}
