//! Steady motions and the oscillations about them, against closed forms.

use crate::common::assert_close;
use lagrangian::analysis::{
    EquilibriumError, EquilibriumSearch, SmallOscillations, Variable, Verdict,
};
use lagrangian::prelude::*;
use lagrangian::rigid_body::SteadyPrecession;
use lagrangian::{Dual, Scalar};

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    kinetic = 0.5 * (i * (dot(phi).powi(2) * sin(theta).powi(2) + dot(theta).powi(2))
        + i_s * (dot(phi) * cos(theta) + dot(psi)).powi(2)),
    potential = mgl * cos(theta),
)]
struct Top<T: Scalar = f64> {
    i: T,
    i_s: T,
    mgl: T,
}

const TOP: Top = Top {
    i: 1.2,
    i_s: 0.5,
    mgl: 5.1,
};

/// φ̇ from (θ, ω₃), both solutions, above, at and below the horizontal, and for either sense of spin.
#[test]
fn steady_precession() {
    for (theta, spin) in [
        (0.5_f64, 40.0),
        (0.5, -40.0),
        (1e-3, 25.0),
        (2.0, 3.0),
        (3.1, 15.0),
    ] {
        let slope = -TOP.mgl * theta.sin();
        let closed = SteadyPrecession::of_top(TOP.i, TOP.i_s, spin, theta, slope);
        let SteadyPrecession::Two { slow, fast } = closed else {
            panic!("{closed:?}");
        };
        for rate in [slow, fast] {
            let guess = State::new(0.0, [0.3, theta, 0.0], [1.2 * rate, 0.0, spin]);
            let found = EquilibriumSearch::of(&TOP)
                .unknown(&[
                    Variable::Velocity(Top::<f64>::PHI),
                    Variable::Velocity(Top::<f64>::PSI),
                ])
                .momentum(Top::<f64>::PSI, TOP.i_s * spin)
                .near(&guess)
                .unwrap();
            assert_close(found.state.v[0] / rate, 1.0, 1e-12);
            assert_close(TOP.momenta(&found.state)[2], TOP.i_s * spin, 1e-12);
            assert_eq!(found.state.q, guess.q);
        }
    }
}

/// θ and both rates from the momenta: the effective potential has an extremum.
#[test]
fn steady_motion_with_given_momenta() {
    let expected = State::new(0.0, [0.0, 0.8, 0.0], [0.0, 0.0, 0.0]);
    let slope = -TOP.mgl * expected.q[1].sin();
    let closed = SteadyPrecession::of_top(TOP.i, TOP.i_s, 20.0, expected.q[1], slope);
    let SteadyPrecession::Two { slow, .. } = closed else {
        panic!("{closed:?}");
    };
    let mut motion = expected;
    (motion.v[0], motion.v[2]) = (slow, 20.0 - slow * motion.q[1].cos());
    let momenta = TOP.momenta(&motion);
    let mut guess = motion;
    guess.q[1] += 0.2;
    guess.v[0] *= 0.7;
    let found = EquilibriumSearch::of(&TOP)
        .unknown(&[
            Variable::Coordinate(1),
            Variable::Velocity(0),
            Variable::Velocity(2),
        ])
        .momentum(0, momenta[0])
        .momentum(2, momenta[2])
        .near(&guess)
        .unwrap();
    assert_close(found.state.q[1], 0.8, 1e-13);
    assert_close(found.state.v[0], slow, 1e-13);
    assert!(found.report.iterations <= 8, "{:?}", found.report);
}

/// A top that spins too slowly: accelerations that are left are told, and the closed form says by how much it is too slow.
#[test]
fn no_steady_precession() {
    let (theta, spin) = (0.5_f64, 5.0);
    let slope = -TOP.mgl * theta.sin();
    let closed = SteadyPrecession::of_top(TOP.i, TOP.i_s, spin, theta, slope);
    let SteadyPrecession::None {
        discriminant,
        least_axial_velocity,
    } = closed
    else {
        panic!("{closed:?}");
    };
    // |ω₃| ≥ (2/Iₛ) √(I m g l cos θ), and with it both rates are the same.
    let expected = 2.0 / TOP.i_s * (TOP.i * TOP.mgl * theta.cos()).sqrt();
    assert_close(least_axial_velocity, expected, 1e-14);
    for (factor, exists) in [(1.0 - 1e-9, false), (1.0 + 1e-9, true)] {
        let spin = factor * least_axial_velocity;
        let there = SteadyPrecession::of_top(TOP.i, TOP.i_s, spin, theta, slope);
        assert_eq!(matches!(there, SteadyPrecession::Two { .. }), exists);
    }
    let least = 4.0 * TOP.i * TOP.mgl * theta.cos() - (TOP.i_s * spin).powi(2);
    assert_close(-discriminant / theta.sin().powi(2), least, 1e-12);
    let error = EquilibriumSearch::of(&TOP)
        .unknown(&[Variable::Velocity(0), Variable::Velocity(2)])
        .momentum(2, TOP.i_s * spin)
        .near(&State::new(0.0, [0.0, theta, 0.0], [1.0, 0.0, spin]))
        .unwrap_err();
    let last = error.last().unwrap();
    assert!(matches!(error, EquilibriumError::Stalled { .. }), "{error}");
    let left = TOP.accelerations(&last.state)[1];
    assert!(last.report.residual >= left && left > 1.0, "{error}");
    assert!(last.report.condition > 1e6);
}

