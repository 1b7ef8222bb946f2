//! Steps do not depend on units: of time, of length where sizes are given, nor on where an ignorable coordinate is.

use crate::common::assert_close;
use lagrangian::EquationsOfMotion;
use lagrangian::prelude::*;

/// A bead on a spring that carries a pendulum, with a wheel that nothing acts upon.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x, theta, psi),
    kinetic = m * dot(x).powi(2) + m * l * cos(theta) * dot(x) * dot(theta)
        + 0.5 * m * (l * dot(theta)).powi(2) + 0.5 * j * dot(psi).powi(2),
    potential = 0.5 * k * x.powi(2) - m * g * l * cos(theta),
)]
#[derive(Clone)]
struct Bead {
    m: f64,
    l: f64,
    j: f64,
    k: f64,
    g: f64,
}

const BEAD: Bead = Bead {
    m: 0.7,
    l: 1.25,
    j: 0.3,
    k: 3.0,
    g: 9.81,
};

const START: ([f64; 3], [f64; 3]) = ([0.3, 2.0, 0.0], [0.0, 0.1, 5.0]);

/// The same motion in units of time that are `faster` times shorter.
fn faster(faster: f64) -> (Bead, State<f64, 3>, f64) {
    let (q, v) = START;
    let bead = Bead {
        k: BEAD.k * faster * faster,
        g: BEAD.g * faster * faster,
        ..BEAD
    };
    (
        bead,
        State::new(0.0, q, v.map(|v| v * faster)),
        12.0 / faster,
    )
}

type Ends = Vec<State<f64, 3>>;

/// The ends of all steps.
fn ends<I, D>(problem: Problem<f64, D>, end: f64, method: I) -> Ends
where
    D: Dynamics<State = Phase<f64, 3>>,
    I: Integrator<f64, D>,
{
    let motion = problem.save(StepEnds).solve(end, method).unwrap();
    motion.into_iter().skip(1).collect()
}

fn assert_same_bits(found: &Ends, expected: &Ends, unit: impl Fn(&State<f64, 3>) -> State<f64, 3>) {
    assert_eq!(found.len(), expected.len());
    assert!(expected.len() > 10);
    for (found, expected) in found.iter().zip(expected) {
        assert_eq!(unit(found), *expected);
    }
}

fn time_has_no_unit<I>(method: I)
where
    I: for<'a> Integrator<f64, EquationsOfMotion<&'a Bead, f64, 3>> + Copy,
{
    let (bead, start, end) = faster(1.0);
    let expected = ends(Problem::new(&bead, start), end, method);
    for exponent in [-30, -7, 3, 20] {
        let factor = f64::powi(2.0, exponent);
        let (bead, start, end) = faster(factor);
        let found = ends(Problem::new(&bead, start), end, method);
        assert_same_bits(&found, &expected, |sample| At {
            t: sample.t * factor,
            x: Phase::new(sample.x.q, sample.x.v / factor),
        });
    }
    // Other factors are rounded.
    for factor in [1e-3, 0.3, 1000.0, 31_557_600.0] {
        let (bead, start, end) = faster(factor);
        let found = ends(Problem::new(&bead, start), end, method);
        assert_eq!(found.len(), expected.len(), "{factor}");
        for (found, expected) in found.iter().zip(&expected) {
            assert_close(found.t * factor, expected.t, 1e-5);
        }
        let (found, expected) = (found.last().unwrap(), expected.last().unwrap());
        assert!((found.x.q - expected.x.q).norm() < 1e-7, "{factor}");
    }
}

#[test]
fn steps_do_not_depend_on_the_unit_of_time() {
    time_has_no_unit(Dop853::new());
    time_has_no_unit(
        Dop853::new()
            .relative_tolerance(1e-6)
            .absolute_tolerance(1e-9),
    );
    time_has_no_unit(Dop853::new().relative_tolerance(0.0));
    time_has_no_unit(Taylor::new());
    time_has_no_unit(Taylor::order_12().relative_tolerance(1e-7));
    time_has_no_unit(Taylor::order_16().absolute_tolerance(1e-11));
}

