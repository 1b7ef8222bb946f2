//! Declared events against functions whose zeros are known: random trees of |x|, min and max, jumps, clusters of zeros.
//! They are declared once and filled with random numbers, so that many cases cost one model.

use crate::directions::{Direction, directed};
use crate::random_numbers::Random;
use lagrangian::DeclaredEvent;
use lagrangian::prelude::*;

/// A particle at unit velocity, x = t, so that events are functions of x whose zeros are written down.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    event(
        zigzag = abs(abs(abs(x - c[0]) - c[1]) - c[2]) - c[3],
        tree = max(min(a[0] + b[0] * x, a[1] + b[1] * x), min(max(a[2] + b[2] * x, a[3] + b[3] * x), a[4])),
        signs = signum(x - c[0]) * signum(x - c[1]) + c[2],
        bent = abs(sin(8.0 * x) - c[0]) - c[3],
        cluster = (x - c[0]) * (x - c[1]) * (x - c[2]) * (x - c[3]),
    ),
)]
#[derive(Clone, Copy, Debug)]
struct Particle {
    a: [f64; 5],
    b: [f64; 4],
    c: [f64; 4],
}

impl Particle {
    fn zigzag(&self, x: f64) -> f64 {
        (((x - self.c[0]).abs() - self.c[1]).abs() - self.c[2]).abs() - self.c[3]
    }

    fn tree(&self, x: f64) -> f64 {
        let line = |i: usize| self.a[i] + self.b[i] * x;
        f64::max(line(0).min(line(1)), line(2).max(line(3)).min(self.a[4]))
    }
}

/// The sign changes of a function with pieces between corners on which it is straight: from, to, and where.
fn changes(function: impl Fn(f64) -> f64, mut corners: Vec<f64>, end: f64) -> Vec<(f64, bool)> {
    corners.retain(|x| *x > 0.0 && *x < end);
    corners.push(end);
    corners.sort_by(f64::total_cmp);
    let mut found = Vec::new();
    let (mut left, mut sign) = (
        0.0,
        function(0.0).signum() * f64::from(function(0.0) != 0.0),
    );
    for right in corners {
        let (from, to) = (function(left), function(right));
        if to != 0.0 && sign * to < 0.0 {
            // A zero at the corner itself is where the sign is lost.
            let at = if from == 0.0 {
                left
            } else {
                left - from * (right - left) / (to - from)
            };
            found.push((at, to > 0.0));
        }
        if to != 0.0 {
            sign = to.signum();
        }
        left = right;
    }
    found
}

/// The occurrences of one declared event from x = 0 until t = 1, by steps of at most this length.
fn found<I>(
    method: I,
    model: &Particle,
    event: DeclaredEvent<Particle>,
    direction: Direction,
    start: f64,
    end: f64,
) -> Vec<f64>
where
    I: for<'a> Integrator<f64, lagrangian::EquationsOfMotion<&'a Particle, f64, 1>>,
{
    let problem = Problem::new(model, State::new(start, [start], [1.0])).on(event);
    let problem = directed!(direction, problem).record();
    let motion = problem.solve(end, method).unwrap();
    motion
        .events()
        .iter()
        .map(|occurrence| occurrence.t)
        .collect()
}

fn compare(what: &str, model: &Particle, found: &[f64], expected: &[f64], error: f64) {
    let close = found.len() == expected.len()
        && found
            .iter()
            .zip(expected)
            .all(|(a, b)| (a - b).abs() <= error);
    assert!(
        close,
        "{what} of {model:?}:\n found {found:?}\n expected {expected:?}"
    );
}

/// The numbers of the grid are exact, and zeros without a change of sign are left out by a shift off the grid.
#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn corners_have_neither_false_zeros_nor_missed_ones() {
    cross_corners(120);
}

#[test]
fn some_corners_have_neither_false_zeros_nor_missed_ones() {
    cross_corners(15);
}

fn cross_corners(cases: usize) {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    for case in 0..cases {
        let mut model = Particle {
            a: [0.0; 5].map(|_| random.dyadic()),
            b: [0.0; 4].map(|_| 4.0 * random.dyadic()),
            c: [0.0; 4].map(|_| random.dyadic().abs()),
        };
        // No zero at a corner: those of the grid have denominators up to 64.
        model.c[3] += 1.0 / 1024.0;
        let steps = [f64::INFINITY, 0.3, 0.0625][case % 3];
        let method = Taylor::new().max_step(steps.min(1e3));
        let [zigzag, tree] = [zigzag_corners(&model), tree_corners(&model)];
        let what = format!("case {case}, zigzag");
        cross(
            &what,
            method,
            &model,
            Particle::ZIGZAG,
            Particle::zigzag,
            zigzag,
        );
        let what = format!("case {case}, tree");
        cross(&what, method, &model, Particle::TREE, Particle::tree, tree);
    }
}

