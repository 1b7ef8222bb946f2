//! Equilibria and steady motions, against closed forms.

use lagrangian::analysis::{EquilibriumError, EquilibriumSearch, Variable};
use lagrangian::prelude::*;
use lagrangian::rigid_body::SteadyPrecession;
use lagrangian::{DoubleDouble, Scalar};

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(a, b),
    define(
        p = l * [sin(a), -cos(a)],
        q = p + l * [sin(b), -cos(b)],
    ),
    kinetic = 0.5 * m * (dot(p).norm_squared() + dot(q).norm_squared()),
    potential = m * g * (p.y + q.y),
    force(a = shoulder - elbow, b = elbow),
)]
struct DoublePendulum {
    m: f64,
    l: f64,
    g: f64,
    #[lagrangian(input)]
    shoulder: f64,
    #[lagrangian(input)]
    elbow: f64,
}

const ARM: DoublePendulum = DoublePendulum {
    m: 1.5,
    l: 0.5,
    g: 9.81,
    shoulder: 0.0,
    elbow: 0.0,
};

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

/// The restricted problem of three bodies in the rotating frame, in units of the distance and the angular velocity of the primaries.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    define(
        r1 = ((x + mu).powi(2) + y.powi(2)).sqrt(),
        r2 = ((x - 1 + mu).powi(2) + y.powi(2)).sqrt(),
    ),
    kinetic = 0.5 * ((dot(x) - y).powi(2) + (dot(y) + x).powi(2)),
    potential = -(1 - mu) / r1 - mu / r2,
)]
struct ThreeBodies<T: Scalar = f64> {
    mu: T,
}

#[track_caller]
fn assert_near(found: f64, expected: f64, tolerance: f64) {
    let error = (found - expected).abs();
    assert!(error <= tolerance, "{found} is not {expected}: {error:e}");
}

fn rest<const N: usize>(q: [f64; N]) -> State<f64, N> {
    State::new(0.0, q, [0.0; N])
}

#[test]
fn all_equilibria_of_a_double_pendulum() {
    let pi = std::f64::consts::PI;
    for [a, b] in [[0.0, 0.0], [0.0, pi], [pi, 0.0], [pi, pi]] {
        for offset in [0.2, -0.25] {
            let guess = rest([a + offset, b - 0.7 * offset]);
            let found = EquilibriumSearch::of(&ARM).near(&guess).unwrap();
            assert_near(found.state.q[0], a, 1e-14);
            assert_near(found.state.q[1], b, 1e-14);
            assert!(found.report.residual < 1e-12, "{:?}", found.report);
            assert_eq!(found.report.rank, 2);
        }
    }
}

/// Where the Jacobian is singular, or nearly so, Newton's step is endless; it is shortened.
#[test]
fn from_a_place_without_a_slope() {
    let quarter = std::f64::consts::FRAC_PI_2;
    let found = EquilibriumSearch::of(&ARM)
        .near(&rest([quarter, quarter]))
        .unwrap();
    for angle in found.state.q.iter() {
        assert_near(angle.sin(), 0.0, 1e-13);
    }
    assert!(found.report.iterations > 1);
}

/// Torques about both joints against the weights.
#[test]
fn trim() {
    let [a, b] = [0.7, -0.4];
    let found = EquilibriumSearch::trim(&ARM)
        .unknown(&[
            Variable::Input(DoublePendulum::SHOULDER),
            Variable::Input(DoublePendulum::ELBOW),
        ])
        .near(&rest([a, b]))
        .unwrap();
    let weight = ARM.m * ARM.g * ARM.l;
    let elbow = weight * b.sin();
    assert_near(found.inputs[1], elbow, 1e-13);
    assert_near(found.inputs[0], 2.0 * weight * a.sin() + elbow, 1e-13);
    assert_eq!(found.state, rest([a, b]));

    // The elbow alone holds where its torque and the angle of the upper arm are right.
    let found = EquilibriumSearch::trim(&ARM)
        .unknown(&[
            Variable::Coordinate(DoublePendulum::A),
            Variable::Input(DoublePendulum::ELBOW),
        ])
        .near(&rest([0.1, b]))
        .unwrap();
    assert_near(found.inputs[1], elbow, 1e-13);
    assert_near(2.0 * found.state.q[0].sin(), -b.sin(), 1e-13);
}

#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, z),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(z).powi(2)),
    potential = m * g * z,
)]
struct Stone {
    m: f64,
    g: f64,
}
#[test]
fn what_cannot_be_balanced() {
    let search = EquilibriumSearch::trim(&ARM);
    let error = search
        .unknown(&[Variable::Input(DoublePendulum::ELBOW)])
        .near(&rest([0.7, -0.4]))
        .unwrap_err();
    let EquilibriumError::Unbalanced { residual, last, .. } = error else {
        panic!("{error}");
    };
    assert!(residual > 1.0);
    let forces = ARM.with_inputs(last.inputs).accelerations(&last.state);
    assert_near(forces.amax(), residual, 1e-12);

    let error = EquilibriumSearch::of(&Stone { m: 1.0, g: 9.81 })
        .near(&rest([0.0, 1.0]))
        .unwrap_err();
    assert!(error.to_string().contains("cannot balance `z`"), "{error}");
    assert!(error.to_string().contains("9.81"), "{error}");
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
            assert_near(found.state.v[0] / rate, 1.0, 1e-12);
            assert_near(TOP.momenta(&found.state)[2], TOP.i_s * spin, 1e-12);
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
    assert_near(found.state.q[1], 0.8, 1e-13);
    assert_near(found.state.v[0], slow, 1e-13);
    assert!(found.report.iterations <= 8, "{:?}", found.report);
}

