//! What the clauses of a declaration give its reduced model, against the full one and finite differences.

use lagrangian::DeclaredEvent;
use lagrangian::prelude::*;
use lagrangian_tests::{Random, assert_close};

/// A mass on an orbit about a center whose pull changes in time, in a medium that resists radial motion.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(r, phi),
    kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
    potential = -m * mu * (1.0 + 0.1 * sin(w * t)) / r,
    dissipation = 0.5 * c * dot(r).powi(2),
    force(r = push * cos(w * t)),
    output(
        areal_rate = 0.5 * r.powi(2) * dot(phi),
        velocity = [dot(r), r * dot(phi)],
        angular_acceleration = dot(dot(phi)),
        radial_acceleration = dot(dot(r)) - r * dot(phi).powi(2),
        position = r * [cos(phi), sin(phi)],
        distance = sqrt((r * cos(phi)).powi(2) + (r * sin(phi)).powi(2)),
    ),
    event(apsis = dot(r), rate = [dot(phi) - 1.0, dot(phi) - 0.6], turned = sin(phi)),
    taylor,
    hamiltonian,
    energy_balance,
    sensitivities(m, c),
    regressor(c, mu),
    routhian(RadialMotion, without(position, turned)),
)]
struct Orbit {
    m: f64,
    mu: f64,
    c: f64,
    w: f64,
    #[lagrangian(input)]
    push: f64,
}

/// A top whose foot slides on a spring along x, about the vertical of which it precesses: two coordinates remain, and T
/// couples one to the angles that do not.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(phi, theta, x, psi),
    define(w = angular_velocity_zxz(phi, theta, psi), z = x + l * cos(theta)),
    kinetic = 0.5 * w.dot(diagonal([i, i, i_s]) * w) + 0.5 * m * dot(z).powi(2) + 0.1 * m * dot(x) * dot(psi),
    potential = m * g * z + 0.5 * k * x.powi(2),
    output(spin = w.z, spinning_up = dot(w.z), precession = [dot(phi), dot(dot(phi))], height = z),
    event(horizontal = cos(theta), loops = dot(phi)),
    hamiltonian,
    energy_balance,
    sensitivities,
    routhian(NoddingTop),
)]
struct BouncingTop {
    i: f64,
    i_s: f64,
    m: f64,
    l: f64,
    g: f64,
    k: f64,
}

/// A symmetric top through its pole, where its reduced model has outputs, too.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(w = angular_velocity_zxz(phi, theta, psi)),
    kinetic = 0.5 * w.dot(diagonal([i, i, i_s]) * w),
    potential = weight * cos(theta),
    output(turning = dot(phi) + dot(psi), spin = w.z),
    hamiltonian,
    routhian(PolarMotion, half_angles),
)]
struct SleepingTop {
    i: f64,
    i_s: f64,
    weight: f64,
}

fn orbit() -> Orbit {
    Orbit {
        m: 1.3,
        mu: 1.1,
        c: 0.2,
        w: 0.7,
        push: 0.3,
    }
}

fn bouncing_top() -> BouncingTop {
    BouncingTop {
        i: 0.6,
        i_s: 0.25,
        m: 0.8,
        l: 0.4,
        g: 9.81,
        k: 30.0,
    }
}

/// A state of the full model away from the singularities of its coordinates.
fn state<const N: usize>(random: &mut Random) -> State<f64, N> {
    let mut state: State<f64, N> = random.state();
    for i in 0..2 {
        state.q[i] = 1.3 + 0.6 * state.q[i].sin();
    }
    state
}

