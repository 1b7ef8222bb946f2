//! Declared events that have no series: they are sampled under the Taylor method, too.

use lagrangian::DeclaredEvent;
use lagrangian::prelude::*;

use crate::events::times;

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
    let motion = Problem::new(&model, State::new(0.0, [0.0], [1.0]))
        .on([External::OUTSIDE, External::BEYOND])
        .record()
        .solve(1.0, Taylor::new())
        .unwrap();
    assert!((times(&motion, 0)[0] - 0.5).abs() <= 1e-15);
    assert!((times(&motion, 1)[0] - 0.75).abs() <= 1e-15);
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
        let problem = Problem::new(&model, start).on(External::OUTSIDE).record();
        let problem = problem.on(DeclaredEvent::new(index)).falling().record();
        let error = problem.solve(1.0, Taylor::new()).unwrap_err().error();
        let expected = format!(
            "the model has no event {index}: its events are [\"outside\", \"beyond\"], which the constants of the model name"
        );
        assert_eq!(error.to_string(), expected);
    }
}