/// Ω² = φ̇² − 2 (m g l/I) cos θ + (m g l/(I φ̇))², about slow and fast precession; every one is stable.
#[test]
fn nutation() {
    let top = Top {
        i: 1.2,
        i_s: 0.5,
        mgl: 5.1,
    };
    for (theta, spin) in [
        (0.5_f64, 40.0),
        (0.5, 11.2),
        (1e-2, -30.0),
        (2.0, 3.0),
        (3.0, 15.0),
    ] {
        let slope = -top.mgl * theta.sin();
        let closed = SteadyPrecession::of_top(top.i, top.i_s, spin, theta, slope);
        let SteadyPrecession::Two { slow, fast } = closed else {
            panic!("{closed:?}");
        };
        for rate in [slow, fast] {
            let steady = State::new(
                0.0,
                [0.3, theta, -0.2],
                [rate, 0.0, spin - rate * theta.cos()],
            );
            let steady = EquilibriumSearch::of(&top)
                .unknown(&[Variable::Velocity(0)])
                .near(&steady)
                .unwrap()
                .state;
            let ratio = top.mgl / top.i;
            let expected = rate * rate - 2.0 * ratio * theta.cos() + (ratio / rate).powi(2);
            let oscillations = SmallOscillations::about(&top, &steady).unwrap();
            let found = oscillations.normal_modes().unwrap();
            assert_eq!(found.len(), 1);
            assert_close(found.squared_frequency(0) / expected, 1.0, 1e-9);
            let modes = oscillations.damped_modes().unwrap();
            assert_close(modes[0].natural_frequency() / expected.sqrt(), 1.0, 1e-9);
            // The hand-written Hessian of V_eff, with I.
            assert_close(
                oscillations.stiffness()[(1, 1)] / (top.i * expected),
                1.0,
                1e-9,
            );
            assert_eq!(oscillations.stability().unwrap().verdict(), Verdict::Stable);
            // δφ̇ from δp_φ = δp_ψ = 0: I sin²θ δφ̇ = (I_s ω₃ sin θ − 2 I φ̇ sin θ cos θ) δθ.
            let slope = (top.i_s * spin - 2.0 * top.i * rate * theta.cos()) / (top.i * theta.sin());
            let shape = modes[0].shape;
            let quotient = shape[0] / shape[1];
            assert_close(quotient.im * modes[0].eigenvalue.im / -slope, 1.0, 1e-9);
        }
    }
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(theta, phi),
    kinetic = 0.5 * m * l.powi(2) * (dot(theta).powi(2) + (sin(theta) * dot(phi)).powi(2)),
    potential = -m * g * l * cos(theta),
)]
struct Spherical {
    m: f64,
    l: f64,
    g: f64,
}

/// A conical pendulum: θ from the rate, the rate from θ, and both from the momentum.
#[test]
fn conical_pendulum() {
    let pendulum = Spherical {
        m: 0.7,
        l: 1.3,
        g: 9.81,
    };
    let theta = 0.9_f64;
    let rate = (pendulum.g / (pendulum.l * theta.cos())).sqrt();
    let momentum = pendulum.m * (pendulum.l * theta.sin()).powi(2) * rate;
    let search = || EquilibriumSearch::of(&pendulum);
    let guess = |theta: f64, rate: f64| State::new(0.0, [theta, 0.0], [0.0, rate]);
    let found = search().near(&guess(1.1, rate)).unwrap();
    assert_close(found.state.q[0], theta, 1e-13);
    let found = search()
        .unknown(&[Variable::Velocity(1)])
        .near(&guess(theta, 2.0))
        .unwrap();
    assert_close(found.state.v[1], rate, 1e-13);
    let found = search()
        .unknown(&[Variable::Coordinate(0), Variable::Velocity(1)])
        .momentum(1, momentum)
        .near(&guess(0.6, 2.0))
        .unwrap();
    assert_close(found.state.q[0], theta, 1e-13);
    assert_close(found.state.v[1], rate, 1e-13);
    // One of a family, if both are unknown.
    let found = search()
        .unknown(&[Variable::Coordinate(0), Variable::Velocity(1)])
        .near(&guess(0.6, 2.0))
        .unwrap();
    let [theta, rate] = [found.state.q[0], found.state.v[1]];
    assert_close(rate * rate * theta.cos(), pendulum.g / pendulum.l, 1e-12);
    assert_eq!(found.report.rank, 1);
}

