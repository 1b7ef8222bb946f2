//! Declarations of mechanisms other than arms with one joint behind the other.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

/// Mechanisms of other kinds, by name.
pub(super) fn others() -> Vec<(&'static str, TokenStream)> {
    vec![
        ("branches", branches()),
        ("free base", free_base()),
        ("slides", slides()),
        ("gears", gears()),
        ("moving support", moving_support()),
        ("spherical joints", spherical_joints()),
        ("springs", springs()),
        ("rotors", rotors(4)),
        ("many rotors", rotors(9)),
        ("Denavit and Hartenberg", table(6)),
        ("wheels", wheels()),
    ]
}

/// A torso that turns about two axes, with two arms of two links each.
fn branches() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(q[6]),
            define(
                r[0] = rotation_z(q[0]) * rotation_x(q[1]),
                r[1] = r[0] * rotation_y(q[2]),
                r[2] = r[1] * rotation_x(q[3]),
                r[3] = r[0] * rotation_y(q[4]),
                r[4] = r[3] * rotation_x(q[5]),
                p[0] = [0.0, 0.0, 0.0],
                p[1] = r[0] * shoulder[0],
                p[2] = p[1] + r[1] * upper,
                p[3] = r[0] * shoulder[1],
                p[4] = p[3] + r[3] * upper,
                c[i] = p[i] + r[i] * center[i] for i in 0..5,
                w[i] = angular_velocity(r[i]) for i in 0..5,
            ),
            kinetic = (0..5).map(|i| {
                0.5 * m[i] * dot(c[i]).norm_squared() + 0.5 * w[i].dot(inertia[i] * w[i])
            }).sum(),
            potential = (0..5).map(|i| m[i] * g * c[i].z).sum(),
        )]
        struct Torso {
            m: [f64; 5],
            shoulder: [Vector3<f64>; 2],
            upper: Vector3<f64>,
            center: [Vector3<f64>; 5],
            inertia: [Matrix3<f64>; 5],
            g: f64,
        }
    }
}

/// A body without support, with an arm of two links, under gravity and with a torque between them.
fn free_base() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(x: Vector3, a[3], q[2]),
            define(
                r[0] = rotation_zyx(a[0], a[1], a[2]),
                r[1] = r[0] * rotation_y(q[0]),
                r[2] = r[1] * rotation_x(q[1]),
                p[0] = x,
                p[1] = x + r[0] * mount,
                p[2] = p[1] + r[1] * link,
                c[i] = p[i] + r[i] * center[i] for i in 0..3,
                w[i] = angular_velocity(r[i]) for i in 0..3,
            ),
            kinetic = (0..3).map(|i| {
                0.5 * m[i] * dot(c[i]).norm_squared() + 0.5 * w[i].dot(inertia[i] * w[i])
            }).sum(),
            potential = (0..3).map(|i| m[i] * g * c[i].z).sum(),
            force(q[0] = -friction * dot(q[0])),
        )]
        struct Satellite {
            m: [f64; 3],
            mount: Vector3<f64>,
            link: Vector3<f64>,
            center: [Vector3<f64>; 3],
            inertia: [Matrix3<f64>; 3],
            g: f64,
            friction: f64,
        }
    }
}

/// A rail, a slide on an arm, and a helical joint.
fn slides() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(s, a, b, d, e),
            define(
                r[0] = rotation_z(a),
                r[1] = r[0] * rotation_y(b),
                r[2] = r[1] * rotation_x(e),
                p[0] = [s, 0.0, 0.3 * s],
                p[1] = p[0] + r[0] * link,
                p[2] = p[1] + r[1] * [d, 0.1, pitch * e],
                c[i] = p[i] + r[i] * center[i] for i in 0..3,
                w[i] = angular_velocity(r[i]) for i in 0..3,
            ),
            kinetic = (0..3).map(|i| {
                0.5 * m[i] * dot(c[i]).norm_squared() + 0.5 * w[i].dot(inertia[i] * w[i])
            }).sum() + 0.5 * m0 * dot(p[0]).norm_squared(),
            potential = (0..3).map(|i| m[i] * g * c[i].z).sum() + m0 * g * p[0].z,
        )]
        struct Slides {
            m0: f64,
            m: [f64; 3],
            link: Vector3<f64>,
            center: [Vector3<f64>; 3],
            inertia: [Matrix3<f64>; 3],
            g: f64,
            pitch: f64,
        }
    }
}

