//! Composition, displacement and rotation of bodies against their particles, and numbers of other programs.

use crate::common::assert_close;
use lagrangian::prelude::*;
use lagrangian::rigid_body::{
    BodyError, CadReport, InertiaTensor, ProductSign, ProductsOfInertia, RigidBody, Solid,
    UrdfInertial,
};
use nalgebra::Rotation3;

type V = Vector3<f64>;

/// Numbers in (−1, 1) that look random: Weyl's sequence.
fn scattered(index: u32) -> f64 {
    2.0 * (f64::from(index + 1) * 0.618_033_988_749_894_9).fract() - 1.0
}

fn scattered_vector(index: u32) -> V {
    V::from_fn(|i, _| scattered(3 * index + u32::try_from(i).unwrap() + 7 * index * index))
}

fn scattered_rotation(index: u32) -> Rotation3<f64> {
    Rotation3::from_scaled_axis(scattered_vector(index) * 3.0)
}

/// Masses and positions.
type Particles = Vec<(f64, V)>;

fn particles(count: u32, first: u32) -> Particles {
    let numbers = first..first + count;
    numbers
        .map(|i| (1.5 + scattered(5 * i), scattered_vector(i)))
        .collect()
}

fn body(particles: &Particles) -> RigidBody {
    let parts = particles
        .iter()
        .map(|(m, r)| RigidBody::particle(*m, *r).unwrap());
    RigidBody::composed(parts).unwrap()
}

/// The definitions (1.1) and (2.1), term by term, about a point.
fn check(body: &RigidBody, particles: &Particles, point: V) {
    let sum =
        |term: &dyn Fn(V) -> f64| -> f64 { particles.iter().map(|(m, r)| m * term(*r)).sum() };
    let mass = sum(&|_| 1.0);
    assert_close(body.mass(), mass, 1e-13);
    for k in 0..3 {
        assert_close(body.center()[k], sum(&|r| r[k]) / mass, 1e-13);
    }
    let inertia = body.inertia_about(&point);
    let about = |term: &dyn Fn(V) -> f64| sum(&|r| term(r - point));
    let [xx, yy, zz] = inertia.moments();
    assert_close(xx, about(&|r| r.y * r.y + r.z * r.z), 1e-12);
    assert_close(yy, about(&|r| r.x * r.x + r.z * r.z), 1e-12);
    assert_close(zz, about(&|r| r.x * r.x + r.y * r.y), 1e-12);
    let ProductsOfInertia { xy, xz, yz } = inertia.products();
    assert_close(xy, about(&|r| r.x * r.y), 1e-12);
    assert_close(xz, about(&|r| r.x * r.z), 1e-12);
    assert_close(yz, about(&|r| r.y * r.z), 1e-12);
    let matrix = inertia.matrix();
    assert_close(matrix[(0, 1)], -xy, 0.0);
    assert_close(matrix[(2, 0)], -xz, 0.0);
    assert_close(matrix[(1, 2)], -yz, 0.0);
}

#[test]
fn bodies_of_particles() {
    let all = particles(40, 0);
    check(&body(&all), &all, V::zeros());
    check(&body(&all), &all, V::new(0.3, -2.0, 1.1));
    check(&body(&all), &all, body(&all).center());
}

#[test]
fn composed_moved_and_turned_like_their_particles() {
    let [first, second] = [particles(17, 0), particles(9, 50)];
    let (rotation, displacement) = (scattered_rotation(3), V::new(0.4, -1.2, 2.0));
    let changed = |(m, r): &(f64, V)| (*m, rotation * r + displacement);
    let changed: Particles = second.iter().map(changed).collect();
    let changed_body = body(&second).turned(&rotation).moved(displacement);
    check(&changed_body, &changed, V::new(0.1, 0.2, 0.3));

    let whole: Particles = first.iter().chain(&changed).copied().collect();
    let composed = body(&first).plus(&changed_body);
    check(&composed, &whole, V::zeros());
    let rest = composed.minus(&changed_body).unwrap();
    check(&rest, &first, V::new(-1.0, 0.0, 0.5));
}

