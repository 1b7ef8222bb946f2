//! Declared events of models whose inputs are held, driven by signals, or set by control laws, and of models with sizes.

use lagrangian::SetTypicalSizes;
use lagrangian::prelude::*;
use lagrangian::signals::{Constant, Polynomial, Sinusoid, Sum};
use lagrangian_tests::assert_close;

use crate::events::times;

/// A carriage that is pushed, and what it meets: events with inputs, with an external function of one, and without.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(x),
    function(wave(x) = wave(x), derivative(x) = slope(x)),
    function(slope(x) = slope(x), derivative(x) = -4.0 * wave(x)),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = push),
    event(
        gate = x - place,
        twice = (x - place) * (x - place - 1e-4),
        touch = (x - place).powi(2),
        wavy = x - 0.5 * wave(place),
        still = dot(x),
    ),
)]
struct Carriage {
    m: f64,
    #[lagrangian(input)]
    push: f64,
    #[lagrangian(input)]
    place: f64,
}

fn wave<S: Scalar>(x: S) -> S {
    (x + x).sin()
}

fn slope<S: Scalar>(x: S) -> S {
    let two = S::one() + S::one();
    two * (two * x).cos()
}

const CARRIAGE: Carriage = Carriage {
    m: 1.0,
    push: 0.0,
    place: 100.0,
};

/// At rest at x = 1.
fn start() -> State<f64, 1> {
    State::new(0.0, [1.0], [0.0])
}

/// x = 1 + t²/2 under held inputs meets x = 3 at t = 2, and x = 3.0001 soon after; nothing is sampled that finely.
#[test]
fn held_inputs_are_those_of_events() {
    let held = CARRIAGE.with_inputs([1.0, 3.0]);
    let fields = Carriage {
        push: 1.0,
        place: 3.0,
        ..CARRIAGE
    };
    let after = (4.0 + 2e-4_f64).sqrt();
    let events = [
        (Carriage::GATE, vec![2.0], 1e-14),
        (Carriage::TWICE, vec![2.0, after], 1e-10),
        (Carriage::TOUCH, vec![2.0], 1e-6),
    ];
    for (event, expected, tolerance) in events {
        let motion = Problem::new(&held, start()).on(event).record();
        let motion = motion.solve(3.0, Taylor::new()).unwrap();
        assert_close("held", &times(&motion, 0), &expected, tolerance);
        let motion = Problem::new(&fields, start()).on(event).record();
        let motion = motion.solve(3.0, Taylor::new()).unwrap();
        assert_close("fields", &times(&motion, 0), &expected, tolerance);
    }
}

/// x = 1 meets the gate 1 + sin 3t − ½ where sin 3t = ½.
#[test]
fn signals_move_events() {
    let gate = Sinusoid {
        amplitude: 1.0,
        angular_frequency: 3.0,
        phase: 0.0,
    };
    let third = core::f64::consts::FRAC_PI_6 / 3.0;
    let expected = [third, 5.0 * third, 13.0 * third, 17.0 * third];
    let driven = || {
        let problem =
            Problem::new(&CARRIAGE, start()).driven_by((Constant(0.0), Sum((gate, Constant(0.5)))));
        problem.on(Carriage::GATE).record()
    };
    let motion = driven().solve(4.0, Taylor::new()).unwrap();
    assert_close("Taylor", &times(&motion, 0), &expected, 1e-14);
    let motion = driven().solve(4.0, Dop853::new()).unwrap();
    assert_close("sampled", &times(&motion, 0), &expected, 1e-9);
}

/// The gate touches the carriage once in each period, and nothing changes its sign; sampling does not see that.
#[test]
fn tangencies_with_signals_are_found_under_taylor_alone() {
    let gate = Sinusoid {
        amplitude: 1.0,
        angular_frequency: 3.0,
        phase: 0.0,
    };
    let quarter = core::f64::consts::FRAC_PI_2 / 3.0;
    let driven = || {
        let problem = Problem::new(&CARRIAGE, start()).driven_by((Constant(0.0), gate));
        problem.on(Carriage::GATE).record()
    };
    let motion = driven().solve(4.0, Taylor::new()).unwrap();
    assert_close(
        "Taylor",
        &times(&motion, 0),
        &[quarter, 5.0 * quarter],
        1e-7,
    );
    let motion = driven().solve(4.0, Dop853::new()).unwrap();
    assert!(times(&motion, 0).is_empty());
}

/// x = 1 + t²/2 − t³/6 under the push 1 − t, and an external function of a signal.
#[test]
fn signals_push_and_functions_of_them_have_series() {
    let motion = Problem::new(&CARRIAGE, start())
        .driven_by((Polynomial([1.0, -1.0]), Polynomial([0.0, 1.0])))
        .on([Carriage::WAVY, Carriage::STILL])
        .record()
        .solve(6.0, Taylor::new())
        .unwrap();
    let (wavy, still) = (times(&motion, 0), times(&motion, 1));
    assert_close("still", &still, &[2.0], 1e-14);
    assert!(!wavy.is_empty());
    let values = wavy
        .iter()
        .map(|t| 1.0 + t * t / 2.0 - t.powi(3) / 6.0 - 0.5 * (2.0 * t).sin());
    for value in values {
        assert!(value.abs() < 1e-13, "{value:e}");
    }
}

/// u = (−x, x + ½ − t): x = cos t, and the gate is at t = ½.
#[test]
fn control_laws_set_the_inputs_of_events() {
    let motion = Problem::new(&CARRIAGE, start())
        .feedback(|x| [-x.q[0], x.q[0] + 0.5 - x.t])
        .on([Carriage::GATE, Carriage::STILL])
        .rising()
        .record()
        .solve(6.0, Dop853::new())
        .unwrap();
    assert_close("gate", &times(&motion, 0), &[0.5], 1e-13);
    assert_close("still", &times(&motion, 1), &[core::f64::consts::PI], 1e-9);
}

/// A controller that integrates the position: z = ∫ x dt, and the gate is where z = x + 2, t = 3 for x = 1.
#[test]
fn controllers_set_the_inputs_of_events() {
    let motion = Problem::new(&CARRIAGE, start())
        .feedback_with_states([0.0], |x, z| ([0.0, z[0] - 2.0], [x.q[0]]))
        .on(Carriage::GATE)
        .record()
        .solve(6.0, Dop853::new())
        .unwrap();
    assert_close("gate", &times(&motion, 0), &[3.0], 1e-13);
}

#[test]
fn sizes_leave_events_as_they_are() {
    let fields = Carriage {
        push: 1.0,
        place: 3.0,
        ..CARRIAGE
    };
    let equations = fields.dynamics();
    let pair = Problem::new(equations.with_sizes([10.0]), start())
        .on(Carriage::TWICE)
        .record();
    let motion = pair.solve(3.0, Taylor::new()).unwrap();
    assert_close(
        "pair",
        &times(&motion, 0),
        &[2.0, (4.0 + 2e-4_f64).sqrt()],
        1e-10,
    );
}