/// The motion from a start of which the bead is at rest where its coordinate is zero.
#[test]
fn the_first_step_from_rest_does_not_depend_on_the_unit_of_time() {
    let start = |factor: f64| {
        let (bead, _, end) = faster(factor);
        (bead, State::new(0.0, [0.0, 1.0, 0.0], [0.0; 3]), end)
    };
    let method = Dop853::new();
    let (bead, at_rest, end) = start(1.0);
    let expected = ends(Problem::new(&bead, at_rest), end, method);
    let (bead, at_rest, end) = start(4096.0);
    let found = ends(Problem::new(&bead, at_rest), end, method);
    assert_same_bits(&found, &expected, |sample| At {
        t: sample.t * 4096.0,
        x: Phase::new(sample.x.q, sample.x.v / 4096.0),
    });
}

/// x and l in other units of length, with the size of x in that unit.
#[test]
fn steps_do_not_depend_on_the_unit_of_length() {
    let (q, v) = START;
    let run = |length: f64, sized: bool, taylor: bool| {
        let bead = Bead {
            l: BEAD.l * length,
            g: BEAD.g * length,
            ..BEAD
        };
        let scaled = |x: [f64; 3]| [x[0] * length, x[1], x[2]];
        let start = State::new(0.0, scaled(q), scaled(v));
        let sizes = [if sized { length } else { 1.0 }, 1.0, 1.0];
        let dynamics = bead.dynamics();
        let problem = Problem::new(dynamics.with_sizes(sizes), start);
        if taylor {
            ends(problem, 12.0, Taylor::new())
        } else {
            ends(problem, 12.0, Dop853::new())
        }
    };
    for taylor in [false, true] {
        let expected = run(1.0, true, taylor);
        for length in [1024.0, f64::powi(2.0, -12)] {
            let found = run(length, true, taylor);
            assert_same_bits(&found, &expected, |sample| {
                let shorter = |x: SVector<f64, 3>| [x[0] / length, x[1], x[2]];
                At {
                    t: sample.t,
                    x: Phase::new(shorter(sample.x.q), shorter(sample.x.v)),
                }
            });
            assert_ne!(
                run(length, false, taylor)[4].t.to_bits(),
                found[4].t.to_bits()
            );
        }
    }
}

/// ψ and its velocity are neither seen by the tolerances nor by the motion.
#[test]
fn where_an_ignorable_coordinate_is_does_not_matter() {
    let (q, v) = START;
    let run = |psi: f64| {
        let start = State::new(0.0, [q[0], q[1], psi], v);
        ends(Problem::new(&BEAD, start), 12.0, Dop853::new())
    };
    let (near, far) = (run(0.0), run(1e9));
    assert_eq!(near.len(), far.len());
    for (near, far) in near.iter().zip(&far) {
        assert_close(near.t, far.t, 1e-9);
    }
}

/// A coordinate with a larger size takes longer steps; one of infinite size is left out.
#[test]
fn sizes_are_set_by_coordinate() {
    let (q, v) = START;
    let start = State::new(0.0, q, v);
    let count = |x: f64, theta: f64, relative: f64| {
        let mut sizes = [1.0; 3];
        sizes[Bead::X] = x;
        sizes[Bead::THETA] = theta;
        let dynamics = BEAD.dynamics();
        let method = Dop853::new()
            .absolute_tolerance(1e-9)
            .relative_tolerance(relative);
        let problem = Problem::new(dynamics.with_sizes(sizes), start);
        ends(problem, 12.0, method).len()
    };
    let both = count(1.0, 1.0, 0.0);
    assert!(count(1e3, 1e3, 0.0) * 3 < both * 2);
    assert!(count(1e-3, 1.0, 0.0) > both);
    let free = count(f64::INFINITY, 1.0, 0.0);
    assert!(free <= both && free > both / 2, "{free} {both}");
    // A controller has sizes of its own.
    let sizes: ([f64; 3], [f64; 2]) = ([1.0; 3], [1.0; 2]);
    let _: Phase<f64, 3, SVector<f64, 2>> = lagrangian::TypicalSizes::into_state(sizes);
}