/// Joints that are geared to others.
fn gears() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(q[3]),
            define(
                r[0] = rotation_z(q[0]),
                r[1] = r[0] * rotation_y(q[1]),
                r[2] = r[1] * rotation_y(ratio * q[1] + q[2]),
                r[3] = r[2] * rotation_x(0.5 * q[2] - q[0]),
                p[0] = [0.0, 0.0, 0.0],
                p[i] = p[i - 1] + r[i - 1] * link for i in 1..4,
                c[i] = p[i] + r[i] * center for i in 0..4,
                w[i] = angular_velocity(r[i]) for i in 0..4,
            ),
            kinetic = (0..4).map(|i| {
                0.5 * m * dot(c[i]).norm_squared() + 0.5 * w[i].dot(inertia * w[i])
            }).sum(),
            potential = (0..4).map(|i| m * g * c[i].z).sum(),
        )]
        struct Gears {
            m: f64,
            link: Vector3<f64>,
            center: Vector3<f64>,
            inertia: Matrix3<f64>,
            g: f64,
            ratio: f64,
        }
    }
}

/// An arm on a support that shakes and turns as functions of time.
fn moving_support() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(q[3]),
            define(
                r[0] = rotation_x(0.1 * sin(rate * t)) * rotation_z(q[0]),
                r[1] = r[0] * rotation_y(q[1]),
                r[2] = r[1] * rotation_x(PI / 2) * rotation_y(q[2]),
                p[0] = [amplitude * cos(rate * t), 0.0, 0.2],
                p[i] = p[i - 1] + r[i - 1] * link for i in 1..3,
                c[i] = p[i] + r[i] * center for i in 0..3,
                w[i] = angular_velocity(r[i]) for i in 0..3,
            ),
            kinetic = (0..3).map(|i| {
                0.5 * m * dot(c[i]).norm_squared() + 0.5 * w[i].dot(inertia * w[i])
            }).sum(),
            potential = (0..3).map(|i| m * g * c[i].z).sum(),
        )]
        struct Shaken {
            m: f64,
            link: Vector3<f64>,
            center: Vector3<f64>,
            inertia: Matrix3<f64>,
            g: f64,
            rate: f64,
            amplitude: f64,
        }
    }
}

/// Three slender links on joints of three axes.
fn spherical_joints() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(q[3][3]),
            define(
                r[0] = rotation_xyz(q[0][0], q[0][1], q[0][2]),
                r[1] = r[0] * rotation_xyz(q[1][0], q[1][1], q[1][2]),
                r[2] = r[1] * rotation_xyz(q[2][0], q[2][1], q[2][2]),
                p[0] = [0.0, 0.0, 0.0],
                p[i] = p[i - 1] + r[i - 1] * [0.0, 0.0, -l] for i in 1..3,
                c[i] = p[i] + r[i] * [0.0, 0.0, -h] for i in 0..3,
                w[i] = angular_velocity(r[i]) for i in 0..3,
            ),
            kinetic = (0..3).map(|i| {
                0.5 * m * dot(c[i]).norm_squared()
                    + 0.5 * (i1 * (w[i].x.powi(2) + w[i].y.powi(2)) + i3 * w[i].z.powi(2))
            }).sum(),
            potential = (0..3).map(|i| m * g * c[i].z).sum(),
        )]
        struct Chain { m: f64, l: f64, h: f64, i1: f64, i3: f64, g: f64 }
    }
}

/// An arm with a spring between two links, a weight that hangs beside, and no mass in one potential.
fn springs() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(q[3]),
            define(
                r[0] = rotation_z(q[0]),
                r[1] = r[0] * rotation_y(q[1]),
                r[2] = r[1] * rotation_y(q[2]),
                p[0] = [0.0, 0.0, 0.0],
                p[i] = p[i - 1] + r[i - 1] * link for i in 1..3,
                c[i] = p[i] + r[i] * center for i in 0..3,
                w[i] = angular_velocity(r[i]) for i in 0..3,
            ),
            kinetic = (0..3).map(|i| {
                0.5 * m * dot(c[i]).norm_squared() + 0.5 * w[i].dot(inertia * w[i])
            }).sum(),
            potential = (1..3).map(|i| m * g * c[i].z).sum()
                + 0.5 * k * ((c[2] - c[0]).norm() - rest).powi(2)
                + 0.5 * k * q[1].powi(2),
        )]
        struct Springs {
            m: f64,
            link: Vector3<f64>,
            center: Vector3<f64>,
            inertia: Matrix3<f64>,
            g: f64,
            k: f64,
            rest: f64,
        }
    }
}

