//! Small oscillations, modes and stability, against closed forms.

use crate::common::assert_close;
use lagrangian::DoubleDouble;
use lagrangian::analysis::{
    LinearStability, NormalModes, OscillationError, SecondVariation, SmallOscillations, Verdict,
};
use lagrangian::prelude::*;

fn rest<const N: usize>(q: [f64; N]) -> State<f64, N> {
    State::new(0.0, q, [0.0; N])
}

/// Equal masses on equal massless rods.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta[3]),
    define(
        p[0] = l * [sin(theta[0]), -cos(theta[0])],
        p[i] = p[i - 1] + l * [sin(theta[i]), -cos(theta[i])] for i in 1..3,
    ),
    kinetic = (0..3).map(|i| 0.5 * m * dot(p[i]).norm_squared()).sum(),
    potential = (0..3).map(|i| m * g * p[i].y).sum(),
)]
struct TriplePendulum {
    m: f64,
    l: f64,
    g: f64,
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a, b),
    define(
        p = l * [sin(a), -cos(a)],
        q = p + l * [sin(b), -cos(b)],
    ),
    kinetic = 0.5 * m * (dot(p).norm_squared() + dot(q).norm_squared()),
    potential = m * g * (p.y + q.y),
)]
struct DoublePendulum {
    m: f64,
    l: f64,
    g: f64,
}

/// ω² = (g/l)(2 ∓ √2), with the amplitudes 1 : ±√2.
#[test]
fn double_pendulum() {
    let model = DoublePendulum {
        m: 0.7,
        l: 0.4,
        g: 9.81,
    };
    let oscillations = SmallOscillations::about(&model, &rest([0.0, 0.0])).unwrap();
    let modes = oscillations.normal_modes().unwrap();
    let root = 2.0_f64.sqrt();
    for (mode, sign) in [(0, 1.0), (1, -1.0)] {
        let square = 9.81 / 0.4 * (2.0 - sign * root);
        assert_close(modes.squared_frequency(mode) / square, 1.0, 1e-14);
        let shape = modes.shape(mode);
        assert_close(shape[1] / shape[0], sign * root, 1e-13);
        assert_close(
            (shape.transpose() * oscillations.mass * shape)[0],
            1.0,
            1e-13,
        );
        assert!(shape[1] > 0.0);
    }
    assert_eq!(oscillations.stability().unwrap().verdict(), Verdict::Stable);

    // The same in 30 digits.
    let zero = DoubleDouble::from_f64(0.0);
    let state = State::new(zero, [zero; 2], [zero; 2]);
    let fine = SmallOscillations::about(&model, &state).unwrap();
    let square = fine.normal_modes().unwrap().squared_frequency(0);
    let [two, g, l] = [2.0, 9.81, 0.4].map(DoubleDouble::from_f64);
    let error = (two - two.sqrt()) * g / l / square - DoubleDouble::from_f64(1.0);
    assert_close(error.to_f64(), 0.0, 1e-29);
}

/// The roots of the Laguerre polynomial L₃, in units of g/l: D. Bernoulli's hanging chain of equal masses.
#[test]
fn triple_pendulum() {
    let model = TriplePendulum {
        m: 1.3,
        l: 0.4,
        g: 9.81,
    };
    let oscillations = SmallOscillations::about(&model, &rest([0.0; 3])).unwrap();
    let modes = oscillations.normal_modes().unwrap();
    let roots = [
        0.415_774_556_783_479_1,
        2.294_280_360_279_042,
        6.289_945_082_937_479,
    ];
    for (found, root) in modes.squared_frequencies().zip(roots) {
        assert_close(found / (root * 9.81 / 0.4), 1.0, 1e-13);
        // L₃(x) = 1 − 3 x + 3 x²/2 − x³/6.
        let x = root;
        assert_close(1.0 - 3.0 * x + 1.5 * x * x - x.powi(3) / 6.0, 0.0, 1e-13);
    }
    // As many unstable modes as links that point up.
    for (links, negative) in [([0.0, 0.0, 1.0], 1), ([1.0, 0.0, 1.0], 2), ([1.0; 3], 3)] {
        let angles = links.map(|half| half * std::f64::consts::PI);
        let oscillations = SmallOscillations::about(&model, &rest(angles)).unwrap();
        let stability = oscillations.stability().unwrap();
        let expected = SecondVariation::NotPositive { negative };
        assert_eq!(stability.second_variation, expected);
        assert_eq!(stability.verdict(), Verdict::Unstable);
        let modes = oscillations.normal_modes().unwrap();
        assert_eq!(modes.frequencies().flatten().count(), 3 - negative);
        let LinearStability::Growing { rate } = stability.linear else {
            panic!("{stability:?}");
        };
        assert_close(rate * rate / -modes.squared_frequency(0), 1.0, 1e-13);
    }
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = 0.5 * k * x.powi(2),
    dissipation = 0.5 * c * dot(x).powi(2),
)]
struct Oscillator {
    m: f64,
    k: f64,
    c: f64,
}

