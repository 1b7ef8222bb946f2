//! Where the numbers of a body come from: solids that are composed, a hole, principal axes, a mesh, and the numbers of other programs.
//!
//! `cargo run --release --example body_properties` prints them and writes `body_properties.svg`: a hammer, its centre of
//! gravity, its principal axes, and the ellipse of its inertia.

use std::error::Error;
use std::f64::consts::{FRAC_PI_2, PI};

use lagrangian::nalgebra::Rotation3;
use lagrangian::prelude::*;
use lagrangian::rigid_body::{
    BodyError, CadReport, InertiaTensor, ProductSign, ProductsOfInertia, Solid, TriangleMesh,
    UrdfInertial,
};
use lagrangian_examples::{Panel, Svg};

/// Sizes of the hammer in m: the handle along x, the head along y at its end.
const HANDLE: [f64; 2] = [0.015, 0.3];
const HEAD: [f64; 3] = [0.03, 0.11, 0.03];
const HEAD_AT: [f64; 2] = [0.15, 0.012];

/// A wooden handle, and a head of steel with a hole for it.
fn hammer() -> Result<RigidBody, BodyError> {
    let [radius, length] = HANDLE;
    let along_x = Rotation3::from_axis_angle(&Vector3::y_axis(), FRAC_PI_2);
    let handle = Solid::cylinder(radius, length)?
        .with_density(700.0)?
        .turned(&along_x);
    let [x, y, z] = HEAD;
    let block = Solid::cuboid(x, y, z)?.with_density(7850.0)?;
    let hole = Solid::cylinder(0.012, x)?
        .with_density(7850.0)?
        .turned(&along_x);
    let [at_x, at_y] = HEAD_AT;
    let head = block.moved(Vector3::new(at_x, at_y, 0.0));
    let head = head.minus(&hole.moved(Vector3::new(at_x, 0.0, 0.0)))?;
    RigidBody::composed([handle, head])
}

/// A ball as a mesh of triangles between so many meridians, and half as many parallels.
fn ball(radius: f64, meridians: usize) -> Result<RigidBody, Box<dyn Error>> {
    let parallels = meridians / 2;
    let number = |k: usize| f64::from(u32::try_from(k).unwrap_or(u32::MAX));
    let mut vertices = vec![Vector3::new(0.0, 0.0, radius)];
    for j in 1..parallels {
        let (sin, cos) = (PI * number(j) / number(parallels)).sin_cos();
        for i in 0..meridians {
            let (y, x) = (2.0 * PI * number(i) / number(meridians)).sin_cos();
            vertices.push(Vector3::new(x * sin, y * sin, cos) * radius);
        }
    }
    vertices.push(Vector3::new(0.0, 0.0, -radius));
    let last = vertices.len() - 1;
    let at = |j: usize, i: usize| 1 + (j - 1) * meridians + i % meridians;
    let mut triangles = Vec::new();
    for i in 0..meridians {
        triangles.push([0, at(1, i), at(1, i + 1)]);
        triangles.push([last, at(parallels - 1, i + 1), at(parallels - 1, i)]);
        for j in 1..parallels - 1 {
            triangles.push([at(j, i), at(j + 1, i), at(j + 1, i + 1)]);
            triangles.push([at(j, i), at(j + 1, i + 1), at(j, i + 1)]);
        }
    }
    let mesh = TriangleMesh {
        vertices,
        triangles,
    };
    Ok(mesh.solid()?.with_mass(1.0)?)
}

fn main() -> Result<(), Box<dyn Error>> {
    let body = hammer()?;
    println!("A hammer, composed of a handle and a head with a hole.");
    print_properties(&body)?;
    exchange(&body)?;
    compare_mesh()?;
    print_impossible(&body);
    std::fs::write("body_properties.svg", figure(&body))?;
    println!("Wrote body_properties.svg.");
    Ok(())
}

/// Mass, centre of gravity, moments and principal axes.
fn print_properties(body: &RigidBody) -> Result<(), BodyError> {
    let inertia = body.inertia();
    let ProductsOfInertia { xy, xz, yz } = inertia.products();
    println!("  mass                        {:.4} kg", body.mass());
    println!(
        "  centre of gravity, (1.1)    {:.5?} m",
        body.center().as_slice()
    );
    println!(
        "  moments about it, (2.1)     {} kg m²",
        scientific(inertia.moments())
    );
    println!(
        "  products of inertia         {} kg m²",
        scientific([xy, xz, yz])
    );
    let end = Vector3::new(-0.5 * HANDLE[1], 0.0, 0.0);
    let about_end = body.inertia_about_line(&end, &Vector3::z())?;
    println!("  about z at the grip, (2.2)  {about_end:.3e} kg m²");
    let principal = body.principal_axes();
    println!(
        "  principal moments, (2.5)    {} kg m²",
        scientific(principal.moments)
    );
    println!(
        "  along the columns of        {:.4}",
        principal.axes.matrix()
    );
    Ok(())
}

