//! Verdicts on stability where rounding, widely different stiffnesses, or the time could make them wrong.

use lagrangian::analysis::{LinearStability, SmallOscillations, Stability, Verdict};
use lagrangian::prelude::*;
use lagrangian::quantities::StateJacobian;

fn stability<M: Lagrangian<N, Model: StateJacobian<N>>, const N: usize>(model: &M) -> Stability {
    let rest = State::new(0.0, [0.0; N], [0.0; N]);
    let oscillations = SmallOscillations::about(model, &rest).unwrap();
    oscillations.stability().unwrap()
}

/// A free particle in a rotating frame: ±iω are double eigenvalues with Jordan blocks, and it drifts away like t.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * ((dot(x) - w * y).powi(2) + (dot(y) + w * x).powi(2)),
)]
struct RotatingFrame {
    m: f64,
    w: f64,
}

/// A sleeping top near its axis, with the moment s of the spin.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    lagrangian = 0.5 * (dot(x).powi(2) + dot(y).powi(2)) + 0.5 * s * (x * dot(y) - y * dot(x))
        + 0.5 * k * (x * x + y * y),
)]
struct SleepingTop {
    s: f64,
    k: f64,
}

#[test]
fn defective_eigenvalues_are_undecided() {
    for w in [0.3, 0.7, 1.0, 1.3, 2.0, 10.0, 1000.0] {
        let found = stability(&RotatingFrame { m: 1.0, w });
        assert_eq!(found.verdict(), Verdict::Undecided, "{w} {found:?}");
    }
    for k in [0.5_f64, 1.0, 2.0, 3.0, 1e6] {
        let critical = 2.0 * k.sqrt();
        let found = stability(&SleepingTop { s: critical, k });
        assert_eq!(found.verdict(), Verdict::Undecided, "{k} {found:?}");
        // λ² = (2 k − s² ± s √(s² − 4 k))/2.
        for (factor, verdict) in [(1.01, Verdict::LinearlyStable), (0.99, Verdict::Unstable)] {
            let found = stability(&SleepingTop {
                s: factor * critical,
                k,
            });
            assert_eq!(found.verdict(), verdict, "{k} {factor} {found:?}");
        }
    }
}

/// A stiff oscillator and a soft one with a force c ẏ that gives energy; `b` couples them.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = 0.5 * k * x * x + 0.5 * l * y * y + b * x * y,
    force(y = c * dot(y)),
)]
struct StiffAndSoft {
    m: f64,
    k: f64,
    l: f64,
    b: f64,
    c: f64,
}

fn stiff([k, l, b, c]: [f64; 4]) -> Stability {
    stability(&StiffAndSoft { m: 1.0, k, l, b, c })
}

#[test]
fn growth_beside_stiff_modes_is_seen() {
    for (model, rate) in [
        ([1e8, 10.0, 0.0, 1e-4], 5e-5),
        ([1e12, 4e4, 0.0, 1e-3], 5e-4),
        ([1e16, -1.0, 0.0, 0.0], 1.0),
        ([1e8, 10.0, 1.0, 1e-4], 5e-5),
        ([1e8, -1.0, 1.0, 0.0], 1.0),
    ] {
        let found = stiff(model);
        assert_eq!(found.verdict(), Verdict::Unstable, "{model:?} {found:?}");
        assert_eq!(found.is_passive, model[3] <= 0.0, "{model:?} {found:?}");
        let LinearStability::Growing { rate: growing } = found.linear else {
            panic!("{found:?}");
        };
        assert!((growing / rate - 1.0).abs() < 1e-6, "{model:?} {growing}");
    }
    for model in [[1e8, 10.0, 0.0, 0.0], [1e8, 10.0, 1.0, 0.0]] {
        assert_eq!(stiff(model).verdict(), Verdict::Stable, "{model:?}");
    }
    // Damping of the soft one alone.
    let damped = stiff([1e8, 10.0, 0.0, -1e-4]);
    assert_eq!(damped.verdict(), Verdict::Stable);
    assert!(damped.is_passive);
    // Growth that no digits show.
    let least = stiff([1e8, 10.0, 1.0, 1e-14]);
    assert!(!least.is_passive && !least.is_stable(), "{least:?}");
}

/// An oscillator whose stiffness k + p cos ωt, and the force on which, are functions of time.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = 0.5 * (k + p * cos(w * t)) * x * x,
    force(x = f * sin(w * t)),
)]
struct Mathieu {
    m: f64,
    k: f64,
    p: f64,
    w: f64,
    f: f64,
}

/// Mathieu's equation is unstable at ω = 2 √(k/m), though the potential has a minimum at all times.
#[test]
fn driven_models_are_undecided() {
    let mut model = Mathieu {
        m: 1.0,
        k: 1.0,
        p: 0.0,
        w: 2.0,
        f: 0.0,
    };
    assert_eq!(stability(&model).verdict(), Verdict::Stable);
    model.p = 0.4;
    let found = stability(&model);
    assert!(found.contains_time, "{found:?}");
    assert_eq!(found.verdict(), Verdict::Undecided);
    let start = State::new(0.0, [1e-6], [0.0]);
    let end = Problem::new(&model, start).solve(100.0, Dop853::new());
    assert!(end.unwrap().q[0].abs() > 1e-3);
    (model.p, model.f) = (0.0, 0.5);
    assert_eq!(stability(&model).verdict(), Verdict::Undecided);
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
)]
struct FreeParticle {
    m: f64,
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = -c * dot(x)),
)]
struct DraggedParticle {
    m: f64,
    c: f64,
}

#[test]
fn ignorable_coordinates_alone() {
    // Nothing is left that could decay.
    let found = stability(&FreeParticle { m: 1.0 });
    assert_eq!(found.linear, LinearStability::Neutral);
    assert_eq!(found.verdict(), Verdict::Stable);
    for (c, verdict) in [
        (1.0, Verdict::AsymptoticallyStable),
        (-1.0, Verdict::Unstable),
    ] {
        let found = stability(&DraggedParticle { m: 1.0, c });
        assert_eq!(found.verdict(), verdict);
        assert_eq!(found.is_passive, c > 0.0);
    }
}
