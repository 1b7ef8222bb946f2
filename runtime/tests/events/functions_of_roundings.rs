//! Event functions that rounding makes zero, or not zero, near the ends of runs.

#![allow(clippy::unreadable_literal)] // Numbers of generated motions.

use lagrangian::prelude::*;

/// A stone whose event function is zero twice at nearly one place, where x² and x cancel to some roundings.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = k * x,
    event(near = x.powi(2) + x - height),
)]
struct Passing {
    m: f64,
    k: f64,
    height: f64,
}

/// A motion, the ends of its runs, and whether they stop at events, too: where the function is rounded between its zero and the stop,
/// it is zero once more behind that.
type Passes = (Passing, State<f64, 1>, &'static [f64], bool);

/// Made by a generator of motions.
fn passes() -> [Passes; 4] {
    let passing = |m, k, height| Passing { m, k, height };
    [
        (
            passing(2.7, 2.087024555069434, -0.24999944019260698),
            State::new(
                -0.13906214945047823,
                [-0.6028319240392666],
                [1.7778838839658762],
            ),
            &[-0.08004463746006124, 3.1998268153397795],
            true,
        ),
        (
            passing(2.7, 2.087024555069434, -0.24999944019260698),
            State::new(
                -0.13906214945047823,
                [-0.6028319240392666],
                [1.7778838839658762],
            ),
            &[
                -0.0809083143566686,
                -0.08004463746003676,
                -0.08004463746003673,
                3.1998268153397795,
            ],
            false,
        ),
        (
            passing(2.094979057031792, 1.5, -0.2499758541695797),
            State::new(-1.8212595611993856, [-0.060215903728384035], [0.0]),
            &[
                -0.7191137281690557,
                -0.7191137281690515,
                -0.7191137281690512,
                -0.70,
            ],
            true,
        ),
        (
            passing(2.074596697954788, 0.6478584632433317, -0.2499998971645968),
            State::new(
                -0.5681254972032801,
                [0.08164259134833918],
                [-1.5731558205617167],
            ),
            &[
                -0.21086037205015792,
                0.12400835322563453,
                2.5927552232514666,
            ],
            true,
        ),
    ]
}

#[test]
fn zeros_of_a_pair_that_are_known_to_roundings_are_reported_once() {
    for (model, start, ends, is_stopped) in passes() {
        let [mut last, mut stopped] = [start; 2];
        let [mut seen, mut stops] = [const { Vec::new() }; 2];
        for end in ends.iter().copied() {
            let motion = Problem::new(&model, last)
                .on(Passing::NEAR)
                .falling()
                .record()
                .on(Passing::NEAR)
                .rising()
                .record()
                .solve(end, Taylor::new())
                .unwrap();
            seen.extend(motion.events().iter().map(|event| event.event));
            last = motion.last;
            while stopped.t < end {
                let motion = Problem::new(&model, stopped)
                    .on(Passing::NEAR)
                    .falling()
                    .stop()
                    .on(Passing::NEAR)
                    .rising()
                    .stop()
                    .solve(end, Taylor::new())
                    .unwrap();
                stops.extend(motion.met.indices());
                stopped = motion.last;
            }
        }
        assert_eq!(seen, [0, 1], "{model:?}");
        if is_stopped {
            assert_eq!(stops, [0, 1], "{model:?}, stopped");
        }
    }
}

/// A sum of two components that are rounded alike.
#[derive(Lagrangian, Clone, Copy, Debug)]
#[lagrangian(
    taylor,
    coordinates(x, y),
    kinetic = 0.5 * (dot(x).powi(2) + dot(y).powi(2)),
    potential = wind * x,
    event(turning = dot(x) + x),
)]
struct Blown {
    wind: f64,
}

#[test]
fn a_reaction_one_rounding_before_the_end_is_made_once() {
    let blown = Blown {
        wind: 0.7580517238909138,
    };
    let start = State::new(
        -1.8215684452999041,
        [-2.211245056756958, 0.0],
        [1.6669904174939725, 0.0],
    );
    let (mut last, mut seen) = (start, 0);
    for end in [-0.6647199681899555, -0.5803254335133545, 3.2753344787038894] {
        let method = Dop853::new()
            .relative_tolerance(1e-11)
            .absolute_tolerance(1e-11)
            .max_step(0.08439453467659974);
        // It begins anew there, although nothing is changed.
        let problem = Problem::new(&blown, last)
            .on(Blown::TURNING)
            .then_with(|_, _| seen += 1);
        last = problem.solve(end, method).unwrap().last;
    }
    assert_eq!(seen, 2);
}
