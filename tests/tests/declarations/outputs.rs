//! Outputs, at rest and under inputs.

use lagrangian::prelude::*;

/// A cart that a force pushes, with an accelerometer and a power meter.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = push),
    output(acceleration = dot(dot(x)), power = push * dot(x)),
)]
struct Cart {
    m: f64,
    #[lagrangian(input)]
    push: f64,
}

#[test]
fn outputs_follow_the_inputs_that_act() {
    let cart = Cart { m: 2.0, push: 1.0 };
    let state = State::new(0.0, [0.0], [4.0]);
    assert_eq!(
        cart.outputs(&state),
        CartOutputs {
            acceleration: 0.5,
            power: 4.0
        }
    );
    let pushed = CartOutputs {
        acceleration: 1.5,
        power: 12.0,
    };
    assert_eq!(cart.with_inputs([3.0]).outputs(&state), pushed);
    assert_eq!(
        cart.with_inputs(SVector::from([3.0])).outputs(&state),
        pushed
    );
}
