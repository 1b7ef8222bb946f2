//! Reactions to events, under every method: impacts, switches, endless ones.

use core::cell::Cell;
use core::f64::consts::PI;
use core::ops::ControlFlow;

use crate::common::{Oscillator, assert_close};
use crate::directions::{Direction, directed};
use crate::event_models::{BALL, PENDULUM, Pendulum, period, times, under_each_method};
use lagrangian::prelude::*;
use nalgebra::SVector;

type Vector<const N: usize> = SVector<f64, N>;

/// The height of a floor, the direction in which it is watched for, and the restitution.
type Bouncing = (f64, Direction, f64);

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn a_ball_bounces_until_it_is_at_rest_on_every_floor() {
    let restitutions = [
        (Direction::Falling, 0.5),
        (Direction::Either, 0.5),
        (Direction::Falling, 0.9),
        (Direction::Falling, 0.1),
    ];
    let all = [0.0, 0.1, 100.1, -1e4].map(|floor| restitutions.map(|(d, e)| (floor, d, e)));
    bounce_until_at_rest(&all.concat());
}

#[test]
fn a_ball_bounces_until_it_is_at_rest() {
    bounce_until_at_rest(&[
        (0.0, Direction::Falling, 0.9),
        (0.1, Direction::Either, 0.5),
        (100.1, Direction::Falling, 0.5),
        (-1e4, Direction::Falling, 0.1),
    ]);
}

/// With v₀ = √(2 g h) the n-th flight lasts 2 v₀ eⁿ / g, and all of them 2 v₀ e / (g (1 − e)).
fn bounce_until_at_rest(cases: &[Bouncing]) {
    under_each_method!(|method, _error| {
        for &(floor, direction, restitution) in cases {
            let start = State::new(0.0, [floor + 1.0], [0.0]);
            let ball = Problem::new(&BALL, start).when(|x| x.q[0] - floor);
            let ball = directed!(direction, ball).then(|x| x.v[0] *= -restitution);
            let motion = ball.solve(100.0, method).unwrap();
            assert_eq!(motion.reason, StopReason::Zeno, "{floor} {restitution}");
            assert!(motion.met.contains(0));
            let fall = (2.0 / BALL.g).sqrt();
            let rest = fall * (1.0 + 2.0 * restitution / (1.0 - restitution));
            // Heights are rounded, and the last eight flights are within their rounding errors. After a flight
            // that is within them, all that would follow last e/(1 − e) times as long.
            let rounding = (8.0 * f64::EPSILON * (floor.abs() + 1.0)).sqrt();
            let rounding = rounding * (restitution / (1.0 - restitution)).max(1.0);
            assert_close(motion.t, rest, 1e-8 + 16.0 * rounding);
            assert_close(motion.q[0], floor, 1e-13 * (floor.abs() + 1.0));
            assert_close(motion.v[0], 0.0, 1e-8 + 40.0 * rounding);
            let (mut expected, mut flight) = (fall, 2.0 * fall);
            for (n, time) in (1..=10).map(f64::from).zip(times(motion.events(), 0)) {
                // The error of a height in that of the time when it is passed, over all bounces.
                let error = 8.0 * f64::EPSILON * (floor.abs() + 1.0) / (flight * BALL.g);
                assert_close(time, expected, n * error * 4.0 + 1e-13);
                flight *= restitution;
                expected += flight;
                if flight < 1e-5 + 100.0 * rounding {
                    break;
                }
            }
        }
    });
}

/// Nothing is lost without restitution losses.
#[test]
fn an_elastic_ball_bounces_forever() {
    under_each_method!(|method, error| {
        let start = State::new(0.0, [1.0], [0.0]);
        let ball = Problem::new(&BALL, start).when(|x| x.q[0]).falling();
        let fall = (2.0 / BALL.g).sqrt();
        let end = 400.0 * fall;
        let motion = ball.then(|x| x.v[0] = -x.v[0]).solve(end, method).unwrap();
        assert_eq!(motion.reason, StopReason::Completed);
        assert_eq!(motion.events().len(), 200);
        assert_close(motion.q[0], 1.0, 1e-9);
        // Every bounce rounds the time, on which all later ones depend.
        let rounding = 200.0 * 200.0 * f64::EPSILON * end;
        assert_close(motion.events()[199].t, 399.0 * fall, error + rounding);
    });
}

