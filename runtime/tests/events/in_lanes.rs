//! Events of members in lanes: against closed forms, and against the same members alone.

use core::f64::consts::PI;

use crate::random_numbers::Random;
use lagrangian::prelude::*;

/// x = a cos(t − phase). The functions of the first three events have zeros where |x| = level; the second has two in a step
/// about a turning point, and the third has a corner at x = 0.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 0.5 * x.powi(2),
    event(above = x - level, squared = x.powi(2) - level.powi(2), beyond = abs(x) - level, turn = dot(x), never = x - 2.0),
)]
struct Oscillator {
    level: f64,
}

/// A member, and the parameters of its closed form.
struct Case {
    model: Oscillator,
    start: State<f64, 1>,
    amplitude: f64,
    phase: f64,
}

const END: f64 = 20.0;

/// Levels at ordinary heights, and so near to the amplitude that two zeros are close to each other.
fn cases(count: u32) -> Vec<Case> {
    let mut random = Random(0x1d2b_79f5_0a3c_4e87);
    let case = |_| {
        let (amplitude, phase) = (0.5 + random.uniform(), 2.0 * PI * random.uniform());
        let gap = [0.9, 0.3, 1e-2, 1e-4, 1e-8][usize::from(random.below(5))];
        let level = amplitude * (1.0 - gap * (0.1 + 0.9 * random.uniform()));
        let start = State::new(0.0, [amplitude * phase.cos()], [amplitude * phase.sin()]);
        Case {
            model: Oscillator { level },
            start,
            amplitude,
            phase,
        }
    };
    (0..count).map(case).collect()
}

impl Case {
    /// The times in (0, `END`) at which cos(t − phase) is `cosine`.
    fn times(&self, cosine: f64) -> Vec<f64> {
        let angle = cosine.acos();
        let turns = (-2..6).map(|turn| 2.0 * PI * f64::from(turn) + self.phase);
        let mut times: Vec<f64> = turns.flat_map(|t| [t - angle, t + angle]).collect();
        times.retain(|t| (1e-3..END - 1e-3).contains(t));
        times.sort_by(f64::total_cmp);
        times
    }

    /// The times of both zeros of |x| − level.
    fn both(&self) -> Vec<f64> {
        let cosine = self.model.level / self.amplitude;
        let mut times = [self.times(cosine), self.times(-cosine)].concat();
        times.sort_by(f64::total_cmp);
        times
    }

    /// Whether these are the times, to some rounding errors of the state at the slope of the function.
    fn agrees(&self, found: &[f64], expected: &[f64], cosine: f64) {
        let inner = found.iter().filter(|t| (1e-3..END - 1e-3).contains(*t));
        let found: Vec<f64> = inner.copied().collect();
        assert_eq!(
            found.len(),
            expected.len(),
            "{found:?} {expected:?} {}",
            self.model.level
        );
        let slope = (1.0 - cosine * cosine).sqrt();
        for (found, expected) in found.iter().zip(expected) {
            let allowed = 2e-15 * (1.0 + expected) * (1.0 + 1.0 / slope);
            assert!(
                (found - expected).abs() <= allowed,
                "{found} {expected} {cosine}"
            );
        }
    }
}

/// The times of an event of every member, in 4 lanes and in one.
macro_rules! times {
    ($cases:expr, $event:expr $(, $crossing:ident)?) => {{
        let mut times = vec![Vec::new(); $cases.len()];
        let problems = $cases.iter().map(|case: &Case| Problem::new(&case.model, case.start).on($event)$(.$crossing())?.record());
        Ensemble::new(problems)
            .lanes::<4>()
            .solve_each(END, Taylor::order_16(), |index, found| {
                let found = found.unwrap();
                times[index] = found
                    .events()
                    .iter()
                    .map(|event| event.state.t)
                    .collect::<Vec<_>>();
            });
        for (case, together) in $cases.iter().zip(&times).step_by(7) {
            let mut alone = Vec::new();
            let one = Ensemble::new([Problem::new(&case.model, case.start).on($event)$(.$crossing())?.record()]).lanes::<1>();
            one.solve_each(END, Taylor::order_16(), |_, found| {
                alone = found
                    .unwrap()
                    .events()
                    .iter()
                    .map(|event| event.state.t)
                    .collect();
            });
            assert_eq!(&alone, together);
        }
        times
    }};
}

#[test]
fn times_agree_with_closed_forms() {
    let cases = cases(120);
    let above = times!(cases, Oscillator::ABOVE);
    let rising = times!(cases, Oscillator::ABOVE, rising);
    let squared = times!(cases, Oscillator::SQUARED);
    let beyond = times!(cases, Oscillator::BEYOND);
    let turns = times!(cases, Oscillator::TURN, falling);
    let never = times!(cases, Oscillator::NEVER);
    for (index, case) in cases.iter().enumerate() {
        let cosine = case.model.level / case.amplitude;
        case.agrees(&above[index], &case.times(cosine), cosine);
        case.agrees(&squared[index], &case.both(), cosine);
        case.agrees(&beyond[index], &case.both(), cosine);
        let both = case.times(cosine);
        let is_rising = |t: &&f64| (**t - case.phase).sin() < 0.0;
        let expected: Vec<f64> = both.iter().filter(is_rising).copied().collect();
        case.agrees(&rising[index], &expected, cosine);
        // The velocity falls through zero where x is greatest.
        let mut greatest = case.times(1.0);
        greatest.dedup_by(|a, b| (*a - *b).abs() < 1e-6);
        case.agrees(&turns[index], &greatest, 0.0);
        assert!(never[index].is_empty());
    }
}