/// λ = −ζ ω ± ω √(ζ² − 1): under- and overdamped, critically damped, and with damping that gives energy.
#[test]
fn damping_ratios() {
    let (m, k) = (0.5, 18.0);
    let omega = 6.0;
    for ratio in [0.0, 0.05, 0.9, 3.0, -0.2, 1.0] {
        let model = Oscillator {
            m,
            k,
            c: 2.0 * ratio * m * omega,
        };
        let oscillations = SmallOscillations::about(&model, &rest([0.0])).unwrap();
        let modes = oscillations.damped_modes().unwrap();
        let stability = oscillations.stability().unwrap();
        if ratio < 1.0 {
            assert_eq!(modes.len(), 1);
            assert_close(modes[0].natural_frequency(), omega, 1e-14);
            assert_close(modes[0].damping_ratio(), ratio, 1e-15);
            assert_close(
                modes[0].eigenvalue.im,
                omega * (1.0 - ratio * ratio).sqrt(),
                1e-14,
            );
            assert_eq!(stability.is_passive, ratio >= 0.0);
        } else {
            assert_eq!(modes.len(), 2);
            let root = omega * (ratio * ratio - 1.0).sqrt();
            assert_close(modes[0].eigenvalue.re, root - ratio * omega, 1e-13);
            assert_close(modes[1].eigenvalue.re, -root - ratio * omega, 1e-13);
            assert_close(modes[1].damping_ratio(), 1.0, 0.0);
        }
        let verdict = match ratio {
            0.0 => Verdict::Stable,
            ratio if ratio < 0.0 => Verdict::Unstable,
            _ => Verdict::AsymptoticallyStable,
        };
        assert_eq!(stability.verdict(), verdict);
    }
}

/// Each mode is a solution of δq̈ = ∂q̈/∂q δq + ∂q̈/∂q̇ δq̇, where neither damping nor stiffness has real modes.
#[test]
fn complex_modes() {
    #[derive(Lagrangian)]
    #[lagrangian(
        coordinates(x[3]),
        kinetic = (0..3).map(|i| 0.5 * m[i] * dot(x[i]).powi(2)).sum(),
        potential = 0.5 * k * (x[0].powi(2) + (x[1] - x[0]).powi(2) + (x[2] - x[1]).powi(2)),
        dissipation = 0.5 * c[0] * dot(x[0]).powi(2) + 0.5 * c[1] * (dot(x[2]) - dot(x[1])).powi(2),
        force(x[0] = -turn * dot(x[2]), x[2] = turn * dot(x[0])),
    )]
    struct Chain {
        m: [f64; 3],
        k: f64,
        c: [f64; 2],
        turn: f64,
    }
    let model = Chain {
        m: [1.0, 0.5, 2.0],
        k: 3.0,
        c: [0.3, 0.7],
        turn: 0.25,
    };
    let state = rest([0.0; 3]);
    let modes = SmallOscillations::about(&model, &state)
        .unwrap()
        .damped_modes()
        .unwrap();
    let slopes: Linearization<f64, 3> = model.linearize(&state);
    let complex = |matrix: SMatrix<f64, 3, 3>| matrix.map(|x| nalgebra::Complex::new(x, 0.0));
    assert_eq!(modes.len(), 3);
    for mode in modes.iter() {
        let (k, shape) = (mode.eigenvalue, mode.shape);
        let slope = complex(slopes.position) * shape + complex(slopes.velocity) * shape * k;
        let left = slope - shape * k * k;
        assert!(left.iter().all(|x| x.norm_sqr() < 1e-26), "{left}");
        assert!(shape.iter().any(|x| *x == nalgebra::Complex::new(1.0, 0.0)));
        assert!(k.re < 0.0 && k.im > 0.0);
    }
    assert!(modes[0].natural_frequency() < modes[1].natural_frequency());
}