/// A pendulum that bounces off a wall at its lowest point: half periods.
#[test]
fn a_pendulum_bounces_off_a_wall() {
    let half = 0.5 * period(&PENDULUM, 1.5);
    under_each_method!(|method, error| {
        let start = State::new(0.0, [1.5], [0.0]);
        let wall = Problem::new(&PENDULUM, start).when(|x| x.q[0]).falling();
        let bouncing = wall.then(|x| x.v[0] = -x.v[0]);
        let motion = bouncing.solve(10.25 * half, method).unwrap();
        let found = times(motion.events(), 0);
        assert_eq!(found.len(), 10);
        for (n, time) in (0..).map(f64::from).zip(found) {
            assert_close(time, (n + 0.5) * half, error * 20.0);
        }
        let energies = [start, motion.last].map(|state| PENDULUM.energy(&state));
        assert_close(energies[1], energies[0], error * 20.0);
    });
}

/// The mass of a pendulum does not matter and its length does: the parameters are prepared again.
#[test]
fn a_reaction_changes_parameters() {
    let lengthened = Pendulum {
        l: 2.0 * PENDULUM.l,
        ..PENDULUM
    };
    let quarters = [PENDULUM.l, lengthened.l].map(|l| 0.25 * 2.0 * PI * (l / PENDULUM.g).sqrt());
    under_each_method!(|method, error| {
        let start = State::new(0.0, [1e-4], [0.0]);
        let mut running = Problem::new(PENDULUM, start)
            .when(|x| x.q[0])
            .falling()
            .then_with(|_, pendulum| {
                pendulum.change(|pendulum| {
                    pendulum.m *= 1.5;
                    pendulum.l = 2.0 * PENDULUM.l;
                });
            })
            .when(|x| x.q[0])
            .rising()
            .then_with(|_, pendulum| {
                pendulum.change(|pendulum| {
                    pendulum.m *= 1.5;
                    pendulum.l = PENDULUM.l;
                });
            })
            .start(method)
            .unwrap();
        let motion = running.advance(14.0).unwrap();
        let mut expected = quarters[0];
        for (n, occurrence) in motion.events().iter().enumerate() {
            assert_eq!(occurrence.event, n % 2);
            // The period grows with the square of the amplitude.
            assert_close(occurrence.t, expected, 1e-7 + error * 20.0);
            expected += 2.0 * quarters[(n + 1) % 2];
        }
        let bounces = i32::try_from(motion.events().len()).unwrap();
        assert!(bounces >= 10);
        let grown = PENDULUM.m * 1.5_f64.powi(bounces);
        assert_close(running.dynamics().model().m, grown, 1e-12 * grown);
    });
}

/// Five balls side by side: as many swing out on one side as on the other.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(theta[5]),
    kinetic = (0..5).map(|i| 0.5 * m * (l * dot(theta[i])).powi(2)).sum(),
    potential = (0..5).map(|i| -m * g * l * cos(theta[i])).sum(),
)]
struct Cradle {
    m: f64,
    g: f64,
    l: f64,
}

/// The angle between neighbours that hang at rest.
const GAP: f64 = 1e-4;

#[test]
fn newtons_cradle_keeps_momentum_and_energy() {
    let cradle = Cradle {
        m: 0.1,
        g: 9.81,
        l: 0.25,
    };
    let alone = Pendulum {
        m: cradle.m,
        g: cradle.g,
        l: cradle.l,
    };
    under_each_method!(|method, error| {
        for lifted in 1..=3 {
            let amplitude = 0.6;
            let half = 0.5 * period(&alone, amplitude);
            let q = SVector::from_fn(|i, _| if i < lifted { -amplitude } else { 0.0 });
            let start = State::new(0.0, q, SVector::<f64, 5>::zeros());
            let largest = Cell::new(0.0_f64);
            let apart = |i: usize| move |x: &State<f64, 5>| x.q[i + 1] - x.q[i] + GAP;
            let collide = |i: usize| {
                let largest = &largest;
                move |x: &mut State<f64, 5>| {
                    let momentum = x.v.sum();
                    // A central elastic impact of equal masses.
                    x.v.swap_rows(i, i + 1);
                    largest.set(largest.get().max((x.v.sum() - momentum).abs()));
                }
            };
            macro_rules! cradle {
                ($($i:literal)*) => {
                    Problem::new(&cradle, start)$(.when(apart($i)).falling().then(collide($i)))*
                };
            }
            let motion = cradle!(0 1 2 3).solve(7.0 * half, method).unwrap();
            assert_eq!(motion.reason, StopReason::Completed);
            assert!(motion.events().len() >= 7 * 4 && largest.get() < 1e-14);
            let end = motion.last;
            let energies = [start, end].map(|state| cradle.energy(&state));
            assert_close(energies[0], energies[1], 1e-12 + error);
            // After an odd number of half periods as many are at the other side.
            for i in 0..5 {
                let expected = if i + lifted >= 5 { amplitude } else { 0.0 };
                assert_close(end.q[i], expected, 100.0 * GAP);
            }
        }
    });
}

