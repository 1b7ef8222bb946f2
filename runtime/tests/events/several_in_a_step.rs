//! Steps in which event functions have several zeros.

use core::f64::consts::{FRAC_PI_2, TAU};

use lagrangian::prelude::*;

use crate::random_numbers::Random;

/// x = cos(t − φ), with functions of one, two and three times its frequency.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 0.5 * x.powi(2),
    event(level = x - c, double = x * dot(x), triple = x * (4.0 * x.powi(2) - 3.0)),
)]
struct Oscillator {
    c: f64,
}

/// The times t = first + k distance between two times, in ascending order.
fn spaced(first: f64, distance: f64, [from, to]: [f64; 2]) -> Vec<f64> {
    let mut k = ((from - first) / distance).ceil();
    let mut times = Vec::new();
    while first + k * distance < to {
        times.push(first + k * distance);
        k += 1.0;
    }
    times
}

/// In steps with several zeros of one function or of several functions, each is found where the closed form has it, in both
/// directions of time.
#[test]
fn each_zero_of_a_step_is_found() {
    fn check<const HALF: usize>(method: Taylor<HALF>, forwards: bool, random: &mut Random) {
        let phase = TAU * random.uniform();
        let c = 0.99 * (2.0 * random.uniform() - 1.0);
        let oscillator = Oscillator { c };
        let end = if forwards { 40.0 } else { -40.0 };
        let start = State::new(0.0, [f64::cos(phase)], [f64::sin(phase)]);
        let motion = Problem::new(&oscillator, start)
            .on([Oscillator::LEVEL, Oscillator::DOUBLE])
            .record()
            .on(Oscillator::TRIPLE)
            .rising()
            .record()
            .solve(end, method)
            .unwrap();
        let span = [f64::min(0.0, end), f64::max(0.0, end)];
        let turn = f64::acos(c);
        let mut level = spaced(phase - turn, TAU, span);
        level.extend(spaced(phase + turn, TAU, span));
        let double = spaced(phase, FRAC_PI_2, span);
        // cos 3(t − φ) rises where sin 3(t − φ) = −1; backwards in time it rises at the other zeros.
        let rising = if forwards { -FRAC_PI_2 } else { FRAC_PI_2 };
        let triple = spaced(phase + rising / 3.0, TAU / 3.0, span);
        for (event, mut expected) in [level, double, triple].into_iter().enumerate() {
            expected.sort_by(f64::total_cmp);
            if !forwards {
                expected.reverse();
            }
            let events = motion.events().iter().filter(|found| found.event == event);
            let found: Vec<f64> = events.map(|found| found.t).collect();
            assert_eq!(found.len(), expected.len(), "{event} {phase} {c}");
            for (found, expected) in found.iter().zip(&expected) {
                let difference = (found - expected).abs();
                assert!(
                    difference < 1e-12,
                    "{event} {phase} {c}: {found} {expected}"
                );
            }
        }
        let steps = motion.statistics.steps;
        assert!(steps * 3 < motion.events().len() as u64, "{steps} steps");
    }
    let mut random = Random(5);
    for index in 0..16 {
        check(Taylor::new(), index % 2 == 0, &mut random);
        check(Taylor::<20>::of_half_order(), index % 2 == 1, &mut random);
    }
}
