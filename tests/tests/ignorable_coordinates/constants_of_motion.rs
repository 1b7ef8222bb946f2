//! The constants of motion of textbook systems, as they are published, and their changes along integrations.

#![allow(clippy::float_cmp)] // What is watched is exactly what the model computes.

use lagrangian::ConstantsWatch;
use lagrangian::prelude::*;
use lagrangian_tests::{assert_close, relative_error};

use crate::models::{FurutaPendulum, Gyroscope, Kepler, Satellite, SphericalPendulum, Top, top};

/// A symmetric top as three squares (4.5), with friction on the spin.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(w = angular_velocity_zxz(phi, theta, psi)),
    kinetic = 0.5 * i * w.x.powi(2) + 0.5 * i * w.y.powi(2) + 0.5 * i_s * w.z.powi(2),
    potential = m * g * l * cos(theta),
    dissipation = 0.5 * friction * dot(psi).powi(2),
)]
struct DampedTop {
    i: f64,
    i_s: f64,
    m: f64,
    g: f64,
    l: f64,
    friction: f64,
}

/// A cart on which a force acts that its position does not change.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * m * dot(x).powi(2),
    force(x = push),
)]
struct Pushed {
    m: f64,
    push: f64,
}

/// Two bodies that turn freely about one axis, with a spring between them: it is neither angle alone that is ignorable.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * dot(x).powi(2) + 0.5 * dot(y).powi(2),
    potential = 0.5 * k * (x - y).powi(2),
)]
struct Spring {
    k: f64,
}

