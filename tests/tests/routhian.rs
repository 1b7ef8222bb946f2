//! Models reduced by their ignorable coordinates, against the full ones and closed forms.

use lagrangian::prelude::*;
use lagrangian_tests::assert_close;

/// A symmetric top as three squares (4.5).
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(w = angular_velocity_zxz(phi, theta, psi)),
    kinetic = 0.5 * i * w.x.powi(2) + 0.5 * i * w.y.powi(2) + 0.5 * i_s * w.z.powi(2),
    potential = m * g * l * cos(theta),
    taylor,
    routhian(ReducedTop),
)]
struct Top {
    i: f64,
    i_s: f64,
    m: f64,
    g: f64,
    l: f64,
}

fn top() -> Top {
    Top {
        i: 0.4,
        i_s: 0.1,
        m: 1.3,
        g: 9.81,
        l: 0.2,
    }
}

#[test]
fn first_look() {
    let top = top();
    let state = State::new(0.0, [0.3, 0.5, 0.1], [0.2, 0.3, 40.0]);
    let (reduced, start) = top.reduce(&state);
    println!("{reduced:?} {start:?}");
    println!("{}", ReducedTop::EQUATIONS);
    println!("{:?}", ReducedTop::OPERATIONS.accelerations);
    assert_close(
        "u",
        reduced.ignorable_velocities(&start).as_slice(),
        &[0.2, 40.0],
        1e-13,
    );
    assert_close(
        "a",
        reduced.accelerations(&start).as_slice(),
        &[top.accelerations(&state)[1]],
        1e-12,
    );
    assert_close("e", &[reduced.energy(&start)], &[top.energy(&state)], 1e-13);
    let back = reduced.full_state(&start, &[0.3, 0.1].into());
    assert_close("back", back.v.as_slice(), state.v.as_slice(), 1e-12);
    let r = reduced.reconstruction();
    let end = Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-12)
        .integrate_to(&r, (start, [0.3, 0.1]), 5.0)
        .unwrap();
    let end2 = Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-12)
        .integrate_to(&top.dynamics(), state, 5.0)
        .unwrap();
    let end3 = Taylor::new()
        .integrate_to(&r, (start, [0.3, 0.1]), 5.0)
        .unwrap();
    println!("{:?}\n{:?}\n{:?}", end.x, end2.x, end3.x);
}
