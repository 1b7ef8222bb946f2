//! Contacts that begin and end within a step of the Taylor series method.

use core::f64::consts::PI;

use crate::common::in_lanes;
use lagrangian::prelude::*;
use lagrangian::signals::Polynomial;

/// A spring, and another one behind a gap.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 0.5 * x.powi(2) + 0.5 * k * max(x - gap, 0).powi(2),
    force(x = u),
)]
struct Contact {
    k: f64,
    gap: f64,
    #[lagrangian(input)]
    u: f64,
}

/// From x = 0 with the velocity 1: arcs of sines, about 0 and in contact about k gap/(1 + k), in turn.
fn exact(k: f64, gap: f64, t: f64) -> f64 {
    let omega = (1.0 + k).sqrt();
    let center = k * gap / (1.0 + k);
    let first = gap.asin();
    let speed = first.cos();
    let amplitude = (gap - center).hypot(speed / omega);
    let phase = (omega * (gap - center)).atan2(speed);
    let in_contact = (PI - 2.0 * phase) / omega;
    let since = (t - first).rem_euclid(in_contact + PI + 2.0 * first);
    if since <= in_contact {
        center + amplitude * (omega * since + phase).sin()
    } else {
        (PI - first + since - in_contact).sin()
    }
}

#[test]
fn no_contact_is_passed_over() {
    for k in [0.1, 1.0, 10.0, 100.0] {
        for gap in [0.0, 0.05, 0.27, 0.5, 0.77, 0.9, 0.99, 0.999_9] {
            let model = Contact { k, gap, u: 0.0 };
            let problem = Problem::new(&model, State::new(0.0, [0.0], [1.0]));
            for t in [3.0, 12.0, 20.0] {
                let x = problem.clone().solve(t, Taylor::new()).unwrap().q[0];
                let expected = exact(k, gap, t);
                assert!((x - expected).abs() < 1e-9, "{k} {gap} {t}: {x} {expected}");
            }
        }
    }
}

/// Under inputs that are functions of time, and backwards.
#[test]
fn contacts_of_driven_and_backward_motions() {
    let model = Contact {
        k: 10.0,
        gap: 0.9,
        u: 0.0,
    };
    let start = State::new(0.0, [0.0], [1.0]);
    let held = model.with_inputs([0.0]);
    let end = Problem::new(&held, start).solve(3.0, Taylor::new());
    assert!((end.unwrap().q[0] - exact(10.0, 0.9, 3.0)).abs() < 1e-9);
    let driven = |start| Problem::new(&model, start).driven_by([Polynomial([0.0])]);
    let end = driven(start).solve(3.0, Taylor::new()).unwrap();
    assert!((end.q[0] - exact(10.0, 0.9, 3.0)).abs() < 1e-9);
    let back = driven(end.last).solve(0.0, Taylor::new()).unwrap();
    assert!(back.q[0].abs() < 1e-8);
}

/// The same on all scalars, since it has no parameters.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 0.5 * x.powi(2) + 5 * max(x - 0.9, 0).powi(2),
)]
struct FixedContact;

#[test]
fn contacts_in_lanes() {
    let motions = [3.0, 0.5, 12.0, 7.0, -3.0].map(|t| (State::new(0.0, [0.0], [1.0]), t));
    let found = in_lanes::<4, _, _>(Taylor::new(), &FixedContact.dynamics(), motions);
    for (result, (start, t)) in found.into_iter().zip(motions) {
        let alone = Problem::new(&FixedContact, start).solve(t, Taylor::new());
        let (x, alone) = (result.unwrap().last.x.q[0], alone.unwrap().q[0]);
        assert!((x - alone).abs() < 1e-9, "{t}: {x} {alone}");
        if t > 0.0 {
            assert!((x - exact(10.0, 0.9, t)).abs() < 1e-9);
        }
    }
}

/// A force that saturates where x y exceeds 0.1.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = 0.5 * (x.powi(2) + y.powi(2)),
    force(x = c * (max(abs(x), abs(y)) - min(x * y, 0.1))),
)]
struct Saturated {
    c: f64,
}

#[test]
fn both_corners_of_a_saturation_are_seen() {
    let model = Saturated { c: -0.3 };
    let problem = Problem::new(&model, State::new(0.0, [0.0, 0.0], [0.4, 0.3]));
    for t in [1.3, 1.5, 3.0] {
        let found = problem.clone().solve(t, Taylor::new()).unwrap();
        let precise = Dop853::new()
            .relative_tolerance(1e-15)
            .absolute_tolerance(1e-15);
        let expected = problem.clone().solve(t, precise).unwrap();
        assert!((found.q - expected.q).norm() < 1e-10);
    }
}

/// Two masses on springs of their own, between which a third one acts where they overlap.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = 0.5 * (x.powi(2) + y.powi(2)) + 5 * max(x - y, 0).powi(2) + abs(sin(x - y)).powi(3),
)]
struct Touching;

/// Arguments of branches that stay zero to rounding do not stop the motion.
#[test]
fn masses_that_touch_all_the_time() {
    let start = State::new(0.0_f64, [0.5, 0.5], [0.3, 0.3]);
    let problem = Problem::new(&Touching, start).max_steps(200);
    let end = problem.solve(20.0, Taylor::new()).unwrap();
    assert_eq!(end.t.to_bits(), 20.0_f64.to_bits());
    let expected = 0.5 * 20.0_f64.cos() + 0.3 * 20.0_f64.sin();
    let error = end.q[0] - expected;
    assert!(error.abs() < 1e-11, "{error}");
    assert!((end.q[0] - end.q[1]).abs() < 1e-13);
}

/// A mass that passes repulsive bumps w² − (x − aᵢ)², some of them so low that they are not felt.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = (0..18).map(|i| height[i] * max(width.powi(2) - (x - center[i]).powi(2), 0)).sum(),
)]
struct Bumps {
    height: [f64; 18],
    center: [f64; 18],
    width: f64,
}

/// More passages than are kept for a step: 36, of which two are of account. Over a bump ẍ = 2 k x, so that it takes
/// (2/ω) artanh(ω w/v) with ω² = 2 k.
#[test]
fn contacts_behind_many_that_do_not_matter() {
    for felt in [0, 17] {
        let mut model = Bumps {
            height: [0.0; 18],
            center: core::array::from_fn(|i| 1.0 + f64::from(u8::try_from(i).unwrap())),
            width: 0.25,
        };
        model.height[felt] = 4.0;
        let (speed, omega) = (2.0, 8.0_f64.sqrt());
        let delay = 2.0 / omega * (omega * model.width / speed).atanh() - 2.0 * model.width / speed;
        let start = State::new(0.0, [0.0], [speed]);
        let motions = [(start, 10.0); 2];
        let single = Problem::new(&model, start).solve(10.0, Taylor::new());
        let mut found = vec![single.unwrap().q[0]];
        let lanes = in_lanes::<2, _, _>(Taylor::new(), &model.dynamics(), motions);
        found.extend(lanes.into_iter().map(|motion| motion.unwrap().last.x.q[0]));
        for x in found {
            assert!((x - speed * (10.0 - delay)).abs() < 1e-9, "{felt}: {x}");
        }
    }
}