#[test]
fn holes_are_subtracted() {
    // A box with a box cut out at one end is a shorter box.
    let whole = Solid::cuboid(3.0, 1.0, 1.0)
        .unwrap()
        .with_density(2.0)
        .unwrap();
    let end = Solid::cuboid(1.0, 1.0, 1.0)
        .unwrap()
        .with_density(2.0)
        .unwrap();
    let rest = whole.minus(&end.moved(V::new(1.0, 0.0, 0.0))).unwrap();
    let expected = Solid::cuboid(2.0, 1.0, 1.0)
        .unwrap()
        .with_density(2.0)
        .unwrap();
    assert_close(rest.mass(), 4.0, 1e-15);
    assert_close(rest.center().x, -0.5, 1e-15);
    for k in 0..3 {
        assert_close(
            rest.inertia().moments()[k],
            expected.inertia().moments()[k],
            1e-14,
        );
    }
    // A tube is a cylinder without its bore; nearly all of it may be bored.
    let cylinder = |radius: f64| {
        Solid::cylinder(radius, 0.5)
            .unwrap()
            .with_density(1.0)
            .unwrap()
    };
    let bored = cylinder(1.0).minus(&cylinder(0.999_999)).unwrap();
    let tube = Solid::tube(0.999_999, 1.0, 0.5)
        .unwrap()
        .with_density(1.0)
        .unwrap();
    assert_close(
        bored.inertia().moments()[2] / tube.inertia().moments()[2],
        1.0,
        1e-9,
    );
}

#[test]
fn what_is_no_part_is_not_subtracted() {
    let cube = Solid::cuboid(1.0, 1.0, 1.0)
        .unwrap()
        .with_mass(1.0)
        .unwrap();
    let error = cube.minus(&cube).unwrap_err();
    let quantity = "the mass of the difference";
    assert_eq!(
        error,
        BodyError::NotPositive {
            quantity,
            value: 0.0
        }
    );
    let elsewhere = RigidBody::particle(0.9, V::new(5.0, 0.0, 0.0)).unwrap();
    let error = cube.minus(&elsewhere).unwrap_err();
    assert!(
        matches!(error, BodyError::NegativeMoment { moments } if moments[0] < 0.0),
        "{error}"
    );
}

#[test]
fn moments_about_lines() {
    let all = particles(23, 10);
    let body = body(&all);
    let (point, direction) = (V::new(0.2, 0.1, -0.7), V::new(1.0, -2.0, 0.5));
    // (2.3): the distance from a line by the vector product.
    let distance = |r: &V| (r - point).cross(&direction).norm() / direction.norm();
    let expected: f64 = all.iter().map(|(m, r)| m * distance(r).powi(2)).sum();
    let found = body.inertia_about_line(&point, &direction).unwrap();
    assert_close(found, expected, 1e-12);
    // The length of the vector does not matter, however long or short it is.
    for factor in [1e-300, 1e200] {
        let found = body
            .inertia_about_line(&point, &(direction * factor))
            .unwrap();
        assert_close(found, expected, 1e-12);
    }
    let error = body.inertia_about_line(&point, &V::zeros()).unwrap_err();
    assert_eq!(error, BodyError::NoDirection { length: 0.0 });
}

#[test]
fn parallel_axes() {
    // (2.2) as it stands, for a moment and a product.
    let body = body(&particles(12, 20));
    let point = V::new(0.5, 0.25, -1.0);
    let d = point - body.center();
    let (about, central) = (body.inertia_about(&point), body.inertia());
    let m = body.mass();
    let expected = central.moments()[0] + m * (d.y * d.y + d.z * d.z);
    assert_close(about.moments()[0], expected, 1e-13);
    assert_close(
        about.products().xy,
        central.products().xy + m * d.x * d.y,
        1e-13,
    );

    let again =
        RigidBody::with_inertia_about_origin(m, body.center(), body.inertia_about(&V::zeros()));
    let again = again.unwrap().inertia();
    assert_close((again.matrix() - central.matrix()).norm(), 0.0, 1e-13);
}

