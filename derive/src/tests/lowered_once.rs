//! Each definition is lowered once, whatever is asked of it.

use quote::quote;

use crate::lower::definitions_lowered;

/// An arm whose energies are evaluated in frames, with a force on a velocity, which is evaluated at rest.
#[test]
fn definitions_of_an_arm_are_lowered_once() {
    let declaration = quote! {
        #[lagrangian(
            coordinates(theta[3]),
            define(
                rotation[0] = rotation_z(theta[0]),
                rotation[i] = rotation[i - 1] * rotation_y(theta[i]) for i in 1..3,
                place[0] = rotation[0] * [0.0, 0.0, length],
                place[i] = place[i - 1] + rotation[i] * [0.0, 0.0, length] for i in 1..3,
                tip_velocity = dot(place[2]),
            ),
            kinetic = (0..3).map(|i| kinetic_energy(link, rotation[i], place[i])).sum(),
            potential = (0..3).map(|i| potential_energy(link, rotation[i], place[i], [0.0, 0.0, -g])).sum(),
            force(tip_velocity = push),
        )]
        struct Arm { link: PrincipalBody, length: f64, g: f64, push: Vector3<f64> }
    };
    definitions_lowered::take();
    let tokens = crate::expand::expand(declaration).to_string();
    assert!(!tokens.contains("compile_error"), "{tokens}");
    // Five definitions, of which four stand for the six members of two families.
    assert_eq!(definitions_lowered::take(), 5 + 6);
}
