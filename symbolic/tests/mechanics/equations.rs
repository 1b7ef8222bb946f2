//! Lagrange's equations against closed forms.

use lagrangian_symbolic::{Energies, Equations, Symbol};
use lagrangian_symbolic_testing::systems::{driven_pendulum, euler_rates, indefinite, rigid_body};
use lagrangian_symbolic_testing::{Draft, Quantity, assert_close, value};

#[test]
fn explicit_time_enters_the_forcing() {
    let mut model = driven_pendulum();
    let equations = Equations::derive(&mut model).unwrap();
    let (m, l, g, a, w) = (1.3, 1.8, 2.3, 2.8, 3.3);
    let (t, q, v) = (0.3_f64, 0.7_f64, 1.1_f64);
    let found = model
        .graph
        .evaluate(&[equations.mass[0][0], equations.forcing[0]], value);
    assert_close(found[0], m * l * l);
    // m l² q̈ = −m l (g + ÿ₀) sin q with the pivot's acceleration ÿ₀ = −a w² sin(w t).
    assert_close(found[1], -m * l * (g - a * w * w * (w * t).sin()) * q.sin());
    // h = p q̇ − L, which here is not T + V.
    let (vx, vy) = (l * q.cos() * v, a * w * (w * t).cos() + l * q.sin() * v);
    let momentum = m * l * (q.cos() * vx + q.sin() * vy);
    let height = a * (w * t).sin() - l * q.cos();
    let energy = momentum * v - (0.5 * m * (vx * vx + vy * vy) - m * g * height);
    assert_close(model.graph.evaluate(&[equations.energy], value)[0], energy);
}

#[test]
fn lagranges_equations_of_a_rigid_body_are_eulers() {
    let mut model = rigid_body();
    let equations = Equations::derive(&mut model).unwrap();
    let found = model.graph.evaluate(&equations.inverse_dynamics, value);
    let draft = Draft::of(model.graph, 3);
    let w = euler_rates(&draft);
    let values = |w: [Quantity<'_>; 3]| draft.graph().evaluate(&w.map(Quantity::expression), value);
    let (w, rate) = (values(w), values(w.map(Quantity::dot)));
    let i = [1.3, 1.8, 2.3];
    // Q = Eᵀ N with N of (3.5)-(3.7), for any accelerations.
    let n: Vec<f64> = (0..3)
        .map(|k| {
            let (k1, k2) = ((k + 1) % 3, (k + 2) % 3);
            i[k] * rate[k] - (i[k1] - i[k2]) * w[k1] * w[k2]
        })
        .collect();
    let (theta, psi) = (1.1_f64, 1.5_f64);
    let (st, ct) = theta.sin_cos();
    let (sp, cp) = psi.sin_cos();
    assert_close(found[0], (n[0] * sp + n[1] * cp) * st + n[2] * ct);
    assert_close(found[1], n[0] * cp - n[1] * sp);
    assert_close(found[2], n[2]);
}

#[test]
fn natural_systems_conserve_kinetic_plus_potential() {
    let mut model = rigid_body();
    let Energies::Natural { kinetic, .. } = model.energies else {
        unreachable!()
    };
    assert_eq!(Equations::derive(&mut model).unwrap().energy, kinetic);
}

#[test]
fn a_general_lagrangian_need_not_be_quadratic() {
    // A relativistic particle, L = −√(1 − v²) − x: p = γ v, M = γ³, f = −1.
    let draft = Draft::new(1);
    let (x, v) = (draft.q(0), draft.v(0));
    let mut model = draft.general(-((1 - v.squared()).sqrt() + x));
    let equations = Equations::derive(&mut model).unwrap();
    let slow = |symbol: Symbol| {
        if symbol == Symbol::Velocity(0) {
            0.6
        } else {
            value(symbol)
        }
    };
    let roots = [
        equations.momenta[0],
        equations.mass[0][0],
        equations.forcing[0],
        equations.energy,
    ];
    let found = model.graph.evaluate(&roots, slow);
    assert_close(found[0], 1.25 * 0.6);
    assert_close(found[1], 1.25_f64.powi(3));
    assert_close(found[2], -1.0);
    assert_close(found[3], 1.25 + 0.7);
}

#[test]
fn indefinite_mass_matrices_are_regular() {
    let mut model = indefinite();
    let equations = Equations::derive(&mut model).unwrap();
    assert_eq!(equations.mass[0][0], model.graph.zero());
    assert_eq!(equations.mass[0][1], model.graph.one());
}

#[test]
fn derivatives_of_the_residual_are_those_of_finite_differences() {
    let mut model = rigid_body();
    let equations = Equations::derive(&mut model).unwrap();
    let symbols = [
        Symbol::Coordinate(1),
        Symbol::Coordinate(2),
        Symbol::Velocity(0),
        Symbol::Time,
    ];
    let derivatives =
        symbols.map(|symbol| model.graph.derivatives(&equations.inverse_dynamics, symbol));
    for (j, moved) in symbols.into_iter().enumerate() {
        let step = 1e-5;
        let at = |side: f64| {
            let shifted =
                move |symbol| value(symbol) + if symbol == moved { side * step } else { 0.0 };
            model.graph.evaluate(&equations.inverse_dynamics, shifted)
        };
        let (above, below) = (at(1.0), at(-1.0));
        for (i, derivative) in derivatives[j].iter().enumerate() {
            let found = model.graph.evaluate(&[*derivative], value)[0];
            let expected = (above[i] - below[i]) / (2.0 * step);
            // The third derivative is of order ten, so that the formula errs by about 1e-9.
            assert!((found - expected).abs() < 1e-8, "{found} is not {expected}");
        }
    }
}

#[test]
fn the_energy_function_sees_corners() {
    // T = ½ v² − min(v, 0)³: the energy function is not T.
    let draft = Draft::new(1);
    let (v, zero) = (draft.v(0), draft.zero());
    let mut model = draft.natural(v.squared() / 2 - v.min(zero).powi(3), zero);
    let equations = Equations::derive(&mut model).unwrap();
    let back = |symbol: Symbol| {
        if symbol == Symbol::Velocity(0) {
            -2.0
        } else {
            value(symbol)
        }
    };
    // p = v − 3 min(v, 0)², h = p v − T.
    let expected = (-2.0 - 12.0) * -2.0 - (2.0 + 8.0);
    assert_close(model.graph.evaluate(&[equations.energy], back)[0], expected);
}