#[test]
fn inconsistent_numbers_are_errors() {
    let tensor = |moments| InertiaTensor::principal(moments);
    let new = |mass, moments| RigidBody::new(mass, V::zeros(), tensor(moments)).unwrap_err();
    let error = new(1.0, [1.0, 2.0, 3.5]);
    let moments = [1.0, 2.0, 3.5];
    assert_eq!(
        error,
        BodyError::TriangleInequality {
            moments,
            excess: 0.5
        }
    );
    let text = error.to_string();
    assert!(text.contains("by 0.5: I₁ = 1, I₂ = 2, I₃ = 3.5"), "{text}");
    let error = new(1.0, [3.0, -1.0, 3.0]);
    let moments = [-1.0, 3.0, 3.0];
    assert_eq!(error, BodyError::NegativeMoment { moments });
    assert!(matches!(
        new(-2.0, [1.0; 3]),
        BodyError::NotPositive { value: -2.0, .. }
    ));
    assert!(matches!(
        new(f64::NAN, [1.0; 3]),
        BodyError::NotFinite { .. }
    ));
    assert!(matches!(
        new(1.0, [1.0, f64::INFINITY, 1.0]),
        BodyError::NotFinite { .. }
    ));
    let far = RigidBody::particle(1.0, V::new(0.0, f64::NAN, 0.0)).unwrap_err();
    assert!(matches!(far, BodyError::NotFinite { .. }));
    assert_eq!(RigidBody::<f64>::composed([]), Err(BodyError::NoParts));

    // The products of inertia count: these moments alone are possible.
    let products = ProductsOfInertia {
        xy: 0.0,
        xz: 0.9,
        yz: 0.0,
    };
    let tensor = InertiaTensor::from_moments_and_products([1.0, 1.5, 1.0], products);
    let error = RigidBody::new(1.0, V::zeros(), tensor).unwrap_err();
    assert!(
        matches!(error, BodyError::TriangleInequality { .. }),
        "{error}"
    );

    let matrix = Matrix3::new(2.0, 0.1, 0.0, 0.2, 2.0, 0.0, 0.0, 0.0, 2.0);
    let error = InertiaTensor::from_matrix(&matrix).unwrap_err();
    let text = "the inertia tensor is not symmetric: its entry (0, 1) is 0.1, and (1, 0) is 0.2";
    assert_eq!(error.to_string(), text);
}

#[test]
fn matrices_are_tensors() {
    let matrix = Matrix3::new(2.0, 0.1, -0.3, 0.1, 2.5, 0.2, -0.3, 0.2, 3.0);
    let tensor = InertiaTensor::from_matrix(&matrix).unwrap();
    assert_eq!(tensor.matrix(), matrix);
    let products = ProductsOfInertia {
        xy: -0.1,
        xz: 0.3,
        yz: -0.2,
    };
    assert_eq!(tensor.products(), products);
    let second = tensor.second_moments();
    assert_close(
        (InertiaTensor::from_second_moments(&second).matrix() - matrix).norm(),
        0.0,
        1e-15,
    );
    let omega = V::new(1.0, -2.0, 0.5);
    assert_close((tensor * omega - matrix * omega).norm(), 0.0, 1e-15);
}

#[test]
fn plates_and_rods_are_physical_in_any_position() {
    let solids = [Solid::plate(1.0, 0.3), Solid::rod(2.0), Solid::disc(0.7)];
    for (solid, index) in solids.into_iter().zip(0..) {
        let body = solid.unwrap().with_mass(0.3).unwrap();
        for turn in 0..50 {
            let turned = body.turned(&scattered_rotation(50 * index + turn));
            let again = RigidBody::new(turned.mass(), turned.center(), turned.inertia());
            assert_eq!(again, Ok(turned));
        }
    }
}

