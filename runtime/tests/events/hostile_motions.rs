//! Reactions and zeros at the ends of steps against motions in closed form: particles in boxes, fields that switch.

use crate::directions::{Direction, directed};
use crate::random_numbers::Random;
use lagrangian::DeclaredEvent;
use lagrangian::prelude::*;

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

/// When which wall is hit until t = 7.7.
fn hits(place: [f64; 3], speed: [f64; 3]) -> Vec<(f64, usize)> {
    let mut hits = Vec::new();
    for i in (0..3).filter(|i| speed[*i] != 0.0) {
        for wall in -20..20 {
            let time = (f64::from(wall) - place[i]) / speed[i];
            if time > 0.0 && time < 7.7 {
                hits.push((time, if wall % 2 == 0 { i } else { 3 + i }));
            }
        }
    }
    hits.sort_by(|a, b| a.0.total_cmp(&b.0));
    hits
}

fn in_a_box<I>(method: I, cases: u32, error: f64)
where
    I: Copy + for<'a> Integrator<f64, lagrangian::EquationsOfMotion<&'a Box3, f64, 3>>,
{
    let mut random = Random(12345);
    for case in 0..cases {
        // Commensurable: the corners of the lattice are met exactly.
        let place = [0.0; 3].map(|_| (1.0 + f64::from(random.below(7))) / 8.0);
        let speed = [0.0; 3].map(|_| (f64::from(random.below(17)) - 8.0) / 4.0);
        let (room, start) = (Box3 { size: 1.0 }, State::new(0.0, place, speed));
        let bounce = |i: usize| move |x: &mut State<f64, 3>| x.v[i] *= -1.0;
        macro_rules! with_walls {
            ($($wall:literal)*) => {
                Problem::new(&room, start)$(.on(DeclaredEvent::new($wall)).falling().then(bounce($wall % 3)))*
            };
        }
        let times = [0.9, 3.3, 7.7];
        let motion = with_walls!(0 1 2 3 4 5).save(times);
        let motion = motion.solve(7.7, method).unwrap();
        for i in 0..3 {
            for (sample, time) in motion.samples().iter().zip(times) {
                let expected = folded(place[i] + speed[i] * time);
                let found = sample.x.q[i];
                assert!(
                    (found - expected).abs() <= error,
                    "case {case}: {found} {expected}"
                );
            }
        }
        let hits = hits(place, speed);
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
#[ignore = "a long sweep; run with `--include-ignored`"]
fn a_particle_in_a_box_meets_walls_edges_and_corners() {
    in_a_box(Taylor::new(), 30, 1e-12);
    in_a_box(Dop853::new(), 30, 1e-9);
}

#[test]
fn a_particle_in_a_box_meets_some_walls_edges_and_corners() {
    in_a_box(Taylor::new(), 8, 1e-12);
    in_a_box(Dop853::new(), 8, 1e-9);
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
        let gate = Gate {
            m: 0.7,
            field: -field,
            place: 0.0,
            when: 1.0,
        };
        let mut lates = 0;
        let motion = Problem::new(gate, State::new(0.0, [x], [v]))
            .on(Gate::GATE)
            .then_with(|_, dynamics| dynamics.change(|gate| gate.field *= -1.0))
            .on(Gate::LATE)
            .rising()
            .then_with(|x, dynamics| {
                lates += 1;
                assert!((x.t - f64::from(lates)).abs() < 1e-14);
                dynamics.change(|gate| gate.when += 1.0);
            })
            .solve(6.0, Taylor::new())
            .unwrap();
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
        assert!((motion.q[0] - x).abs() < 1e-10, "case {case}");
        // At the end itself there is one more or not.
        assert!(lates == 5 || lates == 6, "case {case}: {lates}");
    }
}

#[test]
#[ignore = "a long sweep; run with `--include-ignored`"]
fn zeros_at_the_ends_of_steps_are_counted_once() {
    count_zeros_at_the_ends_of_steps(&[1.0, 3.0, 7.0, 10.0, 64.0], &[1, 2, 3, 5, 11, 23]);
}

#[test]
fn some_zeros_at_the_ends_of_steps_are_counted_once() {
    count_zeros_at_the_ends_of_steps(&[3.0, 10.0, 64.0], &[1, 2, 5]);
}

/// Steps of these parts of a second, after so many of which a function has its zero, to rounding on either side: nothing is lost
/// or counted twice between steps, nor where an integration is stopped and goes on there.
fn count_zeros_at_the_ends_of_steps(parts: &[f64], numbers: &[u8]) {
    for direction in [Direction::Rising, Direction::Either] {
        for &parts in parts {
            for &n in numbers {
                let step = 1.0 / parts;
                let place = f64::from(n) * step;
                for place in [place.next_down(), place, place.next_up()] {
                    let gate = Gate {
                        m: 1.0,
                        field: 0.0,
                        place,
                        when: place,
                    };
                    let problem = Problem::new(&gate, State::new(0.0, [0.0], [1.0]));
                    let problem = directed!(direction, problem.on([Gate::LATE, Gate::GATE]));
                    let problem = problem.record();
                    let (method, end) = (Taylor::new().max_step(step), place + 2.5 * step);
                    let whole = problem.clone().solve(end, method).unwrap();
                    assert_eq!(whole.events().len(), 2, "{direction:?} {parts} {n} {place}");
                    let mut seen = 0;
                    let mut running = problem.start(method).unwrap();
                    while let Some(step) = running.step(end).unwrap() {
                        seen += step.events().len();
                    }
                    assert_eq!(seen, 2, "step by step: {direction:?} {parts} {n} {place}");
                }
            }
        }
    }
}