/// A top that spins too slowly: accelerations that are left are told, and the closed form says by how much it is too slow.
#[test]
fn no_steady_precession() {
    let (theta, spin) = (0.5_f64, 5.0);
    let slope = -TOP.mgl * theta.sin();
    let closed = SteadyPrecession::of_top(TOP.i, TOP.i_s, spin, theta, slope);
    let SteadyPrecession::None { discriminant } = closed else {
        panic!("{closed:?}");
    };
    let least = 4.0 * TOP.i * TOP.mgl * theta.cos() - (TOP.i_s * spin).powi(2);
    assert_near(-discriminant / theta.sin().powi(2), least, 1e-12);
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

/// A conical pendulum: θ from the rate, the rate from θ, and both from the momentum.
#[test]
fn conical_pendulum() {
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
    assert_near(found.state.q[0], theta, 1e-13);
    let found = search()
        .unknown(&[Variable::Velocity(1)])
        .near(&guess(theta, 2.0))
        .unwrap();
    assert_near(found.state.v[1], rate, 1e-13);
    let found = search()
        .unknown(&[Variable::Coordinate(0), Variable::Velocity(1)])
        .momentum(1, momentum)
        .near(&guess(0.6, 2.0))
        .unwrap();
    assert_near(found.state.q[0], theta, 1e-13);
    assert_near(found.state.v[1], rate, 1e-13);
    // One of a family, if both are unknown.
    let found = search()
        .unknown(&[Variable::Coordinate(0), Variable::Velocity(1)])
        .near(&guess(0.6, 2.0))
        .unwrap();
    let [theta, rate] = [found.state.q[0], found.state.v[1]];
    assert_near(rate * rate * theta.cos(), pendulum.g / pendulum.l, 1e-12);
    assert_eq!(found.report.rank, 1);
}

/// Along the ring of the orbit the potential is nearly constant, and where Newton's paths from these guesses lead, the Jacobian is
/// singular.
#[test]
fn from_beyond_a_singular_jacobian() {
    let mut descents = 0;
    for mu in [0.3, 0.05, 0.012, 0.001] {
        for [x, y] in [
            [0.4, 0.8],
            [0.45, 0.85],
            [0.3, 0.9],
            [0.6, 0.6],
            [0.45, -0.7_f64],
        ] {
            let found = EquilibriumSearch::of(&ThreeBodies { mu })
                .near(&rest([x, y]))
                .unwrap();
            assert_near(found.state.q[0], 0.5 - mu, 1e-12);
            assert_near(found.state.q[1], y.signum() * 0.75_f64.sqrt(), 1e-12);
            descents += usize::from(found.report.descent_steps > 0);
        }
    }
    assert!(descents > 0);
}

/// Lagrange's points: the triangular ones exactly, the collinear ones of the Earth and the Moon as published
/// (V. Szebehely, *Theory of Orbits*, 1967, for μ = 0.012150 and thereabouts) by the quintic equations of Euler.
#[test]
fn lagrange_points() {
    let model = ThreeBodies { mu: 0.012_15 };
    let find = |x, y| {
        EquilibriumSearch::of(&model)
            .near(&rest([x, y]))
            .unwrap()
            .state
            .q
    };
    for sign in [1.0, -1.0] {
        let found = find(0.45, sign * 0.8);
        assert_near(found[0], 0.5 - model.mu, 1e-15);
        assert_near(found[1], sign * 0.75_f64.sqrt(), 1e-15);
    }
    let mu = model.mu;
    let slope = |x: f64| {
        let [first, second] = [x + mu, x - 1.0 + mu];
        x - (1.0 - mu) * first / first.abs().powi(3) - mu * second / second.abs().powi(3)
    };
    for [mut low, mut high, guess] in [[0.5, 0.98, 0.8], [0.995, 1.5, 1.2], [-1.5, -0.5, -0.9]] {
        while high - low > 1e-15 {
            let middle = 0.5 * (low + high);
            if middle <= low || middle >= high {
                break;
            }
            if slope(middle) < 0.0 {
                low = middle;
            } else {
                high = middle;
            }
        }
        let found = find(guess, 0.0);
        assert_near(found[0], low, 1e-13);
        assert_near(found[1], 0.0, 0.0);
    }
}

/// With 30 digits, and with derivatives by parameters.
#[test]
fn other_scalars() {
    let mu = DoubleDouble::from_f64(0.3);
    let zero = DoubleDouble::from_f64(0.0);
    let guess = State::new(zero, [0.2, 0.8].map(DoubleDouble::from_f64), [zero; 2]);
    let found = EquilibriumSearch::of(&ThreeBodies { mu })
        .near(&guess)
        .unwrap();
    let height = DoubleDouble::from_f64(0.75).sqrt();
    assert_near((found.state.q[1] - height).to_f64(), 0.0, 1e-30);
}

#[cfg(feature = "num-dual")]
#[test]
fn derivatives_by_parameters() {
    use num_dual::DualSVec64;
    type Dual = DualSVec64<2>;
    let top = Top {
        i: Dual::from_re(1.2),
        i_s: Dual::from_re(0.5),
        mgl: Dual::from_re(5.1).derivative(0),
    };
    let constant = Dual::from_re;
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
        .momentum(2, Dual::from_re(20.0).derivative(1))
        .near(&guess)
        .unwrap();
    let gradient = found.state.v[0].eps.0.unwrap();
    let h = 1e-5;
    let by_weight = (slow(5.1 + h, 40.0) - slow(5.1 - h, 40.0)) / (2.0 * h);
    let by_momentum = (slow(5.1, 40.0 + 2.0 * h) - slow(5.1, 40.0 - 2.0 * h)) / (2.0 * h);
    assert_near(gradient[0], by_weight, 1e-9);
    assert_near(gradient[1], by_momentum, 1e-9);
}
