//! The numbers of base parameters of arms: as published, and as the rank of what the inverse dynamics do with each inertial
//! parameter, by singular values.
//!
//! An arm of N rotational joints, each of them parallel or perpendicular to the next, has 7 N − 4 β₁ base parameters, of which
//! the first β₁ joints are parallel to each other, and two less if these are parallel to gravity (Mayeda, Yoshida and Osuka,
//! Base parameters of manipulator dynamic models, 1990; Gautier and Khalil, Direct calculation of minimum set of inertial
//! parameters of serial robots, 1990).

use lagrangian::nalgebra::DMatrix;
use lagrangian::prelude::*;
use lagrangian::rigid_body::{InertiaTensor, ProductsOfInertia};
use lagrangian_tests::Random;

/// The number of base parameters that is published.
const fn published(joints: usize, parallel: usize, along_gravity: bool) -> usize {
    7 * joints - 4 * parallel - if along_gravity { 2 } else { 0 }
}

/// Joints like those of the Puma 560, all links of which are any bodies.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(q[6]),
    define(
        r1 = rotation_z(q[0]),
        r2 = r1 * rotation_y(q[1]),
        r3 = r2 * rotation_y(q[2]),
        r4 = r3 * rotation_z(q[3]),
        r5 = r4 * rotation_y(q[4]),
        r6 = r5 * rotation_z(q[5]),
        elbow = r2 * [a2, 0.0, 0.0],
        wrist = elbow + r3 * [a3, d3, d4],
    ),
    body(
        link1 = (r1, [0.0, 0.0, 0.0]),
        link2 = (r2, [0.0, 0.0, 0.0]),
        link3 = (r3, elbow),
        link4 = (r4, wrist),
        link5 = (r5, wrist),
        link6 = (r6, wrist),
    ),
    gravity = [0.0, 0.0, -g],
    regressor(link1, link2, link3, link4, link5, link6),
)]
struct Puma {
    link1: RigidBody,
    link2: RigidBody,
    link3: RigidBody,
    link4: RigidBody,
    link5: RigidBody,
    link6: RigidBody,
    a2: f64,
    a3: f64,
    d3: f64,
    d4: f64,
    g: f64,
}

/// Two links in a vertical plane.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(q1, q2),
    define(r1 = rotation_z(q1), r2 = r1 * rotation_z(q2)),
    body(link1 = (r1, [0.0, 0.0, 0.0]), link2 = (r2, r1 * [l, 0.0, 0.0])),
    gravity = [0.0, -g, 0.0],
    regressor(link1, link2),
)]
struct VerticalArm {
    link1: RigidBody,
    link2: RigidBody,
    l: f64,
    g: f64,
}

/// The same in a horizontal plane.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(q1, q2),
    define(r1 = rotation_z(q1), r2 = r1 * rotation_z(q2)),
    body(link1 = (r1, [0.0, 0.0, 0.0]), link2 = (r2, r1 * [l, 0.0, 0.0])),
    gravity = [0.0, 0.0, -g],
    regressor(link1, link2),
)]
struct HorizontalArm {
    link1: RigidBody,
    link2: RigidBody,
    l: f64,
    g: f64,
}

/// The joints of `robot_arm_3dof` of the references, with any bodies as links.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(q[3]),
    define(
        r1 = rotation_z(q[0]),
        r2 = r1 * rotation_y(q[1]),
        r3 = r2 * rotation_y(q[2]),
    ),
    body(
        link1 = (r1, [0.0, 0.0, 0.0]),
        link2 = (r2, [0.0, 0.0, 0.0]),
        link3 = (r3, r2 * [l, 0.0, 0.0]),
    ),
    gravity = [0.0, 0.0, -g],
    regressor(link1, link2, link3),
)]
struct Elbow {
    link1: RigidBody,
    link2: RigidBody,
    link3: RigidBody,
    l: f64,
    g: f64,
}

