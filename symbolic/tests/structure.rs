//! The properties of coordinates, and declarations without equations of motion.

mod support;

use lagrangian_symbolic::{Binary, Defect, Equations, Model, Symbol};
use support::draft::Draft;
use support::systems::rigid_body;

#[test]
fn euler_angles_are_singular_where_theta_says_so() {
    let (mut model, _) = rigid_body();
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
    let mut draft = Draft::new(3);
    let (r, x) = (draft.q(0), draft.q(2));
    let (vr, vphi, vx) = (draft.v(0), draft.v(1), draft.v(2));
    let across = draft.times(&[r, vphi]);
    let squares: Vec<_> = [vr, across, vx].map(|v| draft.square(v)).to_vec();
    let sum = draft.plus(&squares);
    let (kinetic, potential) = (draft.half(sum), draft.square(x));
    let mut model = draft.natural(kinetic, potential);
    let structure = Equations::derive(&mut model).unwrap().coordinate_properties;
    assert_eq!(structure.singularities, vec![vec![], vec![0], vec![]]);
    // φ occurs nowhere; r and x are lengths.
    assert_eq!(structure.angles, vec![false; 3]);
    assert_eq!(structure.ignorable, vec![false, true, false]);
}

#[test]
fn what_has_no_equations_of_motion_is_refused() {
    // T = ½(ẋ + ẏ)²: M has rank one.
    let mut draft = Draft::new(2);
    let (vx, vy) = (draft.v(0), draft.v(1));
    let sum = draft.plus(&[vx, vy]);
    let square = draft.square(sum);
    let kinetic = draft.half(square);
    let zero = draft.graph.zero();
    let mut model = draft.natural(kinetic, zero);
    assert_eq!(
        Equations::derive(&mut model).unwrap_err(),
        Defect::SingularMass(vec![0, 1])
    );

    // T = ½ẋ², with y in V: y has no acceleration.
    let mut draft = Draft::new(2);
    let (vx, y) = (draft.v(0), draft.q(1));
    let square = draft.square(vx);
    let kinetic = draft.half(square);
    let mut model = draft.natural(kinetic, y);
    assert_eq!(
        Equations::derive(&mut model).unwrap_err(),
        Defect::NoVelocity(vec![1])
    );

    // T = ½ẋ² + u ẋ: the momentum contains an input.
    let mut draft = Draft::new(1);
    let vx = draft.v(0);
    let u = draft.graph.symbol(Symbol::Input(0));
    let square = draft.square(vx);
    let quadratic = draft.half(square);
    let linear = draft.times(&[u, vx]);
    let kinetic = draft.plus(&[quadratic, linear]);
    let zero = draft.graph.zero();
    let mut model = draft.natural(kinetic, zero);
    assert_eq!(
        Equations::derive(&mut model).unwrap_err(),
        Defect::MomentumOfInput(vec![0])
    );
}

#[test]
fn singularity_is_decided_through_trigonometry_and_roots() {
    // w₁ = ẋ cos a + ẏ sin a with a moving, T = ½ w₁² + ½ √(a²+1)² ȧ²: rank two of three.
    let mut draft = Draft::new(3);
    let (vx, vy, a, va) = (draft.v(0), draft.v(1), draft.q(2), draft.v(2));
    let (sin, cos) = (draft.sin(a), draft.cos(a));
    let (first, second) = (draft.times(&[vx, cos]), draft.times(&[vy, sin]));
    let along = draft.plus(&[first, second]);
    let a2 = draft.square(a);
    let one = draft.graph.one();
    let inner = draft.plus(&[a2, one]);
    let root = draft.graph.square_root(inner);
    let turning = draft.times(&[root, va]);
    let (t1, t2) = (draft.square(along), draft.square(turning));
    let sum = draft.plus(&[t1, t2]);
    let kinetic = draft.half(sum);
    let zero = draft.graph.zero();
    let mut singular = draft.natural(kinetic, zero);
    assert_eq!(
        Equations::derive(&mut singular).unwrap_err(),
        Defect::SingularMass(vec![0, 1])
    );
}

/// ½ m (ẋ + √c ẏ)², which is singular for every c.
fn leaning(c: i64) -> Model {
    let mut draft = Draft::new(2);
    let (m, vx, vy) = (draft.parameter(0), draft.v(0), draft.v(1));
    let number = draft.graph.integer(c);
    let root = draft.graph.square_root(number);
    let slanted = draft.times(&[root, vy]);
    let along = draft.plus(&[vx, slanted]);
    let square = draft.square(along);
    let twice = draft.times(&[m, square]);
    let kinetic = draft.half(twice);
    let zero = draft.graph.zero();
    draft.natural(kinetic, zero)
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
        let mut draft = Draft::new(1);
        let (l, v) = (draft.parameter(i), draft.v(0));
        let zero = draft.graph.zero();
        let mass = draft.graph.binary(Binary::Max, l, zero);
        let square = draft.square(v);
        let twice = draft.times(&[mass, square]);
        let kinetic = draft.half(twice);
        assert!(Equations::derive(&mut draft.natural(kinetic, zero)).is_ok());
    }
}
