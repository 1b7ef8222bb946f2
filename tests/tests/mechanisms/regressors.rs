//! Regressors: the published base parameters of arms, and their identification from measurements with noise.

use lagrangian::identification::{Identification, IdentificationError, Identified};
use lagrangian::prelude::*;
use lagrangian_tests::{Random, assert_close};

/// The planar arm of two links with gravity (Khalil and Dombre, Modeling, Identification and Control of Robots, 2002,
/// chapter 9): inertial parameters about the joints, viscous friction; the length l and g are known.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(q1, q2),
    define(
        elbow = l * [cos(q1), sin(q1)],
        moment = [mx2 * cos(q1 + q2) - my2 * sin(q1 + q2), mx2 * sin(q1 + q2) + my2 * cos(q1 + q2)],
    ),
    kinetic = 0.5 * (zz1 * dot(q1).powi(2) + zz2 * dot(q1 + q2).powi(2) + m2 * dot(elbow).norm_squared())
        + dot(elbow).dot(dot(moment)),
    potential = g * (mx1 * sin(q1) + my1 * cos(q1) + m2 * elbow.y + moment.y),
    dissipation = 0.5 * (friction[0] * dot(q1).powi(2) + friction[1] * dot(q2).powi(2)),
    regressor(zz1, mx1, my1, zz2, mx2, my2, m2, friction),
)]
struct TwoLinks {
    zz1: f64,
    mx1: f64,
    my1: f64,
    zz2: f64,
    mx2: f64,
    my2: f64,
    m2: f64,
    l: f64,
    g: f64,
    friction: [f64; 2],
}

const TWO_LINKS: TwoLinks = TwoLinks {
    zz1: 0.3,
    mx1: 0.6,
    my1: -0.1,
    zz2: 0.2,
    mx2: 0.5,
    my2: 0.05,
    m2: 1.7,
    l: 0.8,
    g: 9.81,
    friction: [0.4, 0.25],
};

/// The arm of the references, with unknown masses, places and inertias.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(q[3]),
    define(
        turn = rotation_z(q[0]),
        upper = turn * [cos(q[1]), 0.0, sin(q[1])],
        lower = turn * [cos(q[1] + q[2]), 0.0, sin(q[1] + q[2])],
        elbow = l2 * upper,
        c2 = a2 * upper,
        c3 = elbow + a3 * lower,
        rates = (0..3).map(|i| dot(q[i])).collect(),
    ),
    kinetic = 0.5 * j1 * dot(q[0]).powi(2),
    kinetic = 0.5 * (m2 * dot(c2).norm_squared() + i2 * dot(upper).norm_squared()),
    kinetic = 0.5 * (m3 * dot(c3).norm_squared() + i3 * dot(lower).norm_squared()),
    potential = g * (m2 * c2.z + m3 * c3.z),
    dissipation = 0.5 * rates.dot(friction.component_mul(rates)),
    force(q[i] = torque[i] for i in 0..3),
    regressor(j1, i2, i3, m2, m3, a2, a3, friction),
)]
struct RobotArm {
    j1: f64,
    m2: f64,
    m3: f64,
    l2: f64,
    a2: f64,
    a3: f64,
    i2: f64,
    i3: f64,
    g: f64,
    friction: [f64; 3],
    #[lagrangian(input)]
    torque: SVector<f64, 3>,
}

const ROBOT_ARM: RobotArm = RobotArm {
    j1: 0.5,
    m2: 4.0,
    m3: 2.5,
    l2: 0.5,
    a2: 0.25,
    a3: 0.2,
    i2: 0.1,
    i3: 0.05,
    g: 9.81,
    friction: [0.3, 0.2, 0.1],
    torque: SVector::<f64, 3>::new(0.0, 0.0, 0.0),
};

/// A state and an acceleration.
fn instant<const N: usize>(random: &mut Random) -> (State<f64, N>, SVector<f64, N>) {
    (random.state(), random.array(-5.0, 5.0).into())
}

