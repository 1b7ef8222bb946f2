//! The Hamiltonian form, against the same motions in velocities and against derivatives of H, and the balance of energy.

use lagrangian::prelude::*;
use lagrangian::quantities;
use lagrangian::{CanonicalPhase, EnergyResidual, NoVelocities};
use lagrangian_tests::{Dual, Random, assert_close};

/// A pendulum on a driven, damped cart: T depends on time, and forces act.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    taylor,
    coordinates(x, theta),
    define(p = [x + a * sin(w * t) + l * sin(theta), -l * cos(theta)]),
    kinetic = 0.5 * cart * dot(x).powi(2) + 0.5 * m * dot(p).norm_squared(),
    potential = m * g * p.y + 0.5 * k * x.powi(2) + 0.3 * dot(x) * x * sin(theta),
    dissipation = 0.5 * d * dot(theta).powi(2),
    force(x = push),
    hamiltonian,
    energy_balance,
)]
struct DrivenCart {
    cart: f64,
    m: f64,
    l: f64,
    g: f64,
    k: f64,
    a: f64,
    w: f64,
    d: f64,
    #[lagrangian(input)]
    push: f64,
}

const CART: DrivenCart = DrivenCart {
    cart: 2.0,
    m: 0.7,
    l: 0.8,
    g: 9.81,
    k: 5.0,
    a: 0.3,
    w: 1.7,
    d: 0.2,
    push: 0.6,
};

/// A relativistic particle in a field: L is not quadratic in the velocity.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(r: Vector2),
    lagrangian = -m * c.powi(2) * (1.0 - dot(r).norm_squared() / c.powi(2)).sqrt() - k * r.x,
    hamiltonian,
)]
struct Relativistic {
    m: f64,
    c: f64,
    k: f64,
}

#[test]
fn velocities_and_momenta_are_converted_both_ways() {
    let mut random = Random::default();
    for _ in 0..100 {
        let state: State<f64, 2> = random.state();
        let phase = CART.canonical_equations().canonical(&state);
        let back = CART.canonical_equations().state(phase.t, &phase.x).unwrap();
        assert_close("velocities", back.v.as_slice(), state.v.as_slice(), 1e-14);
        let hamiltonian = CART.hamiltonian(state.t, &phase.x).unwrap();
        assert_close("H", &[hamiltonian], &[CART.energy(&state)], 1e-13);
    }
}

/// What is emitted for the velocities.
fn solved_velocities<M: quantities::Hamiltonian<N>, const N: usize>(
    model: &M,
    state: &State<f64, N>,
    momenta: &SVector<f64, N>,
) -> SVector<f64, N> {
    model.solved_velocities(state, momenta, &model.prepare())
}

/// The velocities are solved for by what is emitted, where L is quadratic in them and M is solved symbolically; elsewhere M is
/// factored by the library. Both ways agree.
#[test]
fn velocities_are_solved_for_by_the_factors_of_the_model() {
    let mut random = Random::default();
    for _ in 0..100 {
        let state: State<f64, 2> = random.state();
        let momenta = CART.momenta(&state);
        let found = solved_velocities(&CART, &state, &momenta);
        assert_close("q̇", found.as_slice(), state.v.as_slice(), 1e-13);
        let at_rest = State::new(state.t, state.q, SVector::zeros());
        let right = momenta - CART.momenta(&at_rest);
        let expected = CART.mass_matrix(&state).lu().solve(&right).unwrap();
        assert_close("M⁻¹ (p − b)", found.as_slice(), expected.as_slice(), 1e-12);
        let phase = CanonicalPhase {
            q: state.q,
            p: momenta,
        };
        let given = CART.with_inputs([2.0]);
        assert_eq!(given.velocities(state.t, &phase), Ok(found));
        // A mass that is negative makes M indefinite: M is factored with interchanges.
        let indefinite = DrivenCart { cart: -0.9, ..CART };
        let equations = indefinite.canonical_equations();
        let phase = equations.canonical(&state);
        let back = equations.state(phase.t, &phase.x).unwrap();
        assert_close("q̇", back.v.as_slice(), state.v.as_slice(), 1e-11);
    }
    let particle = Relativistic {
        m: 1.0,
        c: 3.0,
        k: 0.1,
    };
    let state = State::new(0.0, [0.1, 0.2], [1.0, 0.5]);
    let momenta = particle.momenta(&state);
    let found = solved_velocities(&particle, &state, &momenta);
    assert!(found.iter().all(|v| v.is_nan()));
}

