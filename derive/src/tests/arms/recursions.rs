//! Mechanisms of other kinds, whose velocities are computed along them by the declaration.

use proc_macro2::TokenStream;
use quote::quote;

/// Each with the same mechanism declared by positions.
pub(super) fn pairs() -> Vec<(&'static str, [TokenStream; 2])> {
    vec![
        ("free base", [false, true].map(free_base)),
        ("slides", [false, true].map(slides)),
    ]
}

/// T of links with these places, and V.
fn energies(is_recursion: bool) -> TokenStream {
    let velocity = if is_recursion {
        quote!(v[i] + w[i].cross(center[i]))
    } else {
        quote!(dot(c[i]))
    };
    quote! {
        kinetic = (0..3).map(|i| {
            0.5 * m[i] * (#velocity).norm_squared() + 0.5 * w[i].dot(inertia[i] * w[i])
        }).sum(),
        potential = (0..3).map(|i| m[i] * g * c[i].z).sum(),
    }
}

fn of_links(
    coordinates: &TokenStream,
    places: &TokenStream,
    velocities: Option<TokenStream>,
) -> TokenStream {
    let energies = energies(velocities.is_some());
    let velocities =
        velocities.unwrap_or_else(|| quote!(w[i] = angular_velocity(r[i]) for i in 0..3,));
    quote! {
        #[lagrangian(
            coordinates(#coordinates),
            define(
                #places
                c[i] = p[i] + r[i] * center[i] for i in 0..3,
                #velocities
            ),
            #energies
        )]
        struct Links {
            m: [f64; 3],
            link: [Vector3<f64>; 2],
            center: [Vector3<f64>; 3],
            inertia: [Matrix3<f64>; 3],
            g: f64,
            pitch: f64,
        }
    }
}

/// A body without support, with an arm of two links.
fn free_base(is_recursion: bool) -> TokenStream {
    let places = quote! {
        r[0] = rotation_zyx(a[0], a[1], a[2]),
        r[1] = r[0] * rotation_y(q[0]),
        r[2] = r[1] * rotation_x(0.5 * q[1]),
        p[0] = x,
        p[1] = x + r[0] * link[0],
        p[2] = p[1] + r[1] * link[1],
    };
    let velocities = quote! {
        w[0] = angular_velocity(r[0]),
        w[1] = rotation_y(-q[0]) * w[0] + [0.0, dot(q[0]), 0.0],
        w[2] = rotation_x(-0.5 * q[1]) * w[1] + [0.5 * dot(q[1]), 0.0, 0.0],
        v[0] = r[0].transpose() * dot(x),
        v[1] = rotation_y(-q[0]) * (v[0] + w[0].cross(link[0])),
        v[2] = rotation_x(-0.5 * q[1]) * (v[1] - link[1].cross(w[1])),
    };
    let coordinates = quote!(x: Vector3, a[3], q[2]);
    of_links(&coordinates, &places, is_recursion.then_some(velocities))
}

/// A rail, a slide on an arm, a constant turn, and a helical joint.
fn slides(is_recursion: bool) -> TokenStream {
    let places = quote! {
        r[0] = rotation_z(a),
        r[1] = r[0] * rotation_x(PI / 2) * rotation_y(b),
        r[2] = r[1] * rotation_x(e),
        p[0] = [s, 0.0, 0.3 * s],
        p[1] = p[0] + r[0] * (link[0] + [0.0, d, 0.0]),
        p[2] = p[1] + r[1] * [0.2, 0.1, pitch * e],
    };
    let velocities = quote! {
        w[0] = [0.0, 0.0, dot(a)],
        w[1] = rotation_y(-b) * rotation_x(-PI / 2) * w[0] + [0.0, dot(b), 0.0],
        w[2] = rotation_x(-e) * w[1] + [dot(e), 0.0, 0.0],
        v[0] = rotation_z(-a) * [dot(s), 0.0, 0.3 * dot(s)],
        v[1] = rotation_y(-b) * rotation_x(-PI / 2)
            * (v[0] + w[0].cross(link[0] + [0.0, d, 0.0]) + [0.0, dot(d), 0.0]),
        v[2] = rotation_x(-e) * (v[1] + w[1].cross([0.2, 0.1, pitch * e]) + [0.0, 0.0, pitch * dot(e)]),
    };
    let coordinates = quote!(s, a, b, d, e);
    of_links(&coordinates, &places, is_recursion.then_some(velocities))
}