fn zigzag_corners(model: &Particle) -> Vec<f64> {
    let [c0, c1, c2, _] = model.c;
    let mut corners = vec![c0];
    for s in [-1.0, 1.0] {
        corners.push(c0 + s * c1);
        corners.extend([c0 + s * (c1 + c2), c0 + s * (c1 - c2)]);
    }
    corners
}

/// Where two of the lines of the tree meet.
fn tree_corners(model: &Particle) -> Vec<f64> {
    let mut corners = Vec::new();
    let lines: Vec<_> = (0..5)
        .map(|i| (model.a[i], model.b.get(i).copied().unwrap_or(0.0)))
        .collect();
    for (i, (a, b)) in lines.iter().enumerate() {
        for (other, slope) in &lines[..i] {
            if (slope - b).abs() > 0.0 {
                corners.push((a - other) / (slope - b));
            }
        }
    }
    corners
}

/// The zeros of a function with these corners are found in all directions.
fn cross(
    what: &str,
    method: Taylor,
    model: &Particle,
    event: DeclaredEvent<Particle>,
    function: fn(&Particle, f64) -> f64,
    corners: Vec<f64>,
) {
    let function = |x: f64| function(model, x);
    let expected = changes(function, corners, 1.0);
    let at_edge = |t: f64| !(1e-9..=1.0 - 1e-9).contains(&t);
    // Zeros of two branches at one place are not told apart.
    let are_close = expected.windows(2).any(|pair| pair[1].0 - pair[0].0 < 1e-6);
    if function(0.0) == 0.0 || expected.iter().any(|(t, _)| at_edge(*t)) || are_close {
        return;
    }
    for (direction, wanted) in [
        (Direction::Rising, Some(true)),
        (Direction::Falling, Some(false)),
        (Direction::Either, None),
    ] {
        let times = expected
            .iter()
            .filter(|(_, rises)| wanted.is_none_or(|wanted| wanted == *rises));
        let times: Vec<f64> = times.map(|(t, _)| *t).collect();
        let found = found(method, model, event, direction, 0.0, 1.0);
        if found.len() > times.len() {
            // A zero that is touched at a corner counts as reached; it is no change of sign.
            let is_more = |t: &f64| times.iter().all(|u| (t - u).abs() > 1e-12);
            let mut more = found.iter().copied().filter(is_more);
            assert!(
                more.all(|t| function(t).abs() < 1e-13),
                "{what}, {direction:?} of {model:?}: {found:?} {times:?}"
            );
            continue;
        }
        let what = format!("{what}, {direction:?}");
        compare(&what, model, &found, &times, 1e-13);
    }
}

/// |u| touches zero at its corner once, from above; a small constant lifts it off, or splits the zero into two.
#[test]
fn a_corner_at_zero_is_reached_once() {
    let lifted = |lift: f64, event: DeclaredEvent<Particle>, direction: Direction| {
        let model = Particle {
            a: [0.0; 5],
            b: [0.0; 4],
            c: [0.375, 0.0, 0.0, lift],
        };
        found(Taylor::new(), &model, event, direction, 0.0, 1.0)
    };
    for (direction, touches) in [
        (Direction::Either, 1),
        (Direction::Falling, 1),
        (Direction::Rising, 0),
    ] {
        let times = lifted(0.0, Particle::ZIGZAG, direction);
        assert_eq!(times.len(), touches, "{direction:?} {times:?}");
        assert!(times.iter().all(|t| (t - 0.375).abs() < 1e-13));
    }
    for lift in [1e-12, 1e-9, 1e-6, 1e-3] {
        assert!(lifted(-lift, Particle::ZIGZAG, Direction::Either).is_empty());
        let times = lifted(lift, Particle::ZIGZAG, Direction::Either);
        assert_eq!(times.len(), 2, "{lift:e} {times:?}");
        assert!((times[0] - 0.375 + lift).abs() < 1e-14 && (times[1] - 0.375 - lift).abs() < 1e-14);
    }
}

/// An integration that begins at a corner, where the sign of its argument is 0.
#[test]
fn a_start_at_a_corner_is_no_obstacle() {
    for lift in [0.125, 1e-3, 1e-6] {
        let model = Particle {
            a: [0.0; 5],
            b: [0.0; 4],
            c: [0.25, 0.0, 0.0, lift],
        };
        let times = found(
            Taylor::new(),
            &model,
            Particle::ZIGZAG,
            Direction::Either,
            0.25,
            1.0,
        );
        assert_eq!(times.len(), 1, "{lift:e} {times:?}");
        assert!((times[0] - 0.25 - lift).abs() < 1e-14);
    }
}

/// Jumps of a product of signs are changes of sign; the inverse sine tells where a bent wave has its zeros.
#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn jumps_and_bent_waves() {
    cross_jumps(30);
}