/// A free body in Euler angles near their pole: no digits are lost on the way through momenta, since M is never formed.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(w = angular_velocity_zxz(phi, theta, psi)),
    kinetic = 0.5 * (i1 * w.x.powi(2) + i2 * w.y.powi(2) + i3 * w.z.powi(2)),
    hamiltonian,
)]
struct FreeBody {
    i1: f64,
    i2: f64,
    i3: f64,
}

#[test]
fn velocities_near_the_pole_keep_the_digits_that_momenta_have() {
    let body = FreeBody {
        i1: 1.0,
        i2: 2.0,
        i3: 3.0,
    };
    for theta in [1e-2, 1e-4, 1e-6_f64] {
        // Spinning about the axis of the body and precessing about an axis at right angles to the line of nodes.
        let state = State::new(0.0, [0.3, theta, 0.8], [0.4, 0.7, -0.2]);
        let momenta = body.momenta(&state);
        let found = solved_velocities(&body, &state, &momenta);
        // ω = E q̇ is regular at the pole, and so are the velocities along it.
        let omega = |v: &SVector<f64, 3>| {
            let (sin_psi, cos_psi) = state.q[2].sin_cos();
            [
                v[0] * theta.sin() * sin_psi + v[1] * cos_psi,
                v[0] * theta.sin() * cos_psi - v[1] * sin_psi,
                v[0] * theta.cos() + v[2],
            ]
        };
        // p_φ − p_ψ cos θ has lost as many digits as 1/θ has.
        let tolerance = 1e-15 + 1e-15 / theta;
        assert_close("ω", &omega(&found), &omega(&state.v), tolerance);
    }
}

/// Faster than light there is no Lagrangian: an error that says so, not one about masses.
#[test]
fn a_start_outside_of_the_domain_is_told_from_a_singular_mass_matrix() {
    let particle = Relativistic {
        m: 1.0,
        c: 3.0,
        k: 0.1,
    };
    let start = State::new(0.0, [0.0; 2], [3.5, 0.0]);
    let error = Problem::new(&particle, start).solve(1.0, Dop853::new());
    let text = error.unwrap_err().to_string();
    assert!(
        text.starts_with("at t = 0 the Lagrangian is not a number:"),
        "{text}"
    );
}

/// q̇ = ∂H/∂p and ṗ = −∂H/∂q + Q, with the derivatives of H by dual numbers.
#[test]
fn the_equations_are_those_of_hamilton() {
    let mut random = Random::default();
    for _ in 0..30 {
        let state: State<f64, 2> = random.state();
        let equations = CART.canonical_equations();
        let phase = equations.canonical(&state);
        let found = equations.derivative(state.t, &phase.x);
        let forces = CART.generalized_forces(&state);
        for i in 0..2 {
            let by = |of_q: f64, of_p: f64| {
                let moved = |x: &SVector<f64, 2>, rate: f64| {
                    SVector::from_fn(|j, _| Dual::new(x[j], if i == j { rate } else { 0.0 }))
                };
                let moved = CanonicalPhase {
                    q: moved(&phase.x.q, of_q),
                    p: moved(&phase.x.p, of_p),
                };
                let h = CART.hamiltonian(Dual::from_f64(state.t), &moved).unwrap();
                h.derivative()
            };
            assert_close("q̇", &[found.q[i]], &[by(0.0, 1.0)], 1e-12);
            assert_close("ṗ", &[found.p[i]], &[forces[i] - by(1.0, 0.0)], 1e-12);
        }
    }
}

#[test]
fn motions_are_those_in_velocities() {
    let start = State::new(0.3, [0.1, 0.5], [0.2, -1.0]);
    let method = Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-12);
    let given = CART.with_inputs([-1.5]);
    let equations = given.canonical_equations();
    let end = Problem::new(&equations, equations.canonical(&start))
        .solve(5.0, method)
        .unwrap();
    let found = equations.state(end.t, &end.x).unwrap();
    let expected = Problem::new(&given, start).solve(5.0, method).unwrap();
    assert_close("q", found.q.as_slice(), expected.q.as_slice(), 1e-9);
    assert_close("q̇", found.v.as_slice(), expected.v.as_slice(), 1e-9);
    assert_ne!(given.momentum_rates(&start), CART.momentum_rates(&start));
}

