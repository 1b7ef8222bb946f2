//! Forces with the norm of a velocity, and their slopes, where the velocity is 0.

use lagrangian::prelude::*;
use lagrangian_tests::Dual;

const LANES: usize = 8;

type Lanes = lagrangian::Lanes<LANES>;

/// A particle slowed down by the square of its speed.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r[3]),
    define(p = vector(r)),
    kinetic = 0.5 * m * dot(p).norm_squared(),
    force(p = -c * dot(p).norm() * dot(p)),
)]
struct Drag {
    m: f64,
    c: f64,
}

/// The same by its dissipation function.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r[3]),
    kinetic = 0.5 * m * dot(vector(r)).norm_squared(),
    dissipation = c / 3 * dot(vector(r)).norm().powi(3),
)]
struct Dissipation {
    m: f64,
    c: f64,
}

/// Against air that moves.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r[3]),
    define(p = vector(r), w = dot(p) - [1.5, -2.0, 0.25]),
    kinetic = 0.5 * m * dot(p).norm_squared(),
    force(p = -c * w.norm() * w),
)]
struct Wind {
    m: f64,
    c: f64,
}

/// A spring that gets stiffer with its length.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r[3]),
    define(p = vector(r)),
    kinetic = 0.5 * m * dot(p).norm_squared(),
    force(p = -c * p.norm() * p),
)]
struct Spring {
    m: f64,
    c: f64,
}

/// In one dimension, three spellings.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r[3]),
    kinetic = 0.5 * m * dot(vector(r)).norm_squared(),
    force(
        r[0] = -c * abs(dot(r[0])) * dot(r[0]),
        r[1] = -c * (4 * dot(r[1]).powi(2)).sqrt() * dot(r[1]) / 2,
        r[2] = -c * [dot(r[2])].norm() * dot(r[2]),
    ),
)]
struct Straight {
    m: f64,
    c: f64,
}

/// Dry friction in space.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r[3]),
    kinetic = 0.5 * m * dot(vector(r)).norm_squared(),
    dissipation = c * dot(vector(r)).norm(),
)]
struct Friction {
    m: f64,
    c: f64,
}

/// A body whose turning is slowed down.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a, b, c),
    define(r = rotation_xyz(a, b, c), w = angular_velocity(r)),
    kinetic = 0.5 * inertia.dot(w.component_mul(w)),
    force(w = -drag * w.norm() * w),
)]
struct Body {
    inertia: Vector3<f64>,
    drag: f64,
}

/// A chain of two links in the air.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta[2]),
    define(
        p[0] = l * [sin(theta[0]), -cos(theta[0])],
        p[1] = p[0] + l * [sin(theta[1]), -cos(theta[1])],
    ),
    kinetic = (0..2).map(|i| 0.5 * m * dot(p[i]).norm_squared()).sum(),
    potential = 0.5 * k * (theta[0].powi(2) + theta[1].powi(2)),
    force(p[i] = -c * dot(p[i]).norm() * dot(p[i]) for i in 0..2),
)]
struct Chain {
    m: f64,
    l: f64,
    k: f64,
    c: f64,
}

const M: f64 = 1.5;
const C: f64 = 0.3;
const Q: [f64; 3] = [0.4, -0.3, 0.2];

/// The accelerations −c |w| w/m and their slopes −c/m (|w| 1 + w wᵀ/|w|), from |w| and w/|w|.
fn expected(w: [f64; 3]) -> ([f64; 3], [[f64; 3]; 3]) {
    let largest = w.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    if largest == 0.0 {
        return ([0.0; 3], [[0.0; 3]; 3]);
    }
    let scaled = w.map(|x| x / largest);
    let size = scaled.iter().map(|x| x * x).sum::<f64>().sqrt();
    let direction = scaled.map(|x| x / size);
    let size = size * largest;
    let slope = |i: usize, j: usize| {
        let diagonal = f64::from(u8::from(i == j));
        -C / M * size * (diagonal + direction[i] * direction[j])
    };
    let slopes = [0, 1, 2].map(|i| [0, 1, 2].map(|j| slope(i, j)));
    (w.map(|x| -C / M * size * x), slopes)
}

