//! The heavy top in several spellings: in scalars as (4.5), in vectors, from its rotation alone. The
//! accelerations are the same to the last digits, near the poles too, and so is their cost.

use lagrangian::nalgebra::{Matrix3, Vector3};
use lagrangian::{Operations, prelude::*};
use lagrangian_tests::{Figures, Random, list, numbers};

/// Of the length of q̈; what cancels near the poles, left to rounding, would cost 1e-9.
const TOLERANCE: f64 = 1e-13;

/// Equation (4.5) in scalars.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        w1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        w2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        w3 = dot(phi) * cos(theta) + dot(psi),
    ),
    kinetic = 0.5 * (i1 * w1.powi(2) + i2 * w2.powi(2) + i3 * w3.powi(2)),
    potential = m * g * (x * sin(theta) * sin(psi) + y * sin(theta) * cos(psi) + z * cos(theta)),
)]
struct InScalars {
    i1: f64,
    i2: f64,
    i3: f64,
    m: f64,
    g: f64,
    x: f64,
    y: f64,
    z: f64,
}

/// The angular velocity of the angles, and the vertical as the body sees it.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        w = angular_velocity_zxz(phi, theta, psi),
        vertical = [sin(theta) * sin(psi), sin(theta) * cos(psi), cos(theta)],
    ),
    kinetic = 0.5 * w.dot(diagonal([i1, i2, i3]) * w),
    potential = m * g * center.dot(vertical),
)]
struct InVectors {
    i1: f64,
    i2: f64,
    i3: f64,
    m: f64,
    g: f64,
    center: Vector3<f64>,
}

/// All from the rotation.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), w = angular_velocity(r)),
    kinetic = 0.5 * w.dot(inertia.component_mul(w)),
    potential = m * g * (r * center).z,
)]
struct FromItsRotation {
    inertia: [f64; 3],
    m: f64,
    g: f64,
    center: Vector3<f64>,
}

/// The inertia turned into the axes of space.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        r = rotation_zxz(phi, theta, psi),
        w = angular_velocity_inertial(r),
        turned = r * diagonal(inertia) * r.transpose(),
    ),
    kinetic = 0.5 * w.dot(turned * w),
    potential = m * g * (r * center).z,
)]
struct InSpace {
    inertia: Vector3<f64>,
    m: f64,
    g: f64,
    center: Vector3<f64>,
}

/// Products of inertia (2.1), in scalars.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        w1 = dot(phi) * sin(theta) * sin(psi) + dot(theta) * cos(psi),
        w2 = dot(phi) * sin(theta) * cos(psi) - dot(theta) * sin(psi),
        w3 = dot(phi) * cos(theta) + dot(psi),
    ),
    kinetic = 0.5 * (ixx * w1.powi(2) + iyy * w2.powi(2) + izz * w3.powi(2))
        - ixy * w1 * w2 - ixz * w1 * w3 - iyz * w2 * w3,
    potential = m * g * (x * sin(theta) * sin(psi) + y * sin(theta) * cos(psi) + z * cos(theta)),
)]
struct ProductsOfInertia {
    ixx: f64,
    iyy: f64,
    izz: f64,
    ixy: f64,
    ixz: f64,
    iyz: f64,
    m: f64,
    g: f64,
    x: f64,
    y: f64,
    z: f64,
}

/// The tensor of inertia (2.1) from six inertias.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(
        r = rotation_zxz(phi, theta, psi),
        w = angular_velocity(r),
        inertia = [[ixx, -ixy, -ixz], [-ixy, iyy, -iyz], [-ixz, -iyz, izz]],
    ),
    kinetic = 0.5 * w.dot(inertia * w),
    potential = m * g * (r * center).z,
)]
struct SymmetricTensor {
    ixx: f64,
    iyy: f64,
    izz: f64,
    ixy: f64,
    ixz: f64,
    iyz: f64,
    m: f64,
    g: f64,
    center: Vector3<f64>,
}

/// The same, turned into the axes of space.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), w = angular_velocity_inertial(r)),
    kinetic = 0.5 * w.dot(r * inertia * r.transpose() * w),
    potential = m * g * (r * center).z,
)]
struct TensorInSpace {
    inertia: Matrix3<f64>,
    m: f64,
    g: f64,
    center: Vector3<f64>,
}

/// The tensor of inertia as one parameter, whose symmetry is nowhere written.
#[derive(Lagrangian)]
#[lagrangian(
    coordinates(phi, theta, psi),
    define(r = rotation_zxz(phi, theta, psi), w = angular_velocity(r)),
    kinetic = 0.5 * w.dot(inertia * w),
    potential = m * g * (r * center).z,
)]
struct Tensor {
    inertia: Matrix3<f64>,
    m: f64,
    g: f64,
    center: Vector3<f64>,
}

