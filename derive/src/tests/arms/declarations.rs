//! Declarations of mechanisms.

use proc_macro2::{Literal, TokenStream};
use quote::{format_ident, quote};

use super::spellings::along_own_axes;

/// An arm of so many links: joint i turns about letter i of the repeating zyxy, and each link has a centre of mass off the
/// joint axis and a full inertia tensor.
pub(in crate::tests) fn arm(links: usize) -> TokenStream {
    arm_with(links, by_name, &quote!(angular_velocity), &along_own_axes())
}

/// The rotation by an angle about an axis.
pub(super) fn by_name(axis: &str, angle: &TokenStream) -> TokenStream {
    let name = format_ident!("rotation_{axis}");
    quote!(#name(#angle))
}

/// The same element by element.
pub(super) fn written_out(axis: &str, angle: &TokenStream) -> TokenStream {
    let (s, c) = (quote!(sin(#angle)), quote!(cos(#angle)));
    match axis {
        "x" => quote!([[1.0, 0.0, 0.0], [0.0, #c, -#s], [0.0, #s, #c]]),
        "y" => quote!([[#c, 0.0, #s], [0.0, 1.0, 0.0], [-#s, 0.0, #c]]),
        _ => quote!([[#c, -#s, 0.0], [#s, #c, 0.0], [0.0, 0.0, 1.0]]),
    }
}

pub(super) fn arm_with(
    links: usize,
    rotation: fn(&str, &TokenStream) -> TokenStream,
    angular_velocity: &TokenStream,
    each: &TokenStream,
) -> TokenStream {
    let definitions = joints(links, rotation);
    let links = Literal::usize_unsuffixed(links);
    quote! {
        #[lagrangian(
            coordinates(q[#links]),
            define(
                #definitions
                c[i] = p[i] + r[i] * center[i] for i in 0..#links,
                w[i] = #angular_velocity(r[i]) for i in 0..#links,
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

/// The axes of the links, and the positions of the joints.
pub(super) fn joints(links: usize, rotation: fn(&str, &TokenStream) -> TokenStream) -> TokenStream {
    let axes = ["z", "y", "x", "y"];
    let first = rotation("z", &quote!(q[0]));
    let mut definitions = quote! {
        r[0] = #first,
        p[0] = [0.0, 0.0, 0.0],
    };
    for i in 1..links {
        let axis = axes[i % axes.len()];
        let [before, i] = [i - 1, i].map(Literal::usize_unsuffixed);
        let rotation = rotation(axis, &quote!(q[#i]));
        definitions.extend(quote! {
            r[#i] = r[#before] * #rotation,
            p[#i] = p[#before] + r[#before] * link[#before],
        });
    }
    definitions
}

/// An arm whose parallel joints are declared by angles against the horizontal, `is_absolute`, or against each other.
pub(super) fn parallel_joints(is_absolute: bool) -> TokenStream {
    let [second, third] = if is_absolute {
        [
            quote!(rotation_z(q[0]) * rotation_y(q[1] + q[2])),
            quote!(rotation_z(q[0]) * rotation_y(q[1] + q[2] + q[3])),
        ]
    } else {
        [
            quote!(r[1] * rotation_y(q[2])),
            quote!(r[2] * rotation_y(q[3])),
        ]
    };
    quote! {
        #[lagrangian(
            coordinates(q[4]),
            define(
                r[0] = rotation_z(q[0]),
                r[1] = r[0] * rotation_y(q[1]),
                r[2] = #second,
                r[3] = #third,
                p[0] = [0.0, 0.0, 0.0],
                p[i] = p[i - 1] + r[i - 1] * link[i - 1] for i in 1..4,
                c[i] = p[i] + r[i] * center[i] for i in 0..4,
                w[i] = angular_velocity(r[i]) for i in 0..4,
            ),
            kinetic = (0..4).map(|i| {
                0.5 * m[i] * dot(c[i]).norm_squared() + 0.5 * w[i].dot(inertia[i] * w[i])
            }).sum(),
            potential = (0..4).map(|i| m[i] * g * c[i].z).sum(),
        )]
        struct Parallel {
            m: [f64; 4],
            link: [Vector3<f64>; 3],
            center: [Vector3<f64>; 4],
            inertia: [Matrix3<f64>; 4],
            g: f64,
        }
    }
}
