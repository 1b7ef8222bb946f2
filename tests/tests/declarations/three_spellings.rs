//! The heavy top in several spellings: in scalars as (4.5), in vectors, from its rotation alone. The
//! accelerations are the same to the last digits, near the poles too, and so is their cost.

mod models;
mod comparison;

use lagrangian::nalgebra::{Matrix3, Vector3};
use lagrangian::{Operations, prelude::*};
use lagrangian_tests::Figures;

use comparison::{Check, anywhere, euler, near_the_poles, references, tensor};
use models::{
    FromItsRotation, InScalars, InSpace, InVectors, ProductsOfInertia, SymmetricTensor, Tensor,
    TensorInSpace,
};

/// Of the length of q̈; what cancels near the poles, left to rounding, would cost 1e-9.
const TOLERANCE: f64 = 1e-13;

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
