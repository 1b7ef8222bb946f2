//! State-transition matrices: against closed forms, differences in double-doubles, and their symplecticity.

use lagrangian::prelude::*;
use lagrangian::{DoubleDouble, Dual, Lanes, StateTransition};
use nalgebra::{Matrix4, SVector, Vector4};

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = 0.5 * k * x.powi(2) - load * x,
)]
struct Oscillator<T: Scalar> {
    m: T,
    k: T,
    load: T,
}

/// The Kepler problem in the plane.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = -strength / sqrt(x.powi(2) + y.powi(2)),
)]
struct Kepler<T: Scalar> {
    strength: T,
}

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(alpha, beta),
    define(
        p = [sin(alpha), -cos(alpha)],
        r = p + l * [sin(beta), -cos(beta)],
    ),
    kinetic = 0.5 * (dot(p).norm_squared() + m * dot(r).norm_squared()),
    potential = 9.81 * (p.y + m * r.y),
)]
struct DoublePendulum<T: Scalar> {
    m: T,
    l: T,
}

fn oscillator() -> Oscillator<Dual<f64, 5>> {
    Oscillator {
        m: Dual::variable(1.0, 2),
        k: Dual::variable(4.0, 3),
        load: Dual::variable(0.0, 4),
    }
}

/// At the equilibrium the values rest for ever, and their derivatives do not.
#[test]
fn derivatives_where_the_values_rest() {
    let model = oscillator();
    let rest = State::new(0.0, [0.0], [0.0]);
    let (sine, cosine) = 100.0_f64.sin_cos();
    for method in [
        Taylor::new(),
        Taylor::new().relative_tolerance(1e-15),
        Taylor::new().absolute_tolerance(1e-15),
    ] {
        let transition = StateTransition::over(&method, &model.dynamics(), &rest, 50.0).unwrap();
        assert_eq!(transition.state.q[0].to_bits(), 0.0_f64.to_bits());
        let found = transition.matrix::<2>();
        let expected = Matrix2::new(cosine, 0.5 * sine, -2.0 * sine, cosine);
        assert!((found - expected).amax() < 1e-12, "{found} {expected}");
        let by_parameters = transition.by_parameters::<3>();
        assert!(by_parameters.q[0].abs() + by_parameters.q[1].abs() <= 0.0);
        // x = load (1 − cos ωt)/k.
        assert!((by_parameters.q[2] - (1.0 - cosine) / 4.0).abs() < 1e-12);
        assert!((by_parameters.v[2] - sine / 2.0).abs() < 1e-12);
    }
}

/// The same by Dormand and Prince's method, with a tolerance of each kind.
#[test]
fn derivatives_where_the_values_rest_by_steps() {
    let model = oscillator();
    let rest = State::new(0.0, [0.0], [0.0]);
    let (sine, cosine) = 20.0_f64.sin_cos();
    let method = Dop853::new();
    for method in [
        method.relative_tolerance(1e-12).absolute_tolerance(1e-12),
        method.relative_tolerance(1e-12).absolute_tolerance(0.0),
        method.relative_tolerance(0.0).absolute_tolerance(1e-12),
    ] {
        let transition = StateTransition::over(&method, &model.dynamics(), &rest, 10.0).unwrap();
        let found = transition.matrix::<2>();
        let expected = Matrix2::new(cosine, 0.5 * sine, -2.0 * sine, cosine);
        assert!((found - expected).amax() < 1e-9, "{found} {expected}");
        let by_load = transition.by_parameters::<3>().q[2];
        assert!((by_load - (1.0 - cosine) / 4.0).abs() < 1e-9);
    }
}

/// Derivatives of very different sizes are each as accurate as they can be.
#[test]
fn derivatives_do_not_depend_on_their_units() {
    let base = 1e-200;
    let tiny = |value: f64| Dual::new(value, [base]);
    let model = Oscillator {
        m: Dual::constant(1.0),
        k: tiny(4.0),
        load: Dual::constant(0.0),
    };
    let start = State::new(
        Dual::constant(0.0),
        [Dual::constant(1.0)],
        [Dual::constant(0.0)],
    );
    let end = Problem::new(&model, start)
        .solve(10.0, Taylor::new())
        .unwrap();
    let expected = -10.0 / 4.0 * 20.0_f64.sin();
    assert!((end.q[0].derivative[0] / base - expected).abs() < 1e-12);
}

/// Over a period T = 2π a^(3/2), Φ = 1 − ẋ (∂T/∂x₀)ᵀ: the motion is periodic for all x₀, with 1/a = 2/r − v².
#[test]
fn kepler_over_a_period() {
    let model = Kepler {
        strength: Dual::<f64, 4>::constant(1.0),
    };
    let start = State::new(0.0, [0.4, 0.0], [0.0, 2.0]);
    let period = core::f64::consts::TAU;
    let rate = Vector4::new(0.0, 2.0, -1.0 / 0.16, 0.0);
    let by_axis = Vector4::new(2.0 * 0.4 / 0.4_f64.powi(3), 0.0, 0.0, 2.0 * 2.0);
    let expected = Matrix4::identity() - rate * (1.5 * period * by_axis).transpose();
    let dynamics = model.dynamics();
    let by_series = StateTransition::over(&Taylor::new(), &dynamics, &start, period);
    let explicit = Dop853::new()
        .relative_tolerance(1e-14)
        .absolute_tolerance(1e-14);
    let by_steps = StateTransition::over(&explicit, &dynamics, &start, period);
    let fixed = RungeKutta::classical(1e-3);
    let by_fixed_steps = StateTransition::over(&fixed, &dynamics, &start, period);
    // In relation to the largest element, 736, since errors are turned and stretched as perturbations are.
    for (transition, tolerance) in [
        (by_series, 1e-13),
        (by_steps, 1e-11),
        (by_fixed_steps, 1e-6),
    ] {
        let found = transition.unwrap().matrix::<4>();
        let error = (found - expected).amax() / expected.amax();
        assert!(error < tolerance, "{error:e}: {found} {expected}");
    }
}

