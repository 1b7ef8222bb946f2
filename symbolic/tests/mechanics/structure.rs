//! What is known of a system symbolically, and what has no equations of motion.

use lagrangian_symbolic::{Defect, Equations, Model, Unary};
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

/// The period of the only coordinate under a potential.
fn period(potential: impl for<'a> Fn(Quantity<'a>, &'a Draft) -> Quantity<'a>) -> u32 {
    let draft = Draft::new(1);
    let q = draft.q(0);
    let mut model = draft.natural(q.dot().squared() / 2, potential(q, &draft));
    let properties = Equations::derive(&mut model).unwrap().coordinate_properties;
    properties.periods[0]
}

fn tangent<'d>(x: Quantity<'d>, draft: &'d Draft) -> Quantity<'d> {
    draft.make(|graph| graph.unary(Unary::Tan, x.expression()))
}

#[test]
fn periods_are_the_full_turns_that_all_sines_share() {
    assert_eq!(period(|q, _| q.sin()), 1);
    assert_eq!(period(|q, _| (2 * q).cos()), 1);
    assert_eq!(period(|q, _| (q / 2).sin()), 2);
    assert_eq!(period(|q, _| (-(3 * q) / 10 + 1).sin()), 10);
    assert_eq!(period(|q, draft| tangent(2 * q / 3, draft)), 3);
    assert_eq!(period(|q, _| (q / 4).sin() * (3 * q / 2).cos()), 4);
    assert_eq!(period(|q, _| (q / 4).sin() + (q / 6).cos().exp()), 12);
    assert_eq!(period(|q, _| (q / 4 + (q / 3).sin()).sin()), 12);
    // Not above the limit.
    assert_eq!(period(|q, _| (q / 64).sin()), 64);
    assert_eq!(period(|q, _| (q / 65).sin()), 0);
    assert_eq!(period(|q, _| (q / 11).sin() + (q / 7).sin()), 0);
}

#[test]
fn what_depends_on_a_coordinate_itself_has_no_period() {
    assert_eq!(period(|q, draft| (draft.p(0) * q).sin()), 0);
    assert_eq!(period(|q, _| q.sin() + q.squared()), 0);
    assert_eq!(period(|q, _| (q.squared()).sin()), 0);
    assert_eq!(period(|q, _| (q + q.squared()).sin()), 0);
    // Nothing depends on it.
    assert_eq!(period(|_, draft| draft.zero()), 1);
}

#[test]
fn a_long_sum_under_a_sine_counts_through_its_parts() {
    // The sum of the others stays one term of the argument, with a factor of 1/2.
    let draft = Draft::new(12);
    let qs: [_; 12] = draft.qs();
    let sum = draft.sum(qs);
    let kinetic = draft.sum(qs.map(|q| q.dot().squared())) / 2;
    let mut model = draft.natural(kinetic, (sum / 2 + qs[0] / 3).sin());
    let properties = Equations::derive(&mut model).unwrap().coordinate_properties;
    // 1/2 + 1/3, or both of them.
    assert_eq!(properties.periods[0], 6);
    assert_eq!(properties.periods[1..], [2; 11]);
}

#[test]
fn forces_and_dissipation_count_for_periods() {
    let draft = Draft::new(3);
    let [a, b, c] = draft.qs();
    let kinetic = draft.sum([a, b, c].map(|q| q.dot().squared())) / 2;
    let forces = [(a / 2).sin(), draft.zero(), c].map(Quantity::expression);
    let dissipation = b.dot().squared() * ((b / 3).cos() + 2);
    let dissipation = dissipation.expression();
    let mut model = draft.natural(kinetic, a.cos() + b.cos() + c.cos());
    model.forces = forces.to_vec();
    model.dissipation = dissipation;
    let properties = Equations::derive(&mut model).unwrap().coordinate_properties;
    assert_eq!(properties.periods, [2, 3, 0]);
    assert_eq!(properties.angles, [true, true, false]);
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
