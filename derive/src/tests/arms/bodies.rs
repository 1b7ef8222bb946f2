//! An arm whose links are bodies.

use proc_macro2::{Literal, TokenStream};
use quote::quote;

use super::declarations::{by_name, joints};

/// The arm of so many links, of which all are one line.
pub(super) fn arm_of_bodies(links: usize) -> TokenStream {
    let definitions = joints(links, by_name);
    let links = Literal::usize_unsuffixed(links);
    quote! {
        #[lagrangian(
            coordinates(q[#links]),
            define(#definitions),
            body(links[i] = (r[i], p[i]) for i in 0..#links),
            gravity = [0.0, 0.0, -g],
        )]
        struct Arm {
            link: [Vector3<f64>; #links],
            links: [RigidBody; #links],
            g: f64,
        }
    }
}
