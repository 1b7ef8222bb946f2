//! Discretized models and controllability of systems with widely different frequencies.

use lagrangian::analysis::StateSpace;
use lagrangian::prelude::*;

/// Two oscillators that are not coupled, under one input.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = 0.5 * k * x * x + 0.5 * l * y * y + c * x * y,
    force(x = f, y = b * f),
)]
struct Oscillators {
    k: f64,
    l: f64,
    b: f64,
    c: f64,
    #[lagrangian(input)]
    f: f64,
}

fn plant([k, l, b, c]: [f64; 4]) -> StateSpace<f64, 4, 1, 4> {
    let model = Oscillators { k, l, b, c, f: 0.0 };
    StateSpace::of(&model, &State::new(0.0, [0.0; 2], [0.0; 2]))
}

#[track_caller]
fn assert_near(found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs();
    assert!(
        error <= tolerance * expected.abs().max(tolerance),
        "{found:e} is not {expected:e}"
    );
}

#[test]
fn slow_modes_keep_their_digits() {
    for (k, period) in [(1e8, 1e-3), (1e12, 1.0), (1e16, 1.0)] {
        let found = plant([k, -1.0, 1.0, 0.0]).discretized(period);
        assert_near(found.a[(1, 1)], period.cosh(), 1e-15);
        assert_near(found.a[(1, 3)], period.sinh(), 1e-15);
        assert_near(found.a[(3, 1)], period.sinh(), 1e-15);
        // ∫ sinh and ∫ cosh.
        assert_near(found.b[(1, 0)], 2.0 * (0.5 * period).sinh().powi(2), 1e-14);
        assert_near(found.b[(3, 0)], period.sinh(), 1e-15);
        // The stiff one has the digits that its phase has.
        let phase = k.sqrt() * period;
        let error = (found.a[(0, 0)] - phase.cos()).abs();
        assert!(error <= 1e-15 * phase.max(1.0) * 10.0, "{error:e}");
        assert_near(found.a[(0, 1)], 0.0, 0.0);
        assert_near(found.a[(3, 2)], 0.0, 0.0);
    }
    // Coupled: det exp(A h) = exp(h tr A) = 1, and the slow one has l − c²/k to second order.
    let found = plant([1e10, -1.0, 1.0, 1.0]).discretized(1.0);
    assert_near(found.a[(1, 1)], 1.0_f64.cosh(), 1e-9);
}

/// The powers of a nilpotent matrix end: nothing is scaled, and nothing is rounded.
#[test]
fn free_motion_is_exact() {
    for period in [1e-9, 0.3, 7.0, 1e9] {
        let found = plant([1e10, 0.0, 1.0, 0.0]).discretized(period);
        let exact = [[(1, 1), (3, 3)], [(1, 3), (1, 3)], [(3, 1), (3, 1)]];
        for (entries, value) in exact.into_iter().zip([1.0, period, 0.0]) {
            for entry in entries {
                assert_near(found.a[entry], value, 0.0);
            }
        }
        assert_near(found.b[(3, 0)], period, 0.0);
        assert_near(found.b[(1, 0)], 0.5 * period * period, 1e-15);
    }
}

/// Both oscillators are reached (Hautus), unless their frequencies are equal or b is 0.
#[test]
fn controllability_of_stiff_systems() {
    for [k, b] in [[1e8, 1.0], [1e10, 1.0], [1e14, 1e-3], [1e12, 1e-2]] {
        let found = plant([k, -1.0, b, 0.0]).controllability();
        assert!(found.is_complete(), "{k:e} {b} {found:?}");
    }
    let found = plant([1e8, -1.0, 0.0, 0.0]).controllability();
    assert_eq!(found.rank, 2);
    let left = found.uncontrollable().unwrap();
    assert_near(left[0].re.abs(), 1.0, 1e-12);
    let equal = plant([4.0, 4.0, 1.0, 0.0]).controllability();
    assert_eq!(equal.rank, 2);
}