#[track_caller]
fn assert_all<S: Scalar>(found: impl IntoIterator<Item = S>, expected: &[f64], tolerance: f64) {
    let size = expected.iter().fold(0.0_f64, |a, b| a.max(b.abs()));
    let mut count = 0;
    for (found, expected) in found.into_iter().zip(expected) {
        count += 1;
        let found = found.smallest();
        assert!(
            (found - expected).abs() <= tolerance * size,
            "{found:e} for {expected:e}"
        );
    }
    assert_eq!(count, expected.len());
}

/// Accelerations and their slopes by what `w` is made of.
fn check<S: Scalar>(
    model: &impl Lagrangian<3, S, Model: lagrangian::quantities::StateJacobian<3, S>>,
    q: [f64; 3],
    v: [f64; 3],
    w: [f64; 3],
    by_velocity: bool,
    tolerance: f64,
) {
    let state = State::new(S::zero(), q.map(S::from_f64), v.map(S::from_f64));
    let (accelerations, slopes) = expected(w);
    // Products of the smallest speeds are below the smallest number.
    let found = model.accelerations(&state);
    if w.iter().all(|w| *w == 0.0 || w.abs() > 1e-15) {
        assert_all(found.iter().copied(), &accelerations, tolerance);
    }
    let linearization = model.linearize(&state);
    let [found, other] = if by_velocity {
        [linearization.velocity, linearization.position]
    } else {
        [linearization.position, linearization.velocity]
    };
    assert_all(found.iter().copied(), slopes.as_flattened(), tolerance);
    assert!(other.iter().all(|x| x.smallest() == 0.0));
}

/// At rest, and at speeds from small ones to large ones.
fn check_on<S: Scalar>(tolerance: f64)
where
    Drag: Lagrangian<3, S, Model: lagrangian::quantities::StateJacobian<3, S>>,
    Dissipation: Lagrangian<3, S, Model: lagrangian::quantities::StateJacobian<3, S>>,
    Wind: Lagrangian<3, S, Model: lagrangian::quantities::StateJacobian<3, S>>,
    Spring: Lagrangian<3, S, Model: lagrangian::quantities::StateJacobian<3, S>>,
{
    for size in [0.0, 1e-18, 1e-12, 1e-6, 1.0, 1e6] {
        for direction in [[1.0, -2.0, 0.5], [0.0, 0.0, 1.0], [-0.6, 0.8, 0.0]] {
            let w = direction.map(|x| x * size);
            let (m, c) = (M, C);
            check::<S>(&Drag { m, c }, Q, w, w, true, tolerance);
            check::<S>(&Dissipation { m, c }, Q, w, w, true, tolerance);
            check::<S>(&Spring { m, c }, w, [0.0; 3], w, false, tolerance);
        }
    }
    let (m, c) = (M, C);
    let wind = [1.5, -2.0, 0.25];
    check::<S>(&Wind { m, c }, Q, wind, [0.0; 3], true, tolerance);
    check::<S>(
        &Wind { m, c },
        Q,
        [2.5, -4.0, 0.75],
        [1.0, -2.0, 0.5],
        true,
        tolerance,
    );
}

#[test]
fn drag_has_its_slopes_at_rest() {
    check_on::<f64>(1e-14);
    check_on::<f32>(1e-6);
    check_on::<Dual>(1e-14);
    check_on::<Lanes>(1e-14);
}

#[test]
fn drag_in_one_dimension() {
    let model = Straight { m: M, c: C };
    for v in [0.0, 1e-9, -2.5] {
        let state = State::new(0.0, Q, [v; 3]);
        let slopes = model.linearize(&state).velocity;
        for i in 0..3 {
            let expected = -2.0 * C / M * v.abs();
            assert!((slopes[(i, i)] - expected).abs() <= 1e-15 * expected.abs());
            let expected = -C / M * v.abs() * v;
            let found = model.accelerations(&state)[i];
            assert!((found - expected).abs() <= 1e-15 * expected.abs());
        }
    }
}