/// A body about a fixed point.
#[derive(Lagrangian, Clone, Debug)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi)),
    body(link = (r, [0.0, 0.0, 0.0])),
    gravity = [0.0, 0.0, -g],
    regressor(link),
)]
struct Body {
    link: RigidBody,
    g: f64,
}

/// The ten inertial parameters of a body: m, m c, and the inertia about the origin of its axes.
type Inertial = [f64; 10];

/// A body of these parameters.
fn body([m, x, y, z, xx, yy, zz, xy, xz, yz]: Inertial) -> RigidBody {
    let products = ProductsOfInertia { xy, xz, yz };
    let inertia = InertiaTensor::from_moments_and_products([xx, yy, zz], products);
    RigidBody::with_inertia_about_origin(m, Vector3::new(x, y, z) / m, inertia).unwrap()
}

/// Parameters of some body.
fn any(random: &mut Random) -> Inertial {
    let [a, b, c, d, e, f] = random.array(0.0, 0.1);
    [
        1.5 + a,
        0.1 + b,
        0.15 - c,
        0.1 + d,
        1.0 + e,
        1.1 - f,
        1.2 + a,
        0.05,
        -0.03,
        0.02,
    ]
}

/// The rank of the changes of M q̈ − f by each inertial parameter of `links` bodies, at many random motions. M q̈ − f is linear
/// in these, so that differences are derivatives.
fn rank<const N: usize>(
    links: usize,
    forces: impl Fn(&[RigidBody], &State<f64, N>, &SVector<f64, N>) -> SVector<f64, N>,
) -> usize {
    let mut random = Random::default();
    let given: Vec<Inertial> = (0..links).map(|_| any(&mut random)).collect();
    let motions = 40;
    let mut columns = DMatrix::zeros(motions * N, 10 * links);
    for motion in 0..motions {
        let state: State<f64, N> = random.state();
        let accelerations: SVector<f64, N> = random.array(-5.0, 5.0).into();
        let at = |parameters: &[Inertial]| {
            let bodies: Vec<_> = parameters.iter().map(|x| body(*x)).collect();
            forces(&bodies, &state, &accelerations)
        };
        let before = at(&given);
        for j in 0..10 * links {
            let mut moved = given.clone();
            moved[j / 10][j % 10] += 0.01;
            let change = (at(&moved) - before) / 0.01;
            columns.view_mut((motion * N, j), (N, 1)).copy_from(&change);
        }
    }
    let values = columns.singular_values();
    let largest = values.max();
    let rank = values.iter().filter(|x| **x > 1e-8 * largest).count();
    // The values that count are far from those that are rounding errors.
    let least = values
        .iter()
        .filter(|x| **x > 1e-8 * largest)
        .fold(largest, |a, b| a.min(*b));
    assert!(least > 1e-5 * largest, "{values}");
    rank
}

#[test]
fn planar_arms_have_as_many_base_parameters_as_are_published() {
    let (l, g) = (0.7, 9.81);
    let found = rank(2, |links, state: &State<f64, 2>, a| {
        VerticalArm {
            link1: links[0],
            link2: links[1],
            l,
            g,
        }
        .inverse_dynamics(state, a)
    });
    assert_eq!(found, published(2, 2, false));
    assert_eq!(VerticalArm::BASE_PARAMETERS.len(), found);
    let found = rank(2, |links, state: &State<f64, 2>, a| {
        HorizontalArm {
            link1: links[0],
            link2: links[1],
            l,
            g,
        }
        .inverse_dynamics(state, a)
    });
    assert_eq!(found, published(2, 2, true));
    assert_eq!(HorizontalArm::BASE_PARAMETERS.len(), found);
}