/// Two lists of events together: each of them occurs where it does alone.
#[test]
fn events_watched_together_occur_where_they_do_alone() {
    let cases = cases(24);
    let above = times!(cases, Oscillator::ABOVE, falling);
    let turns = times!(cases, Oscillator::TURN);
    let problems = cases.iter().map(|case| {
        let above = Problem::new(&case.model, case.start).on(Oscillator::ABOVE);
        let both = above.falling().record().on(Oscillator::TURN).record();
        both.on(Oscillator::NEVER).record()
    });
    Ensemble::new(problems)
        .lanes::<4>()
        .solve_each(END, Taylor::order_16(), |index, found| {
            let found = found.unwrap();
            let mut expected = [&above[index][..], &turns[index]].concat();
            expected.sort_by(f64::total_cmp);
            let times: Vec<f64> = found.events().iter().map(|event| event.state.t).collect();
            assert_eq!(times.len(), expected.len(), "{times:?} {expected:?}");
            for (found, expected) in times.iter().zip(&expected) {
                assert!((found - expected).abs() <= 1e-12, "{found} {expected}");
            }
        });
}

/// What a member finds, in full: its events, samples, end, and how it ended.
#[derive(Clone, Debug, Default, PartialEq)]
struct Findings {
    events: Vec<(usize, f64, f64)>,
    samples: Vec<f64>,
    last: [f64; 3],
    ending: String,
}

macro_rules! findings {
    ($found:expr) => {{
        let found = $found.unwrap();
        Findings {
            events: found
                .events()
                .iter()
                .map(|event| (event.event, event.state.t, event.state.v[0]))
                .collect(),
            samples: found.samples().iter().map(|sample| sample.q[0]).collect(),
            last: [found.last.t, found.last.q[0], found.last.v[0]],
            ending: format!("{:?} {:?}", found.reason, found.met),
        }
    }};
}

/// Asserts that members find in 4 lanes what each of them finds alone, and what `Dop853` finds up to its errors.
macro_rules! finds_the_same {
    ($cases:expr, $end:expr, |$case:ident| $problem:expr) => {{
        let mut together = vec![Findings::default(); $cases.len()];
        let problems = $cases.iter().map(|$case: &Case| $problem.save(Every(0.7)));
        Ensemble::new(problems)
            .lanes::<4>()
            .solve_each($end, Taylor::new(), |index, found| {
                together[index] = findings!(found)
            });
        for ($case, together) in $cases.iter().zip(&together) {
            let one = Ensemble::new([$problem.save(Every(0.7))]).lanes::<1>();
            one.solve_each($end, Taylor::new(), |_, found| {
                assert_eq!(&findings!(found), together)
            });
            let explicit = findings!(
                $problem.save(Every(0.7)).solve(
                    $end,
                    Dop853::new()
                        .relative_tolerance(1e-13)
                        .absolute_tolerance(1e-13)
                )
            );
            assert_eq!(explicit.ending, together.ending);
            assert_eq!(
                explicit.events.len(),
                together.events.len(),
                "{explicit:?} {together:?}"
            );
            for (one, other) in explicit.events.iter().zip(&together.events) {
                let distance = (one.1 - other.1).abs();
                assert!(one.0 == other.0 && distance <= 1e-9, "{one:?} {other:?}");
            }
        }
    }};
}

/// A sampled input shifts the event function.
#[derive(Lagrangian, Clone)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = 0.5 * x.powi(2),
    force(x = 0.1 * shift),
    event(shifted = x + shift),
)]
struct Shifted {
    #[lagrangian(input)]
    shift: f64,
}

/// Levels far enough below the amplitude that `Dop853` locates every event.
fn distinct_cases() -> Vec<Case> {
    let mut all = cases(60);
    all.retain(|case| {
        case.model.level < 0.9 * case.amplitude && case.start.q[0] < case.model.level
    });
    all
}

#[test]
fn members_find_in_lanes_what_they_find_alone() {
    let cases = distinct_cases();
    assert!(cases.len() > 10);
    finds_the_same!(cases, 15.0, |case| {
        let problem = Problem::new(&case.model, case.start);
        problem.on(Oscillator::ABOVE).rising().record()
    });
    // Backwards in time.
    finds_the_same!(cases, -15.0, |case| {
        let problem = Problem::new(&case.model, case.start);
        problem.on(Oscillator::ABOVE).record()
    });
    // A wall that reflects, and another list that watches the velocity.
    finds_the_same!(cases, 15.0, |case| {
        let problem = Problem::new(&case.model, case.start);
        let wall = problem
            .on(Oscillator::ABOVE)
            .rising()
            .then(|x| x.v[0] *= -0.9);
        wall.on(Oscillator::TURN).rising().record()
    });
    // An end at an event.
    finds_the_same!(cases, 15.0, |case| {
        let problem = Problem::new(&case.model, case.start);
        let record = problem.on(Oscillator::TURN).record();
        record.on(Oscillator::ABOVE).falling().stop()
    });
    // An end at a limit of steps, after another event function that is sampled.
    finds_the_same!(cases, 15.0, |case| {
        let problem = Problem::new(&case.model, case.start).max_steps(1000);
        let level = case.model.level;
        problem
            .on(Oscillator::NEVER)
            .record()
            .when(move |x| x.q[0] + level)
            .record()
    });
    // An event function that jumps, and has zeros between its jumps.
    finds_the_same!(cases, 15.0, |case| {
        let shifted = Problem::new(Shifted { shift: 0.3 }, case.start);
        let shifted = shifted.sampled_feedback(0.7, [0.3], |_, shift| {
            shift[0] = -shift[0];
            [shift[0]]
        });
        shifted.on(Shifted::SHIFTED).record()
    });
}
