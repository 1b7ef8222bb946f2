//! Derivatives of accelerations and multipliers by parameters.

use lagrangian::prelude::*;
use lagrangian::{Dual, Scalar};

/// A four-bar linkage with friction and a torque.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(crank, coupler, rocker),
    define(
        pin = [a * cos(crank), a * sin(crank)],
        arm = [b * cos(coupler), b * sin(coupler)],
        end = [d + c * cos(rocker), c * sin(rocker)],
        middle = pin + 0.5 * arm,
    ),
    kinetic = m * (a.powi(2) * dot(crank).powi(2) + c.powi(2) * dot(rocker).powi(2)) / 6.0,
    kinetic = 0.5 * m * (dot(middle).norm_squared() + b.powi(2) / 12.0 * dot(coupler).powi(2)),
    potential = m * g * middle.y,
    dissipation = 0.5 * friction * dot(rocker).powi(2),
    force(crank = torque),
    constraint(joint = pin + arm - end),
    sensitivities,
)]
struct Linkage<T: Scalar> {
    a: T,
    b: T,
    c: T,
    d: T,
    m: T,
    g: T,
    friction: T,
    #[lagrangian(input)]
    torque: T,
}

/// A body on two wires that cross each other obliquely, and a wheel that rolls beside it, with all kinds of constraints: dense ones
/// and one without mass.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y, z, phi, angle),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2) + dot(z).powi(2)) + 0.5 * j * dot(phi).powi(2),
    potential = m * g * (x + 2.0 * y + 3.0 * z) + 0.5 * k * phi.powi(2),
    constraint(
        sphere = x * y + y * z + z * x - l.powi(2) * cos(phi),
        pointer = angle - l * x * z,
    ),
    nonholonomic(rolling = y * dot(x) + z * dot(y) - r * x * dot(phi) + speed * t),
    sensitivities(m, l, r, speed, k),
)]
struct Rolling<T: Scalar> {
    m: T,
    j: T,
    g: T,
    k: T,
    l: T,
    r: T,
    speed: T,
}

/// A closed chain of links in relative angles, whose equations are solved numerically.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q[8]),
    define(
        angle[0] = q[0],
        angle[i] = angle[i - 1] + q[i] for i in 1..8,
        end[0] = l * [cos(angle[0]), sin(angle[0])],
        end[i] = end[i - 1] + l * [cos(angle[i]), sin(angle[i])] for i in 1..8,
    ),
    kinetic = (0..8).map(|i| 0.5 * m * dot(end[i]).norm_squared() + 0.5 * j * dot(angle[i]).powi(2)).sum(),
    potential = (0..8).map(|i| m * g * end[i].y).sum(),
    constraint(closure = end[7] - [d, 0.0]),
    sensitivities(m, j, l),
)]
struct Chain<T: Scalar> {
    m: T,
    j: T,
    g: T,
    l: T,
    d: T,
}

/// Compares ∂λ/∂π and ∂q̈/∂π with differences and with dual numbers.
macro_rules! compared {
    ($model:ident { $($field:ident: $value:expr),* }, by [$($parameter:ident),*], at $state:expr) => {{
        let state = $state;
        let model = $model { $($field: $value),* };
        let found = model.multiplier_sensitivities(&state);
        let accelerations = model.sensitivities(&state);
        let parameters = [$(stringify!($parameter)),*];
        assert_eq!($model::<f64>::PARAMETERS, parameters);
        for (j, parameter) in parameters.into_iter().enumerate() {
            let of = |name: &str, value: f64, slope: f64| {
                let slope = if name == parameter { slope } else { 0.0 };
                Dual::new(value, [slope])
            };
            let dual = $model { $($field: of(stringify!($field), $value, 1.0)),* };
            let at = State::new(
                Dual::constant(state.t),
                state.q.map(Dual::constant),
                state.v.map(Dual::constant),
            );
            let slopes = dual.multipliers(&at).map(|x| x.derivative[0]);
            let error = (found.column(j) - slopes).amax() / found.amax();
            assert!(error < 1e-12, "{parameter}: {error:e} {found} {slopes}");
            let slopes = dual.accelerations(&at).map(|x| x.derivative[0]);
            let error = (accelerations.column(j) - slopes).amax() / accelerations.amax();
            assert!(error < 1e-12, "{parameter}: {error:e} {accelerations} {slopes}");
            let shifted = |change: f64| {
                let moved = |name: &str, value: f64| {
                    if name == parameter { value + change } else { value }
                };
                let model = $model { $($field: moved(stringify!($field), $value)),* };
                model.multipliers(&state)
            };
            let difference = (shifted(1e-4) - shifted(-1e-4)) * (8.0 / 12.0)
                - (shifted(2e-4) - shifted(-2e-4)) / 12.0;
            let error = (found.column(j) - difference / 1e-4).amax() / found.amax();
            assert!(error < 1e-7, "{parameter}: {error:e}");
        }
    }};
}

#[test]
fn multipliers_are_differentiated_by_parameters() {
    for (crank, rate) in [(0.9, 1.3), (2.5, -2.0)] {
        let example = Linkage {
            a: 1.0,
            b: 2.5,
            c: 2.0,
            d: 3.0,
            m: 0.4,
            g: 9.81,
            friction: 0.05,
            torque: 0.7,
        };
        let guess = State::new(0.0, [crank, 0.2, 1.5], [rate, 0.0, 0.0]);
        let state = example.assemble(guess).hold([0]).hold_velocities([0]);
        let state = state.solve().expect("it closes").state;
        compared!(
            Linkage { a: 1.0, b: 2.5, c: 2.0, d: 3.0, m: 0.4, g: 9.81, friction: 0.05, torque: 0.7 },
            by [a, b, c, d, m, g, friction], at state
        );
    }
    assert!(Chain::<f64>::EQUATIONS.contains("a numerical factorization"));
    let state = State::new(
        0.0,
        [0.3, -0.2, 0.5, 0.4, -0.7, 1.1, 0.2, -0.3],
        [0.5, 0.1, -0.4, 1.0, -2.0, 0.6, 0.3, 0.2],
    );
    compared!(
        Chain { m: 0.7, j: 0.3, g: 9.81, l: 0.4, d: 1.5 },
        by [m, j, l], at state
    );
    // λ does not depend on whether the constraints are met.
    for sign in [1.0, -1.0] {
        let state = State::new(
            0.3,
            [0.4, 0.9, -0.7, 0.2 * sign, 0.3],
            [1.0, -0.5, 0.3, 2.0, sign],
        );
        compared!(
            Rolling { m: 0.7, j: 0.3, g: 9.81, k: 2.0, l: 0.8, r: 0.6, speed: 0.5 },
            by [m, l, r, speed, k], at state
        );
    }
}
