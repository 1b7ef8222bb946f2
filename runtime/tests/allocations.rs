//! No step allocates, by any method: event functions, observers, interpolation and checkpoints included.

mod common;

use std::hint::black_box;
use std::ops::ControlFlow;

use allocation_counter::measure;
use common::Oscillator;
use lagrangian::prelude::*;
use lagrangian::{DenseOutput, Event, Resume};

/// How often `work` allocates.
fn allocations<T>(mut work: impl FnMut() -> T) -> u64 {
    measure(|| {
        black_box(work());
    })
    .count_total
}

type X = SVector<f64, 2>;

fn start() -> (f64, X) {
    (0.0, SVector::from([1.0, 0.0]))
}

fn does_not_allocate<I>(method: &I)
where
    I: Integrator<f64, Oscillator> + Resume<f64, Oscillator> + IntegrationMethod,
{
    let run = || method.integrate_to(&Oscillator, start(), 30.0).unwrap();
    assert_eq!(allocations(run), 0);

    let mut crossings = 0_u32;
    let run = || {
        let watched = [
            Event::rising(),
            Event::falling(),
            Event::either().terminal(),
        ];
        let driver = method
            .driver()
            .events(watched, |t, x: &X| [x[0], x[1], t - 20.0]);
        let driver = driver.observe(|_: &Progress<'_, X>| {
            crossings += 1;
            ControlFlow::Continue(())
        });
        driver
            .run_through(&Oscillator, start(), &[3.0, 7.5, 30.0])
            .unwrap()
    };
    assert_eq!(allocations(run), 0);
    assert!(crossings > 0);

    let run = || {
        let mut running = method.driver().start(&Oscillator, start()).unwrap();
        for step in running.steps_to(5.0) {
            step.unwrap();
        }
        let middle = 0.5 * (running.previous_time() + running.time());
        let x = running.at(middle).unwrap();
        running.restart(x).unwrap();
        running.advance_to(9.0).unwrap();
        let checkpoint = running.checkpoint();
        let mut resumed = method.driver().resume(&Oscillator, checkpoint).unwrap();
        resumed.advance_to(11.0).unwrap()
    };
    assert_eq!(allocations(run), 0);

    // Errors, too.
    let run = || {
        method
            .integrate_to(&Oscillator, start(), f64::NAN)
            .unwrap_err()
    };
    assert_eq!(allocations(run), 0);
}

#[test]
fn no_step_allocates() {
    assert!(
        allocations(|| vec![0_u8; 64]) > 0,
        "allocations are counted"
    );
    does_not_allocate(&RungeKutta::classical(0.01));
    does_not_allocate(&Dop853::new());
    does_not_allocate(&Taylor::new());
    does_not_allocate(&Taylor::order_12());
    does_not_allocate(&Taylor::order_40());
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
    let one = || {
        let driver = Dop853::new().driver();
        let driver =
            driver.stop_at_crossing(Crossing::Falling, |_, x: &Phase<f64, 3>| x.v[1] - 0.1);
        driver.run_until(&top.dynamics(), start, 9.0).unwrap()
    };
    assert_eq!(allocations(one), 0);
    let other = || {
        Taylor::new()
            .integrate_to(&top.dynamics(), start, 9.0)
            .unwrap()
    };
    assert_eq!(allocations(other), 0);
    // The dense output of a step is a value.
    let last = || {
        let dynamics = top.dynamics();
        let mut running = Taylor::new().driver().start(&dynamics, start).unwrap();
        running.step_towards(9.0).unwrap();
        running.stepper_mut().interpolant(&dynamics).unwrap()
    };
    assert_eq!(allocations(last), 0);
}