#[test]
fn equal_modes_are_independent() {
    #[derive(Lagrangian)]
    #[lagrangian(
        coordinates(x[3]),
        kinetic = 0.5 * dot(vector(x)).norm_squared(),
        potential = 2 * vector(x).norm_squared(),
        dissipation = 0.1 * dot(vector(x)).norm_squared(),
    )]
    struct Alike {}
    let state = rest([0.0; 3]);
    let modes = SmallOscillations::about(&Alike {}, &state)
        .unwrap()
        .damped_modes()
        .unwrap();
    let shapes: Matrix3<nalgebra::Complex<f64>> =
        Matrix3::from_columns(&[modes[0].shape, modes[1].shape, modes[2].shape]);
    let determinant: nalgebra::Complex<f64> = shapes.determinant();
    assert!(determinant.norm_sqr() > 1e-2, "{shapes}");
}

/// A pendulum on a cart on a rail, with and without drag on the cart: its momentum is constant only without.
#[test]
fn ignorable_coordinate_with_friction() {
    #[derive(Lagrangian)]
    #[lagrangian(
        coordinates(x, theta),
        define(px = x + l * sin(theta), py = -l * cos(theta)),
        kinetic = 0.5 * cart * dot(x).powi(2) + 0.5 * bob * (dot(px).powi(2) + dot(py).powi(2)),
        potential = bob * g * py,
        force(x = -drag * dot(x)),
    )]
    struct CartPole {
        cart: f64,
        bob: f64,
        l: f64,
        g: f64,
        drag: f64,
    }
    let model = |drag| CartPole {
        cart: 2.0,
        bob: 0.5,
        l: 0.4,
        g: 9.81,
        drag,
    };
    let free = SmallOscillations::about(&model(0.0), &rest([0.3, 0.0])).unwrap();
    let square = free.normal_modes().unwrap().squared_frequency(0);
    assert_close(square / (9.81 / 0.4 * 1.25), 1.0, 1e-14);
    assert_eq!(free.stability().unwrap().verdict(), Verdict::Stable);
    let slowed = SmallOscillations::about(&model(0.8), &rest([0.3, 0.0])).unwrap();
    let spectrum = slowed.spectrum().unwrap();
    assert_eq!(spectrum.len(), 3);
    // M l λ³ + d l λ² + (M + m) g λ + d g = 0.
    for value in spectrum.iter() {
        let k = *value;
        let left = k * k * k * 0.8 + k * k * 0.8 * 0.4 + k * 2.5 * 9.81 + 0.8 * 9.81;
        assert!(left.norm_sqr().sqrt() < 1e-12, "{left}");
    }
    let stability = slowed.stability().unwrap();
    assert_eq!(stability.second_variation, SecondVariation::NoPotential);
    assert_eq!(stability.verdict(), Verdict::AsymptoticallyStable);
    let error = slowed.normal_modes().unwrap_err();
    assert!(
        matches!(error, OscillationError::VelocityForces { .. }),
        "{error}"
    );
}

#[test]
fn what_has_no_small_oscillations() {
    let model = DoublePendulum {
        m: 0.7,
        l: 0.4,
        g: 9.81,
    };
    let text = |state: State<f64, 2>| {
        SmallOscillations::about(&model, &state)
            .unwrap_err()
            .to_string()
    };
    assert!(
        text(rest([0.3, 0.0]))
            .starts_with("the state is no equilibrium: `a` has the acceleration -")
    );
    let moving = State::new(0.0, [0.0, 0.0], [0.0, 0.5]);
    assert_eq!(
        text(moving),
        "the motion is not steady: `b`, which is not ignorable, has the velocity 0.5"
    );
    let [mass, stiffness] = [[1.0, 2.0, 2.0, 1.0], [1.0, 0.5, -0.5, 2.0]]
        .map(|entries: [f64; 4]| Matrix2::from_row_slice(&entries));
    let error = NormalModes::of(&mass, &mass).unwrap_err();
    assert_eq!(
        error,
        OscillationError::NoPositiveMass {
            coordinate: 1,
            pivot: -3.0
        }
    );
    let error = NormalModes::of(&Matrix2::identity(), &stiffness).unwrap_err();
    assert_eq!(error, OscillationError::NotConservative { asymmetry: 1.0 });
}