/// A conical pendulum: Ω² = φ̇² (1 + 3 cos² θ).
#[test]
fn oscillations_of_a_conical_pendulum() {
    let pendulum = Spherical {
        m: 0.7,
        l: 1.3,
        g: 9.81,
    };
    let theta = 0.9_f64;
    let rate = (pendulum.g / (pendulum.l * theta.cos())).sqrt();
    let state = State::new(0.0, [theta, 0.0], [0.0, rate]);
    let oscillations = SmallOscillations::about(&pendulum, &state).unwrap();
    let square = oscillations.normal_modes().unwrap().squared_frequency(0);
    assert_close(
        square / (rate * rate * (1.0 + 3.0 * theta.cos().powi(2))),
        1.0,
        1e-13,
    );
}

#[test]
fn derivatives_by_parameters() {
    let constant = Dual::<f64, 2>::constant;
    let top = Top {
        i: constant(1.2),
        i_s: constant(0.5),
        mgl: Dual::variable(5.1, 0),
    };
    let slow = |mgl: f64, spin: f64| {
        let slope = -mgl * 0.5_f64.sin();
        match SteadyPrecession::of_top(1.2, 0.5, spin, 0.5, slope) {
            SteadyPrecession::Two { slow, .. } => slow,
            other => panic!("{other:?}"),
        }
    };
    let guess = State::new(
        constant(0.0),
        [0.0, 0.5, 0.0].map(constant),
        [0.2, 0.0, 40.0].map(constant),
    );
    let found = EquilibriumSearch::of(&top)
        .unknown(&[Variable::Velocity(0), Variable::Velocity(2)])
        .momentum(2, Dual::variable(20.0, 1))
        .near(&guess)
        .unwrap();
    let gradient = found.state.v[0].derivative;
    let h = 1e-5;
    let by_weight = (slow(5.1 + h, 40.0) - slow(5.1 - h, 40.0)) / (2.0 * h);
    let by_momentum = (slow(5.1, 40.0 + 2.0 * h) - slow(5.1, 40.0 - 2.0 * h)) / (2.0 * h);
    assert_close(gradient[0], by_weight, 1e-9);
    assert_close(gradient[1], by_momentum, 1e-9);
}

#[test]
fn what_was_asked_in_vain() {
    let of = || EquilibriumSearch::of(&TOP);
    let guess = State::new(0.0, [0.0, 0.5, 0.0], [0.3, 0.0, 40.0]);
    let text = |found: Result<_, EquilibriumError<f64, 3, 0>>| match found {
        Ok(found) => panic!("{found:?}"),
        Err(error) => error.to_string(),
    };
    let moving = State::new(0.0, [0.0, 0.5, 0.0], [0.3, 0.25, 40.0]);
    assert!(text(of().near(&moving)).starts_with("`theta` is not ignorable, so that its velocity"));
    assert!(text(of().momentum(1, 0.0).near(&guess)).contains("its momentum is no constant"));
    assert!(
        text(of().momentum(3, 0.0).near(&guess)).contains("no Velocity(3) among 3 coordinates")
    );
    assert!(text(of().unknown(&[Variable::Input(0)]).near(&guess)).contains("no Input(0)"));
    assert!(text(of().unknown(&[]).near(&guess)).starts_with("nothing is unknown"));
    let pole = State::new(0.0, [0.0, f64::NAN, 0.0], [0.3, 0.0, 40.0]);
    assert!(text(of().near(&pole)).contains("not finite after 0 Newton steps"));
    let few = of().max_iterations(1).unknown(&[Variable::Velocity(0)]);
    let error = few
        .near(&State::new(0.0, [0.0, 0.5, 0.0], [3.0, 0.0, 40.0]))
        .unwrap_err();
    assert!(
        matches!(error, EquilibriumError::NoConvergence { .. }),
        "{error}"
    );
    assert_eq!(error.last().unwrap().report.iterations, 1);
}