#[test]
fn the_arm_of_three_joints_has_as_many_base_parameters_as_are_published() {
    let (l, g) = (0.5, 9.81);
    let found = rank(3, |links, state: &State<f64, 3>, a| {
        let [link1, link2, link3] = [links[0], links[1], links[2]];
        Elbow {
            link1,
            link2,
            link3,
            l,
            g,
        }
        .inverse_dynamics(state, a)
    });
    assert_eq!(found, published(3, 1, true));
    assert_eq!(Elbow::BASE_PARAMETERS.len(), found);
}

/// 36, as published for the Puma 560.
#[test]
fn the_puma_has_as_many_base_parameters_as_are_published() {
    let found = rank(6, |links, state: &State<f64, 6>, a| {
        let puma = Puma {
            link1: links[0],
            link2: links[1],
            link3: links[2],
            link4: links[3],
            link5: links[4],
            link6: links[5],
            a2: 0.4318,
            a3: 0.0203,
            d3: 0.1501,
            d4: 0.4318,
            g: 9.81,
        };
        puma.inverse_dynamics(state, a)
    });
    assert_eq!(found, published(6, 1, true));
    assert_eq!(
        Puma::BASE_PARAMETERS.len(),
        found,
        "{:#?}",
        Puma::BASE_PARAMETERS
    );
}

/// The inertia and the moment of mass about the point; the mass does not count.
#[test]
fn a_body_about_a_point_has_nine_base_parameters() {
    let found = rank(1, |links, state: &State<f64, 3>, a| {
        Body {
            link: links[0],
            g: 9.81,
        }
        .inverse_dynamics(state, a)
    });
    assert_eq!(found, 9);
    assert_eq!(Body::BASE_PARAMETERS.len(), found);
}

/// Two links with a mass, the distance of its centre from its joint and the inertia about that centre.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(q1, q2),
    define(
        elbow = l * [cos(q1), sin(q1)],
        p1 = c1 * [cos(q1), sin(q1)],
        p2 = elbow + c2 * [cos(q1 + q2), sin(q1 + q2)],
    ),
    kinetic = 0.5 * (m1 * dot(p1).norm_squared() + i1 * dot(q1).powi(2)),
    kinetic = 0.5 * (m2 * dot(p2).norm_squared() + i2 * dot(q1 + q2).powi(2)),
    potential = g * (m1 * p1.y + m2 * p2.y),
    regressor(i1, m1, c1, i2, m2, c2),
)]
struct ByCenters {
    i1: f64,
    m1: f64,
    c1: f64,
    i2: f64,
    m2: f64,
    c2: f64,
    l: f64,
    g: f64,
}

/// By link; what moves with an earlier link is regrouped with that, and nothing is divided by a length.
#[test]
fn base_parameters_read_as_in_the_books() {
    let expected = [
        "I₁ + m₁ c₁² + m₂ l²",
        "m₁ c₁ + m₂ l",
        "I₂ + m₂ c₂²",
        "m₂ c₂",
    ];
    assert_eq!(ByCenters::BASE_PARAMETERS, expected);
    let expected = [
        "m_link1·x_C_link1 + m_link2·l",
        "m_link1·y_C_link1",
        "m_link1·x_C_link1² + m_link1·y_C_link1² + I_link1₃₃ + m_link2·l²",
        "m_link2·x_C_link2",
        "m_link2·y_C_link2",
        "m_link2·x_C_link2² + m_link2·y_C_link2² + I_link2₃₃",
    ];
    assert_eq!(VerticalArm::BASE_PARAMETERS, expected);
    // Further out than the first one, all links of the Puma have seven.
    let of_link = |i: usize| {
        let name = format!("link{i}");
        let ends = |text: &&&str| {
            text.split(['_', '·', '²', '₁', '₂', '₃', ' ', '+', '−'])
                .find(|x| x.starts_with("link"))
                == Some(&name)
        };
        Puma::BASE_PARAMETERS.iter().filter(ends).count()
    };
    assert_eq!([1, 2, 3, 4, 5, 6].map(of_link), [1, 7, 7, 7, 7, 7]);
}
