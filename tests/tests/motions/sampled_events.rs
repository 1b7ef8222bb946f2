//! Declared events that have no series: they are sampled under the Taylor method, too.

use lagrangian::prelude::*;

/// The times of one event.
fn times<X>(motion: &[Occurrence<X>], event: usize) -> Vec<f64> {
    let events = motion.iter().filter(|occurrence| occurrence.event == event);
    events.map(|occurrence| occurrence.t).collect()
}

fn ramp<S: Scalar>(x: S) -> S {
    x - S::from_f64(0.5)
}

/// Events with external functions of unknown derivatives are sampled, and so is then one with an input.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(x),
    function(ramp(x) = ramp(x)),
    kinetic = 0.5 * m * dot(x).powi(2),
    event(outside = ramp(x), beyond = x - limit),
)]
struct External {
    m: f64,
    #[lagrangian(input)]
    limit: f64,
}

#[test]
fn events_with_external_functions_are_sampled() {
    let model = External {
        m: 1.0,
        limit: 0.75,
    };
    let driver = Taylor::new().driver().declared_events([
        (External::OUTSIDE, Event::either()),
        (External::BEYOND, Event::either()),
    ]);
    let start = State::new(0.0, [0.0], [1.0]);
    let motion = driver.sample(&model.dynamics(), start, &[1.0]).unwrap();
    assert!((times(motion.events(), 0)[0] - 0.5).abs() <= 1e-15);
    assert!((times(motion.events(), 1)[0] - 0.75).abs() <= 1e-15);
}

/// An index that no event has is an error before the first step.
#[test]
fn events_of_another_model_are_refused() {
    let model = External {
        m: 1.0,
        limit: 0.75,
    };
    let start = State::new(0.0, [0.0], [1.0]);
    for index in [2, 7] {
        let driver = Taylor::new()
            .driver()
            .declared_events([(0, Event::either()), (index, Event::falling())]);
        let error = driver.run_until(&model.dynamics(), start, 1.0);
        let error = error.unwrap_err();
        let expected = format!(
            "the model has no event {index}: its events are [\"outside\", \"beyond\"], with the constants of the model \
             as their indices"
        );
        assert_eq!(error.to_string(), expected);
    }
}
