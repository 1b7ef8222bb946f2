//! The clause `reflect`: the fields by their names, and models made from their numbers.

use std::marker::PhantomData;

use lagrangian::nalgebra::{Matrix2x3, Point2};
use lagrangian::prelude::*;
use lagrangian::quantities::{FieldDescription, FieldElement, InvalidNumbers, Reflect};
use lagrangian::rigid_body::InertiaTensor;

/// Everything that a field can be.
///
/// And a second paragraph.
#[derive(Lagrangian, Clone, Debug, PartialEq)]
#[lagrangian(
    reflect,
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2))
        + 0.5 * masses[0][1] * dot(x).powi(2) + 0.5 * small * dot(y).powi(2),
    potential = k[2] * x.powi(2) + wide[(1, 0)] * y.powi(2) + anchor.x * x,
    force(x = push[0], y = push[1]),
    output(both = [x, y], table = [[x, y, t], [dot(x), dot(y), push[1]]], r#type = x * y),
    event(left = x, below = y - anchor.y),
)]
struct Everything {
    /// The mass in kg,
    /// of all.
    m: f64,
    masses: [[f64; 2]; 2],
    k: Vector3<f64>,
    wide: Matrix2x3<f64>,
    anchor: Point2<f64>,
    small: f32,
    #[lagrangian(input)]
    push: [f64; 2],
    #[lagrangian(skip)]
    label: String,
}

#[test]
fn fields_are_described_in_their_order() {
    let described = |field: &FieldDescription| (field.name, field.lengths, field.is_input);
    let fields: Vec<_> = Everything::FIELDS.iter().map(described).collect();
    let expected: [(&str, &[usize], bool); 7] = [
        ("m", &[], false),
        ("masses", &[2, 2], false),
        ("k", &[3], false),
        ("wide", &[2, 3], false),
        ("anchor", &[2], false),
        ("small", &[], false),
        ("push", &[2], true),
    ];
    assert_eq!(fields, expected);
    assert_eq!(
        Everything::FIELDS[0].documentation,
        "The mass in kg,\nof all."
    );
    assert_eq!(Everything::NAME, "Everything");
    assert_eq!(
        Everything::DOCUMENTATION,
        "Everything that a field can be.\n\nAnd a second paragraph."
    );
    let outputs = Everything::OUTPUTS
        .iter()
        .map(|output| (output.name, output.lengths));
    let expected: [(&str, &[usize]); 3] = [("both", &[2]), ("table", &[2, 3]), ("type", &[])];
    assert!(outputs.eq(expected));
    assert_eq!(<Everything as Reflect<2>>::INPUTS, ["push[0]", "push[1]"]);
    assert_eq!(<Everything as Reflect<2>>::EVENTS, ["left", "below"]);
    assert!(<Everything as Reflect<2>>::CONSTRAINTS.is_empty());
}

#[test]
fn a_model_is_made_from_its_numbers_row_by_row() -> Result<(), InvalidNumbers> {
    let numbers: Vec<f64> = (0..19).map(|i| 0.5 * f64::from(i)).collect();
    let made = Everything::from_numbers(&numbers)?;
    let expected = Everything {
        m: 0.0,
        masses: [[0.5, 1.0], [1.5, 2.0]],
        k: Vector3::new(2.5, 3.0, 3.5),
        wide: Matrix2x3::new(4.0, 4.5, 5.0, 5.5, 6.0, 6.5),
        anchor: Point2::new(7.0, 7.5),
        small: 8.0,
        push: [8.5, 9.0],
        label: String::new(),
    };
    assert_eq!(made, expected);
    let mut written = Vec::new();
    made.numbers(&mut |number| written.push(number));
    assert_eq!(written, numbers);
    Ok(())
}

#[test]
fn outputs_are_written_row_by_row() -> Result<(), InvalidNumbers> {
    let model = Everything::from_numbers(&[1.0; 19])?;
    let state = State::new(0.25, [2.0, 3.0], [5.0, 7.0]);
    let mut written = Vec::new();
    model.output_numbers(&state, &mut |number| written.push(number));
    assert_eq!(written, [2.0, 3.0, 2.0, 3.0, 0.25, 5.0, 7.0, 1.0, 6.0]);
    Ok(())
}