#[test]
fn outputs_and_events_are_those_of_the_full_model() {
    let (orbit, top) = (orbit(), bouncing_top());
    let mut random = Random::default();
    for _ in 0..50 {
        let full = state::<2>(&mut random);
        let (reduced, start) = orbit.reduce(&full);
        let (found, expected) = (reduced.outputs(&start), orbit.outputs(&full));
        let values = |areal_rate: f64, velocity: SVector<f64, 2>, others: [f64; 3]| {
            let [first, second] = velocity.into();
            [&[areal_rate, first, second], &others[..]].concat()
        };
        let others = [
            found.angular_acceleration,
            found.radial_acceleration,
            found.distance,
        ];
        let found = values(found.areal_rate, found.velocity, others);
        let others = [
            expected.angular_acceleration,
            expected.radial_acceleration,
            expected.distance,
        ];
        let expected = values(expected.areal_rate, expected.velocity, others);
        assert_close("outputs of the orbit", &found, &expected, 1e-12);
        let (found, expected) = (
            reduced.event_functions(&start),
            orbit.event_functions(&full),
        );
        assert_close("events of the orbit", &found, &expected[..3], 1e-12);

        let full = state::<4>(&mut random);
        let (reduced, start) = top.reduce(&full);
        let (found, expected) = (reduced.outputs(&start), top.outputs(&full));
        let values = [found.spin, found.spinning_up, found.height];
        let of_full = [expected.spin, expected.spinning_up, expected.height];
        assert_close("outputs of the top", &values, &of_full, 1e-11);
        let (found, expected) = (found.precession, expected.precession);
        assert_close("precession", found.as_slice(), expected.as_slice(), 1e-11);
        let (found, expected) = (reduced.event_functions(&start), top.event_functions(&full));
        assert_close("events of the top", &found, &expected, 1e-11);
    }
    assert_eq!(RadialMotion::EVENTS, ["apsis", "rate[0]", "rate[1]"]);
    assert_eq!(RadialMotion::RATE.map(DeclaredEvent::index), [1, 2]);
    assert_eq!(NoddingTop::EVENTS, ["horizontal", "loops"]);
}

/// Under the reconstruction, too, and by series as by samples.
#[test]
fn events_occur_when_they_do_in_the_full_model() {
    let orbit = orbit();
    let start = State::new(0.0, [1.0, 0.2], [0.1, 1.2]);
    let (radial, reduced_start) = orbit.reduce(&start);
    macro_rules! watched {
        ($model:ident, $problem:expr, $method:expr) => {
            $problem
                .on([$model::APSIS, $model::RATE[0]])
                .record()
                .on($model::RATE[1])
                .falling()
                .record()
                .solve(12.0, $method)
                .unwrap()
        };
    }
    let expected = watched!(Orbit, Problem::new(&orbit, start), Taylor::new());
    let occurrences = |events: &[(usize, f64)]| {
        assert!(events.len() >= 5, "{events:?}");
        for (one, other) in events.iter().zip(expected.events()) {
            assert_eq!(one.0, other.event);
            assert!((one.1 - other.t).abs() < 1e-9, "{one:?} {other:?}");
        }
        assert_eq!(events.len(), expected.events().len());
    };
    let there = At::from((reduced_start, [0.2]));
    let motion = watched!(
        RadialMotion,
        Problem::new(radial.reconstruction(), there),
        Taylor::new()
    );
    let events = motion.events().iter().map(|event| (event.event, event.t));
    occurrences(&events.collect::<Vec<_>>());
    for (event, other) in motion.events().iter().zip(expected.events()) {
        let x: Phase<f64, 1, SVector<f64, 1>> = event.x;
        assert!((x.z[0] - other.x.q[1]).abs() < 1e-9);
    }
    let method = Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-13);
    let motion = watched!(RadialMotion, Problem::new(&radial, reduced_start), method);
    let events = motion.events().iter().map(|event| (event.event, event.t));
    occurrences(&events.collect::<Vec<_>>());
}

#[test]
fn energy_is_exchanged_as_in_the_full_model() {
    let (orbit, top) = (orbit(), bouncing_top());
    let mut random = Random::default();
    for _ in 0..50 {
        let full = state::<2>(&mut random);
        let (reduced, start) = orbit.reduce(&full);
        let (found, expected) = (reduced.energy_rate(&start), orbit.energy_rate(&full));
        assert_close("energy rate", &[found], &[expected], 1e-12);
        let full = state::<4>(&mut random);
        let (reduced, start) = top.reduce(&full);
        assert!(reduced.energy_rate(&start).abs() < 1e-12);
    }
}

