//! Declared events against motions whose zeros are known: random trees of |x|, min and max, clusters of zeros, particles
//! in boxes. What is random is what is declared once and filled with numbers, so that thousands of cases cost one model.

use lagrangian::prelude::*;

/// xorshift64 (G. Marsaglia, *Xorshift RNGs*, J. Stat. Softw. **8** (2003) 14).
struct Random(u64);

impl Random {
    fn next(&mut self) -> u64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        self.0
    }

    fn below(&mut self, n: u64) -> u64 {
        (self.next() >> 11) % n
    }

    /// One of the multiples of 1/64 in [−1, 1].
    fn dyadic(&mut self) -> f64 {
        (self.below(129) as f64 - 64.0) / 64.0
    }

    fn uniform(&mut self) -> f64 {
        (self.next() >> 11) as f64 * 2.0_f64.powi(-53)
    }
}

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
    method: &I,
    model: &Particle,
    index: usize,
    event: Event,
    start: f64,
    end: f64,
) -> Vec<f64>
where
    I: IntegrationMethod
        + for<'a> Integrator<f64, lagrangian::EquationsOfMotion<'a, Particle, f64, 1>>,
{
    let driver = method.driver().declared_events([(index, event)]);
    let start = State::new(start, [start], [1.0]);
    let motion = driver.sample(&model.dynamics(), start, &[end]).unwrap();
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
fn corners_have_neither_false_zeros_nor_missed_ones() {
    let mut random = Random(0x9E37_79B9_7F4A_7C15);
    for case in 0..120 {
        let mut model = Particle {
            a: [0.0; 5].map(|_| random.dyadic()),
            b: [0.0; 4].map(|_| 4.0 * random.dyadic()),
            c: [0.0; 4].map(|_| random.dyadic().abs()),
        };
        // No zero at a corner: those of the grid have denominators up to 64.
        model.c[3] += 1.0 / 1024.0;
        let [c0, c1, c2, _] = model.c;
        let mut corners = vec![c0];
        for s in [-1.0, 1.0] {
            corners.push(c0 + s * c1);
            corners.extend([c0 + s * (c1 + c2), c0 + s * (c1 - c2)]);
        }
        let zigzag = changes(|x| model.zigzag(x), corners, 1.0);
        let mut corners = Vec::new();
        let lines: Vec<_> = (0..5)
            .map(|i| (model.a[i], model.b.get(i).copied().unwrap_or(0.0)))
            .collect();
        for (i, (a, b)) in lines.iter().enumerate() {
            for (other, slope) in &lines[..i] {
                if slope != b {
                    corners.push((a - other) / (slope - b));
                }
            }
        }
        let tree = changes(|x| model.tree(x), corners, 1.0);
        let steps = [f64::INFINITY, 0.3, 0.0625][case % 3];
        let method = Taylor::new().max_step(steps.min(1e3));
        for (index, expected, what) in [
            (Particle::ZIGZAG, zigzag, "zigzag"),
            (Particle::TREE, tree, "tree"),
        ] {
            let at_edge = |t: f64| t < 1e-9 || t > 1.0 - 1e-9;
            let value = if index == Particle::TREE {
                model.tree(0.0)
            } else {
                model.zigzag(0.0)
            };
            if value == 0.0 || expected.iter().any(|(t, _)| at_edge(*t)) {
                continue;
            }
            // Zeros of two branches at one place are not told apart.
            if expected.windows(2).any(|pair| pair[1].0 - pair[0].0 < 1e-6) {
                continue;
            }
            for (event, wanted) in [
                (Event::rising(), Some(true)),
                (Event::falling(), Some(false)),
                (Event::either(), None),
            ] {
                let times = expected
                    .iter()
                    .filter(|(_, rises)| wanted.is_none_or(|wanted| wanted == *rises));
                let times: Vec<f64> = times.map(|(t, _)| *t).collect();
                let found = found(&method, &model, index, event, 0.0, 1.0);
                if found.len() > times.len() {
                    // A zero that is touched at a corner counts as reached; it is no change of sign.
                    let function = |x: f64| {
                        if index == Particle::TREE {
                            model.tree(x)
                        } else {
                            model.zigzag(x)
                        }
                    };
                    let more: Vec<_> = found
                        .iter()
                        .filter(|t| times.iter().all(|u| (**t - u).abs() > 1e-12))
                        .collect();
                    assert!(
                        more.iter().all(|t| function(**t).abs() < 1e-13),
                        "case {case}, {what} {event:?} of {model:?}: {found:?} {times:?}"
                    );
                    continue;
                }
                compare(
                    &format!("case {case}, {what}, {event:?}"),
                    &model,
                    &found,
                    &times,
                    1e-13,
                );
            }
        }
    }
}

/// |u| touches zero at its corner once, from above; a small constant lifts it off, or splits the zero into two.
#[test]
fn a_corner_at_zero_is_reached_once() {
    let lifted = |lift: f64, index: usize, event: Event| {
        let model = Particle {
            a: [0.0; 5],
            b: [0.0; 4],
            c: [0.375, 0.0, 0.0, lift],
        };
        found(&Taylor::new(), &model, index, event, 0.0, 1.0)
    };
    for (event, touches) in [
        (Event::either(), 1),
        (Event::falling(), 1),
        (Event::rising(), 0),
    ] {
        let times = lifted(0.0, Particle::ZIGZAG, event);
        assert_eq!(times.len(), touches, "{event:?} {times:?}");
        assert!(times.iter().all(|t| (t - 0.375).abs() < 1e-13));
    }
    for lift in [1e-12, 1e-9, 1e-6, 1e-3] {
        assert!(lifted(-lift, Particle::ZIGZAG, Event::either()).is_empty());
        let times = lifted(lift, Particle::ZIGZAG, Event::either());
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
            &Taylor::new(),
            &model,
            Particle::ZIGZAG,
            Event::either(),
            0.25,
            1.0,
        );
        assert_eq!(times.len(), 1, "{lift:e} {times:?}");
        assert!((times[0] - 0.25 - lift).abs() < 1e-14);
    }
}