/// A number from the normal distribution of deviation 1 (Box and Muller 1958).
fn normal(random: &mut Random) -> f64 {
    let radius = (-2.0 * random.between(1e-12, 1.0).ln()).sqrt();
    radius * (std::f64::consts::TAU * random.between(0.0, 1.0)).cos()
}

#[test]
fn the_base_parameters_are_the_published_ones() {
    let expected = [
        "zz₁ + m₂ l²",
        "mx₁ + m₂ l",
        "my₁",
        "zz₂",
        "mx₂",
        "my₂",
        "friction₀",
        "friction₁",
    ];
    assert_eq!(TwoLinks::BASE_PARAMETERS, expected);
    let l = TWO_LINKS.l;
    let values = [
        0.3 + 1.7 * l * l,
        0.6 + 1.7 * l,
        -0.1,
        0.2,
        0.5,
        0.05,
        0.4,
        0.25,
    ];
    let found: SVector<f64, 8> = TWO_LINKS.base_parameters();
    assert_close("base parameters", found.as_slice(), &values, 1e-15);
    // Of the arm: 3 about the axes, 2 of gravity, and friction.
    assert_eq!(RobotArm::BASE_PARAMETERS.len(), 8);
}

#[test]
fn the_regressor_gives_the_inverse_dynamics() {
    let mut random = Random::default();
    for _ in 0..100 {
        let (state, accelerations) = instant(&mut random);
        let forces = TWO_LINKS.regressor(&state, &accelerations) * TWO_LINKS.base_parameters();
        let known = TWO_LINKS.known_terms(&state, &accelerations);
        assert_eq!(known, SVector::<f64, 2>::zeros());
        let expected = TWO_LINKS.inverse_dynamics(&state, &accelerations);
        assert_close("two links", forces.as_slice(), expected.as_slice(), 1e-13);

        let (state, accelerations) = instant(&mut random);
        let arm = RobotArm {
            torque: random.array(-3.0, 3.0).into(),
            ..ROBOT_ARM
        };
        let forces = arm.regressor(&state, &accelerations) * arm.base_parameters()
            + arm.known_terms(&state, &accelerations);
        let expected = arm.inverse_dynamics(&state, &accelerations);
        assert_close("arm", forces.as_slice(), expected.as_slice(), 1e-13);
        // The inputs are all that is known.
        let known = arm.known_terms(&state, &accelerations);
        assert_close("known", known.as_slice(), (-arm.torque).as_slice(), 1e-15);
    }
}

/// No direction of base parameters is without effect: the columns are independent, and one that is left out changes
/// the forces.
#[test]
fn the_columns_are_independent_functions_of_the_motion() {
    let mut random = Random::default();
    let mut gram = SMatrix::<f64, 8, 8>::zeros();
    for _ in 0..50 {
        let (state, accelerations) = instant(&mut random);
        let columns = ROBOT_ARM.regressor(&state, &accelerations);
        gram += columns.transpose() * columns;
    }
    let scale = gram.diagonal().map(|x| 1.0 / x.sqrt());
    let scaled = SMatrix::<f64, 8, 8>::from_fn(|i, j| gram[(i, j)] * scale[i] * scale[j]);
    assert!(scaled.symmetric_eigenvalues().min() > 1e-3);
}

/// (π̂ − π)ᵀ C⁻¹ (π̂ − π).
fn mahalanobis<const B: usize>(found: &Identified<B>, expected: &SVector<f64, B>) -> f64
where
    nalgebra::Const<B>: nalgebra::DimMin<nalgebra::Const<B>, Output = nalgebra::Const<B>>,
{
    let error = found.parameters - expected;
    let solved = found.covariance.lu().solve(&error).expect("a covariance");
    error.dot(&solved)
}

