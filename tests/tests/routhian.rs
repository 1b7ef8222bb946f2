//! Models reduced by their ignorable coordinates, against the full ones and closed forms.

use lagrangian::prelude::*;
use lagrangian::{OperationCount, ReconstructedPhase};
use lagrangian_tests::{Random, assert_close, relative_error};

/// A symmetric top as three squares (4.5), of which two have the same inertia.
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

/// The same for motions through the poles.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(w = angular_velocity_zxz(phi, theta, psi)),
    kinetic = 0.5 * i * w.x.powi(2) + 0.5 * i * w.y.powi(2) + 0.5 * i_s * w.z.powi(2),
    potential = m * g * l * cos(theta),
    taylor,
    routhian(TopThroughPoles, half_angles),
)]
struct PolarTop {
    i: f64,
    i_s: f64,
    m: f64,
    g: f64,
    l: f64,
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    potential = -m * mu / r,
    routhian(RadialMotion),
)]
struct Kepler {
    m: f64,
    mu: f64,
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, phi),
    define(r = l * [sin(theta) * cos(phi), sin(theta) * sin(phi), -cos(theta)]),
    kinetic = 0.5 * m * dot(r).norm_squared(),
    potential = m * g * r.z,
    routhian(ReducedSphericalPendulum),
)]
struct SphericalPendulum {
    m: f64,
    l: f64,
    g: f64,
}

/// Furuta's pendulum without a motor; the rod is driven and damped: forces that are not on the arm depend on its velocity.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(arm, rod),
    define(
        turn = rotation_z(arm),
        along = turn * [1.0, 0.0, 0.0],
        down = turn * [0.0, sin(rod), -cos(rod)],
        center = length * along + l * down,
    ),
    kinetic = 0.5 * inertia_arm * dot(along).norm_squared()
        + 0.5 * m * dot(center).norm_squared()
        + 0.5 * inertia_rod * dot(down).norm_squared(),
    potential = m * g * center.z,
    dissipation = 0.5 * friction * dot(rod).powi(2),
    force(rod = torque + 0.1 * friction * dot(arm)),
    taylor,
    routhian(ReducedFurutaPendulum),
)]
struct FurutaPendulum {
    inertia_arm: f64,
    inertia_rod: f64,
    m: f64,
    length: f64,
    l: f64,
    g: f64,
    friction: f64,
    #[lagrangian(input)]
    torque: f64,
}

/// A gyroscope in two gimbals.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(alpha, beta, gamma),
    define(
        inner = angular_velocity_zx(alpha, beta),
        rotor = angular_velocity_zxz(alpha, beta, gamma),
    ),
    kinetic = 0.5 * outer_gimbal * dot(alpha).powi(2)
        + 0.5 * inner.dot(diagonal(inner_gimbal) * inner)
        + 0.5 * rotor.dot(diagonal([a, a, c]) * rotor),
    potential = weight * cos(beta),
    routhian(ReducedGyroscope),
)]
struct Gyroscope {
    outer_gimbal: f64,
    inner_gimbal: [f64; 3],
    a: f64,
    c: f64,
    weight: f64,
}

/// A symmetric satellite on a circular orbit: gyroscopic terms, and two coordinates that remain.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        r = rotation_zxz(phi, theta, psi),
        w = angular_velocity_zxz(phi, theta, psi) + r.transpose() * [0.0, n, 0.0],
    ),
    kinetic = 0.5 * w.dot(diagonal([i, i, i_s]) * w),
    potential = 1.5 * n.powi(2) * (i_s - i) * cos(theta).powi(2),
    taylor,
    routhian(ReducedSatellite),
)]
struct Satellite {
    i: f64,
    i_s: f64,
    n: f64,
}

/// A charge in the field of a magnet along z, and an oscillator whose spring is stiffer the faster it moves: L is of the
/// fourth degree in the velocities, and of the second one in that of φ. One coordinate of a vector is ignorable.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(r, phi, p: Vector2),
    lagrangian = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2) + dot(p).norm_squared())
        + 0.05 * dot(r).powi(4) + 0.2 * dot(r).powi(2) * dot(phi).powi(2)
        + 0.5 * field * r.powi(2) * dot(phi) + 0.3 * sin(t) * dot(p.y) - 0.5 * k * (r.powi(2) + p.x.powi(2)),
    routhian(ReducedCharge),
)]
struct Charge {
    m: f64,
    field: f64,
    k: f64,
}

