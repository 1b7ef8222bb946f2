//! Motions of the shorter reduced form that run into a pole of its angle: an error there, with all that came before.

use lagrangian::StopReason;
use lagrangian::prelude::*;
use lagrangian_tests::assert_close;

use crate::models::{ReducedTop, TopThroughPoles, top};

const TEXT: &str = "of its angles: write `routhian(Name, half_angles)`";

/// A fast top with equal constants, which goes through the vertical, in both forms.
fn through_the_pole() -> (ReducedTop, TopThroughPoles) {
    let (shorter, _) = top().reduce(&State::new(0.0, [0.0, 0.5, 0.0], [0.0, 0.0, 40.0]));
    let ReducedTop {
        i,
        i_s,
        m,
        g,
        l,
        p_psi,
        ..
    } = shorter;
    let p_phi = p_psi;
    (
        ReducedTop { p_phi, ..shorter },
        TopThroughPoles {
            i,
            i_s,
            m,
            g,
            l,
            p_phi,
            p_psi,
        },
    )
}

const START: [f64; 2] = [0.3, 0.0];

/// The time at which the top passes the vertical, by the form that goes on there, and its solution.
fn passage(complete: &TopThroughPoles) -> (f64, impl Fn(f64) -> f64 + '_) {
    let start = State::new(0.0, [START[0]], [START[1]]);
    let angle = move |t: f64| {
        let end = Problem::new(complete, start).solve(t, Taylor::new());
        end.unwrap().q[0]
    };
    let (mut before, mut after) = (0.0, 0.6);
    assert!(angle(after) < 0.0);
    while after - before > 1e-13 {
        let middle = 0.5 * (before + after);
        *if angle(middle) > 0.0 {
            &mut before
        } else {
            &mut after
        } = middle;
    }
    (before, angle)
}

/// An error that names the pole, there or so near to it that the digits of the method are lost. The time.
fn assert_at_pole(error: IntegrationError, expected: f64, tolerance: f64) -> f64 {
    let IntegrationError::SingularConfiguration {
        time, singularity, ..
    } = error
    else {
        panic!("{error}");
    };
    assert_eq!(singularity.coordinate(), "theta");
    let (_, theta) = singularity.coordinates().next().unwrap();
    assert!(theta.abs() < 1.6e-3, "{theta}");
    // It moves by some 1.3 a second.
    let near = tolerance + 2.0 * theta.abs();
    assert!((time - expected).abs() < near, "{time} {expected}");
    assert!(error.to_string().contains(TEXT), "{error}");
    time
}

/// Samples, the dense solution and events up to the pole are kept.
#[test]
fn a_motion_into_the_pole_ends_there_with_all_that_came_before() {
    let (shorter, complete) = through_the_pole();
    let (expected, angle) = passage(&complete);
    let start = State::new(0.0, [START[0]], [START[1]]);
    let times: Vec<f64> = (0..=1000).map(|k| 0.6 * f64::from(k) / 1000.0).collect();
    let problem = || Problem::new(&shorter, start);
    let through = Problem::new(&complete, start).save(&times);
    let through = through.solve(0.6, Taylor::new()).unwrap();
    macro_rules! assert_kept {
        ($method:expr, $tolerance:expr) => {{
            let partial = problem().save(&times).solve(0.6, $method).unwrap_err();
            let time = assert_at_pole(partial.error(), expected, $tolerance);
            let kept = times.iter().filter(|t| **t < time).count();
            let motion = partial.solution();
            assert_eq!(motion.samples().len(), kept);
            for (sample, expected) in motion.samples().iter().zip(through.samples()) {
                assert_close("θ", &[sample.q[0]], &[expected.q[0]], $tolerance);
            }
            let last = motion.q[0];
            assert!((0.0..1.6e-3).contains(&last), "{last}");

            let partial = problem()
                .when(|x| [x.q[0] - 0.1, x.q[0] - 0.01])
                .falling()
                .record()
                .solve(0.6, $method)
                .unwrap_err();
            let found = partial.solution().events().iter();
            let found: Vec<f64> = found.map(|event| event.x.q[0]).collect();
            assert_close("events", &found, &[0.1, 0.01], $tolerance);

            // An event before the pole ends the motion without an error.
            let ending = problem().when(|x| x.q[0] - 0.01).stop();
            let end = ending.solve(0.6, $method).unwrap();
            assert_eq!(end.reason, StopReason::Condition);
        }};
    }
    macro_rules! assert_solved {
        ($method:expr, $tolerance:expr) => {{
            let partial = problem().save(Dense).solve(0.6, $method).unwrap_err();
            let solution = partial.solution();
            let near = assert_at_pole(partial.error(), expected, $tolerance) - 1e-6;
            let found = solution.at(near).unwrap().q[0];
            assert_close("θ", &[found], &[angle(near)], $tolerance);
            assert!(solution.at(expected + 1e-3).is_err());
        }};
    }
    assert_solved!(Taylor::new(), 1e-9);
    assert_solved!(Dop853::new(), 1e-6);
    assert_kept!(Taylor::new(), 1e-9);
    assert_kept!(Taylor::order_12(), 1e-6);
    assert_kept!(Dop853::new(), 1e-6);
    assert_kept!(RungeKutta::classical(0.01), 1e-3);
}