/// A reaction that changes nothing leaves the motion as it is, to the last bit, and one that stops ends it.
#[test]
fn reactions_without_changes_and_reactions_that_stop() {
    let start = At::from((0.0, SVector::from([1.0, 0.0])));
    let problem = Problem::new(&Oscillator, start);
    let plain = problem.clone().solve(20.0, Dop853::new()).unwrap();
    let zero = problem.when(|x| x[0]);
    let mut count = 0;
    let watched = zero.clone().then(|_| count += 1);
    let watched = watched.solve(20.0, Dop853::new());
    assert_eq!((plain.last, count), (watched.unwrap().last, 6));
    let stopped = zero
        .then(|x| {
            if x.t > 4.0 {
                x[1] = 7.0;
                ControlFlow::Break(())
            } else {
                ControlFlow::Continue(())
            }
        })
        .solve(20.0, Dop853::new())
        .unwrap();
    assert_eq!(stopped.reason, StopReason::Condition);
    assert!(stopped.met.contains(0));
    assert_close(stopped.t, 1.5 * PI, 1e-8);
    assert_close(stopped[1], 7.0, 0.0);
}

/// Functions that are zero at the start, everywhere, NaN, or that oscillate without end: values, and no hang.
#[test]
fn events_without_end_are_no_hang() {
    let start = At::from((0.0, SVector::from([0.0, 1.0])));
    let count = |function: fn(&At<f64, Vector<2>>) -> f64| {
        let mut reactions = 0;
        let zero = Problem::new(&Oscillator, start).when(function);
        // The method begins anew at each of them.
        let reacting = zero.then_with(|_, _| reactions += 1);
        let reason = reacting.solve(1.0, Dop853::new()).unwrap().reason;
        (reactions, reason)
    };
    assert_eq!(count(|x| x[0]), (0, StopReason::Completed));
    assert_eq!(count(|_| 0.0), (0, StopReason::Completed));
    assert_eq!(count(|_| f64::NAN), (0, StopReason::Completed));
    let (reactions, _) = count(|x| (1e12 * x.t).sin());
    assert!(reactions < 1000, "{reactions}");
    let (reactions, _) = count(|x| (1.0 / (0.5 - x.t)).sin());
    assert!(reactions < 1000, "{reactions}");
}

/// A state that a reaction has changed counts, whatever the reaction says, also where another one at the same time changes it.
#[test]
fn a_changed_state_counts_whatever_the_reaction_says() {
    under_each_method!(|method, error| {
        let fall = (2.0 / BALL.g).sqrt();
        let problem = Problem::new(&BALL, State::new(0.0, [1.0], [0.0]));
        let motion = problem
            .clone()
            .when(|x| x.q[0])
            .falling()
            .then(|x| x.q[0] += 1.0)
            .when(|x| x.q[0])
            .falling()
            .then_with(|x, _| x.v[0] = -x.v[0])
            .solve(2.0 * fall, method)
            .unwrap();
        assert_close(motion.q[0], 2.0, 10.0 * error);
        let disowned = problem.when(|x| x.q[0]).falling();
        let disowned = disowned.then(|x| x.v[0] = -x.v[0]);
        let motion = disowned.solve(2.0 * fall, method).unwrap();
        assert_close(motion.q[0], 1.0, 10.0 * error);
    });
}