/// The arm follows its torques; these are measured with noise, the motion is not.
#[test]
fn parameters_are_identified_with_the_covariance_that_is_expected() {
    let deviation = 0.05;
    let law = |state: &State<f64, 3>| {
        let t = state.t;
        [
            (1.3 * t).sin() * 4.0,
            22.0 + 8.0 * (2.1 * t).cos(),
            5.0 * (3.3 * t).sin() + 3.0,
        ]
    };
    let times: Vec<f64> = (1..=200).map(|k| 0.02 * f64::from(k)).collect();
    let start = State::new(0.0, [0.0, 0.3, -0.5], [0.0; 3]);
    let motion = Problem::new(&ROBOT_ARM, start)
        .feedback(law)
        .save(times)
        .solve(4.0, Dop853::new())
        .expect("a motion");
    let unknown = RobotArm {
        j1: 0.0,
        m2: 0.0,
        m3: 0.0,
        a2: 0.0,
        a3: 0.0,
        i2: 0.0,
        i3: 0.0,
        friction: [0.0; 3],
        ..ROBOT_ARM
    };
    let expected = ROBOT_ARM.base_parameters();
    let mut random = Random::default();
    let (mut distances, mut sum) = (Vec::new(), SVector::<f64, 8>::zeros());
    let runs = 100;
    let mut squares = SVector::<f64, 8>::zeros();
    for _ in 0..runs {
        let mut identification = Identification::new(RobotArm::BASE_PARAMETERS);
        for state in motion.samples() {
            let torque = SVector::from(law(state));
            let accelerations = ROBOT_ARM.with_inputs(torque).accelerations(state);
            let measured = torque + SVector::from_fn(|_, _| deviation * normal(&mut random));
            let model = unknown.with_inputs(measured);
            let none = SVector::zeros();
            identification.add_weighted(
                &model,
                state,
                &accelerations,
                &none,
                &SVector::repeat(deviation),
            );
        }
        let found = identification.solve().expect("a rich motion");
        // 592 degrees of freedom: the variance is 1 ± 0.058.
        assert!(
            (found.variance - 1.0).abs() < 5.0 * 0.058,
            "{}",
            found.variance
        );
        distances.push(mahalanobis(&found, &expected));
        let deviations = found.standard_deviations();
        let errors = (found.parameters - expected).component_div(&deviations);
        sum += errors;
        squares += errors.component_mul(&errors);
    }
    // χ² with 8 degrees of freedom: 8 ± 4, in the mean of 100 runs 8 ± 0.4.
    let mean = distances.iter().sum::<f64>() / f64::from(runs);
    assert!((mean - 8.0).abs() < 4.0 * 0.4, "{mean}");
    // Each parameter is free of bias, 0 ± 0.1, and its deviation is the one that is told, 1 ± 0.14.
    for (mean, square) in (sum / f64::from(runs))
        .iter()
        .zip((squares / f64::from(runs)).iter())
    {
        assert!(mean.abs() < 0.45, "{mean}");
        assert!((square - 1.0).abs() < 0.65, "{square}");
    }
}

#[test]
fn a_poor_motion_names_what_it_does_not_excite() {
    let mut identification = Identification::new(TwoLinks::BASE_PARAMETERS);
    let mut random = Random::default();
    for _ in 0..50 {
        // At rest only gravity acts: nothing tells the inertias and the friction.
        let state = State::new(0.0, random.array(-3.0, 3.0), [0.0; 2]);
        let forces = TWO_LINKS.inverse_dynamics(&state, &SVector::zeros());
        identification.add(&TWO_LINKS, &state, &SVector::zeros(), &forces);
    }
    let error = identification.solve().expect_err("a poor motion");
    let IdentificationError::PoorExcitation { direction, .. } = error else {
        panic!("{error}");
    };
    let visible = [1, 2, 4, 5].map(|i| direction[i].abs());
    assert!(visible.iter().all(|x| *x < 1e-6), "{direction}");
    assert!(error.to_string().contains("does not excite"), "{error}");

    // Equal rates of both joints: their frictions act on different joints, but the second inertia moves with the first.
    let few = Identification::<8>::new(TwoLinks::BASE_PARAMETERS).solve();
    assert_eq!(
        few,
        Err(IdentificationError::TooFewEquations { equations: 0 })
    );
    let mut broken = Identification::new(TwoLinks::BASE_PARAMETERS);
    let state = State::new(0.0, [f64::NAN, 0.0], [0.0; 2]);
    broken.add(&TWO_LINKS, &state, &SVector::zeros(), &SVector::zeros());
    assert_eq!(
        broken.solve(),
        Err(IdentificationError::NotFinite { equation: 0 })
    );
}