/// Jumps of a product of signs are changes of sign; the inverse sine tells where a bent wave has its zeros.
#[test]
fn jumps_and_bent_waves() {
    let mut random = Random(7);
    for case in 0..30 {
        let mut c = [0.0; 4].map(|_| 0.05 + 0.9 * random.uniform());
        c[2] = 0.5;
        let model = Particle {
            a: [0.0; 5],
            b: [0.0; 4],
            c,
        };
        let [low, high] = [c[0].min(c[1]), c[0].max(c[1])];
        let method = Taylor::new();
        let falls = found(&method, &model, Particle::SIGNS, Event::falling(), 0.0, 1.0);
        let rises = found(&method, &model, Particle::SIGNS, Event::rising(), 0.0, 1.0);
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
        let times = found(&method, &model, Particle::BENT, Event::either(), 0.0, 1.0);
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
fn clusters_of_zeros_are_counted_with_their_multiplicities() {
    let mut random = Random(99);
    for case in 0..120 {
        let mut roots = Vec::new();
        while roots.len() < 4 {
            let root: f64 = (8.0 + 48.0 * random.uniform()).round() / 64.0;
            let copies = 1 + random.below(3);
            let apart = [0.0, 1e-4, 1e-2][random.below(3) as usize];
            for i in 0..copies {
                roots.push(root + apart * i as f64);
            }
        }
        roots.truncate(4);
        // The order of factors does not matter.
        let swap = random.below(4) as usize;
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
        let mut groups: Vec<(f64, usize)> = Vec::new();
        for root in roots {
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
        let max_step = [10.0, 0.25, 1.0 / 64.0][case % 3];
        let method = Taylor::new().max_step(max_step);
        for (event, expected) in [
            (Event::either(), all),
            (Event::falling(), falling),
            (Event::rising(), rising),
        ] {
            let times = found(&method, &model, Particle::CLUSTER, event, 0.0, 1.0);
            // A triple zero is known to a third of the digits, a fourfold one to a quarter.
            compare(
                &format!("case {case}, {event:?}"),
                &model,
                &times,
                &expected,
                2e-4,
            );
        }
    }
}

/// A particle in a box whose walls are events, as it is unfolded: two walls or three are met at once where lines of a
/// lattice cross.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(r: Vector3),
    kinetic = 0.5 * dot(r).norm_squared(),
    event(low = r, high = [size - r.x, size - r.y, size - r.z]),
)]
struct Box3 {
    size: f64,
}

/// The distance from 0 of a point that goes to and fro between 0 and 1.
fn folded(x: f64) -> f64 {
    let rest = x.rem_euclid(2.0);
    if rest > 1.0 { 2.0 - rest } else { rest }
}

fn in_a_box<I>(method: &I, error: f64)
where
    I: IntegrationMethod + for<'a> Integrator<f64, lagrangian::EquationsOfMotion<'a, Box3, f64, 3>>,
{
    let mut random = Random(12345);
    for case in 0..30 {
        // Commensurable: the corners of the lattice are met exactly.
        let place = [0.0; 3].map(|_| (1.0 + random.below(7) as f64) / 8.0);
        let speed = [0.0; 3].map(|_| (random.below(17) as f64 - 8.0) / 4.0);
        let events: [(usize, Event); 6] = core::array::from_fn(|i| (i, Event::falling()));
        let start = State::new(0.0, place, speed);
        let driver = method.driver().declared_events(events);
        let room = Box3 { size: 1.0 };
        let mut dynamics = room.dynamics();
        let times = [0.9, 3.3, 7.7];
        let motion = driver
            .sample_reacting(&mut dynamics, start, &times, |event, _, x, _| {
                x.v[event % 3] *= -1.0;
                Reaction::Changed
            })
            .unwrap();
        let mut hits = Vec::new();
        for i in 0..3 {
            for (sample, time) in motion.samples().iter().zip(times) {
                let expected = folded(place[i] + speed[i] * time);
                let found = sample.x.q[i];
                assert!(
                    (found - expected).abs() <= error,
                    "case {case}: {found} {expected}"
                );
            }
            if speed[i] != 0.0 {
                for wall in -20..20 {
                    let time = (f64::from(wall) - place[i]) / speed[i];
                    if time > 0.0 && time < 7.7 {
                        let index = if wall % 2 == 0 { i } else { 3 + i };
                        hits.push((time, index));
                    }
                }
            }
        }
        hits.sort_by(|a, b| a.0.total_cmp(&b.0));
        assert_eq!(
            motion.events().len(),
            hits.len(),
            "case {case} {place:?} {speed:?}"
        );
        for (found, (time, _)) in motion.events().iter().zip(&hits) {
            assert!(
                (found.t - time).abs() <= error,
                "case {case}: {} {time}",
                found.t
            );
        }
        for wall in 0..6 {
            let found = motion
                .events()
                .iter()
                .filter(|occurrence| occurrence.event == wall)
                .count();
            let expected = hits.iter().filter(|(_, index)| *index == wall).count();
            assert_eq!(found, expected, "case {case}, wall {wall}");
        }
        for pair in motion.events().windows(2) {
            let in_order =
                pair[0].t < pair[1].t || pair[0].t <= pair[1].t && pair[0].event < pair[1].event;
            assert!(in_order, "case {case}");
        }
    }
}

#[test]
fn a_particle_in_a_box_meets_walls_edges_and_corners() {
    in_a_box(&Taylor::new(), 1e-12);
    in_a_box(&Dop853::new(), 1e-9);
}

/// A particle in a field that each passage of a place reverses: a parameter changes, the state does not.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = -m * field * x,
    event(gate = x - place, late = t - when),
)]
struct Gate {
    m: f64,
    field: f64,
    place: f64,
    when: f64,
}

