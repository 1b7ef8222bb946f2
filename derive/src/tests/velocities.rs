//! Which sums with products of vectors are velocities, on which forces act.

use proc_macro2::TokenStream;
use quote::quote;

/// Whether a force acts on a velocity.
fn is_velocity(velocity: &TokenStream) -> bool {
    let declaration = quote! {
        #[lagrangian(
            coordinates(x, y, z, theta),
            define(
                p = [x, y, z],
                s = [length * sin(theta), 0, length * cos(theta)],
                r = rotation_y(theta),
                v = #velocity,
            ),
            kinetic = 0.5 * m * dot(p).norm_squared() + 0.5 * m * dot(theta).powi(2),
            force(v = push),
        )]
        struct Body { m: f64, length: f64, tau: f64, n: Vector3<f64>, omega: Vector3<f64>, a: Matrix3<f64>, push: Vector3<f64> }
    };
    let tokens = crate::expand::expand(declaration).to_string();
    let is_ambiguous = tokens.contains("adds a velocity to what depends on coordinates alone");
    assert!(
        is_ambiguous || !tokens.contains("compile_error"),
        "{velocity}: {tokens}"
    );
    !is_ambiguous
}

#[test]
fn points_in_frames_that_turn_have_velocities() {
    for velocity in [
        quote!(dot(p) + omega.cross(p)),
        quote!(omega.cross(p) + dot(p)),
        quote!(dot(p) + p.cross(omega)),
        quote!(dot(p) - omega.cross(p)),
        quote!(2 * tau * (dot(p) + omega.cross(p))),
        quote!(r * (dot(p) + omega.cross(p))),
        quote!(a * (omega.cross(p) + dot(p))),
        quote!(dot(p) + omega.cross(p) + n.cross(p)),
        quote!(dot(p) + (omega + n).cross(p)),
        quote!(dot(tau * p) + omega.cross(tau * p)),
        quote!(tau * dot(p) + tau * omega.cross(p)),
        quote!(dot(p + s) + omega.cross(p) + omega.cross(s)),
        quote!(dot(p) + dot(s) + omega.cross(p + s)),
        quote!(dot(p) + omega.cross([x, y, z])),
        quote!([dot(x), dot(y), dot(z)] + omega.cross(p)),
        quote!(dot(p) + (omega + angular_velocity(r)).cross(p)),
        quote!(dot(p) + angular_velocity(r).cross(p)),
        quote!(dot(p) + [0, 0, dot(theta)].cross(p)),
        quote!(dot(p) + dot(theta) * n.cross(p)),
        quote!(dot(x) * n.cross(p) + dot(p) + omega.cross(p)),
        quote!(dot(p) + dot(s) + n.cross(p)),
        quote!(dot(s) + n.cross(omega)),
        quote!((dot(p) + omega.cross(p)).cross(n)),
    ] {
        assert!(is_velocity(&velocity), "{velocity}");
    }
}

#[test]
fn products_of_given_vectors_and_positions_are_positions() {
    for sum in [
        quote!(n.cross(p) + tau * dot(p)),
        quote!(tau * dot(p) + p.cross(n)),
        quote!(2 * dot(p) + n.cross(p)),
        quote!(dot(p) + 2 * n.cross(p) + dot(p) + n.cross(s)),
        quote!(n.cross(p) + dot(s)),
        quote!(n.cross(s) + dot(p)),
        quote!(n.cross([x, 0, 0]) + [dot(x), dot(y), 0]),
        quote!(n.cross(s) + [0, dot(y), 0]),
        quote!(p.cross(s) + dot(p)),
        quote!(p.cross(r * n) + dot(p)),
        quote!(n.cross(p).cross(omega) + dot(p)),
        quote!(n.cross(omega.cross(p)) + dot(p)),
        quote!(a * n.cross(p) + dot(p)),
        quote!(n.cross(p) + a * dot(p)),
        quote!(n.cross(p) + [dot(x), 2 * dot(y), dot(z)]),
        quote!(n.cross(p) * tau + dot(p)),
        quote!(dot(p) + omega.cross(p) + p),
        quote!(n.cross(p).component_mul(n) + dot(p)),
        quote!(dot(p) + tau * (omega.cross(p) + dot(s))),
    ] {
        assert!(!is_velocity(&sum), "{sum}");
    }
}
