//! Several motions at once, in SIMD lanes.

use crate::common::{Pendulum, assert_close};
use lagrangian::num_traits::Zero;
use lagrangian::prelude::*;
use lagrangian::{Factorization, Lanes, Series, SeriesMemory, TaylorCoefficients};
use nalgebra::{SMatrix, SVector};

const PENDULUM: Pendulum = Pendulum {
    m: 1.0,
    g: 9.81,
    l: 1.0,
};

/// Two pendulums of different amplitudes, integrated together.
fn both() -> State<Lanes<2>, 1> {
    State::new(Lanes([0.0; 2]), [Lanes([0.5, 2.5])], [Lanes([0.0, 1.0])])
}

#[test]
fn lanes_move_as_they_would_alone() {
    let method = Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-12);
    let times = [0.5, 1.0, 2.0];
    let together = Problem::new(&PENDULUM, both())
        .save(times)
        .solve(2.0, method)
        .unwrap();
    for (lane, (q, v)) in [(0.5, 0.0), (2.5, 1.0)].into_iter().enumerate() {
        let initial = State::new(0.0, [q], [v]);
        let alone = Problem::new(&PENDULUM, initial)
            .save(times)
            .solve(2.0, method)
            .unwrap();
        for (together, alone) in together.samples().iter().zip(alone.samples()) {
            assert_close(together.q[0].0[lane], alone.q[0], 1e-10);
            assert_close(together.v[0].0[lane], alone.v[0], 1e-10);
        }
    }
}

/// Where the steps are the same, so are the bits.
#[test]
fn lanes_that_take_the_same_steps_have_the_same_bits() {
    let method = RungeKutta::classical(0.01);
    let together = Problem::new(&PENDULUM, both()).solve(2.0, method).unwrap();
    for (lane, (q, v)) in [(0.5, 0.0), (2.5, 1.0)].into_iter().enumerate() {
        let initial = State::new(0.0_f64, [q], [v]);
        let alone = Problem::new(&PENDULUM, initial).solve(2.0, method).unwrap();
        assert_eq!(together.q[0].lane(lane).to_bits(), alone.q[0].to_bits());
        assert_eq!(together.v[0].lane(lane).to_bits(), alone.v[0].to_bits());
    }
}

/// The error of a step is that of the worst lane.
#[test]
fn the_step_is_that_of_the_fastest_lane() {
    let method = Dop853::new()
        .relative_tolerance(1e-10)
        .absolute_tolerance(1e-10);
    let steps = |initial: State<Lanes<2>, 1>| {
        let end = Problem::new(&PENDULUM, initial).solve(10.0, method);
        end.unwrap().statistics.steps
    };
    let slow = State::new(Lanes([0.0; 2]), [Lanes([0.5; 2])], [Lanes([0.0; 2])]);
    assert!(steps(both()) > steps(slow));
}

#[test]
fn a_lane_that_is_not_finite_is_an_error_and_lanes_have_one_time() {
    let error = |initial| {
        let refused = Problem::new(&PENDULUM, initial).solve(1.0, Dop853::new());
        refused.unwrap_err().error()
    };
    let mut initial = both();
    initial.q[0] = Lanes([0.5, f64::NAN]);
    assert_eq!(
        error(initial).to_string(),
        "the coordinate theta is NaN at t = 0"
    );
    let mut initial = both();
    initial.t = Lanes([0.0, 1.0]);
    let error = error(initial);
    assert!(
        matches!(error, IntegrationError::NonFiniteTime { .. }),
        "{error}"
    );
}

/// The results of the first lane beside any other and alone are equal: bit for bit where it is not
/// positive definite, and up to rounding where it is.
#[track_caller]
fn assert_alike(beside: f64, alone: f64) {
    assert_eq!(beside.is_finite(), alone.is_finite(), "{beside}, {alone}");
    assert_eq!(beside.is_nan(), alone.is_nan(), "{beside}, {alone}");
    if alone.is_finite() {
        assert_close(beside, alone, 1e-14 * alone.abs().max(1.0));
    }
}

