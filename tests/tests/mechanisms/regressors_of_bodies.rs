//! Regressors of arms whose links are bodies: as many base parameters as are published, and these from measured motions.

use lagrangian::identification::Identification;
use lagrangian::prelude::*;
use lagrangian::rigid_body::{InertiaTensor, ProductsOfInertia};
use lagrangian_tests::{Random, assert_close};

/// A planar arm of two links in a vertical plane (Khalil and Dombre, Modeling, Identification and Control of Robots, 2002,
/// chapter 9). The axes of a link have their origin at its joint.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(q1, q2),
    define(first = rotation_z(q1), second = rotation_z(q1 + q2)),
    body(upper = (first, [0.0, 0.0, 0.0]), lower = (second, first * [l, 0.0, 0.0])),
    gravity = [0.0, -g, 0.0],
    regressor(upper, lower),
)]
struct PlanarArm {
    upper: RigidBody,
    lower: RigidBody,
    l: f64,
    g: f64,
}

/// A column about the vertical, and two links about axes that are horizontal and parallel.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(q[3]),
    define(
        turned = rotation_z(q[0]),
        raised = turned * rotation_y(q[1]),
        bent = raised * rotation_y(q[2]),
    ),
    body(
        column = (turned, [0.0, 0.0, 0.0]),
        upper = (raised, [0.0, 0.0, 0.0]),
        lower = (bent, raised * [l, 0.0, 0.0]),
    ),
    gravity = [0.0, 0.0, -g],
    force(q[i] = torque[i] for i in 0..3),
    regressor(column, upper, lower),
)]
struct Elbow {
    column: SymmetricBody,
    upper: RigidBody,
    lower: RigidBody,
    l: f64,
    g: f64,
    #[lagrangian(input)]
    torque: [f64; 3],
}

/// Any body, by a random mass, centre and inertia.
fn body(random: &mut Random) -> RigidBody {
    let [m, x, y, z] = random.array(0.3, 1.2);
    let [a, b, c] = random.array(0.1, 0.3);
    let [xy, xz, yz] = random.array(-0.02, 0.02);
    let products = ProductsOfInertia { xy, xz, yz };
    let moments = [0.3 + a, 0.3 + b, 0.3 + c];
    let inertia = InertiaTensor::from_moments_and_products(moments, products);
    RigidBody::new(m, Vector3::new(x, y, z), inertia).unwrap()
}

fn elbow(random: &mut Random) -> Elbow {
    Elbow {
        column: SymmetricBody::new(12.0, 0.25, 0.5, 0.1).unwrap(),
        upper: body(random),
        lower: body(random),
        l: 0.6,
        g: 9.81,
        torque: [0.0; 3],
    }
}

/// ZZ₁ + m₂ l², MX₁ + m₂ l, MY₁, ZZ₂, MX₂, MY₂ of the planar arm; one parameter of the column and seven of
/// each further link of the other one (Gautier and Khalil, Direct calculation of minimum set of inertial parameters of serial
/// robots, 1990).
#[test]
fn there_are_as_many_base_parameters_as_are_published() {
    assert_eq!(
        PlanarArm::BASE_PARAMETERS.len(),
        6,
        "{:?}",
        PlanarArm::BASE_PARAMETERS
    );
    assert_eq!(
        Elbow::BASE_PARAMETERS.len(),
        15,
        "{:?}",
        Elbow::BASE_PARAMETERS
    );
    let mut random = Random::default();
    let (upper, lower, l) = (body(&mut random), body(&mut random), 0.7);
    let arm = PlanarArm {
        upper,
        lower,
        l,
        g: 9.81,
    };
    let found: SVector<f64, 6> = arm.base_parameters();
    // By another road: moments about the joints.
    let about_joint = |body: &RigidBody| {
        let (m, c) = (body.mass(), body.center());
        let zz = body.inertia().matrix()[(2, 2)] + m * (c.x * c.x + c.y * c.y);
        [m, m * c.x, m * c.y, zz]
    };
    let ([_, mx1, my1, zz1], [m2, mx2, my2, zz2]) = (about_joint(&upper), about_joint(&lower));
    let expected = [mx1 + m2 * l, my1, zz1 + m2 * l * l, mx2, my2, zz2];
    assert_close("base parameters", found.as_slice(), &expected, 1e-13);
}

#[test]
fn the_regressor_gives_the_inverse_dynamics() {
    let mut random = Random::default();
    for _ in 0..50 {
        let arm = Elbow {
            torque: random.array(-3.0, 3.0),
            ..elbow(&mut random)
        };
        let (state, accelerations) = (random.state(), random.array(-5.0, 5.0).into());
        let forces = arm.regressor(&state, &accelerations) * arm.base_parameters()
            + arm.known_terms(&state, &accelerations);
        let expected = arm.inverse_dynamics(&state, &accelerations);
        assert_close("M q̈ − f", forces.as_slice(), expected.as_slice(), 1e-12);
    }
}

/// Least squares over a motion whose torques are measured gives the base parameters back, and two arms that differ in nothing
/// else move alike.
#[test]
fn identification_gives_the_base_parameters_back() {
    let mut random = Random::default();
    let arm = elbow(&mut random);
    let law = |state: &State<f64, 3>| {
        let t = state.t;
        let wave = |w: f64| (w * t).sin();
        [
            3.0 * wave(1.7) - 2.0 * state.v[0],
            30.0 * wave(2.3) - 2.0 * state.v[1],
            15.0 * wave(3.1) - 2.0 * state.v[2],
        ]
    };
    let times: Vec<f64> = (1..=150).map(|k| 0.04 * f64::from(k)).collect();
    let start = State::new(0.0, [0.0, 0.4, -0.9], [0.3, 0.0, 0.0]);
    let motion = Problem::new(&arm, start)
        .feedback(law)
        .save(times)
        .solve(6.0, Dop853::new())
        .expect("a motion");
    // Nothing is known of the links.
    let nothing = arm.upper.map(|_| f64::NAN);
    let mut identification = Identification::new(Elbow::BASE_PARAMETERS);
    for state in motion {
        let torque = SVector::from(law(&state));
        let accelerations = arm.with_inputs(torque).accelerations(&state);
        let unknown = Elbow {
            upper: nothing,
            lower: nothing,
            ..arm.clone()
        };
        let model = unknown.with_inputs(torque);
        identification.add(&model, &state, &accelerations, &SVector::zeros());
    }
    let found = identification.solve().expect("a rich motion");
    let expected = arm.base_parameters();
    assert_close(
        "base parameters",
        found.parameters.as_slice(),
        expected.as_slice(),
        1e-8,
    );
}
