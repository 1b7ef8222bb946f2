//! One arm in the spellings that textbooks have.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::declarations::{arm_with, by_name, joints, written_out};

/// The arm by name, as it is spelt in each way.
pub(super) fn spellings(links: usize) -> Vec<(&'static str, TokenStream)> {
    vec![
        (
            "angular velocities along inertial axes",
            along_inertial_axes(links),
        ),
        ("homogeneous matrices", homogeneous(links, false)),
        ("homogeneous matrices written out", homogeneous(links, true)),
        (
            "rotations written out",
            arm_with(
                links,
                written_out,
                &quote!(angular_velocity),
                &along_own_axes(),
            ),
        ),
        (
            "velocities computed along the axes of the links",
            recursion(links, &along_body_axes(links, true)),
        ),
        (
            "velocities of the joints, tensors about them",
            recursion(links, &about_the_joints(links)),
        ),
        (
            "turns that are written out",
            recursion(links, &along_body_axes(links, false)),
        ),
        (
            "velocities computed along inertial axes",
            recursion(links, &along_space_axes(links)),
        ),
    ]
}

/// Velocities of the centres of mass, and angular velocities along the axes of the links.
pub(super) fn along_own_axes() -> TokenStream {
    quote! {
        0.5 * m[i] * dot(c[i]).norm_squared() + 0.5 * w[i].dot(inertia[i] * w[i])
    }
}

/// The same with angular velocities along inertial axes.
fn along_inertial_axes(links: usize) -> TokenStream {
    let each = quote! {
        0.5 * m[i] * dot(c[i]).dot(dot(c[i]))
            + 0.5 * w[i].transpose() * (r[i] * inertia[i] * r[i].transpose()) * w[i]
    };
    arm_with(links, by_name, &quote!(angular_velocity_inertial), &each)
}

