//! Reactions to events, under every method: impacts, switches, endless ones.

use core::f64::consts::PI;

use crate::common::{Oscillator, assert_close};
use crate::event_models::{BALL, PENDULUM, Pendulum, period, times, under_each_method};
use lagrangian::prelude::*;
use nalgebra::SVector;

type Vector<const N: usize> = SVector<f64, N>;

/// With v₀ = √(2 g h) the n-th flight lasts 2 v₀ eⁿ / g, and all of them 2 v₀ e / (g (1 − e)).
#[test]
fn a_ball_bounces_until_it_is_at_rest() {
    under_each_method!(|method, _error| {
        for floor in [0.0, 0.1, 100.1, -1e4] {
            for (crossing, restitution) in [
                (Crossing::Falling, 0.5),
                (Crossing::Either, 0.5),
                (Crossing::Falling, 0.9),
                (Crossing::Falling, 0.1),
            ] {
                let driver = method
                    .driver()
                    .events(Event::new(crossing), |_, x: &Phase<f64, 1>| x.q[0] - floor);
                let start = State::new(0.0, [floor + 1.0], [0.0]);
                let bounce = |_, _, x: &mut Phase<f64, 1>, _: &mut _| {
                    x.v[0] *= -restitution;
                    Reaction::Changed
                };
                let motion = driver
                    .sample_reacting(&mut BALL.dynamics(), start, &[100.0], bounce)
                    .unwrap();
                assert_eq!(motion.reason(), StopReason::Zeno, "{floor} {restitution}");
                assert!(motion.outcome().met.contains(0));
                let fall = (2.0 / BALL.g).sqrt();
                let rest = fall * (1.0 + 2.0 * restitution / (1.0 - restitution));
                // Heights are rounded, and the last eight flights are within their rounding errors. After a flight
                // that is within them, all that would follow last e/(1 − e) times as long.
                let rounding = (8.0 * f64::EPSILON * (floor.abs() + 1.0)).sqrt();
                let rounding = rounding * (restitution / (1.0 - restitution)).max(1.0);
                assert_close(motion.last().t, rest, 1e-8 + 16.0 * rounding);
                assert_close(motion.last().x.q[0], floor, 1e-13 * (floor.abs() + 1.0));
                assert_close(motion.last().x.v[0], 0.0, 1e-8 + 40.0 * rounding);
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
        }
    });
}

/// Nothing is lost without restitution losses.
#[test]
fn an_elastic_ball_bounces_forever() {
    under_each_method!(|method, error| {
        let driver = method
            .driver()
            .events(Event::falling(), |_, x: &Phase<f64, 1>| x.q[0]);
        let start = State::new(0.0, [1.0], [0.0]);
        let bounce = |_, _, x: &mut Phase<f64, 1>, _: &mut _| {
            x.v[0] = -x.v[0];
            Reaction::Changed
        };
        let fall = (2.0 / BALL.g).sqrt();
        let end = 400.0 * fall;
        let motion = driver
            .sample_reacting(&mut BALL.dynamics(), start, &[end], bounce)
            .unwrap();
        assert_eq!(motion.reason(), StopReason::Completed);
        assert_eq!(motion.events().len(), 200);
        assert_close(motion.last().x.q[0], 1.0, 1e-9);
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
        let driver = method
            .driver()
            .events(Event::falling(), |_, x: &Phase<f64, 1>| x.q[0]);
        let start = State::new(0.0, [1.5], [0.0]);
        let mut dynamics = PENDULUM.dynamics();
        let motion = driver
            .sample_reacting(&mut dynamics, start, &[10.25 * half], |_, _, x, _| {
                x.v[0] = -x.v[0];
                Reaction::Changed
            })
            .unwrap();
        let found = times(motion.events(), 0);
        assert_eq!(found.len(), 10);
        for (n, time) in (0..).map(f64::from).zip(found) {
            assert_close(time, (n + 0.5) * half, error * 20.0);
        }
        let energies = [start, motion.last().state()].map(|state| PENDULUM.energy(&state));
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
        let driver = method.driver().events(
            [Event::falling(), Event::rising()],
            |_, x: &Phase<f64, 1>| [x.q[0]; 2],
        );
        let start = State::new(0.0, [1e-4], [0.0]);
        let mut pendulum = PENDULUM.into_dynamics();
        let motion = driver
            .sample_reacting(&mut pendulum, start, &[14.0], |event, _, _, pendulum| {
                pendulum.change(|pendulum| {
                    pendulum.m *= 1.5;
                    pendulum.l = [2.0 * PENDULUM.l, PENDULUM.l][event];
                });
                Reaction::Changed
            })
            .unwrap();
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
        assert_close(pendulum.model().m, grown, 1e-12 * grown);
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
            let driver = method
                .driver()
                .events([Event::falling(); 4], |_, x: &Phase<f64, 5>| {
                    core::array::from_fn(|i| x.q[i + 1] - x.q[i] + GAP)
                });
            let mut largest = 0.0_f64;
            let motion = driver
                .sample_reacting(
                    &mut cradle.dynamics(),
                    start,
                    &[7.0 * half],
                    |i, _, x, _| {
                        let momentum = x.v.sum();
                        // A central elastic impact of equal masses.
                        x.v.swap_rows(i, i + 1);
                        largest = largest.max((x.v.sum() - momentum).abs());
                        Reaction::Changed
                    },
                )
                .unwrap();
            assert_eq!(motion.reason(), StopReason::Completed);
            assert!(motion.events().len() >= 7 * 4 && largest < 1e-14);
            let end = motion.last().state();
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
    let start = (0.0, SVector::from([1.0, 0.0]));
    let zero = |_, x: &Vector<2>| x[0];
    let driver = Dop853::new().driver();
    let plain = driver.clone().run_until(&Oscillator, start, 20.0).unwrap();
    let watching = driver.events(Event::either(), zero);
    let mut count = 0;
    let watched = watching
        .clone()
        .run_reacting(&mut Oscillator, start, 20.0, |_, _, _, _| {
            count += 1;
            Reaction::Unchanged
        })
        .unwrap();
    assert_eq!((plain.last, count), (watched.last, 6));
    let stopped = watching
        .run_reacting(&mut Oscillator, start, 20.0, |_, t, x, _| {
            if t > 4.0 {
                x[1] = 7.0;
                Reaction::Stop
            } else {
                Reaction::Unchanged
            }
        })
        .unwrap();
    assert_eq!(stopped.reason, StopReason::Condition);
    assert!(stopped.met.contains(0));
    assert_close(stopped.last.t, 1.5 * PI, 1e-8);
    assert_close(stopped.last.x[1], 7.0, 0.0);
}

/// Functions that are zero at the start, everywhere, NaN, or that oscillate without end: values, and no hang.
#[test]
fn events_without_end_are_no_hang() {
    let start = (0.0, SVector::from([0.0, 1.0]));
    let count = |function: fn(f64, &Vector<2>) -> f64| {
        let driver = Dop853::new().driver().events(Event::either(), function);
        let mut reactions = 0;
        let outcome = driver.run_reacting(&mut Oscillator, start, 1.0, |_, _, _, _| {
            reactions += 1;
            Reaction::Changed
        });
        (reactions, outcome.unwrap().reason)
    };
    assert_eq!(count(|_, x| x[0]), (0, StopReason::Completed));
    assert_eq!(count(|_, _| 0.0), (0, StopReason::Completed));
    assert_eq!(count(|_, _| f64::NAN), (0, StopReason::Completed));
    let (reactions, _) = count(|t, _| (1e12 * t).sin());
    assert!(reactions < 1000, "{reactions}");
    let (reactions, _) = count(|t, _| (1.0 / (0.5 - t)).sin());
    assert!(reactions < 1000, "{reactions}");
}

/// A state that a reaction has changed counts, whatever the reaction says, also where another one at the same time changes it.
#[test]
fn a_changed_state_counts_whatever_the_reaction_says() {
    under_each_method!(|method, error| {
        let driver = method
            .driver()
            .events([Event::falling(); 2], |_, x: &Phase<f64, 1>| {
                [x.q[0], x.q[0]]
            });
        let bounce = |event, _, x: &mut Phase<f64, 1>, _: &mut _| {
            if event == 0 {
                x.q[0] += 1.0;
                return Reaction::Unchanged;
            }
            x.v[0] = -x.v[0];
            Reaction::Changed
        };
        let start = State::new(0.0, [1.0], [0.0]);
        let fall = (2.0 / BALL.g).sqrt();
        let motion = driver
            .run_reacting(&mut BALL.dynamics(), start, 2.0 * fall, bounce)
            .unwrap();
        assert_close(motion.last.x.q[0], 2.0, 10.0 * error);
        let driver = method
            .driver()
            .events(Event::falling(), |_, x: &Phase<f64, 1>| x.q[0]);
        let disowned = |_, _, x: &mut Phase<f64, 1>, _: &mut _| {
            x.v[0] = -x.v[0];
            Reaction::Unchanged
        };
        let motion = driver
            .run_reacting(&mut BALL.dynamics(), start, 2.0 * fall, disowned)
            .unwrap();
        assert_close(motion.last.x.q[0], 1.0, 10.0 * error);
    });
}