/// The same numbers as other programs write and read them.
fn exchange(body: &RigidBody) -> Result<(), Box<dyn Error>> {
    let inertia = body.inertia();
    let ProductsOfInertia { xy, xz, yz } = inertia.products();
    let urdf = UrdfInertial::of(body);
    println!(
        "As URDF has it, with entries of the tensor:\n  ixx {:.4e} iyy {:.4e} izz {:.4e} ixy {:.4e} ixz {:.4e} iyz {:.4e}",
        urdf.ixx, urdf.iyy, urdf.izz, urdf.ixy, urdf.ixz, urdf.iyz
    );
    assert_eq!(urdf.body()?.inertia(), inertia);

    // A CAD program that prints the integrals.
    let report = CadReport {
        mass: body.mass(),
        center: body.center().into(),
        moments: inertia.moments(),
        products: [xy, xz, yz],
        sign: ProductSign::Integral,
    };
    assert_eq!(report.body_about_center()?.inertia(), inertia);
    Ok(())
}

/// A mesh that is refined, beside the solid.
fn compare_mesh() -> Result<(), Box<dyn Error>> {
    println!("\nA ball of 1 kg and radius 0.1 m as a mesh, beside the solid:");
    let solid = Solid::sphere(0.1)?.with_mass(1.0)?;
    for meridians in [8, 16, 32, 64] {
        let mesh = ball(0.1, meridians)?;
        let error = mesh.inertia().moments()[2] / solid.inertia().moments()[2] - 1.0;
        println!("  {meridians:3} meridians: moment of inertia off by {error:9.2e}");
    }
    Ok(())
}

/// What is said of numbers that no body has.
fn print_impossible(body: &RigidBody) {
    println!("\nWhat no body has:");
    let impossible = InertiaTensor::principal([1.0, 2.0, 3.5]);
    let signs = InertiaTensor::from_moments_and_products(
        [2.0, 2.0, 0.5],
        ProductsOfInertia {
            xy: 1.9,
            xz: 0.0,
            yz: 0.0,
        },
    );
    for error in [
        RigidBody::new(1.0, Vector3::zeros(), impossible).err(),
        RigidBody::new(1.0, Vector3::zeros(), signs).err(),
        RigidBody::new(-1.0, Vector3::zeros(), body.inertia()).err(),
        Solid::tube(0.03_f64, 0.02, 0.1).err(),
        SymmetricBody::of(body).err(),
    ]
    .into_iter()
    .flatten()
    {
        println!("  {error}");
    }
}

/// Three numbers with four digits.
fn scientific(numbers: [f64; 3]) -> String {
    numbers.map(|number| format!("{number:.3e}")).join(", ")
}

/// The outline of the hammer in its face, with what was computed.
fn figure(body: &RigidBody) -> String {
    let subtitle = format!(
        "{:.3} kg; the ellipse has the radii of gyration about the principal axes.",
        body.mass()
    );
    let mut svg = Svg::titled(1000.0, 560.0, "Mass properties of a hammer", &subtitle);
    // One centimetre is as long on both axes.
    let panel = Panel::new(
        [84.0, 972.0, 112.0, 482.0],
        ([-0.2, 0.28], [-0.1, 0.1]),
        [10.0, 5.0],
    );
    panel.draw(&mut svg, "In the plane of its face", "x / m", "y / m");
    let [radius, length] = HANDLE;
    svg.rectangle(
        "outline",
        panel.at(-0.5 * length, radius),
        panel.at(0.5 * length, -radius),
    );
    let [width, height, _] = HEAD;
    let [x, y] = HEAD_AT;
    svg.rectangle(
        "outline",
        panel.at(x - 0.5 * width, y + 0.5 * height),
        panel.at(x + 0.5 * width, y - 0.5 * height),
    );
    let center = body.center();
    let principal = body.principal_axes();
    let gyration = principal
        .moments
        .map(|moment| (moment / body.mass()).sqrt());
    let axis = |k: usize| principal.axes.matrix().column(k).into_owned();
    for (k, class) in [(0, "second"), (1, "third")] {
        let along = axis(k) * 0.085;
        let ends = [center - along, center + along];
        panel.curve(&mut svg, class, ends.iter().map(|end| [end.x, end.y]));
    }
    let ellipse = (0..=180).map(|k| {
        let (sin, cos) = (f64::from(k) * PI / 90.0).sin_cos();
        let point = center + axis(0) * (gyration[0] * cos) + axis(1) * (gyration[1] * sin);
        [point.x, point.y]
    });
    panel.curve(&mut svg, "curve", ellipse);
    svg.circle("start", panel.at(center.x, center.y), 5.0);
    svg.circle("start", panel.at(0.0, 0.0), 2.0);
    svg.finish()
}