#[test]
fn some_jumps_and_bent_waves() {
    cross_jumps(5);
}

fn cross_jumps(cases: usize) {
    let mut random = Random(7);
    for case in 0..cases {
        let mut c = [0.0; 4].map(|_| 0.05 + 0.9 * random.uniform());
        c[2] = 0.5;
        let model = Particle {
            a: [0.0; 5],
            b: [0.0; 4],
            c,
        };
        let [low, high] = [c[0].min(c[1]), c[0].max(c[1])];
        let found =
            |model, event, direction| found(Taylor::new(), model, event, direction, 0.0, 1.0);
        let falls = found(&model, Particle::SIGNS, Direction::Falling);
        let rises = found(&model, Particle::SIGNS, Direction::Rising);
        compare(
            &format!("case {case}, falls"),
            &model,
            &falls,
            &[low],
            1e-12,
        );
        compare(
            &format!("case {case}, rises"),
            &model,
            &rises,
            &[high],
            1e-12,
        );
        // |sin 8x − c₀| = c₃, all branches.
        let model = Particle {
            c: [0.4 * c[0], 0.0, 0.0, 0.3 * c[3] + 0.01],
            ..model
        };
        let mut expected = Vec::new();
        for value in [model.c[0] + model.c[3], model.c[0] - model.c[3]] {
            for turn in -1..4 {
                let base = value.asin();
                let pi = core::f64::consts::PI;
                let turn = 2.0 * pi * f64::from(turn);
                expected.extend([(base + turn) / 8.0, (pi - base + turn) / 8.0]);
            }
        }
        expected.retain(|x| *x > 0.0 && *x < 1.0);
        expected.sort_by(f64::total_cmp);
        let times = found(&model, Particle::BENT, Direction::Either);
        compare(
            &format!("case {case}, bent"),
            &model,
            &times,
            &expected,
            1e-12,
        );
    }
}

/// Four zeros in clusters of every kind: apart, close, and of higher multiplicity. A zero of even multiplicity counts as
/// reached, and clusters within rounding are one zero.
#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn clusters_of_zeros_are_counted_with_their_multiplicities() {
    count_clusters(120);
}

#[test]
fn some_clusters_of_zeros_are_counted_with_their_multiplicities() {
    count_clusters(15);
}

/// Where a polynomial with these ascending roots, positive before them, vanishes, where it falls, and where it rises; a double root
/// is both.
fn passages(roots: &[f64]) -> [Vec<f64>; 3] {
    let mut groups: Vec<(f64, usize)> = Vec::new();
    for &root in roots {
        match groups.last_mut() {
            Some((at, count)) if root - *at < 1e-9 => *count += 1,
            _ => groups.push((root, 1)),
        }
    }
    let mut sign = 1.0;
    let (mut all, mut falling, mut rising) = (Vec::new(), Vec::new(), Vec::new());
    for (at, count) in groups {
        all.push(at);
        if sign > 0.0 {
            falling.push(at);
        } else {
            rising.push(at);
        }
        if count % 2 == 1 {
            sign = -sign;
        }
    }
    [all, falling, rising]
}

fn count_clusters(cases: usize) {
    let mut random = Random(99);
    for case in 0..cases {
        let mut roots = Vec::new();
        while roots.len() < 4 {
            let root: f64 = (8.0 + 48.0 * random.uniform()).round() / 64.0;
            let copies = 1 + random.below(3);
            let apart = [0.0, 1e-4, 1e-2][usize::from(random.below(3))];
            for i in 0..copies {
                roots.push(root + apart * f64::from(i));
            }
        }
        roots.truncate(4);
        // The order of factors does not matter.
        let swap = usize::from(random.below(4));
        roots.swap(0, swap);
        let c = [roots[0], roots[1], roots[2], roots[3]];
        let model = Particle {
            a: [0.0; 5],
            b: [0.0; 4],
            c,
        };
        roots.sort_by(f64::total_cmp);
        // Zeros that rounding of the coefficients makes one are not told apart.
        let width = roots.windows(2).map(|pair| pair[1] - pair[0]);
        if width.filter(|gap| *gap > 0.0 && *gap < 1e-3).count() > 1 {
            continue;
        }
        let [all, falling, rising] = passages(&roots);
        let max_step = [10.0, 0.25, 1.0 / 64.0][case % 3];
        let method = Taylor::new().max_step(max_step);
        for (direction, expected) in [
            (Direction::Either, all),
            (Direction::Falling, falling),
            (Direction::Rising, rising),
        ] {
            let times = found(method, &model, Particle::CLUSTER, direction, 0.0, 1.0);
            // A triple zero is known to a third of the digits, a fourfold one to a quarter.
            compare(
                &format!("case {case}, {direction:?}"),
                &model,
                &times,
                &expected,
                2e-4,
            );
        }
    }
}