/// Mass matrices of three rows: definite, indefinite, with row interchanges, and singular in four ways.
const MASSES: [[[f64; 3]; 3]; 9] = [
    [[2.0, 0.5, 0.1], [0.5, 3.0, 0.2], [0.1, 0.2, 1.0]],
    [[-2.0, 0.5, 0.1], [0.5, 3.0, 0.2], [0.1, 0.2, 1.0]],
    [[0.0, 0.5, 0.0], [0.5, 0.0, 0.0], [0.0, 0.0, 1.0]],
    [[0.0, 0.0, 1.0], [0.0, 1.0, 0.3], [1.0, 0.3, 0.0]],
    [[1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
    [[0.0, 0.0, 0.0], [0.0, 2.0, 0.5], [0.0, 0.5, 1.0]],
    [[2.0, 0.5, 0.0], [0.5, 1.0, 0.0], [0.0, 0.0, 0.0]],
    [[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [3.0, 6.0, 9.0]],
    [[0.0; 3]; 3],
];

#[test]
fn a_lane_is_factored_as_it_is_alone() {
    let right = SVector::from([1.0, -2.0, 0.5]);
    for first in MASSES {
        for second in MASSES {
            let [one, other] = [first, second].map(SMatrix::<f64, 3, 3>::from);
            let together = Factorization::new(one.zip_map(&other, |x, y| Lanes([x, y])));
            let alone = Factorization::new(one);
            let found = together.solve(&right.map(|x| Lanes([x; 2])));
            for (found, expected) in found.iter().zip(&alone.solve(&right)) {
                assert_alike(found.0[0], *expected);
            }
            let found = together.relative_pivots();
            for (found, expected) in found.iter().zip(&alone.relative_pivots()) {
                assert_eq!(found.0[0].to_bits(), expected.to_bits());
            }
        }
    }
}

/// ½ a ẋ² + b ẋ ẏ + ½ c ẏ² of three parameters, with a potential and an input.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * a * dot(x).powi(2) + b * dot(x) * dot(y) + 0.5 * c * dot(y).powi(2),
    potential = k * x * sin(y),
    force(y = pull),
)]
struct Coupled<T: Scalar> {
    a: T,
    b: T,
    c: T,
    k: T,
    #[lagrangian(input)]
    pull: T,
}

/// All results that are solved for with the mass matrix.
fn solved<S: Scalar>([a, b, c]: [S; 3]) -> Vec<S> {
    let [k, pull] = [1.5, 0.25].map(S::from_f64);
    let model = Coupled { a, b, c, k, pull };
    let state = State::new(S::zero(), [0.3, 0.7].map(S::from_f64), [S::zero(); 2]);
    let linear = model.linearize(&state);
    let mut numbers: Vec<S> = model.accelerations(&state).iter().copied().collect();
    numbers.extend(linear.position.iter());
    numbers.extend(linear.velocity.iter());
    numbers.extend(model.input_jacobian(&state).iter());
    numbers.extend(model.relative_pivots(&state).iter());
    numbers
}

/// The emitted solution is used where the pivots are positive, lane by lane.
#[test]
fn a_lane_of_a_derived_model_gives_what_it_gives_alone() {
    let masses = [
        [2.0, 0.5, 1.0],
        [0.5, 2.0, 1.0],
        [0.0, 1.5, 0.0],
        [-1.0, 0.5, -3.0],
        [1.0, 1.0, 1.0],
        [0.0, 0.0, 1.0],
        [1.0, 0.0, 0.0],
        [0.0, 0.0, 0.0],
        // All digits of a lane that is nearly singular are kept beside one that is indefinite.
        [1e-9, 0.0, 1.0],
    ];
    for first in masses {
        for second in masses {
            let both = [0, 1, 2].map(|i| Lanes([first[i], second[i]]));
            for (found, expected) in solved(both).iter().zip(&solved(first)) {
                // Zeros may differ in sign, and NaN has many bit patterns.
                let [found, expected] = [found.0[0], *expected].map(|x| x + 0.0);
                assert_eq!(found.is_nan(), expected.is_nan(), "{first:?}, {second:?}");
                assert!(
                    found.to_bits() == expected.to_bits() || found.is_nan(),
                    "{found} for {expected}: {first:?}, {second:?}"
                );
            }
        }
    }
}

/// Where a component is exactly zero in one lane, the error of the other lane decides, also without an absolute
/// tolerance.
#[test]
fn a_lane_at_rest_needs_no_absolute_tolerance() {
    let method = Dop853::new().absolute_tolerance(0.0);
    let initial = State::new(Lanes::zero(), [Lanes([0.0, 0.5])], [Lanes([0.0, 0.0])]);
    let end = Problem::new(&PENDULUM, initial)
        .max_steps(200)
        .solve(1.0, method)
        .unwrap();
    assert_close(end.q[0].0[0], 0.0, 0.0);
    let alone = Problem::new(&PENDULUM, State::new(0.0, [0.5], [0.0])).solve(1.0, Dop853::new());
    assert_close(end.q[0].0[1], alone.unwrap().q[0], 1e-8);
}

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(a, b),
    kinetic = dot(a).powi(2) + 0.5 * dot(b).powi(2) + dot(a) * dot(b) * cos(a - b),
    potential = -2.0 * cos(a) - cos(b) - 0.1 * a * sin(t),
)]
struct DoublePendulum;