/// The parameters of the reference values near the poles.
const PRINCIPAL: [f64; 3] = [1.2, 1.5, 0.7];
const CENTER: [f64; 3] = [0.05, 0.03, 0.4];
const M: f64 = 1.3;
const G: f64 = 9.81;

/// The products of inertia Ixy, Ixz and Iyz of a body that is not turned to its principal axes.
const PRODUCTS: [f64; 3] = [0.11, -0.07, 0.16];

#[test]
fn spellings_about_principal_axes_agree() {
    let [i1, i2, i3] = PRINCIPAL;
    let [x, y, z] = CENTER;
    let (m, g, center) = (M, G, Vector3::from(CENTER));
    let scalars = InScalars {
        i1,
        i2,
        i3,
        m,
        g,
        x,
        y,
        z,
    };
    let vectors = InVectors {
        i1,
        i2,
        i3,
        m,
        g,
        center,
    };
    let rotation = FromItsRotation {
        inertia: PRINCIPAL,
        m,
        g,
        center,
    };

    let tensor = Matrix3::from_diagonal(&PRINCIPAL.into());
    let mut check = Check::new(&tensor, TOLERANCE);
    for states in [anywhere(), near_the_poles()] {
        check.compare("in scalars", &scalars, &states);
        check.compare("in vectors", &vectors, &states);
        check.compare("from its rotation", &rotation, &states);
    }
    check.figures.finish();
}

#[test]
fn spellings_with_products_of_inertia_agree() {
    let [ixx, iyy, izz] = PRINCIPAL;
    let [ixy, ixz, iyz] = PRODUCTS;
    let [x, y, z] = CENTER;
    let (m, g, center) = (M, G, Vector3::from(CENTER));
    let inertia = tensor();
    let scalars = ProductsOfInertia {
        ixx,
        iyy,
        izz,
        ixy,
        ixz,
        iyz,
        m,
        g,
        x,
        y,
        z,
    };
    let symmetric = SymmetricTensor {
        ixx,
        iyy,
        izz,
        ixy,
        ixz,
        iyz,
        m,
        g,
        center,
    };
    let tensor = Tensor {
        inertia,
        m,
        g,
        center,
    };

    // Among these states are some in which what turns φ nearly cancels.
    let mut check = Check::new(&inertia, 10.0 * TOLERANCE);
    for states in [anywhere(), near_the_poles()] {
        check.compare("in scalars", &scalars, &states);
        check.compare("a symmetric tensor", &symmetric, &states);
        check.compare("a tensor", &tensor, &states);
    }
    check.figures.finish();
}

#[test]
fn spellings_in_space_agree() {
    check_in_space(&anywhere(), 100.0 * TOLERANCE);
}

#[test]
fn spellings_in_space_agree_near_the_poles() {
    check_in_space(&near_the_poles(), 10.0 * TOLERANCE);
}

fn check_in_space(states: &[State<f64, 3>], tolerance: f64) {
    let (m, g, center) = (M, G, Vector3::from(CENTER));
    let principal = InSpace {
        inertia: PRINCIPAL.into(),
        m,
        g,
        center,
    };
    let mut check = Check::new(&Matrix3::from_diagonal(&principal.inertia), tolerance);
    check.compare("principal, in space", &principal, states);
    check.figures.finish();

    let general = TensorInSpace {
        inertia: tensor(),
        m,
        g,
        center,
    };
    let mut check = Check::new(&general.inertia, tolerance);
    check.compare("a tensor in space", &general, states);
    check.figures.finish();
}

#[test]
fn the_equations_of_euler_are_those_of_the_references() {
    let inertia = Matrix3::from_diagonal(&PRINCIPAL.into());
    let mut figures = Figures::new();
    for (state, expected) in references() {
        let error = (euler(&inertia, &state) - expected).norm() / expected.norm();
        figures.record("Euler's equations", &format!("{state:?}"), error, TOLERANCE);
    }
    figures.finish();
}

#[test]
fn spellings_cost_the_same() {
    let others = [
        ("in vectors", InVectors::OPERATIONS),
        ("from its rotation", FromItsRotation::OPERATIONS),
    ];
    assert_costs(&InScalars::OPERATIONS, &others);
    let others = [("a symmetric tensor", SymmetricTensor::OPERATIONS)];
    assert_costs(&ProductsOfInertia::OPERATIONS, &others);
}

