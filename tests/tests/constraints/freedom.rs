//! Degrees of freedom: their number against the singular values of G, and the independent coordinates that are proposed.
#![allow(clippy::float_cmp)] // What is held is not changed at all.

use lagrangian::assembly::DegreesOfFreedom;
use lagrangian::prelude::*;
use lagrangian::quantities::Constraints;
use lagrangian::rigid_body::InertiaTensor;
use nalgebra::{DMatrix, Matrix3, Vector3};

use crate::mechanisms::{Disc, FourBar, Platform};

/// The door of a wagon hangs on three hinges: one holds a point, another its place in the plane, and the third one direction of
/// it.
#[allow(clippy::struct_field_names)] // Its body has its name.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    coordinates(s, p: Vector3, psi, theta, phi),
    define(
        r = rotation_xyz(psi, theta, phi),
        hinge[i] = p + r * hinges[i] - hinges[i] for i in 0..3,
    ),
    body(door = (r, p)),
    kinetic = 0.5 * m * dot(s).powi(2),
    constraint(
        first = hinge[0] - [s, 0.0, 0.0],
        second = [hinge[1].x - s, hinge[1].y],
        third = hinge[2].x - s,
    ),
)]
struct Door {
    m: f64,
    door: RigidBody,
    hinges: [Vector3<f64>; 3],
}

/// A wheel that rolls on a line.
#[allow(deprecated)] // It is declared by its velocities, though it is holonomic.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    coordinates(x, phi, psi),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(psi).powi(2)) + 0.5 * inertia * dot(phi).powi(2),
    constraint(gear = psi - 2.0 * phi),
    nonholonomic(roll = dot(x) - r * dot(phi)),
)]
struct Wheel {
    m: f64,
    inertia: f64,
    r: f64,
}

fn door() -> Door {
    let inertia = Matrix3::from_diagonal(&Vector3::new(0.5, 0.6, 0.7));
    let inertia = InertiaTensor::from_matrix(&inertia).expect("an inertia tensor");
    let door = RigidBody::new(2.0, Vector3::new(0.4, 0.0, 1.0), inertia).expect("a body");
    let hinges = [0.2, 1.0, 1.8].map(|height| Vector3::new(0.0, 0.0, height));
    Door {
        m: 30.0,
        door,
        hinges,
    }
}

/// The rows of G at q, from the residuals of unit velocities.
fn rows<M, const N: usize, const C: usize>(model: &M, q: [f64; N], rows: usize) -> DMatrix<f64>
where
    M: Lagrangian<N, Model: Constraints<N, C>>,
{
    let at = |v: [f64; N]| model.constraint_residuals(&State::new(0.0, q, v)).1;
    let rest = at([0.0; N]);
    DMatrix::from_fn(rows, N, |row, column| {
        let mut unit = [0.0; N];
        unit[column] = 1.0;
        at(unit)[row] - rest[row]
    })
}

fn rank(matrix: &DMatrix<f64>) -> usize {
    let values = matrix.singular_values();
    let limit = 1e-9 * values.max();
    values.iter().filter(|value| **value > limit).count()
}

/// Compares the numbers, and looks whether the columns of what depends on the rest have full rank. Returns what was found.
fn check<M, const N: usize, const C: usize>(model: &M, q: [f64; N]) -> DegreesOfFreedom<N, C>
where
    M: Lagrangian<N, Model: Constraints<N, C>>,
{
    let freedom = model.degrees_of_freedom(&State::new(0.0, q, [0.0; N]));
    let holonomic = <M::Model as Constraints<N, C>>::HOLONOMIC;
    let of_coordinates = (rows(model, q, holonomic), freedom.coordinates);
    let of_velocities = (rows(model, q, C), freedom.velocities);
    let chosen: [Vec<usize>; 2] = [
        freedom.independent_coordinates().collect(),
        freedom.independent_velocities().collect(),
    ];
    for ((g, number), independent) in [of_coordinates, of_velocities].into_iter().zip(&chosen) {
        let rank = rank(&g);
        assert_eq!(number, N - rank, "{g}");
        assert_eq!(independent.len(), number);
        let dependent: Vec<_> = (0..N).filter(|i| !independent.contains(i)).collect();
        let values = g.select_columns(&dependent).singular_values();
        assert_eq!(values.len(), rank);
        assert!(values.min() > 0.05 * g.singular_values().max(), "{values}");
    }
    assert!(chosen[1].iter().all(|i| chosen[0].contains(i)));
    assert!(freedom.velocities >= <M::Model as Constraints<N, C>>::MIN_DEGREES_OF_FREEDOM);
    // What is redundant can be left out.
    let redundant: Vec<_> = freedom.redundant_constraints().collect();
    let g = rows(model, q, C);
    let others: Vec<_> = (0..C).filter(|i| !redundant.contains(i)).collect();
    assert_eq!(rank(&g.select_rows(&others)), others.len());
    assert_eq!(rank(&g), others.len());
    // A reaction is unique if its row is no combination of the others.
    let without = |i: usize| g.clone().remove_row(i);
    let indeterminate: Vec<_> = (0..C).filter(|i| rank(&without(*i)) == rank(&g)).collect();
    let found: Vec<_> = freedom.indeterminate_reactions().collect();
    assert_eq!(found, indeterminate, "{freedom}");
    freedom
}

fn names<const N: usize>(
    all: [&'static str; N],
    indices: impl Iterator<Item = usize>,
) -> Vec<&'static str> {
    indices.map(|i| all[i]).collect()
}

