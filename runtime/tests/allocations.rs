//! No step allocates, by any method: event functions, observers, interpolation and checkpoints included. The list of events
//! grows where one occurs.

mod common;

use std::hint::black_box;

use allocation_counter::measure;
use common::Oscillator;
use lagrangian::prelude::*;
use lagrangian::{DenseOutput, Resume};

/// How often `work` allocates.
fn allocations<T>(mut work: impl FnMut() -> T) -> u64 {
    measure(|| {
        black_box(work());
    })
    .count_total
}

fn problem() -> Problem<f64, Oscillator> {
    let x = SVector::from([1.0, 0.0]);
    Problem::new(Oscillator, At { t: 0.0, x })
}

fn does_not_allocate<I>(method: I)
where
    I: Integrator<f64, Oscillator> + Resume<f64, Oscillator> + Copy,
{
    let run = || problem().solve(30.0, method).unwrap();
    assert_eq!(allocations(run), 0);

    let run = || {
        let mut run = problem().start(method).unwrap();
        while run.step(5.0).unwrap().is_some() {}
        let middle = 0.5 * (run.previous_time() + run.state().t);
        let middle = run.at(middle).unwrap();
        run.change(|state, _| state.x = middle.x).unwrap();
        run.advance(9.0).unwrap();
        let mut resumed = problem().resume(run.checkpoint(), method).unwrap();
        resumed.advance(11.0).unwrap()
    };
    assert_eq!(allocations(run), 0);

    // Errors: one without a solution, and one that owns it.
    let x = SVector::from([1.0, 0.0]);
    let run = || {
        let never = Problem::new(Oscillator, At { t: f64::NAN, x });
        never.start(method).err().unwrap()
    };
    assert_eq!(allocations(run), 0);
    let run = || problem().solve(f64::NAN, method).unwrap_err();
    assert_eq!(allocations(run), 1);
}

/// The list of the events of a step is allocated where there are any, and nothing else.
fn lists_events_alone<I: Integrator<f64, Oscillator> + Copy>(method: I) {
    let (mut observed, mut events) = (0_u32, 0);
    let watched = problem()
        .when(|x| x[0])
        .rising()
        .record()
        .when(|x| x[1])
        .falling()
        .record()
        .when(|x| x.t - 20.0)
        .stop()
        .each_step(|_| observed += 1);
    let mut run = watched.start(method).unwrap();
    loop {
        let mut step = None;
        let count = allocations(|| {
            step = run.step(30.0).unwrap();
            let part = run.state().t - run.previous_time();
            [0.3, 0.75].map(|k| run.at(run.previous_time() + k * part).unwrap())
        });
        let step = step.unwrap();
        assert_eq!(count, u64::from(!step.events().is_empty()));
        events += step.events().len();
        if step.reason != StopReason::StepLimit {
            assert_eq!(step.reason, StopReason::Condition);
            break;
        }
    }
    drop(run);
    assert_eq!(events, 7);
    assert!(observed > 0);
}

#[test]
fn no_step_allocates() {
    assert!(
        allocations(|| vec![0_u8; 64]) > 0,
        "allocations are counted"
    );
    macro_rules! check {
        ($($method:expr),+ $(,)?) => {$(
            does_not_allocate($method);
            lists_events_alone($method);
        )+};
    }
    check!(
        RungeKutta::classical(0.01),
        Dop853::new(),
        Taylor::new(),
        Taylor::order_12(),
        Taylor::order_40(),
    );
}

/// A model with its pivots, angles and events.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(phi, theta, psi),
    kinetic = 0.5 * (i * (dot(phi).powi(2) * sin(theta).powi(2) + dot(theta).powi(2))
        + i_s * (dot(phi) * cos(theta) + dot(psi)).powi(2)),
    potential = weight * cos(theta),
)]
struct Top {
    i: f64,
    i_s: f64,
    weight: f64,
}

#[test]
fn no_step_of_a_model_allocates() {
    let top = Top {
        i: 1.2,
        i_s: 0.5,
        weight: 5.1,
    };
    let start = State::new(0.0, [0.0, 0.5, 0.0], [0.3, 0.0, 20.0]);
    // The event at which it stops is listed.
    let listed = || {
        let until = Problem::new(&top, start).when(|x| x.v[1] - 0.1);
        let end = until.falling().stop().solve(9.0, Dop853::new()).unwrap();
        assert_eq!(end.events().len(), 1);
        end
    };
    assert_eq!(allocations(listed), 1);
    let other = || Problem::new(&top, start).solve(9.0, Taylor::new()).unwrap();
    assert_eq!(allocations(other), 0);
    // The dense output of a step is a value.
    let last = || {
        let mut run = Problem::new(&top, start).start(Taylor::new()).unwrap();
        run.step(9.0).unwrap();
        let mut stepper = run.stepper().clone();
        stepper.interpolant(run.dynamics()).unwrap()
    };
    assert_eq!(allocations(last), 0);
}
