//! Models reduced by their ignorable coordinates, against the full ones.

use lagrangian::prelude::*;
use lagrangian_tests::{Random, assert_close};

use crate::models::{
    Charge, FurutaPendulum, Gyroscope, Kepler, KeplerOf, RadialMotionOf, ReducedCharge,
    ReducedFurutaPendulum, ReducedTop, Satellite, SphericalPendulum, polar_top, top,
};

/// At random states, the reduced model has the accelerations, the energy and the velocities of the full one.
macro_rules! assert_reduced {
    ($model:expr, $full:literal, $remaining:expr, $ignorable:expr, $tolerance:expr) => {{
        let model = $model;
        let mut random = Random::default();
        for _ in 0..100 {
            let mut state: State<f64, $full> = random.state();
            state.q[0] = 1.2 + 0.5 * state.q[0].sin();
            state.q[1] = 1.2 + 0.5 * state.q[1].sin();
            let (reduced, start) = model.reduce(&state);
            let all = model.accelerations(&state);
            let expected: Vec<f64> = $remaining.iter().map(|i: &usize| all[*i]).collect();
            let found = reduced.accelerations(&start);
            assert_close("accelerations", found.as_slice(), &expected, $tolerance);
            assert_close(
                "energy",
                &[reduced.energy(&start)],
                &[model.energy(&state)],
                $tolerance,
            );
            let rates: Vec<f64> = $ignorable.iter().map(|i: &usize| state.v[*i]).collect();
            let found = reduced.ignorable_velocities(&start);
            assert_close("velocities", found.as_slice(), &rates, $tolerance);
            let places = SVector::from($ignorable.map(|i: usize| state.q[i]));
            let back = reduced.full_state(&start, &places);
            assert_eq!((back.t, back.q), (state.t, state.q));
            assert_close(
                "full state",
                back.v.as_slice(),
                state.v.as_slice(),
                $tolerance,
            );
            let momenta = model.momenta(&back);
            let constants: Vec<f64> = $ignorable.iter().map(|i: &usize| momenta[*i]).collect();
            assert_close(
                "constants",
                reduced.constants().as_slice(),
                &constants,
                $tolerance,
            );
            let forces = model.generalized_forces(&state);
            let forces: Vec<f64> = $remaining.iter().map(|i: &usize| forces[*i]).collect();
            assert_close(
                "forces",
                reduced.generalized_forces(&start).as_slice(),
                &forces,
                $tolerance,
            );
            let rest = State::new(start.t, start.q, start.v.map(|_| 0.0));
            assert_close(
                "V_eff",
                &[reduced.effective_potential(&start)],
                &[reduced.routhian(&rest)],
                1e-11,
            );
        }
    }};
}

#[test]
fn reduced_models_move_as_the_full_ones() {
    assert_reduced!(top(), 3, [1], [0, 2], 1e-12);
    assert_reduced!(polar_top(), 3, [1], [0, 2], 1e-12);
    assert_reduced!(Kepler { m: 2.0, mu: 1.5 }, 2, [0], [1], 1e-12);
    let (m, l, g) = (0.7, 1.1, 9.81);
    assert_reduced!(SphericalPendulum { m, l, g }, 2, [0], [1], 1e-12);
    let furuta = FurutaPendulum {
        inertia_arm: 0.1,
        inertia_rod: 0.02,
        m,
        length: 0.7,
        l,
        g,
        friction: 0.3,
        torque: 0.4,
    };
    assert_reduced!(furuta, 2, [1], [0], 1e-11);
    let gyroscope = Gyroscope {
        outer_gimbal: 0.3,
        inner_gimbal: [0.1, 0.2, 0.3],
        a: 0.4,
        c: 0.7,
        weight: 1.3,
    };
    assert_reduced!(gyroscope, 3, [1], [0, 2], 1e-12);
    let satellite = Satellite {
        i: 2.0,
        i_s: 0.9,
        n: 0.6,
    };
    assert_reduced!(satellite, 3, [0, 1], [2], 1e-11);
    let charge = Charge {
        m: 1.2,
        field: 0.8,
        k: 2.0,
    };
    assert_reduced!(charge, 4, [0, 2], [1, 3], 1e-11);
}

/// On other scalars, and with inputs that are held.
#[test]
fn reduced_models_are_models_like_any_other() {
    use lagrangian::DoubleDouble;
    let (reduced, start) = top().reduce(&State::new(0.0, [0.3, 0.5, 0.1], [0.2, 0.3, 40.0]));
    let wide = State::new(
        DoubleDouble::from_f64(0.0),
        start.q.map(DoubleDouble::from_f64),
        start.v.map(DoubleDouble::from_f64),
    );
    let found = Lagrangian::<1, DoubleDouble>::accelerations(&reduced, &wide)[0];
    assert_close(
        "θ̈",
        &[reduced.accelerations(&start)[0]],
        &[found.largest()],
        1e-13,
    );
    let orbit = KeplerOf {
        m: DoubleDouble::from_f64(2.0),
        mu: DoubleDouble::from_f64(1.0),
    };
    let state = State::new(0.0, [1.0, 0.5], [0.1, 1.2]);
    let state = State::new(
        DoubleDouble::from_f64(state.t),
        state.q.map(DoubleDouble::from_f64),
        state.v.map(DoubleDouble::from_f64),
    );
    let (radial, _): (RadialMotionOf<DoubleDouble>, _) = orbit.reduce(&state);
    assert!((radial.p_phi.largest() - 2.4).abs() < 1e-15);
    assert_eq!(ReducedTop::COORDINATES, ["theta"]);
    assert_eq!(<ReducedTop as Routhian<1, 2>>::ELIMINATED, ["phi", "psi"]);
    assert_eq!(
        <ReducedTop as ConstantsOfMotion<1, 1>>::CONSTANTS_OF_MOTION,
        ["energy"]
    );
    assert_eq!(ReducedCharge::COORDINATES, ["r", "p_x"]);
    assert_eq!(ReducedFurutaPendulum::INPUTS, ["torque"]);
    let written = format!("{reduced:?}");
    assert!(
        written.starts_with("ReducedTop { i: 0.4, ") && written.contains("p_psi: "),
        "{written}"
    );
    let equations = ReducedTop::EQUATIONS;
    let potential = "V = (p_φ − p_ψ cos θ)²/(2 I sin²θ) + p_ψ²/(2 I_s) + m g l cos θ";
    assert!(equations.contains(potential), "{equations}");
}
