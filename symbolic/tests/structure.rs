//! What is known of a system symbolically, and what has no equations of motion.

use lagrangian_symbolic::{Defect, Equations, Model};
use lagrangian_symbolic_testing::systems::rigid_body;
use lagrangian_symbolic_testing::{Draft, Quantity};

#[test]
fn euler_angles_are_singular_where_theta_says_so() {
    let mut model = rigid_body();
    let equations = Equations::derive(&mut model).unwrap();
    // det M = I₁ I₂ I₃ sin²θ: neither φ nor ψ matters, though M contains ψ.
    assert_eq!(
        equations.coordinate_properties.singularities,
        vec![vec![1]; 3]
    );
    // φ occurs nowhere.
    assert_eq!(
        equations.coordinate_properties.angles,
        vec![false, true, true]
    );
    assert_eq!(
        equations.coordinate_properties.ignorable,
        vec![true, false, false]
    );
}

#[test]
fn blocks_of_the_mass_matrix_have_their_own_singularities() {
    // A planar point in polar coordinates beside a linear one: T = ½(ṙ² + r²φ̇² + ẋ²), V = x².
    let draft = Draft::new(3);
    let [r, phi, x] = draft.qs();
    let speeds = [r.dot(), r * phi.dot(), x.dot()];
    let kinetic = draft.sum(speeds.map(Quantity::squared)) / 2;
    let mut model = draft.natural(kinetic, x.squared());
    let structure = Equations::derive(&mut model).unwrap().coordinate_properties;
    assert_eq!(structure.singularities, vec![vec![], vec![0], vec![]]);
    // φ occurs nowhere; r and x are lengths.
    assert_eq!(structure.angles, vec![false; 3]);
    assert_eq!(structure.ignorable, vec![false, true, false]);
}

#[test]
fn what_has_no_equations_of_motion_is_refused() {
    // T = ½(ẋ + ẏ)²: M has rank one.
    let draft = Draft::new(2);
    let [vx, vy] = draft.vs();
    let mut model = draft.natural((vx + vy).squared() / 2, draft.zero());
    assert_eq!(
        Equations::derive(&mut model).unwrap_err(),
        Defect::SingularMass(vec![0, 1])
    );

    // T = ½ẋ², with y in V: y has no acceleration.
    let draft = Draft::new(2);
    let [x, y] = draft.qs();
    let mut model = draft.natural(x.dot().squared() / 2, y);
    assert_eq!(
        Equations::derive(&mut model).unwrap_err(),
        Defect::NoInertia(vec![1])
    );

    // T = ½ẋ² + u ẋ: the momentum contains an input.
    let draft = Draft::new(1);
    let (vx, u) = (draft.v(0), draft.input());
    let mut model = draft.natural(vx.squared() / 2 + u * vx, draft.zero());
    assert_eq!(
        Equations::derive(&mut model).unwrap_err(),
        Defect::MomentumOfInput(vec![0])
    );
}

#[test]
fn singularity_is_decided_through_trigonometry_and_roots() {
    // w₁ = ẋ cos a + ẏ sin a with a moving, T = ½ w₁² + ½ √(a²+1)² ȧ²: rank two of three.
    let draft = Draft::new(3);
    let [x, y, a] = draft.qs();
    let w1 = x.dot() * a.cos() + y.dot() * a.sin();
    let w2 = (a.squared() + 1).sqrt() * a.dot();
    let mut singular = draft.natural((w1.squared() + w2.squared()) / 2, draft.zero());
    assert_eq!(
        Equations::derive(&mut singular).unwrap_err(),
        Defect::SingularMass(vec![0, 1])
    );
}

/// ½ m (ẋ + √c ẏ)², which is singular for every c.
fn leaning(c: i64) -> Model {
    let draft = Draft::new(2);
    let (m, [vx, vy]) = (draft.p(0), draft.vs());
    let speed = vx + draft.number(c).sqrt() * vy;
    draft.natural(m * speed.squared() / 2, draft.zero())
}

#[test]
fn roots_of_small_numbers_are_no_obstacle() {
    for c in [2, 3, 5, 6, 7, 10, 11, 13, 17, 19, 23] {
        let defect = Equations::derive(&mut leaning(c)).unwrap_err();
        assert_eq!(defect, Defect::SingularMass(vec![0, 1]), "root of {c}");
    }
}

#[test]
fn corners_are_not_taken_for_zero() {
    // T = ½ max(l, 0) ẋ²: M vanishes for half of all l, and not identically.
    for i in 0..24 {
        let draft = Draft::new(1);
        let (l, v, zero) = (draft.p(i), draft.v(0), draft.zero());
        let mut model = draft.natural(l.max(zero) * v.squared() / 2, zero);
        assert!(Equations::derive(&mut model).is_ok());
    }
}