#[test]
fn a_plate_is_left_when_the_rest_is_subtracted() {
    let plate = Solid::plate(1.0, 0.3).unwrap().with_mass(0.3).unwrap();
    let ball = Solid::sphere(2.0).unwrap().with_mass(7.0).unwrap();
    for turn in 0..50 {
        let plate = plate.turned(&scattered_rotation(turn));
        let rest = plate.plus(&ball).minus(&ball).unwrap();
        let error = rest.inertia().matrix() - plate.inertia().matrix();
        assert_close(error.norm(), 0.0, 1e-14);
    }
}

#[test]
fn urdf_refers_to_turned_axes() {
    let all = particles(31, 5);
    let expected = body(&all);
    let rpy = [0.3, -0.7, 2.1];
    // Roll about x, then pitch about the fixed y, then yaw about the fixed z.
    let axes = Rotation3::from_axis_angle(&V::z_axis(), rpy[2])
        * Rotation3::from_axis_angle(&V::y_axis(), rpy[1])
        * Rotation3::from_axis_angle(&V::x_axis(), rpy[0]);
    let in_axes = axes.matrix().transpose() * expected.inertia().matrix() * axes.matrix();
    let link = UrdfInertial {
        mass: expected.mass(),
        xyz: expected.center().into(),
        rpy,
        ixx: in_axes[(0, 0)],
        ixy: in_axes[(0, 1)],
        ixz: in_axes[(0, 2)],
        iyy: in_axes[(1, 1)],
        iyz: in_axes[(1, 2)],
        izz: in_axes[(2, 2)],
    };
    check(&link.body().unwrap(), &all, V::new(1.0, 0.0, 0.0));
    check(
        &UrdfInertial::of(&expected).body().unwrap(),
        &all,
        V::zeros(),
    );
}

#[test]
fn reports_of_both_signs() {
    let all = particles(31, 5);
    let expected = body(&all);
    for sign in [ProductSign::Integral, ProductSign::TensorEntry] {
        let report = CadReport::of(&expected, sign);
        check(&report.body_about_center().unwrap(), &all, V::zeros());
        let about_origin = expected.inertia_about(&V::zeros());
        let products = match sign {
            ProductSign::Integral => about_origin.products(),
            ProductSign::TensorEntry => -about_origin.products(),
        };
        let report = CadReport {
            moments: about_origin.moments(),
            products: [products.xy, products.xz, products.yz],
            ..report
        };
        check(&report.body_about_origin().unwrap(), &all, V::zeros());
    }
    // A rod at 45°, printed with six digits.
    let report = CadReport {
        mass: 1.0,
        center: [0.0; 3],
        moments: [0.083_333, 0.166_667, 0.083_333],
        products: [0.0, 0.083_333, 0.0],
        sign: ProductSign::Integral,
    };
    assert!(report.body_about_center().is_ok());
    let moments = [0.083_333, 0.166_68, 0.083_333];
    let wrong = CadReport { moments, ..report };
    assert!(matches!(
        wrong.body_about_center(),
        Err(BodyError::TriangleInequality { .. })
    ));
}

#[test]
fn bodies_on_other_scalars() {
    let double = Solid::cone(0.3, 1.9).unwrap().with_mass(2.0).unwrap();
    let on_singles = double.map(f32::from_f64);
    assert_close(f64::from(on_singles.center().z), 0.475, 1e-7);
    let turned = on_singles.turned(&Rotation3::from_matrix_unchecked(
        scattered_rotation(1).into_inner().map(f32::from_f64),
    ));
    let expected = double.turned(&scattered_rotation(1)).inertia().matrix();
    let error = turned.inertia().matrix().map(f64::from) - expected;
    assert_close(error.norm(), 0.0, 1e-6);
}
