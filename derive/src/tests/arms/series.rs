//! The Taylor series of arms go along the links.

use super::*;

/// Nothing but the recursions of Newton and Euler has convolutions: sine and cosine take two, turning ω, α and the
/// acceleration of the origin inwards and the force and the moment outwards four each, ω × q̇ two, and Ω six. The
/// factors of M have none.
#[test]
fn the_convolutions_of_an_arm_are_thirty_a_link() {
    for links in [3, 6, 10] {
        let mut derived = derive(arm(links));
        let (model, equations) = (&mut derived.model, &derived.equations);
        let method = derived.methods.taylor_method(model, equations);
        let Ok(method) = method else {
            panic!("{links} links have no series");
        };
        let found = method.program.convolutions.len();
        assert_eq!(found, 47 + 30 * (links - 3), "{links}");
    }
}
