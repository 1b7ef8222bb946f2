//! A mechanism whose inputs act on the reactions.

use lagrangian::analysis::{StateSpace, TangentSpace};
use lagrangian::prelude::*;

use super::checked;

/// A motor turns a crank, by whose rod a ram presses.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(alpha, beta, x),
    define(middle = [a * cos(alpha) + 0.5 * b * cos(beta), a * sin(alpha) + 0.5 * b * sin(beta)]),
    kinetic = 0.5 * i * dot(alpha).powi(2) + 0.5 * ram * dot(x).powi(2),
    kinetic = 0.5 * m * (dot(middle).norm_squared() + b.powi(2) / 12.0 * dot(beta).powi(2)),
    potential = m * g * middle.y,
    force(alpha = torque, x = -load),
    constraint(pin = [a * cos(alpha) + b * cos(beta) - x, a * sin(alpha) + b * sin(beta)]),
)]
struct Press {
    i: f64,
    m: f64,
    ram: f64,
    a: f64,
    b: f64,
    g: f64,
    #[lagrangian(input)]
    torque: f64,
    #[lagrangian(input)]
    load: f64,
}

/// The mechanism of [`Press`] by the angle of the crank. The force on the ram is that of the work −`load` δx.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(alpha),
    define(
        beta = asin(-a * sin(alpha) / b),
        x = a * cos(alpha) + b * cos(beta),
        middle = [a * cos(alpha) + 0.5 * b * cos(beta), a * sin(alpha) + 0.5 * b * sin(beta)],
    ),
    kinetic = 0.5 * i * dot(alpha).powi(2) + 0.5 * ram * dot(x).powi(2),
    kinetic = 0.5 * m * (dot(middle).norm_squared() + b.powi(2) / 12.0 * dot(beta).powi(2)),
    potential = m * g * middle.y,
    force(
        alpha = torque + load * (a * sin(alpha) - a * cos(alpha) * tan(beta)),
    ),
    output(push = ram * dot(dot(x)) + load),
)]
struct PressAlone {
    i: f64,
    m: f64,
    ram: f64,
    a: f64,
    b: f64,
    g: f64,
    #[lagrangian(input)]
    torque: f64,
    #[lagrangian(input)]
    load: f64,
}

/// λ of the pin along x is the force of the ram on the rod: −(`ram` ẍ + `load`), in both mechanisms with its derivatives.
#[test]
fn a_press_under_load() {
    let (i, m, ram, a, b, g) = (0.15, 0.8, 2.0, 0.4, 1.1, 9.81);
    for (alpha, rate, torque, load) in [
        (0.4, 3.0, 2.0, 30.0),
        (2.2, -1.5, -4.0, 50.0),
        (-1.3, 0.2, 7.0, -20.0),
    ] {
        let three = Press {
            i,
            m,
            ram,
            a,
            b,
            g,
            torque,
            load,
        };
        let alone = PressAlone {
            i,
            m,
            ram,
            a,
            b,
            g,
            torque,
            load,
        };
        let guess = State::new(0.0, [alpha, -0.2, 1.2], [rate, 0.0, 0.0]);
        let held = [Press::ALPHA];
        let state = three.assemble(guess).hold(held).hold_velocities(held);
        let state = state.solve().expect("it closes").state;
        let inputs = [torque, load].into();
        let tangent = TangentSpace::at(&three, &state)
            .coordinates(held)
            .velocities(held)
            .along_motion();
        checked::<_, 3, 2, 2>(&three, &state, [&[], &held]);
        let basis = tangent.basis::<2>().expect("regular");
        let found = StateSpace::<f64, 2, 2, 2>::reduced(&tangent).expect("regular");
        let found = found.with_linearized_outputs_along(&basis, (&state, &inputs), |x, u| {
            [three.with_inputs(*u).multipliers(x)[0]]
        });
        let minimal = State::new(0.0, [alpha], [rate]);
        let expected = StateSpace::<f64, 2, 2, 2>::of(&alone, &minimal).with_linearized_outputs(
            &minimal,
            &inputs,
            |x, u| [-alone.with_inputs(*u).outputs(x).push],
        );
        let errors = [
            (found.a - expected.a).amax() / expected.a.amax(),
            (found.b - expected.b).amax() / expected.b.amax(),
            (found.c - expected.c).amax() / expected.c.amax(),
            (found.d - expected.d).amax() / expected.d.amax(),
            (found.output - expected.output).amax() / expected.output.amax(),
        ];
        assert!(errors.iter().all(|error| *error < 1e-11), "{errors:?}");
        assert!(expected.d[(0, 1)].abs() > 1e-3 && expected.b.row(1).amin() > 1e-3);
    }
}