/// Critical damping beside two oscillators: λ = −1 is double and has one shape.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x[3]),
    kinetic = 0.5 * (dot(x[0]).powi(2) + dot(x[1]).powi(2) + dot(x[2]).powi(2)),
    potential = 0.5 * (x[0].powi(2) + x[1].powi(2) + x[2].powi(2)),
    dissipation = c * dot(x[0]).powi(2),
)]
struct CriticallyDamped {
    c: f64,
}

#[test]
fn a_double_eigenvalue_may_have_one_shape() {
    let model = CriticallyDamped { c: 1.0 };
    let oscillations = SmallOscillations::about(&model, &rest([0.0; 3])).unwrap();
    let modes = oscillations.damped_modes().unwrap();
    assert_eq!(modes.len(), 4);
    let mut turning = Vec::new();
    for mode in modes.iter() {
        // λ² φ + 2 c λ φ₀ e₀ + φ = 0.
        let left = mode
            .shape
            .map(|x| x * (mode.eigenvalue * mode.eigenvalue + 1.0));
        let damping = mode.eigenvalue * mode.shape[0] * 2.0;
        for (i, left) in left.iter().enumerate() {
            let left = if i == 0 { left + damping } else { *left };
            assert!(left.norm() < 1e-7, "{mode:?}");
        }
        if mode.eigenvalue.im > 0.5 {
            turning.push(mode.shape);
        }
    }
    // Those of ±i are two that differ.
    let [first, second] = [turning[0], turning[1]];
    assert_close(first.dotc(&second).norm(), 0.0, 1e-12);
}

/// Masses that nothing holds, between springs and dampers.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x[4]),
    kinetic = (0..4).map(|i| 0.5 * m[i] * dot(x[i]).powi(2)).sum(),
    potential = (0..3).map(|i| 0.5 * k[i] * (x[i + 1] - x[i]).powi(2)).sum(),
    dissipation = (0..3).map(|i| 0.5 * c * (dot(x[i + 1]) - dot(x[i])).powi(2)).sum(),
)]
struct FreeChain {
    m: [f64; 4],
    k: [f64; 3],
    c: f64,
}

#[test]
fn rigid_motions_have_the_frequency_zero() {
    for (m, k) in [
        ([1.0; 4], [1.0; 3]),
        ([0.3, 1.7, 2.9, 0.7], [1.3e3, 0.7e3, 2.1e3]),
    ] {
        let model = FreeChain { m, k, c: 0.0 };
        let oscillations = SmallOscillations::about(&model, &rest([0.0; 4])).unwrap();
        let modes = oscillations.normal_modes().unwrap();
        assert!(modes.squared_frequency(0).abs() <= 0.0);
        assert!(modes.squared_frequency(1) > 0.1);
        for c in [0.0, 0.5] {
            let model = FreeChain { m, k, c };
            let oscillations = SmallOscillations::about(&model, &rest([0.0; 4])).unwrap();
            let modes = oscillations.damped_modes().unwrap();
            for mode in &modes[..2] {
                assert!(mode.natural_frequency() <= 0.0);
                for x in mode.shape.iter() {
                    assert!((x - 1.0).norm() < 1e-9, "{mode:?}");
                }
            }
            assert!(modes[2].natural_frequency() > 0.1);
        }
    }
    // A soft spring beside a hard one is none.
    let stiffness = nalgebra::Matrix2::new(1e15, 0.0, 0.0, 1.0);
    let modes = NormalModes::of(&nalgebra::Matrix2::identity(), &stiffness).unwrap();
    assert!((modes.squared_frequency(0) - 1.0).abs() < 1e-15);
}