/// The homogeneous matrix of a rotation about an axis, and of a place, by its elements.
fn elements(axis: &str, angle: &TokenStream, place: &[TokenStream; 3]) -> TokenStream {
    let (s, c) = (quote!(sin(#angle)), quote!(cos(#angle)));
    let [x, y, z] = place;
    match axis {
        "x" => {
            quote!([[1.0, 0.0, 0.0, #x], [0.0, #c, -#s, #y], [0.0, #s, #c, #z], [0.0, 0.0, 0.0, 1.0]])
        }
        "y" => {
            quote!([[#c, 0.0, #s, #x], [0.0, 1.0, 0.0, #y], [-#s, 0.0, #c, #z], [0.0, 0.0, 0.0, 1.0]])
        }
        _ => {
            quote!([[#c, -#s, 0.0, #x], [#s, #c, 0.0, #y], [0.0, 0.0, 1.0, #z], [0.0, 0.0, 0.0, 1.0]])
        }
    }
}

/// Homogeneous matrices of the links, and homogeneous coordinates of the centres of mass.
fn homogeneous(links: usize, is_written_out: bool) -> TokenStream {
    let axes = ["z", "y", "x", "y"];
    let mut definitions = TokenStream::new();
    for i in 0..links {
        let axis = axes[i % axes.len()];
        let joint = Literal::usize_unsuffixed(i);
        let angle = quote!(q[#joint]);
        let before = Literal::usize_unsuffixed(i.saturating_sub(1));
        let step = if is_written_out {
            let place = [0, 1, 2].map(|k| {
                let k = Literal::usize_unsuffixed(k);
                if i == 0 {
                    quote!(0.0)
                } else {
                    quote!(link[#before][#k])
                }
            });
            elements(axis, &angle, &place)
        } else {
            let turn = by_name(axis, &angle);
            if i == 0 {
                quote!(homogeneous(#turn, [0.0, 0.0, 0.0]))
            } else {
                quote!(homogeneous(#turn, link[#before]))
            }
        };
        definitions.extend(if i == 0 {
            quote!(a[0] = #step,)
        } else {
            quote!(a[#joint] = a[#before] * #step,)
        });
    }
    let place = if is_written_out {
        quote!(a[i] * [center[i].x, center[i].y, center[i].z, 1.0])
    } else {
        quote!(a[i] * center[i].push(1.0))
    };
    let each = along_own_axes();
    let links = Literal::usize_unsuffixed(links);
    quote! {
        #[lagrangian(
            coordinates(q[#links]),
            define(
                #definitions
                c[i] = #place for i in 0..#links,
                w[i] = angular_velocity(a[i].view((0, 0), (3, 3))) for i in 0..#links,
            ),
            kinetic = (0..#links).map(|i| #each).sum(),
            potential = (0..#links).map(|i| m[i] * g * c[i].z).sum(),
        )]
        struct Arm {
            m: [f64; #links],
            link: [Vector3<f64>; #links],
            center: [Vector3<f64>; #links],
            inertia: [Matrix3<f64>; #links],
            g: f64,
        }
    }
}

/// An arm whose velocities are computed along it, and whose positions serve the potential alone.
fn recursion(links: usize, velocities: &TokenStream) -> TokenStream {
    let definitions = joints(links, by_name);
    let links = Literal::usize_unsuffixed(links);
    quote! {
        #[lagrangian(
            coordinates(q[#links]),
            define(
                #definitions
                c[i] = p[i] + r[i] * center[i] for i in 0..#links,
            ),
            potential = (0..#links).map(|i| m[i] * g * c[i].z).sum(),
        )]
        #[lagrangian(#velocities)]
        struct Arm {
            m: [f64; #links],
            link: [Vector3<f64>; #links],
            center: [Vector3<f64>; #links],
            inertia: [Matrix3<f64>; #links],
            g: f64,
        }
    }
}

/// w and v along the axes of each link, of the turns back to them.
fn twists(links: usize, is_by_name: bool) -> TokenStream {
    let mut definitions = quote! {
        w[0] = [0.0, 0.0, dot(q[0])],
        v[0] = [0.0, 0.0, 0.0],
    };
    let axes = ["z", "y", "x", "y"];
    for i in 1..links {
        let axis = axes[i % axes.len()];
        let rate = rate(axis, i);
        let [before, i] = [i - 1, i].map(Literal::usize_unsuffixed);
        let back = if is_by_name {
            let name = format_ident!("rotation_{axis}");
            quote!(#name(-q[#i]))
        } else {
            let turn = written_out(axis, &quote!(q[#i]));
            quote!(#turn.transpose())
        };
        definitions.extend(quote! {
            w[#i] = #back * w[#before] + #rate,
            v[#i] = #back * (v[#before] + w[#before].cross(link[#before])),
        });
    }
    definitions
}

fn along_body_axes(links: usize, is_by_name: bool) -> TokenStream {
    let twists = twists(links, is_by_name);
    let links = Literal::usize_unsuffixed(links);
    quote! {
        define(#twists),
        kinetic = (0..#links).map(|i| {
            0.5 * m[i] * (v[i] + w[i].cross(center[i])).norm_squared() + 0.5 * w[i].dot(inertia[i] * w[i])
        }).sum(),
    }
}

/// T of each link by the velocity of its joint: ½ m v² + m v·(ω × c) + ½ ω·(I + m (c² 1 − c cᵀ)) ω.
fn about_the_joints(links: usize) -> TokenStream {
    let twists = twists(links, true);
    let links = Literal::usize_unsuffixed(links);
    quote! {
        define(
            #twists
            about[i] = inertia[i]
                + m[i] * (center[i].norm_squared() * identity(3) - center[i].outer(center[i]))
                for i in 0..#links,
        ),
        kinetic = (0..#links).map(|i| {
            0.5 * m[i] * v[i].norm_squared() + m[i] * v[i].dot(w[i].cross(center[i]))
                + 0.5 * w[i].dot(about[i] * w[i])
        }).sum(),
    }
}

/// w and v along inertial axes.
fn along_space_axes(links: usize) -> TokenStream {
    let mut definitions = quote! {
        w[0] = [0.0, 0.0, dot(q[0])],
        v[0] = [0.0, 0.0, 0.0],
    };
    let axes = ["z", "y", "x", "y"];
    for i in 1..links {
        let rate = rate(axes[i % axes.len()], i);
        let [before, i] = [i - 1, i].map(Literal::usize_unsuffixed);
        definitions.extend(quote! {
            w[#i] = w[#before] + r[#before] * #rate,
            v[#i] = v[#before] + w[#before].cross(r[#before] * link[#before]),
        });
    }
    let links = Literal::usize_unsuffixed(links);
    quote! {
        define(#definitions),
        kinetic = (0..#links).map(|i| {
            0.5 * m[i] * (v[i] + w[i].cross(r[i] * center[i])).norm_squared()
                + 0.5 * w[i].dot(r[i] * inertia[i] * r[i].transpose() * w[i])
        }).sum(),
    }
}

/// The rate of a joint along its axis.
fn rate(axis: &str, joint: usize) -> TokenStream {
    let joint = Literal::usize_unsuffixed(joint);
    match axis {
        "x" => quote!([dot(q[#joint]), 0.0, 0.0]),
        "y" => quote!([0.0, dot(q[#joint]), 0.0]),
        _ => quote!([0.0, 0.0, dot(q[#joint])]),
    }
}
