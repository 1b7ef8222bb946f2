//! Sensitivities across jumps.

use lagrangian::Dual;
use lagrangian::prelude::*;

/// A relay whose strengths differ, and a spring.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * dot(x).powi(2), force(x = a - b * signum(x - c) - 0.3 * dot(x)))]
struct Switched<T: Scalar> {
    a: T,
    b: T,
    c: T,
}

/// At a jump the sensitivity jumps, too (saltation): the time of the crossing depends on the parameters.
#[test]
fn sensitivities_jump_with_the_force() {
    let run = |parameters: [f64; 3], x: f64, t: f64| {
        let [a, b, c] = parameters;
        let model = Switched { a, b, c };
        let start = State::new(0.0, [x], [0.0]);
        let end = Problem::new(&model, start).solve(t, Taylor::new());
        end.unwrap().q[0]
    };
    let (at, h) = ([0.3, 1.1, 0.2], 1e-5);
    for t in [0.5, 2.0, 5.0, 9.0] {
        for which in 0..4 {
            let dual = |index: usize, value: f64| {
                Dual::new(value, [if index == which { 1.0 } else { 0.0 }])
            };
            let [a, b, c] = [0, 1, 2].map(|i| dual(i, at[i]));
            let zero = Dual::constant(0.0);
            let start = State::new(zero, [dual(3, 1.0)], [zero]);
            let model = Switched { a, b, c };
            let end = Problem::new(&model, start).solve(t, Taylor::new());
            let moved = |h: f64| {
                let (mut parameters, mut x) = (at, 1.0);
                match parameters.get_mut(which) {
                    Some(parameter) => *parameter += h,
                    None => x += h,
                }
                run(parameters, x, t)
            };
            let expected = (moved(h) - moved(-h)) / (2.0 * h);
            let found = end.unwrap().q[0];
            assert!((found.value - run(at, 1.0, t)).abs() < 1e-12);
            assert!(
                (found.derivative[0] - expected).abs() < 1e-8,
                "{t} {which}: {} {expected}",
                found.derivative[0]
            );
        }
    }
}