/// A slider on a spring whose rest length and gear are known, with a force that is known and a part of the mass, too.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(x),
    kinetic = 0.5 * (m + carriage + rotor / (r1 + r2).powi(2) + belt * r1 / (r1 + r2)) * dot(x).powi(2),
    potential = 0.5 * k * (x - drift * t).powi(2) + (x.powi(2) + width.powi(2)).sqrt(),
    force(x = -d * dot(x)),
    regressor(m, rotor, belt, k, d),
)]
struct Slider {
    m: f64,
    carriage: f64,
    rotor: f64,
    belt: f64,
    r1: f64,
    r2: f64,
    k: f64,
    drift: f64,
    width: f64,
    d: f64,
}

/// What is regrouped depends on known parameters, and what is known stays out.
#[test]
fn known_parameters_stay_in_the_columns() {
    let slider = Slider {
        m: 1.5,
        carriage: 0.7,
        rotor: 0.02,
        belt: 0.3,
        r1: 0.1,
        r2: 0.15,
        k: 40.0,
        drift: 0.2,
        width: 0.5,
        d: 1.1,
    };
    assert_eq!(Slider::BASE_PARAMETERS.len(), 3);
    let mass = 1.5 + 0.02 / 0.25_f64.powi(2) + 0.3 * 0.1 / 0.25;
    let found: SVector<f64, 3> = slider.base_parameters();
    assert_close(
        "base parameters",
        found.as_slice(),
        &[mass, 40.0, 1.1],
        1e-14,
    );
    let mut random = Random::default();
    let (state, accelerations) = instant(&mut random);
    let (x, v, a, t) = (state.q[0], state.v[0], accelerations[0], state.t);
    let row = slider.regressor(&state, &accelerations);
    assert_close("row", row.as_slice(), &[a, x - 0.2 * t, v], 1e-14);
    let known = slider.known_terms(&state, &accelerations);
    let expected = 0.7 * a + x / (x * x + 0.25).sqrt();
    assert_close("known", known.as_slice(), &[expected], 1e-14);
}

/// All parameters are unknown, components of arrays, vectors and matrices included; the angle of the mount is within
/// functions, and known.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), w = angular_velocity(r)),
    kinetic = 0.5 * w.dot(inertia * w),
    potential = -(r * moment).dot(gravity),
    regressor(inertia, moment),
)]
struct Body {
    inertia: Matrix3<f64>,
    moment: Vector3<f64>,
    gravity: Vector3<f64>,
}

/// A rigid body about a fixed point has its 6 moments of inertia and 3 of mass (Gautier and Khalil 1990).
#[test]
fn a_body_about_a_point_has_nine_base_parameters() {
    assert_eq!(
        Body::BASE_PARAMETERS.len(),
        9,
        "{:?}",
        Body::BASE_PARAMETERS
    );
    let body = Body {
        inertia: Matrix3::new(2.0, 0.1, 0.2, 0.3, 3.0, -0.1, 0.1, 0.2, 4.0),
        moment: Vector3::new(0.1, 0.2, 0.9),
        gravity: Vector3::new(0.0, 0.0, -9.81),
    };
    let mut random = Random::default();
    for _ in 0..20 {
        let (state, accelerations) = instant(&mut random);
        let found = body.regressor(&state, &accelerations) * body.base_parameters();
        let expected = body.inverse_dynamics(&state, &accelerations);
        assert_close("body", found.as_slice(), expected.as_slice(), 1e-12);
    }
}
