//! Members of an ensemble under laws, against each of them alone.

use crate::members::{alone_and_together, number};
use lagrangian::prelude::*;
use lagrangian::signals::Sinusoid;

#[derive(Lagrangian, Clone)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    potential = 0.5 * k * x.powi(2),
    force(x = push),
    event(middle = x),
)]
struct Slider {
    m: f64,
    k: f64,
    #[lagrangian(input)]
    push: f64,
}

fn slider(index: usize) -> Problem<f64, lagrangian::EquationsOfMotion<Slider, f64, 1>> {
    let slider = Slider {
        m: 0.5 + number(index),
        k: 1.0 + 3.0 * number(index + 1),
        push: number(index + 2),
    };
    let start = State::new(number(index + 3), [number(index + 4)], [0.0]);
    Problem::new(slider, start)
}

fn signal(index: usize) -> Sinusoid {
    Sinusoid {
        amplitude: number(index + 5),
        angular_frequency: 1.0 + 4.0 * number(index + 6),
        phase: number(index + 7),
    }
}

#[test]
fn members_under_laws_are_as_they_are_alone() {
    let end = |index| 3.0 + 5.0 * number(index + 8);
    let held = |index| (slider(index).save(Every(0.5)), end(index));
    alone_and_together(11, held, Taylor::new());
    let driven = |index| {
        let problem = slider(index).driven_by([signal(index)]);
        (problem.on(Slider::MIDDLE).record(), end(index))
    };
    alone_and_together(11, driven, Taylor::new());
    let lagged = |index| {
        let problem = slider(index)
            .driven_by([signal(index)])
            .lagged([0.1 + number(index)]);
        (problem.on(Slider::MIDDLE).record(), end(index))
    };
    let found = alone_and_together(11, lagged, Taylor::new());
    assert!(found.iter().flatten().all(|found| found.z.1[0] != 0.0));
    // A closure that is a law has no series: one after the other.
    let fed_back = |index| {
        let gain = 1.0 + number(index + 9);
        let problem = slider(index).feedback(move |x: &State<f64, 1>| -gain * x.v[0]);
        (problem.on(Slider::MIDDLE).rising().record(), end(index))
    };
    alone_and_together(5, fed_back, Dop853::new());
}

/// Each with a period and a memory of its own, and an actuator behind it.
#[test]
fn sampled_members_are_as_they_are_alone() {
    let end = |index| 2.0 + 2.0 * number(index + 8);
    let sampled = |index| {
        let target = number(index + 9);
        let period = 0.02 + 0.1 * number(index + 10);
        slider(index).sampled_feedback(period, [0.0], move |x, sum| {
            let error = target - x.q[0];
            sum[0] += period * error;
            8.0 * error + 4.0 * sum[0] - 2.0 * x.v[0]
        })
    };
    let member = |index| {
        let problem = sampled(index).on(Slider::MIDDLE).record().save(Every(0.3));
        (problem, end(index))
    };
    let found = alone_and_together(6, member, Taylor::new());
    assert!(found.iter().flatten().all(|found| found.z.samplings > 10.0));
    let member = |index| {
        let slow = sampled(index).lagged([0.05 + 0.1 * number(index + 11)]);
        (slow.on(Slider::MIDDLE).record(), end(index))
    };
    alone_and_together(6, member, Taylor::new());
}