/// The next time at which x + v s + ½ f s² is zero.
fn next_zero(x: f64, v: f64, f: f64) -> f64 {
    let discriminant = v * v - 2.0 * f * x;
    if discriminant < 0.0 {
        return f64::INFINITY;
    }
    let root = discriminant.sqrt();
    let sum = -(v + root.copysign(v));
    let roots = [sum / f, 2.0 * x / sum];
    roots
        .into_iter()
        .filter(|s| *s > 1e-9)
        .fold(f64::INFINITY, f64::min)
}

#[test]
fn reactions_that_change_parameters_follow_the_parabolas() {
    let mut random = Random(4711);
    for case in 0..60 {
        let field = 0.5 + random.uniform();
        let [x, v] = [1.0 + random.uniform(), 2.0 * random.uniform() - 1.0];
        let mut dynamics = Gate {
            m: 0.7,
            field: -field,
            place: 0.0,
            when: 1.0,
        }
        .into_dynamics();
        let driver = Taylor::new()
            .driver()
            .declared_events([(Gate::GATE, Event::either()), (Gate::LATE, Event::rising())]);
        let start = State::new(0.0, [x], [v]);
        let mut lates = 0;
        let motion =
            driver.sample_reacting(&mut dynamics, start, &[6.0], |event, t, _, dynamics| {
                dynamics.change(|gate| {
                    if event == 0 {
                        gate.field *= -1.0;
                    } else {
                        lates += 1;
                        assert!((t - f64::from(lates)).abs() < 1e-14);
                        gate.when += 1.0;
                    }
                });
                Reaction::Changed
            });
        let motion = motion.unwrap();
        let (mut t, mut x, mut v, mut f) = (0.0, x, v, -field);
        let mut expected = Vec::new();
        loop {
            let s = next_zero(x, v, f);
            let until = s.min(6.0 - t);
            (x, v) = (x + v * until + 0.5 * f * until * until, v + f * until);
            t += until;
            if s > until {
                break;
            }
            (x, f) = (0.0, -f);
            expected.push(t);
        }
        let found: Vec<f64> = motion
            .events()
            .iter()
            .filter(|o| o.event == 0)
            .map(|o| o.t)
            .collect();
        assert_eq!(
            found.len(),
            expected.len(),
            "case {case}: {found:?} {expected:?}"
        );
        for (found, expected) in found.iter().zip(&expected) {
            assert!(
                (found - expected).abs() < 1e-11,
                "case {case}: {found} {expected}"
            );
        }
        assert!((motion.last().x.q[0] - x).abs() < 1e-10, "case {case}");
        // At the end itself there is one more or not.
        assert!(lates == 5 || lates == 6, "case {case}: {lates}");
    }
}

