//! External functions, and arguments, that are called like other things.

/// Functions whose names, and whose arguments' names, are those of other things.
mod functions {
    use lagrangian::prelude::*;

    #[derive(Lagrangian)]
    #[lagrangian(
        scalar = f64,
        coordinates(x),
        function(
            r#match(state, arguments, x0) = state * arguments + x0 * self.state(),
            derivative(state) = arguments,
            derivative(arguments) = state,
            derivative(x0) = prepared,
        ),
        function(mentions(r#type) = r#type * r#type, derivative(r#type) = twice(r#type)),
        function(twice(x) = twice(x), derivative(x) = twice_by_0()),
        function(twice_by_0() = 2.0),
        function(state(q) = { let state = q; self::functions_of_the_user::state(state) }, derivative(q) = 3.0),
        kinetic = 0.5 * factors * dot(x).powi(2),
        potential = r#match(x, x, t) + mentions(x) + state(x),
        force(x = x.r#match(dot(x), 1.0)),
        output(state = state(x)),
    )]
    pub(super) struct Model {
        pub(super) factors: f64,
        pub(super) prepared: f64,
        #[lagrangian(skip)]
        pub(super) state: f64,
    }

    impl Model {
        fn state(&self) -> f64 {
            self.state
        }
    }

    fn twice(x: f64) -> f64 {
        2.0 * x
    }

    mod functions_of_the_user {
        pub(super) fn state(state: f64) -> f64 {
            3.0 * state
        }
    }
}

#[test]
fn functions_meet_nothing_of_the_users() {
    use lagrangian::prelude::*;

    let model = functions::Model {
        factors: 2.0,
        prepared: 5.0,
        state: 5.0,
    };
    let state = State::new(4.0, [0.5], [3.0]);
    // V = x² + 5 t + x² + 3 x, and the force is x ẋ + 5.
    assert!((model.potential_energy(&state) - 22.0).abs() < 1e-15);
    assert!((model.accelerations(&state)[0] - (1.5 + 5.0 - 5.0) / 2.0).abs() < 1e-15);
    assert!((model.outputs(&state).state - 1.5).abs() < 1e-15);
    let regions = [-1.0..=1.0, -1.0..=1.0, -1.0..=1.0];
    assert_eq!(model.check_derivatives("match", regions), Ok(()));
    for function in ["mentions", "twice", "state"] {
        assert_eq!(model.check_derivatives(function, [-1.0..=1.0]), Ok(()));
    }
}
