//! The names that the files of the models have in common.

pub(super) use lagrangian::analysis::StateSpace;
pub(super) use lagrangian::nalgebra;
pub(super) use lagrangian::prelude::*;

pub(super) use crate::about::{About, Curve, SWITCH, control, parameter, start};
pub(super) use crate::exhibit::{Law, Refusal, Shown};
pub(super) use crate::scene::{Body, Form, Scene, Shape, Tone, about_x, about_y, about_z, plane};
pub(super) use crate::values::Values;

/// The value of a mass, checked as that of a particle.
pub(super) fn mass(values: &Values, name: &str) -> Result<f64, Refusal> {
    Ok(RigidBody::particle(values.get(name), Vector3::zeros())?.mass())
}

/// A small block that holds a pivot, for a model of this size.
pub(super) fn support(at: Vector3<f64>, size: f64) -> Shape {
    Shape::new(
        Form::Cuboid([0.05 * size, 0.05 * size, 0.03 * size]),
        Tone::Fixed,
    )
    .at(at)
}

/// The axes of a body with these z-x-z Euler angles.
pub(super) fn zxz(phi: f64, theta: f64, psi: f64) -> Matrix3<f64> {
    about_z(phi) * about_x(theta) * about_z(psi)
}

/// A cart on a straight track along x, and the scene about it.
pub(super) fn track(mass: f64, x: f64, size: f64) -> Scene {
    let cart = Body::central(mass, [0.0; 3], Matrix3::identity(), plane(x, 0.0)).with(
        Shape::new(
            Form::Cuboid([0.2 * size, 0.12 * size, 0.055 * size]),
            Tone::First,
        )
        .at(plane(0.0, -0.03 * size)),
    );
    let mut scene = Scene::seen(plane(0.5 * x, 0.4 * size), 1.15 * size).on_ground(-0.1 * size);
    for part in -8..8 {
        let ends = [part, part + 1].map(|k| plane(0.5 * size * f64::from(k), -0.1 * size));
        scene = scene.line(ends[0], ends[1], 0.025 * size, Tone::Fixed);
    }
    scene.body(cart)
}