/// ∂q̈/∂π at constant momenta, by central differences; the constants are among the parameters.
#[test]
fn sensitivities_are_derivatives_at_constant_momenta() {
    assert_eq!(RadialMotion::PARAMETERS, ["m", "c", "p_phi"]);
    assert_eq!(NoddingTop::PARAMETERS.len(), 8);
    let mut random = Random::default();
    for _ in 0..20 {
        let (radial, start) = orbit().reduce(&state::<2>(&mut random));
        let found = radial.sensitivities(&start);
        let fields: [fn(&mut RadialMotion) -> &mut f64; 3] =
            [|m| &mut m.m, |m| &mut m.c, |m| &mut m.p_phi];
        for (k, field) in fields.into_iter().enumerate() {
            let moved = |by: f64| {
                let mut moved = radial.clone();
                *field(&mut moved) += by;
                moved.accelerations(&start)
            };
            let expected = (moved(1e-5) - moved(-1e-5)) / 2e-5;
            let column = found.column(k).into_owned();
            assert_close("∂r̈/∂π", column.as_slice(), expected.as_slice(), 1e-7);
        }
        let (top, start) = bouncing_top().reduce(&state::<4>(&mut random));
        let found = top.sensitivities(&start);
        let moved = |by: f64| {
            let mut moved = top.clone();
            moved.p_psi += by;
            moved.accelerations(&start)
        };
        let expected = (moved(1e-5) - moved(-1e-5)) / 2e-5;
        let column = found.column(7).into_owned();
        assert_close("∂q̈/∂C", column.as_slice(), expected.as_slice(), 1e-6);
    }
}

/// M q̈ − f of the reduced model in its base parameters.
#[test]
fn the_regressor_is_that_of_the_reduced_equations() {
    assert_eq!(RadialMotion::BASE_PARAMETERS, ["c", "μ"]);
    let mut random = Random::default();
    for _ in 0..20 {
        let (radial, start) = orbit().reduce(&state::<2>(&mut random));
        let accelerations = SVector::from(random.array(-2.0, 2.0));
        let found = radial.regressor(&start, &accelerations) * radial.base_parameters()
            + radial.known_terms(&start, &accelerations);
        let expected = radial.inverse_dynamics(&start, &accelerations);
        assert_close("M q̈ − f", found.as_slice(), expected.as_slice(), 1e-13);
    }
}

/// Hamilton's equations of the reduced model: its momenta are those of the remaining coordinates of the full one.
#[test]
fn the_canonical_motion_is_that_of_the_full_model() {
    let top = bouncing_top();
    let full = State::new(0.0, [0.3, 1.1, 0.05, -0.4], [0.7, -0.3, 0.2, 9.0]);
    let (reduced, start) = top.reduce(&full);
    let (own, of_full) = (reduced.momenta(&start), top.momenta(&full));
    assert_close("p", own.as_slice(), &[of_full[1], of_full[2]], 1e-13);
    let method = Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-13);
    let equations = reduced.canonical_equations();
    let end = Problem::new(&equations, equations.canonical(&start));
    let end = end.solve(2.0, method).unwrap();
    let expected = Problem::new(&top, full).solve(2.0, method).unwrap();
    let expected = [expected.q[1], expected.q[2]];
    assert_close("q", end.q.as_slice(), &expected, 1e-9);
    // The Hamiltonian of the reduced model is that of the full one.
    let (found, expected) = (reduced.energy(&start), top.energy(&full));
    assert_close("H", &[found], &[expected], 1e-13);
}

/// In half angles the outputs have values at the pole.
#[test]
fn outputs_have_values_at_the_pole() {
    let top = SleepingTop {
        i: 0.4,
        i_s: 0.1,
        weight: 2.5,
    };
    let (reduced, start) = top.reduce(&State::new(0.0, [0.0; 3], [0.0, 0.0, 30.0]));
    let outputs = reduced.outputs(&start);
    assert_close(
        "φ̇ + ψ̇ and the spin",
        &[outputs.turning, outputs.spin],
        &[30.0, 30.0],
        1e-13,
    );
}