/// Along a reconstruction, backwards, in an ensemble, and on a motion that is stepped.
#[test]
fn every_way_to_integrate_notices_the_pole() {
    let (shorter, complete) = through_the_pole();
    let (expected, _) = passage(&complete);
    let start = State::new(0.0, [START[0]], [START[1]]);
    let there = At::from((start, [0.0; 2]));
    let partial = Problem::new(shorter.reconstruction(), there).solve(0.6, Taylor::new());
    assert_at_pole(partial.unwrap_err().error(), expected, 1e-9);
    // The motion begins at rest, so that it is the same in both directions of time.
    let partial = Problem::new(&shorter, start).solve(-0.6, Dop853::new());
    assert_at_pole(partial.unwrap_err().error(), -expected, 1e-6);

    let starts = [0.3, 0.2, 0.25, 0.1, 0.28].map(|q| (State::new(0.0, [q], [0.0]), 0.6));
    let problems = starts.map(|(start, _)| Problem::new(&shorter, start));
    let ends = Ensemble::new(problems).solve(0.6, Dop853::new());
    assert_eq!(ends.len(), 5);
    for end in ends {
        let error = end.unwrap_err();
        assert!(error.to_string().contains(TEXT), "{error}");
    }

    let mut run = Problem::new(&shorter, start).start(Taylor::new()).unwrap();
    let partial = loop {
        if let Err(partial) = run.step(0.6) {
            break partial;
        }
    };
    assert_at_pole(partial.error(), expected, 1e-9);
    let last = run.state();
    assert!(last.q[0] > 0.0 && last.t < expected);
}

/// Near the pole the digits are lost before: an error, too. A motion that stays away from it is none, however often it turns.
#[test]
fn lost_digits_near_the_pole_are_an_error() {
    let (shorter, _) = through_the_pole();
    let near = State::new(0.0, [1e-6], [0.0]);
    let error = Problem::new(&shorter, near).solve(0.1, Dop853::new());
    let error = error.unwrap_err();
    let text = "the reduced model loses its digits at theta = 1e-6, near a pole of its angles: write \
                `routhian(Name, half_angles)`";
    assert!(error.to_string().contains(text), "{error}");
    // Who knows better may say so.
    let start = State::new(0.0, [START[0]], [START[1]]);
    let unchecked = Problem::new(&shorter, start).singularity_tolerance(f64::INFINITY);
    assert!(unchecked.solve(0.6, Dop853::new()).is_ok());
    // Constants that differ keep the top away from the vertical.
    let mut kept = shorter;
    kept.p_phi *= 0.99;
    let end = Problem::new(&kept, start).solve(50.0, Taylor::new());
    assert!(end.unwrap().q[0] > 0.0);
    // The angle may be at another turn.
    let turned = State::new(0.0, [0.3 - core::f64::consts::TAU], [0.0]);
    let error = Problem::new(&through_the_pole().0, turned).solve(0.6, Taylor::new());
    let error = error.unwrap_err();
    assert!(error.to_string().contains("theta = -6.28"), "{error}");
}