#[test]
fn spellings_in_space_cost_the_same() {
    assert_costs(
        &InScalars::OPERATIONS,
        &[("principal, in space", InSpace::OPERATIONS)],
    );
    let others = [("a tensor in space", TensorInSpace::OPERATIONS)];
    assert_costs(&ProductsOfInertia::OPERATIONS, &others);
}

#[test]
fn a_tensor_costs_as_much_as_its_six_inertias() {
    assert_costs(
        &ProductsOfInertia::OPERATIONS,
        &[("a tensor", Tensor::OPERATIONS)],
    );
}

/// Each costs as much as the scalars, to a tenth.
fn assert_costs(scalars: &Operations, others: &[(&str, Operations)]) {
    let scalars = scalars.accelerations.total();
    println!("{scalars:>4} operations in scalars");
    for (name, operations) in others {
        let total = operations.accelerations.total();
        println!("{total:>4} operations: {name}");
        assert!(
            10 * total.abs_diff(scalars) <= scalars,
            "{name} costs {total}, not {scalars}"
        );
    }
}

/// Comparisons with Euler's equations for one body.
struct Check {
    inertia: Matrix3<f64>,
    tolerance: f64,
    figures: Figures,
}

impl Check {
    fn new(inertia: &Matrix3<f64>, tolerance: f64) -> Self {
        Self {
            inertia: *inertia,
            tolerance,
            figures: Figures::new(),
        }
    }

    /// The error of q̈, in relation to its length.
    fn compare(
        &mut self,
        name: &'static str,
        model: &impl Lagrangian<3>,
        states: &[State<f64, 3>],
    ) {
        for state in states {
            let expected = euler(&self.inertia, state);
            let error = (model.accelerations(state) - expected).norm() / expected.norm();
            self.figures
                .record(name, &format!("{state:?}"), error, self.tolerance);
        }
    }
}

/// A tensor of inertia (2.1) about axes that are not principal.
fn tensor() -> Matrix3<f64> {
    let ([ixx, iyy, izz], [ixy, ixz, iyz]) = (PRINCIPAL, PRODUCTS);
    Matrix3::new(ixx, -ixy, -ixz, -ixy, iyy, -iyz, -ixz, -iyz, izz)
}

fn anywhere() -> Vec<State<f64, 3>> {
    let mut random = Random::default();
    let states = std::iter::repeat_with(|| random.state());
    states
        .filter(|state| state.q[1].sin().abs() > 0.01)
        .take(500)
        .collect()
}

fn near_the_poles() -> Vec<State<f64, 3>> {
    references().into_iter().map(|(state, _)| state).collect()
}

/// States near the poles, and the accelerations of the body with principal axes, of 40 digits.
fn references() -> Vec<(State<f64, 3>, Vector3<f64>)> {
    let references = lagrangian_tests::near_the_poles();
    let inclinations = references["general"]["theta"].as_object();
    let cases = inclinations
        .expect("cases by inclination")
        .values()
        .flat_map(list);
    let vector = |value| Vector3::from_vec(numbers(value));
    cases
        .map(|case| {
            let state = State::new(0.0, vector(&case["q"]), vector(&case["qd"]));
            (state, vector(&case["qdd"]))
        })
        .collect()
}

/// Euler's equations I ω̇ + ω × I ω = N, with the moment of the weight, solved for the angles by the
/// inverse of (4.4).
fn euler(inertia: &Matrix3<f64>, state: &State<f64, 3>) -> Vector3<f64> {
    let [phi_dot, theta_dot, psi_dot] = state.v.into();
    let ((st, ct), (sp, cp)) = (state.q[1].sin_cos(), state.q[2].sin_cos());
    let vertical = Vector3::new(st * sp, st * cp, ct);
    let w = phi_dot * vertical + Vector3::new(theta_dot * cp, -theta_dot * sp, psi_dot);
    let moment = -M * G * Vector3::from(CENTER).cross(&vertical);
    let inverse = inertia.try_inverse().expect("a body has an inertia");
    let rate = inverse * (moment - w.cross(&(inertia * w)));
    // What is left for φ̈, θ̈ and ψ̈ of the rates of ω: the vertical turns by −ω × vertical.
    let line_of_nodes = Vector3::new(-sp, -cp, 0.0) * (theta_dot * psi_dot);
    let [b1, b2, b3] = (rate + phi_dot * w.cross(&vertical) - line_of_nodes).into();
    let phi = (b1 * sp + b2 * cp) / st;
    Vector3::new(phi, b1 * cp - b2 * sp, b3 - phi * ct)
}