/// Steps that end where a function has its zero, to rounding on either side: nothing is lost or counted twice between
/// steps, nor where an integration is stopped and goes on there.
#[test]
fn zeros_at_the_ends_of_steps_are_counted_once() {
    for event in [Event::rising(), Event::either()] {
        for parts in [1.0, 3.0, 7.0, 10.0, 64.0] {
            for n in [1, 2, 3, 5, 11, 23] {
                let step = 1.0 / parts;
                let place = f64::from(n) * step;
                for place in [place.next_down(), place, place.next_up()] {
                    let dynamics = Gate {
                        m: 1.0,
                        field: 0.0,
                        place,
                        when: place,
                    };
                    let dynamics = dynamics.dynamics();
                    let driver = || {
                        Taylor::new()
                            .max_step(step)
                            .driver()
                            .declared_events([(Gate::LATE, event), (Gate::GATE, event)])
                    };
                    let start = State::new(0.0, [0.0], [1.0]);
                    let end = place + 2.5 * step;
                    let whole = driver().sample(&dynamics, start, &[end]).unwrap();
                    assert_eq!(whole.events().len(), 2, "{event:?} {parts} {n} {place}");
                    let mut seen = 0;
                    let observer = |progress: &Progress<'_, Phase<f64, 1>>| {
                        seen += usize::from(matches!(progress.kind, ObservationKind::Event(_)));
                        core::ops::ControlFlow::Continue(())
                    };
                    let mut running = driver().observe(observer).start(&dynamics, start).unwrap();
                    while running.step_towards(end).unwrap().is_some() {}
                    drop(running);
                    assert_eq!(seen, 2, "step by step: {event:?} {parts} {n} {place}");
                }
            }
        }
    }
}