fn names<M, const N: usize, const C: usize>(_: &M) -> ([&'static str; C], &'static [usize])
where
    M: ConstantsOfMotion<N, C>,
{
    (M::CONSTANTS_OF_MOTION, M::IGNORABLE_COORDINATES)
}

/// The momenta of cyclic coordinates and, where L does not depend on t, the energy function: H. Goldstein, C. Poole and
/// J. Safko, Classical Mechanics, 3rd edition, 2002, 2.6 and 2.7.
#[test]
fn constants_are_those_that_are_published() {
    assert_eq!(names(&top()), (["p_phi", "p_psi", "energy"], &[0, 2][..]));
    let kepler = Kepler { m: 1.0, mu: 1.0 };
    assert_eq!(names(&kepler), (["p_phi", "energy"], &[1][..]));
    let (m, l, g) = (1.0, 1.0, 9.81);
    let pendulum = SphericalPendulum { m, l, g };
    assert_eq!(names(&pendulum), (["p_phi", "energy"], &[1][..]));
    let furuta = FurutaPendulum {
        inertia_arm: 0.1,
        inertia_rod: 0.02,
        m,
        length: 0.7,
        l,
        g,
        friction: 0.1,
        torque: 0.0,
    };
    // Friction on the rod takes energy.
    assert_eq!(names(&furuta), (["p_arm"], &[0][..]));
    let satellite = Satellite {
        i: 2.0,
        i_s: 1.0,
        n: 0.1,
    };
    assert_eq!(names(&satellite), (["p_psi", "energy"], &[2][..]));
    let gyroscope = Gyroscope {
        outer_gimbal: 0.3,
        inner_gimbal: [0.1, 0.2, 0.3],
        a: 0.4,
        c: 0.7,
        weight: 1.0,
    };
    let expected = (["p_alpha", "p_gamma", "energy"], &[0, 2][..]);
    assert_eq!(names(&gyroscope), expected);
    assert_eq!(names(&Spring { k: 1.0 }), (["energy"], &[][..]));
}

/// A force takes away what it acts on, and the energy if it does work.
#[test]
fn dissipation_on_the_spin_leaves_one_momentum() {
    let damped = DampedTop {
        i: 0.4,
        i_s: 0.1,
        m: 1.3,
        g: 9.81,
        l: 0.2,
        friction: 0.01,
    };
    assert_eq!(names(&damped), (["p_phi"], &[0][..]));
}

/// The momenta (4.8): that of φ is I φ̇ sin²θ and cos θ times that of ψ, which is Iₛ (ψ̇ + φ̇ cos θ).
/// What is printed names the same momenta as the trait.
#[test]
fn printed_constants_are_those_of_the_trait() {
    assert!(Top::EQUATIONS.contains("p_φ and p_ψ are constant."));
    assert!(DampedTop::EQUATIONS.contains("p_φ is constant."));
    assert!(!Pushed::EQUATIONS.contains("constant"));
}

#[test]
fn momenta_of_the_top_are_those_of_the_book() {
    let top = top();
    for (theta, v) in [(0.4, [0.7, -0.3, 20.0]), (2.5, [-3.0, 1.0, 0.2])] {
        let state = State::new(1.0, [0.3, theta, -2.0], v);
        let (s, c) = f64::sin_cos(theta);
        let c_psi = top.i_s * (v[2] + v[0] * c);
        let c_phi = top.i * v[0] * s * s + c_psi * c;
        let energy = 0.5 * top.i * (v[1] * v[1] + (v[0] * s).powi(2))
            + c_psi * c_psi / (2.0 * top.i_s)
            + top.m * top.g * top.l * c;
        let found = top.constants_of_motion(&state);
        assert_close(
            "constants",
            found.as_slice(),
            &[c_phi, c_psi, energy],
            1e-14,
        );
    }
}

/// They are watched under any method, and the largest change is taken over the observed states.
#[test]
fn changes_are_watched_along_a_motion() {
    let top = top();
    let start = State::new(0.0, [0.0, 0.5, 0.0], [0.1, 0.0, 40.0]);
    let problem = Problem::new(&top, start);
    let changes = |integrate: &dyn Fn(&mut ConstantsWatch<'_, Top, f64, 3, 3>)| {
        let mut watch = top.watch_constants(&start);
        integrate(&mut watch);
        let changes = watch.largest_changes();
        assert_eq!(
            changes.map(|change| change.name),
            ["p_phi", "p_psi", "energy"]
        );
        let initial = changes.map(|change| change.initial);
        assert_eq!(initial, <[f64; 3]>::from(top.constants_of_motion(&start)));
        changes
    };
    macro_rules! watched {
        ($method:expr) => {
            changes(&|watch| {
                let problem = problem
                    .clone()
                    .each_step(|progress| watch.observe(progress));
                problem.solve(2.0, $method).unwrap();
            })
        };
    }
    let loose = watched!(RungeKutta::classical(0.01));
    let method = Dop853::new()
        .relative_tolerance(1e-12)
        .absolute_tolerance(1e-14);
    let tight = watched!(method);
    let series = watched!(Taylor::new());
    for (loose, (tight, series)) in loose.into_iter().zip(tight.into_iter().zip(series)) {
        assert!(loose.change.abs() > 1e-9, "{loose:?}");
        assert!(loose.t > 0.0 && loose.t <= 2.0, "{loose:?}");
        assert!(tight.change.abs() < 1e-9, "{tight:?}");
        assert!(series.change.abs() < 1e-12, "{series:?}");
    }
    // The same change is found by hand, over all steps.
    let mut largest = (0.0, 0.0);
    let energy = top.energy(&start);
    let by_hand = problem.each_step(|progress| {
        let change = top.energy(&At::from((progress.t, *progress.x))) - energy;
        if f64::abs(change) > f64::abs(largest.0) {
            largest = (change, progress.t);
        }
    });
    by_hand.solve(2.0, RungeKutta::classical(0.01)).unwrap();
    assert_eq!((loose[2].change, loose[2].t), largest);
}

/// A change that is not a number is not forgotten.
#[test]
fn a_singular_state_is_reported() {
    let kepler = Kepler { m: 1.0, mu: 1.0 };
    let start = State::new(0.0, [1.0, 0.0], [0.0, 0.5]);
    let mut watch = kepler.watch_constants(&start);
    for (rate, t) in [(0.6, 1.0), (f64::NAN, 2.0), (0.9, 3.0)] {
        let x = Phase::new([1.0, 0.0], [0.0, rate]);
        let progress = Progress {
            kind: ObservationKind::Step,
            t,
            x: &x,
            start: 0.0,
            end: 3.0,
            statistics: Statistics::default(),
        };
        watch.observe(&progress);
    }
    let [momentum, _] = watch.largest_changes();
    assert!(momentum.change.is_nan());
    assert_eq!(momentum.t, 2.0);
    assert!(relative_error(&[momentum.initial], &[0.5], 1.0) == 0.0);
}
