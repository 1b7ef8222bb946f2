//! Constrained mechanisms against closed forms.

use lagrangian::prelude::*;

/// A pendulum in Cartesian coordinates: x sideways, y upwards.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    constraint(rod = x.powi(2) + y.powi(2) - l.powi(2)),
    output(tension = -2.0 * l * reaction(rod)),
    taylor,
)]
struct CartesianPendulum {
    m: f64,
    g: f64,
    l: f64,
}

#[test]
fn the_first_slice() {
    let pendulum = CartesianPendulum {
        m: 2.0,
        g: 9.81,
        l: 1.5,
    };
    let start = State::new(0.0, [1.5, 0.0], [0.0, 0.0]);
    let end = Problem::new(&pendulum, start)
        .solve(10.0, Dop853::new())
        .unwrap();
    let taylor = Problem::new(&pendulum, start)
        .solve(10.0, Taylor::new())
        .unwrap();
    println!("{end:?}\n{taylor:?}");
    println!("{:?}", pendulum.constraint_residuals(&end));
    println!("{:?}", pendulum.multipliers(&end));
    println!("{:?}", pendulum.outputs(&end).tension);
    println!("{}", CartesianPendulum::EQUATIONS);
    panic!();
}