/// So many products that their sums are in a loop.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(y[5]),
    kinetic = (0..5).map(|i| (2.0 + cos(y[i])) * dot(y[i]).powi(2)).sum(),
    potential = (0..4).map(|i| y[i].powi(2) * y[i + 1].powi(2) * exp(y[i])).sum(),
)]
struct Chain;

/// As many products, of other factors.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(y[5]),
    kinetic = (0..5).map(|i| (2.0 + cos(y[i])) * dot(y[i]).powi(2)).sum(),
    potential = (0..4).map(|i| y[i].powi(2) * y[i + 1].powi(2) * exp(y[i + 1])).sum(),
)]
struct OtherChain;

/// Memory that is kept from one series to the next, of other motions, of another order, or of another model, changes no digit.
#[test]
fn series_in_kept_memory_are_those_in_new_memory() {
    fn check<const HALF: usize, const N: usize>(
        equations: &impl Series<Lanes<4>, State = Phase<Lanes<4>, N>>,
        memory: &mut SeriesMemory,
    ) {
        for member in 0..3 {
            let angle = |i: usize, lane: usize| {
                f64::from(u32::try_from(7 * i + 5 * lane + 11 * member).unwrap())
            };
            let component = |i: usize| Lanes::from_fn(|lane| angle(i, lane).sin());
            let x = Phase::new(
                core::array::from_fn(component),
                core::array::from_fn(|i| component(N + i)),
            );
            let (t, unit) = (component(2 * N), Lanes([0.5; 4]));
            let mut expected = TaylorCoefficients::<_, HALF>::new(x);
            equations.series((t, &x), unit, &mut expected, None);
            let mut found = TaylorCoefficients::<_, HALF>::new(x);
            equations.series((t, &x), unit, &mut found, Some(memory));
            assert_eq!(found, expected);
        }
    }

    let memory = &mut SeriesMemory::default();
    check::<6, 2>(&DoublePendulum.dynamics(), memory);
    check::<14, 2>(&DoublePendulum.dynamics(), memory);
    check::<6, 2>(&DoublePendulum.dynamics(), memory);
    check::<6, 5>(&Chain.dynamics(), memory);
    check::<6, 5>(&OtherChain.dynamics(), memory);
    check::<6, 2>(&DoublePendulum.dynamics(), memory);
}