/// An arm whose motors turn behind gears, two joints on one motor, with a mass that is moved to and fro inside of it.
fn rotors(links: usize) -> TokenStream {
    let axes = ["z", "y", "x", "y"];
    let mut definitions = quote!(r[0] = rotation_z(q[0]),);
    for i in 1..links {
        let rotation = format_ident!("rotation_{}", axes[i % axes.len()]);
        let [before, i] = [i - 1, i].map(Literal::usize_unsuffixed);
        definitions.extend(quote!(r[#i] = r[#before] * #rotation(q[#i]),));
    }
    let links = Literal::usize_unsuffixed(links);
    quote! {
        #[lagrangian(
            coordinates(q[#links], d),
            define(
                #definitions
                p[0] = [0.0, 0.0, 0.0],
                p[i] = p[i - 1] + r[i - 1] * link for i in 1..#links,
                c[i] = p[i] + r[i] * center for i in 0..#links,
                w[i] = angular_velocity(r[i]) for i in 0..#links,
            ),
            kinetic = (0..#links).map(|i| {
                0.5 * m * dot(c[i]).norm_squared() + 0.5 * w[i].dot(inertia * w[i])
            }).sum()
                + (0..3).map(|i| 0.5 * rotor[i] * (ratio[i] * dot(q[i])).powi(2)).sum()
                + 0.5 * rotor[3] * (ratio[2] * dot(q[2]) - ratio[3] * dot(q[3])).powi(2)
                + 0.5 * slug * (dot(d).powi(2) + d.powi(2) * dot(q[1]).powi(2))
                + speed * d * dot(q[0]),
            potential = (0..#links).map(|i| m * g * c[i].z).sum() + 0.5 * k * d.powi(2),
            dissipation = 0.5 * friction * dot(q[3]).powi(2),
        )]
        struct Driven {
            m: f64,
            link: Vector3<f64>,
            center: Vector3<f64>,
            inertia: Matrix3<f64>,
            rotor: [f64; 4],
            ratio: [f64; 4],
            slug: f64,
            speed: f64,
            g: f64,
            k: f64,
            friction: f64,
        }
    }
}

/// An arm by the parameters of Denavit and Hartenberg, whose rotations are written out.
fn table(links: usize) -> TokenStream {
    let links = Literal::usize_unsuffixed(links);
    quote! {
        #[lagrangian(
            coordinates(q[#links]),
            define(
                a[i] = [
                    [cos(q[i]), -sin(q[i]) * cos(twist[i]), sin(q[i]) * sin(twist[i])],
                    [sin(q[i]), cos(q[i]) * cos(twist[i]), -cos(q[i]) * sin(twist[i])],
                    [0.0, sin(twist[i]), cos(twist[i])],
                ] for i in 0..#links,
                r[0] = a[0],
                r[i] = r[i - 1] * a[i] for i in 1..#links,
                p[0] = [length[0] * cos(q[0]), length[0] * sin(q[0]), offset[0]],
                p[i] = p[i - 1]
                    + r[i - 1] * [length[i] * cos(q[i]), length[i] * sin(q[i]), offset[i]]
                    for i in 1..#links,
                c[i] = p[i] + r[i] * center[i] for i in 0..#links,
                w[i] = angular_velocity(r[i]) for i in 0..#links,
            ),
            kinetic = (0..#links).map(|i| {
                0.5 * m[i] * dot(c[i]).norm_squared() + 0.5 * w[i].dot(inertia[i] * w[i])
            }).sum(),
            potential = (0..#links).map(|i| m[i] * g * c[i].z).sum(),
        )]
        struct Table {
            m: [f64; #links],
            length: [f64; #links],
            offset: [f64; #links],
            twist: [f64; #links],
            center: [Vector3<f64>; #links],
            inertia: [Matrix3<f64>; #links],
            g: f64,
        }
    }
}

/// A bicycle in the air: a frame, and a fork that is steered, each with a wheel. The last two angles are those of the wheels.
pub(super) fn wheels() -> TokenStream {
    quote! {
        #[lagrangian(
            coordinates(x: Vector3, yaw, roll, pitch, steer, rear, front),
            define(
                frame = rotation_z(yaw) * rotation_x(roll) * rotation_y(pitch),
                fork = frame * rotation_y(rake) * rotation_z(steer),
                hub = x + frame * base,
            ),
            body(
                rider = (frame, x),
                handlebar = (fork, hub),
                wheels[0] = (frame * rotation_x(quarter) * rotation_z(rear), x),
                wheels[1] = (fork * rotation_x(quarter) * rotation_z(front), hub),
            ),
            gravity = [0.0, 0.0, -g],
        )]
        struct Bicycle {
            rider: RigidBody,
            handlebar: RigidBody,
            wheels: [SymmetricBody; 2],
            base: Vector3<f64>,
            rake: f64,
            quarter: f64,
            g: f64,
        }
    }
}