#[test]
fn friction_is_zero_at_rest_and_a_unit_vector_elsewhere() {
    let model = Friction { m: M, c: C };
    let at = |v: [f64; 3]| model.accelerations(&State::new(0.0, Q, v));
    assert!(at([0.0; 3]).iter().all(|x| *x == 0.0));
    for size in [1e-18, 1e-6, 1.0] {
        let found = at([0.6 * size, 0.0, -0.8 * size]);
        assert_all(found.iter().copied(), &[-0.12, 0.0, 0.16], 1e-15);
    }
    // There the slope is infinite.
    let slopes = model.linearize(&State::new(0.0, Q, [0.0; 3])).velocity;
    assert!(slopes.iter().all(|slope| !slope.is_finite()));
}

#[test]
fn bodies_and_chains_have_the_slopes_of_undamped_ones_at_rest() {
    let inertia = Vector3::new(1.0, 2.0, 3.0);
    let body = |drag| Body { inertia, drag }.linearize(&State::new(0.0, Q, [0.0; 3]));
    let (damped, undamped) = (body(C), body(0.0));
    assert!(damped.velocity.iter().all(|slope| *slope == 0.0));
    assert_eq!(damped.position, undamped.position);
    let chain = |c| {
        let chain = Chain {
            m: M,
            l: 0.7,
            k: 2.0,
            c,
        };
        chain.linearize(&State::new(0.0, [0.4, -0.3], [0.0; 2]))
    };
    let (damped, undamped) = (chain(C), chain(0.0));
    assert!(damped.velocity.iter().all(|slope| *slope == 0.0));
    assert!(undamped.position.iter().all(|slope| slope.abs() > 0.1));
    assert_eq!(damped.position, undamped.position);
}

#[test]
fn slopes_of_chains_are_those_of_accelerations() {
    // At rest and in motion, by difference quotients whose error is that of the square of the step, times |v|.
    let chain = Chain {
        m: M,
        l: 0.7,
        k: 2.0,
        c: C,
    };
    for v in [[0.0, 0.0], [1.0, -0.5], [1e-3, 0.0]] {
        let slopes = chain.linearize(&State::new(0.0, [0.4, -0.3], v)).velocity;
        for j in 0..2 {
            let step = 1e-7;
            let moved = |step: f64| {
                let mut v = v;
                v[j] += step;
                chain.accelerations(&State::new(0.0, [0.4, -0.3], v))
            };
            let quotient = (moved(step) - moved(-step)) / (2.0 * step);
            assert!((quotient - slopes.column(j)).norm() < 1e-6);
        }
    }
}

#[test]
fn derivatives_are_carried_through_rest() {
    let model = Drag { m: M, c: C };
    let state = State::new(
        Dual::constant(0.0),
        Q.map(Dual::constant),
        [
            Dual::constant(0.0),
            Dual::constant(0.0),
            Dual::new(0.0, 1.0),
        ],
    );
    let accelerations = model.accelerations(&state);
    assert!(
        accelerations
            .iter()
            .all(|x| x.value() == 0.0 && x.derivative() == 0.0)
    );
}

#[test]
fn one_lane_at_rest_does_not_concern_the_others() {
    let model = Drag { m: M, c: C };
    let speed = |lane: usize| [0.3, 1e-9, 0.0, 0.9, 1.2, 0.0, 5.0, 1e6][lane];
    let v = [1.0, -2.0, 0.5];
    let zero = Lanes::from_fn(|_| 0.0);
    let state = State::new(
        zero,
        Q.map(|q| Lanes::from_fn(|_| q)),
        v.map(|v| Lanes::from_fn(|lane| v * speed(lane))),
    );
    let together = model.linearize(&state).velocity;
    for lane in 0..LANES {
        let state = State::new(0.0, Q, v.map(|v| v * speed(lane)));
        let alone = model.linearize(&state).velocity;
        for (together, alone) in together.iter().zip(&alone) {
            assert_eq!(together.lane(lane).to_bits(), alone.to_bits());
        }
    }
}