/// Φᵀ J Φ = J, with canonical variables (q, p) where p = q̇.
#[test]
fn the_matrix_is_symplectic() {
    let model = Kepler {
        strength: Dual::<f64, 4>::constant(1.0),
    };
    let start = State::new(0.0, [1.0, 0.2], [-0.1, 0.8]);
    let transition =
        StateTransition::over(&Taylor::new(), &model.dynamics(), &start, 30.0).unwrap();
    let matrix = transition.matrix::<4>();
    let mut symplectic = Matrix4::zeros();
    for i in 0..2 {
        symplectic[(i, i + 2)] = 1.0;
        symplectic[(i + 2, i)] = -1.0;
    }
    let defect = matrix.transpose() * symplectic * matrix - symplectic;
    assert!(matrix.amax() > 10.0);
    assert!(defect.amax() < 1e-11 * matrix.amax(), "{defect}");
}

/// Differences of motions in double-doubles, by initial values and parameters.
#[test]
fn differences_confirm_all_columns() {
    let model = DoublePendulum {
        m: Dual::<f64, 6>::variable(0.5, 4),
        l: Dual::variable(0.7, 5),
    };
    let values = [0.4, 1.2, 0.1, -0.3, 0.5, 0.7];
    let start = State::new(0.0, [values[0], values[1]], [values[2], values[3]]);
    let transition = StateTransition::over(&Taylor::new(), &model.dynamics(), &start, 2.0).unwrap();
    let moved = |index: usize, by: f64| {
        let mut values = values.map(DoubleDouble::from_f64);
        values[index] += DoubleDouble::from_f64(by);
        let [alpha, beta, v, w, m, l] = values;
        let start = State::new(
            DoubleDouble::from_f64(0.0),
            SVector::from([alpha, beta]),
            SVector::from([v, w]),
        );
        let model = DoublePendulum { m, l };
        let end = Problem::new(&model, start).solve(2.0, Taylor::order_40());
        end.unwrap().last
    };
    let step = 2.0_f64.powi(-36);
    for j in 0..6 {
        let (after, before) = (moved(j, step), moved(j, -step));
        for i in 0..2 {
            let by_q = (after.q[i] - before.q[i]).to_f64() / (2.0 * step);
            let by_v = (after.v[i] - before.v[i]).to_f64() / (2.0 * step);
            let size = transition.v.amax();
            assert!(
                (transition.q[(i, j)] - by_q).abs() < 1e-12 * size,
                "{i} {j}"
            );
            assert!(
                (transition.v[(i, j)] - by_v).abs() < 1e-12 * size,
                "{i} {j}"
            );
        }
    }
}

#[test]
fn samples_have_transitions_too() {
    let model = oscillator();
    let start = State::new(1.0, [0.5], [0.25]);
    let times = [1.0, 1.5, 4.0];
    let motion = Problem::new(&model, StateTransition::<1, 5>::initial(&start))
        .save(times)
        .solve(4.0, Taylor::new())
        .unwrap();
    for (sample, t) in motion.samples().iter().zip(times) {
        assert_eq!(sample.t, Dual::constant(t));
        let matrix = StateTransition::of(sample).matrix::<2>();
        let (sine, cosine) = (2.0 * (t - 1.0)).sin_cos();
        let expected = Matrix2::new(cosine, 0.5 * sine, -2.0 * sine, cosine);
        assert!((matrix - expected).amax() < 1e-14);
    }
}

/// Plain numbers have no derivative parts, and dual ones as many as they say.
#[test]
fn derivative_parts() {
    fn parts<S: Scalar>(number: S) -> Vec<f64> {
        (0..=S::DERIVATIVES)
            .map(|index| number.derivative_part(index))
            .collect()
    }
    assert_eq!(parts(3.0), [0.0]);
    assert_eq!(parts(Lanes([1.0, 2.0])), [0.0]);
    assert_eq!(parts(Dual::new(1.0, [2.0])), [2.0, 0.0]);
    let gradient = Dual::<f64, 2>::variable(1.0, 1);
    assert_eq!(parts(gradient), [0.0, 1.0, 0.0]);
    // Those of the value first, then each derivative with its own.
    let nested = Dual::new(
        Dual::new(1.0, [2.0, 3.0]),
        [Dual::new(4.0, [5.0, 6.0]), Dual::new(7.0, [8.0, 9.0])],
    );
    let expected = [2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 0.0];
    assert_eq!(parts(nested), expected);
    // The largest over lanes.
    let lanes = Dual::new(Lanes([1.0, 2.0]), [Lanes([-3.0, 2.0])]);
    assert_eq!(parts(lanes), [-3.0, 0.0]);
}
