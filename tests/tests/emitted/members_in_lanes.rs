//! Structs with a type parameter for the scalar, whose members are integrated in lanes.

use core::marker::PhantomData;

use lagrangian::prelude::*;

/// Whatever is about a type.
pub(crate) trait About<T> {}

/// With a constant, a lifetime, a private field that is copied, and an identifier that is a keyword.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2), potential = 0.5 * r#type * x.powi(2))]
struct Tagged<'a, T: Scalar, const L: usize> {
    m: T,
    r#type: T,
    #[lagrangian(skip)]
    tags: [&'a str; L],
    #[lagrangian(skip)]
    scalar: PhantomData<T>,
}

/// With the bound in a `where` clause, beside others.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
struct Where<T, A>
where
    T: Scalar,
    A: Clone,
{
    m: T,
    #[lagrangian(skip)]
    other: A,
}

/// Not for lanes: another parameter is about the scalar.
#[derive(Lagrangian)]
#[lagrangian(taylor, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
struct Entangled<T: Scalar, A: About<T>> {
    m: T,
    #[lagrangian(skip)]
    other: PhantomData<(A, fn(T))>,
}

struct Something;

impl About<f64> for Something {}

#[test]
fn members_have_their_own_parameters() {
    let members = [1.0, 4.0, 9.0].map(|stiffness| Tagged {
        m: 1.0,
        r#type: stiffness,
        tags: ["spring"],
        scalar: PhantomData,
    });
    assert_eq!(members[0].tags, ["spring"]);
    let start = State::new(0.0, [1.0], [0.0]);
    let problems = members.map(|member| Problem::new(member, start));
    let ends = Ensemble::new(problems).solve(2.0, Taylor::new());
    for (found, rate) in ends.into_iter().zip([1.0_f64, 2.0, 3.0]) {
        let found = found.expect("it is regular");
        assert!((found.q[0] - (2.0 * rate).cos()).abs() < 1e-14);
    }
    let problems = [1.0, 2.0].map(|m| Problem::new(Where { m, other: "" }, start));
    let ends = Ensemble::new(problems).solve(1.0, Taylor::new());
    assert!(
        ends.into_iter()
            .all(|end| end.is_ok_and(|end| (end.q[0] - 1.0).abs() < 1e-15))
    );
    let entangled: Entangled<f64, Something> = Entangled {
        m: 1.0,
        other: PhantomData,
    };
    let end = Problem::new(&entangled, start).solve(1.0, Taylor::new());
    assert!(end.is_ok());
}

/// Beside a type with a name that a constant might have.
mod beside_a_type {
    use lagrangian::prelude::*;

    #[allow(dead_code)]
    struct L;

    #[derive(Lagrangian)]
    #[lagrangian(taylor, coordinates(x), kinetic = 0.5 * m * dot(x).powi(2))]
    pub(super) struct Free<T: Scalar> {
        pub(super) m: T,
    }
}

#[test]
fn names_in_scope_do_not_matter() {
    let start = State::new(0.0, [1.0], [0.5]);
    let problems = [1.0, 2.0].map(|m| Problem::new(beside_a_type::Free { m }, start));
    for found in Ensemble::new(problems).solve(2.0, Taylor::new()) {
        let end = found.expect("it is regular");
        assert!((end.q[0] - 2.0).abs() < 1e-15);
    }
}