#[test]
fn a_door_on_three_hinges_turns() {
    let (door, swung) = (door(), [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.3]);
    let freedom = check(&door, swung);
    assert_eq!((freedom.coordinates, freedom.velocities), (2, 2));
    assert_eq!(freedom.redundant_constraints().count(), 1);
    let text = freedom.to_string();
    assert!(text.contains("2 degrees of freedom in "), "{text}");
    assert!(text.contains("; redundant: "), "{text}");
    assert!(text.contains("; reactions that are not unique: "), "{text}");
    assert_eq!(<Door as Constraints<7, 6>>::MIN_DEGREES_OF_FREEDOM, 1);
    // Hinges that are not on one axis hold it.
    let mut bent = door;
    bent.hinges[2].y = 0.5;
    assert_eq!(check(&bent, [0.0; 7]).velocities, 1);
}

#[test]
fn a_platform_on_three_bars_has_one_freedom() {
    let angle = 0.8_f64;
    let q = [
        Platform::PARALLEL.l * angle.sin(),
        -Platform::PARALLEL.l * angle.cos(),
        0.0,
    ];
    let freedom = check(&Platform::PARALLEL, q);
    assert_eq!((freedom.coordinates, freedom.velocities), (1, 1));
    // Bars nearer to the vertical leave the other coordinate free.
    assert_eq!(
        names(Platform::COORDINATES, freedom.independent_coordinates()),
        ["y"]
    );
    let q = [
        Platform::PARALLEL.l * 0.5,
        -Platform::PARALLEL.l * 0.75_f64.sqrt(),
        0.0,
    ];
    let freedom = check(&Platform::PARALLEL, q);
    assert_eq!(
        names(Platform::COORDINATES, freedom.independent_coordinates()),
        ["x"]
    );
}

#[test]
fn a_disc_has_five_configurations_and_three_velocities() {
    let (disc, _) = Disc::numbered(0);
    let angle = 1.0_f64;
    let freedom = check(
        &disc,
        [0.1, 0.2, disc.radius * angle.sin(), 0.4, angle, 0.7],
    );
    assert_eq!((freedom.coordinates, freedom.velocities), (5, 3));
    assert_eq!(freedom.redundant_constraints().count(), 0);
    assert_eq!(
        <Disc as Constraints<6, 3>>::CONSTANT_COLUMNS,
        [true, true, true, false, false, false]
    );
    // The rates of the angles are independent, in whichever direction the disc rolls.
    for heading in 0..16 {
        for lean in [0.3, 0.8, 1.5, 2.5] {
            let height = disc.radius * f64::sin(lean);
            let q = [0.1, 0.2, height, 0.4 * f64::from(heading), lean, 0.7];
            assert_eq!(
                names(Disc::COORDINATES, check(&disc, q).independent_velocities()),
                names(Disc::COORDINATES, [3, 4, 5].into_iter())
            );
        }
    }
    assert_eq!(<Disc as Constraints<6, 3>>::MIN_DEGREES_OF_FREEDOM, 3);
    assert_eq!(
        <Disc as Constraints<6, 3>>::INTEGRABLE,
        [true, false, false]
    );
}

#[test]
fn a_parallelogram_gains_a_freedom_where_its_bars_are_in_line() {
    let parallelogram = FourBar {
        a: 1.0,
        b: 2.0,
        c: 1.0,
        d: 2.0,
        m: 0.1,
    };
    assert_eq!(check(&parallelogram, [0.7, 0.0, 0.7]).velocities, 1);
    let freedom = check(&parallelogram, [0.0; 3]);
    assert_eq!((freedom.coordinates, freedom.velocities), (2, 2));
    assert_eq!(freedom.redundant_constraints().count(), 1);
}

#[test]
fn independent_coordinates_do_not_depend_on_units() {
    let scaled = |length: f64, time: f64| {
        let linkage = FourBar {
            a: length,
            b: 2.5 * length,
            c: 2.0 * length,
            d: 3.0 * length,
            m: 0.1 * time,
        };
        let guess = State::new(0.0, [0.9, 0.2, 1.5], [0.0; 3]);
        let state = linkage.assemble(guess).solve().expect("it closes").state;
        check(&linkage, state.q.into());
        linkage.degrees_of_freedom(&state)
    };
    assert_eq!(scaled(1.0, 1.0), scaled(1e-6, 1e9));
}

#[test]
fn independent_coordinates_can_be_held() {
    let linkage = FourBar {
        a: 1.0,
        b: 2.5,
        c: 2.0,
        d: 3.0,
        m: 0.1,
    };
    let guess = State::new(0.0, [0.9, 0.2, 1.5], [0.0; 3]);
    let state = linkage.assemble(guess).solve().expect("it closes").state;
    let freedom = linkage.degrees_of_freedom(&state);
    let moved = State::new(0.0, state.q.map(|q| q + 0.01), [1.0; 3]);
    let found = linkage
        .assemble(moved)
        .hold(freedom.independent_coordinates())
        .hold_velocities(freedom.independent_velocities())
        .solve()
        .expect("the others follow");
    for i in freedom.independent_coordinates() {
        assert_eq!((found.moved.q[i], found.moved.v[i]), (0.0, 0.0));
    }
    assert!(found.moved.q.norm() > 1e-4 && found.moved.v.norm() > 0.1);
}

#[test]
fn a_wheel_on_a_line_is_holonomic_in_disguise() {
    assert_eq!(<Wheel as Constraints<3, 2>>::HOLONOMIC, 1);
    assert_eq!(<Wheel as Constraints<3, 2>>::INTEGRABLE, [true; 2]);
    let wheel = Wheel {
        m: 2.0,
        inertia: 0.3,
        r: 0.4,
    };
    // It counts among the velocities until it is declared for positions.
    let freedom = check(&wheel, [0.0; 3]);
    assert_eq!((freedom.coordinates, freedom.velocities), (2, 1));
}
