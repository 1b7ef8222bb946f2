//! Events of motions whose steps are so long that the series of event functions lack visible terms.

use lagrangian::prelude::*;

#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(theta, x),
    kinetic = 0.5 * dot(theta).powi(2) + 0.5 * m * dot(x).powi(2) + 0.2 * dot(theta) * dot(x) * cos(theta),
    potential = -g * cos(theta) + 0.5 * (x - 0.5 * theta).powi(2),
    event(
        turn = dot(theta),
        level = sin(theta - 0.3 * x) - 0.2,
        fast = dot(x).powi(2) - 0.1 * dot(theta),
    ),
)]
struct Pendulum {
    m: f64,
    g: f64,
}

/// Events occur as often as at a small tolerance, about when they do there, and where their functions are zero: to rounding, if the zero
/// is the only one in its step, although the series of the functions lack terms that are visible.
#[test]
fn single_zeros_are_zeros_of_the_functions_and_not_of_their_series() {
    fn check<const HALF: usize>(method: Taylor<HALF>, near: f64) {
        let [mut count, mut to_rounding] = [0_u32; 2];
        for index in 0..8 {
            let part = f64::from(index) / 8.0;
            let pendulum = Pendulum {
                m: 1.0 + part,
                g: 9.81,
            };
            let start = State::new(0.0, [0.5 + part, 0.3], [0.1, 1.0 - part]);
            let problem = || {
                Problem::new(&pendulum, start)
                    .on([Pendulum::TURN, Pendulum::LEVEL, Pendulum::FAST])
                    .record()
            };
            let found = problem().solve(6.0, method).unwrap();
            let expected = problem().solve(6.0, Taylor::new()).unwrap();
            assert_eq!(found.events().len(), expected.events().len(), "{index}");
            for (found, expected) in found.events().iter().zip(expected.events()) {
                assert_eq!(found.event, expected.event);
                assert!((found.t - expected.t).abs() < near);
                let ([theta, x], [turning, moving]) = (found.q.into(), found.v.into());
                let value = if found.is(Pendulum::TURN) {
                    turning
                } else if found.is(Pendulum::LEVEL) {
                    f64::sin(theta - 0.3 * x) - 0.2
                } else {
                    moving.powi(2) - 0.1 * turning
                };
                let value = value.abs();
                assert!(value < near, "{index}: {value} at {}", found.t);
                to_rounding += u32::from(value < 1e-14);
                count += 1;
            }
        }
        // The other zeros are not alone in their steps.
        assert!(
            count > 60 && to_rounding > count - 10,
            "{to_rounding} of {count}"
        );
    }
    check(Taylor::order_12().absolute_tolerance(1e-5), 1e-4);
    check(Taylor::order_16().absolute_tolerance(1e-7), 1e-6);
    check(Taylor::order_16().absolute_tolerance(1e-9), 1e-8);
}