/// Parameters of any scalar, and a constant that is one, too.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    potential = -m * mu / r,
    routhian(RadialMotionOf),
)]
struct KeplerOf<T: Scalar> {
    m: T,
    mu: T,
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

fn polar_top() -> PolarTop {
    let Top { i, i_s, m, g, l } = top();
    PolarTop { i, i_s, m, g, l }
}

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
            let rest = State {
                v: start.v.map(|_| 0.0),
                ..start
            };
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

/// (4.7) to (4.10), by hand.
#[test]
fn the_reduced_top_is_that_of_the_book() {
    let top = top();
    let Top { i, i_s, m, g, l } = top;
    let mut random = Random::default();
    for _ in 0..100 {
        let [theta, rate, precession, spin] = random.array(0.2, 2.8);
        let state = State::new(0.0, [0.4, theta, -1.0], [precession, rate, 10.0 * spin]);
        let (reduced, start) = top.reduce(&state);
        let (s, c) = theta.sin_cos();
        let (p_phi, p_psi) = (reduced.p_phi, reduced.p_psi);
        assert_close(
            "C_ψ",
            &[p_psi],
            &[i_s * (10.0 * spin + precession * c)],
            1e-14,
        );
        assert_close(
            "C_φ",
            &[p_phi],
            &[i * precession * s * s + p_psi * c],
            1e-13,
        );
        let potential = m * g * l * c
            + p_psi * p_psi / (2.0 * i_s)
            + (p_phi - p_psi * c).powi(2) / (2.0 * i * s * s);
        assert_close(
            "V_eff",
            &[reduced.effective_potential(&start)],
            &[potential],
            1e-12,
        );
        let energy = 0.5 * i * rate * rate + potential;
        assert_close("E", &[reduced.energy(&start)], &[energy], 1e-12);
        assert_close(
            "R",
            &[reduced.routhian(&start)],
            &[potential - 0.5 * i * rate * rate],
            1e-12,
        );
        assert_close(
            "T",
            &[reduced.kinetic_energy(&start)],
            &[0.5 * i * rate * rate],
            1e-13,
        );
        let slope = -m * g * l * s + (p_phi - p_psi * c) * (p_psi - p_phi * c) / (i * s.powi(3));
        assert_close(
            "θ̈",
            &[reduced.accelerations(&start)[0]],
            &[-slope / i],
            1e-12,
        );
        let phi = (p_phi - p_psi * c) / (i * s * s);
        let rates = [phi, p_psi / i_s - phi * c];
        assert_close(
            "φ̇, ψ̇",
            reduced.ignorable_velocities(&start).as_slice(),
            &rates,
            1e-12,
        );
    }
}

/// In additions, with divisions as five and a sine and cosine as twelve of them.
fn cost(count: OperationCount) -> usize {
    assert_eq!((count.square_roots, count.functions), (0, 0));
    count.additions + count.multiplications + 5 * count.divisions + 12 * count.sines_and_cosines
}

#[test]
fn the_reduced_top_costs_little() {
    let reduced = ReducedTop::OPERATIONS.accelerations;
    assert!(reduced.total() <= 11 && cost(reduced) <= 26, "{reduced:?}");
    let through_poles = TopThroughPoles::OPERATIONS.accelerations;
    assert!(
        through_poles.total() <= 14 && cost(through_poles) <= 33,
        "{through_poles:?}"
    );
    let full = Top::OPERATIONS.accelerations;
    assert!(full.total() >= 19 && cost(full) >= 34, "{full:?}");
}

/// θ of the full and the reduced top over a hundred nutations, and φ and ψ from the reduced one.
#[test]
fn a_hundred_nutations_are_reconstructed() {
    let top = top();
    let start = State::new(0.0, [0.3, 0.5, 0.1], [0.2, 0.3, 40.0]);
    let (reduced, reduced_start) = top.reduce(&start);
    // The frequency of the nutation is somewhat less than Iₛ ω₃/I = 10.
    let end = 115.0 * core::f64::consts::TAU / (0.1 * 40.0 / 0.4);
    let method = Taylor::new();
    let times: Vec<f64> = (1..=400).map(|k| end * f64::from(k) / 400.0).collect();
    let full = method.sample(&top.dynamics(), start, &times).unwrap();
    let equations = reduced.reconstruction();
    let there = (reduced_start, [0.3, 0.1]);
    let motion = method.sample(&equations, there, &times).unwrap();
    let mut nutations = 0;
    let mut before = 0.0;
    for (full, sample) in full.states().zip(motion.samples()) {
        let state = equations.full_state(sample.t, &sample.x);
        assert!((state.q - full.q).amax() < 1e-10, "{} {}", state.q, full.q);
        assert!((state.v - full.v).amax() < 1e-9, "{} {}", state.v, full.v);
        nutations += usize::from(before < 0.0 && full.v[1] >= 0.0);
        before = full.v[1];
    }
    assert!(nutations >= 99, "{nutations}");
    // Dense output of Runge and Kutta's kind, too.
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let solution = method
        .driver()
        .solve(&equations, (reduced_start, [0.3, 0.1]), 5.0)
        .unwrap();
    for t in [0.123, 1.7, 4.999] {
        let x: ReconstructedPhase<f64, 1, 2> = solution.at(t).unwrap();
        let expected = method.integrate_to(&top.dynamics(), start, t).unwrap();
        let state = equations.full_state(t, &x);
        assert!((state.q - expected.x.q).amax() < 1e-9, "{t}");
    }
}

/// The sleeping top at θ = 0 itself, and near it with all digits: `V_eff` = const + (C²/(8 I) − m g l/2) θ² + ….
#[test]
fn the_sleeping_top_is_evaluated_where_it_sleeps() {
    let top = polar_top();
    let (i, i_s, weight) = (top.i, top.i_s, top.m * top.g * top.l);
    let spin = 30.0;
    for pole in [0.0, core::f64::consts::PI] {
        let state = State::new(0.0, [0.0, pole, 0.0], [0.0, 0.0, spin]);
        let (mut reduced, start) = top.reduce(&state);
        let up = pole.cos();
        reduced.p_phi = up * reduced.p_psi;
        let constant = i_s * spin;
        assert_close("C_ψ", &[reduced.p_psi], &[constant], 1e-15);
        let potential = constant.powi(2) / (2.0 * i_s) + up * weight;
        assert_close(
            "V_eff",
            &[reduced.effective_potential(&start)],
            &[potential],
            1e-14,
        );
        let stiffness = constant.powi(2) / (4.0 * i) - up * weight;
        let found = -reduced.linearize(&start).position[(0, 0)];
        assert_close("V_eff″", &[i * found], &[stiffness], 1e-12);
        assert!(reduced.accelerations(&start)[0].abs() < 1e-14 * stiffness);
        assert!(reduced.forcing(&start)[0].abs() < 1e-14 * stiffness);
        let rates = reduced.ignorable_velocities(&start);
        // Of the sum, or the difference, of the angles the velocity is that of the spin.
        assert_close("ψ̇ ± φ̇", &[rates[1] + up * rates[0]], &[spin], 1e-13);
        let end = Taylor::new()
            .integrate_to(&reduced.dynamics(), start, 3.0)
            .unwrap();
        assert!((end.x.q[0] - pole).abs() < 1e-12);
    }
    // Nearby, a motion through the pole keeps its energy, and is that of x and y.
    let state = State::new(0.0, [0.0, 0.0, 0.0], [0.0, 0.4, spin]);
    let (reduced, start) = top.reduce(&state);
    assert!(reduced.p_phi.to_bits() == reduced.p_psi.to_bits());
    for theta in [1e-3, 1e-6, 1e-9, 1e-12_f64] {
        let near = State::new(0.0, [theta], [0.0]);
        let slope = (reduced.p_psi.powi(2) / (4.0 * i) - weight) * theta;
        let expected = -slope / i;
        let error = relative_error(&[reduced.accelerations(&near)[0]], &[expected], 1e-300);
        assert!(error < theta * theta + 1e-14, "{theta}: {error}");
    }
    let end = Taylor::new()
        .integrate_to(&reduced.dynamics(), start, 5.0)
        .unwrap()
        .state();
    assert_close(
        "energy",
        &[reduced.energy(&end)],
        &[reduced.energy(&start)],
        1e-13,
    );
    // With other constants there is a pole.
    let (mut reduced, start) = top.reduce(&state);
    reduced.p_phi += 1e-3;
    assert!(!reduced.accelerations(&start)[0].is_finite());
    assert!(!reduced.effective_potential(&start).is_finite());
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
    let state = State {
        t: DoubleDouble::from_f64(state.t),
        q: state.q.map(DoubleDouble::from_f64),
        v: state.v.map(DoubleDouble::from_f64),
    };
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