#[test]
fn too_few_and_too_many_numbers_are_errors() {
    for count in [0, 18, 20] {
        let error = Everything::from_numbers(&vec![1.0; count]).unwrap_err();
        assert_eq!(
            error,
            InvalidNumbers::Count {
                expected: 19,
                found: count
            }
        );
        assert!(error.to_string().contains("19 numbers, but there are"));
    }
}

/// On a scalar of its own. The second constraint is of velocities, so that there are both kinds.
#[derive(Lagrangian)]
#[allow(deprecated)]
#[lagrangian(
    reflect,
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * y,
    constraint(rod = x.powi(2) + y.powi(2) - 1),
    nonholonomic(skate = dot(x) - dot(y)),
)]
struct OnScalar<T: Scalar, U>
where
    U: Default,
{
    m: T,
    #[lagrangian(skip)]
    _mark: PhantomData<U>,
}

#[test]
fn a_generic_model_is_made_on_f64() -> Result<(), InvalidNumbers> {
    let model = OnScalar::<f64, u8>::from_numbers(&[3.0])?;
    let state = State::new(0.0, [0.6, -0.8], [0.1, 0.2]);
    assert_eq!(
        <OnScalar<f64, u8> as Reflect<2>>::CONSTRAINTS,
        ["rod", "skate"]
    );
    let mut written = Vec::new();
    model.multiplier_numbers(&state, &mut |number| written.push(number));
    assert_eq!(written, model.multipliers::<2>(&state).as_slice());
    Ok(())
}

/// Bodies.
#[derive(Lagrangian, PartialEq, Debug)]
#[lagrangian(
    reflect,
    coordinates(a, b, c),
    body(
        arms[0] = (rotation_z(a), [0.0, 0.0, 0.0]),
        arms[1] = (rotation_x(b), [0.0, 0.0, 0.0]),
        ball = (rotation_y(c), [0.0, 0.0, 0.0]),
        wheel = (rotation_z(a + b), [0.0, 0.0, 0.0]),
    ),
)]
struct Bodies {
    arms: [RigidBody; 2],
    ball: PrincipalBody,
    wheel: SymmetricBody,
}

#[test]
fn bodies_are_made_from_their_numbers() -> Result<(), Box<dyn std::error::Error>> {
    let elements = Bodies::FIELDS
        .iter()
        .map(|field| (field.element, field.lengths, field.count()));
    let expected: [(FieldElement, &[usize], usize); 3] = [
        (FieldElement::RigidBody, &[2], 26),
        (FieldElement::PrincipalBody, &[], 4),
        (FieldElement::SymmetricBody, &[], 4),
    ];
    assert!(elements.eq(expected));
    let arm = |mass| {
        let center = Vector3::new(0.1, 0.2, 0.3);
        let inertia = Matrix3::new(2.0, 0.1, 0.2, 0.1, 2.5, 0.3, 0.2, 0.3, 3.0);
        RigidBody::new(mass, center, InertiaTensor::from_matrix(&inertia)?)
    };
    let bodies = Bodies {
        arms: [arm(1.0)?, arm(2.0)?],
        ball: PrincipalBody::new(3.0, [0.5, 0.6, 0.7])?,
        wheel: SymmetricBody::new(4.0, 0.4, 0.3, 0.2)?,
    };
    let mut numbers = Vec::new();
    bodies.numbers(&mut |number| numbers.push(number));
    assert_eq!(numbers[..4], [1.0, 0.1, 0.2, 0.3]);
    assert_eq!(numbers[26..], [3.0, 0.5, 0.6, 0.7, 4.0, 0.4, 0.3, 0.2]);
    assert_eq!(Bodies::from_numbers(&numbers)?, bodies);

    numbers[13] = -2.0;
    let error = Bodies::from_numbers(&numbers).unwrap_err();
    assert_eq!(
        format!("{error:?}"),
        "the numbers of the field `arms` describe no body: the mass is -2, but has to be positive"
    );
    Ok(())
}
