//! Reactions as outputs and in events.

use lagrangian::prelude::*;

/// A bead on the outside of a smooth sphere, which it leaves where the reaction vanishes: at cos θ = 2/3 from the top.
#[derive(Clone, Lagrangian)]
#[lagrangian(
    coordinates(x, y),
    kinetic = 0.5 * m * (dot(x).powi(2) + dot(y).powi(2)),
    potential = m * g * y,
    constraint(sphere = [x, y].norm() - r),
    output(normal = reaction(sphere)),
    event(leaves = reaction(sphere)),
    taylor,
)]
struct Bead {
    m: f64,
    g: f64,
    r: f64,
}

const BEAD: Bead = Bead {
    m: 0.3,
    g: 9.81,
    r: 2.0,
};

#[test]
fn a_bead_leaves_a_sphere_where_the_reaction_vanishes() -> Result<(), IntegrationError> {
    // From rest at θ₀ it leaves where 3 cos θ = 2 cos θ₀ (Goldstein, Classical Mechanics, 1980, derivation 2.13).
    let theta = 0.1_f64;
    let start = State::new(0.0, [BEAD.r * theta.sin(), BEAD.r * theta.cos()], [0.0; 2]);
    assert!((BEAD.outputs(&start).normal - BEAD.m * BEAD.g * theta.cos()).abs() < 1e-14);
    let expected = BEAD.r * 2.0 * theta.cos() / 3.0;
    let taylor = Problem::new(&BEAD, start)
        .on([Bead::LEAVES])
        .falling()
        .stop()
        .solve(10.0, Taylor::new())?;
    let dop853 = Problem::new(&BEAD, start)
        .on([Bead::LEAVES])
        .falling()
        .stop()
        .solve(10.0, Dop853::new())?;
    for end in [taylor.last, dop853.last] {
        assert!(
            (end.q[1] - expected).abs() < 1e-8,
            "{} {expected}",
            end.q[1]
        );
        assert!(BEAD.multipliers(&end)[0].abs() < 1e-8);
    }
    Ok(())
}