#[test]
fn a_lagrangian_that_is_not_quadratic_is_transformed_by_newtons_method() {
    let particle = Relativistic {
        m: 2.0,
        c: 3.0,
        k: 0.4,
    };
    let mut random = Random::default();
    for speed in [0.0, 0.1, 1.0, 2.0, 2.9] {
        let angle = random.between(0.0, 6.0);
        let state = State::new(
            0.0,
            random.array(-1.0, 1.0),
            [speed * angle.cos(), speed * angle.sin()],
        );
        let phase = particle.canonical_equations().canonical(&state).x;
        let found = particle.velocities(0.0, &phase).unwrap();
        let error = (found - state.v).norm();
        assert!(error < 1e-13, "{speed} {error:e}");
        // H = √(m² c⁴ + p² c²) + k x.
        let rest = 2.0 * 9.0_f64;
        let energy = (rest.powi(2) + phase.p.norm_squared() * 9.0).sqrt() + 0.4 * state.q[0];
        let found = particle.hamiltonian(0.0, &phase).unwrap();
        assert_close("H", &[found], &[energy], 1e-13);
    }
    let nowhere = CanonicalPhase::new([0.0; 2], [f64::NAN, 0.0]);
    let error = particle.velocities(0.0, &nowhere).unwrap_err();
    assert!(
        matches!(error, NoVelocities::NotFound { change } if !change.is_finite()),
        "{error}"
    );
    assert!(error.to_string().contains("singular"), "{error}");
    let slow = NoVelocities::NotFound { change: 0.5 };
    assert!(slow.to_string().contains("Newton"), "{slow}");
}

/// Its momentum ẋ³ − ẋ belongs to three velocities where it is small.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    lagrangian = 0.25 * dot(x).powi(4) - 0.5 * dot(x).powi(2) - 0.5 * x.powi(2),
    hamiltonian,
)]
struct Branched;

#[test]
fn momenta_of_several_velocities_have_none() {
    for v in [0.9, -0.6, 0.3] {
        let state = State::new(0.0, [0.0], [v]);
        let phase = Branched.canonical_equations().canonical(&state).x;
        let error = Branched.velocities(0.0, &phase).unwrap_err();
        assert_eq!(error, NoVelocities::NotConvex);
        assert!(error.to_string().contains("not convex"), "{error}");
    }
}

/// dh/dt by the chain rule along the motion, on dual numbers.
#[test]
fn the_rate_of_the_energy_is_that_along_the_motion() {
    let mut random = Random::default();
    for _ in 0..50 {
        let state: State<f64, 2> = random.state();
        let accelerations = CART.accelerations(&state);
        let along = State::new(
            Dual::new(state.t, 1.0),
            SVector::from_fn(|i, _| Dual::new(state.q[i], state.v[i])),
            SVector::from_fn(|i, _| Dual::new(state.v[i], accelerations[i])),
        );
        let expected = CART.energy(&along).derivative();
        assert_close("rate", &[CART.energy_rate(&state)], &[expected], 1e-12);
        let power = 0.6 * state.v[0] - 0.2 * state.v[1].powi(2);
        assert_close("power", &[CART.power(&state)], &[power], 1e-13);
    }
}

#[test]
fn every_method_keeps_the_balance_of_energy_as_well_as_its_tolerance() {
    let start = State::new(0.0, [0.1, 0.5], [0.2, -1.0]);
    let motion = Problem::new(&CART, start).save(Dense);
    let fine = motion.clone().solve(10.0, Taylor::new()).unwrap();
    let residual = EnergyResidual::along(&CART, &fine).unwrap();
    assert!(residual.largest.abs() < 1e-12, "{residual:?}");
    assert!(residual.exchanged > 1.0, "{residual:?}");
    let coarse = Dop853::new()
        .relative_tolerance(1e-5)
        .absolute_tolerance(1e-5);
    let coarse = motion.solve(10.0, coarse).unwrap();
    let rough = EnergyResidual::along(&CART, &coarse).unwrap();
    assert!((1e-9..1e-2).contains(&rough.largest.abs()), "{rough:?}");
    // Under another force than that of the model, the work is missing.
    let pushed = CART.with_inputs([1.6]);
    let wrong = Problem::new(&pushed, start).save(Dense);
    let wrong = wrong.solve(10.0, Taylor::new()).unwrap();
    let right = EnergyResidual::along(&pushed, &wrong).unwrap();
    assert!(right.largest.abs() < 1e-12, "{right:?}");
    let wrong = EnergyResidual::along(&CART, &wrong).unwrap();
    assert!(wrong.largest.abs() > 1e-2, "{wrong:?}");
}
