//! Derivatives of a motion through a switch of its parameters, against their closed form.

use lagrangian::Dual;
use lagrangian::prelude::*;

#[track_caller]
fn close(what: &str, found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs();
    assert!(
        error <= tolerance * expected.abs().max(1.0),
        "{what}: {found} is not {expected}: {error:e}"
    );
}

/// A particle in one of two fields, which a switch at a place exchanges.
#[derive(Lagrangian)]
#[lagrangian(
    taylor,
    coordinates(x),
    kinetic = 0.5 * dot(x).powi(2),
    potential = -field * x,
    event(switch = x - place),
)]
struct Switched<T: Scalar> {
    field: T,
    place: T,
}

/// A reaction that changes the dynamics alone, and a part of the motion from where an event has stopped it.
#[test]
fn a_switch_has_the_gradient_of_its_closed_form() {
    let [before, after, place] = Dual::variables([2.0, -1.0, 0.75]);
    let number = Dual::constant;
    let switch = (number(2.0) * place / before).sqrt();
    let speed = before * switch;
    let end = number(1.5) - switch;
    let expected = [
        place + speed * end + number(0.5) * after * end * end,
        speed + after * end,
    ];
    let switched = Switched {
        field: before,
        place,
    };
    let start = State::new(number(0.0), [number(0.0)], [number(0.0)]);
    let motion = Problem::new(switched, start)
        .on(Switched::SWITCH)
        .rising()
        .then_with(|_, dynamics| dynamics.change(|model| model.field = after))
        .solve(1.5, Taylor::new())
        .unwrap();
    for (found, expected) in [motion.q[0], motion.v[0]].iter().zip(&expected) {
        close("a value", found.value, expected.value, 1e-14);
        for part in 0..3 {
            let [found, expected] = [found, expected].map(|x| x.derivative_part(part));
            close("a derivative", found, expected, 1e-13);
        }
    }
    // At the event, the place is where the switch is, whatever moves it.
    let at_switch = &motion.events()[0];
    for part in 0..3 {
        let expected = if part == 2 { 1.0 } else { 0.0 };
        close(
            "the place",
            at_switch.x.q[0].derivative_part(part),
            expected,
            1e-14,
        );
        close(
            "the time",
            at_switch.t.derivative_part(part),
            switch.derivative_part(part),
            1e-14,
        );
    }
}
