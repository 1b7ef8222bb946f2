//! Slices of numbers as states, and back.

use lagrangian::prelude::*;
use lagrangian_solvers::OdeSystem;

use crate::models::{balance, cart_pole, top};

#[test]
fn components_are_coordinates_then_velocities() {
    let (model, start) = top();
    let system = OdeSystem::new(&model, start).unwrap();
    assert_eq!(system.size(), 6);
    assert_eq!(system.start(), &start);
    assert_eq!(system.initial(), [0.1, 0.5, 0.2, 0.3, 0.1, 12.0]);
    assert_eq!(system.initial_array(), Ok([0.1, 0.5, 0.2, 0.3, 0.1, 12.0]));
    let state = system.state(3.0, &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]).unwrap();
    assert_eq!(state, State::new(3.0, [1.0, 2.0, 3.0], [4.0, 5.0, 6.0]));
}

#[test]
fn the_derivative_of_a_model_are_its_velocities_and_accelerations() {
    let (model, _) = cart_pole();
    let state = State::new(0.4, [0.1, 0.3], [0.5, 0.7]);
    let pushed = model.with_inputs(2.0);
    let system = OdeSystem::new(&pushed, state).unwrap();
    let mut derivative = [0.0; 4];
    system
        .derivative(0.4, &[0.1, 0.3, 0.5, 0.7], &mut derivative)
        .unwrap();
    let accelerations = pushed.accelerations(&state);
    assert_eq!(derivative, [0.5, 0.7, accelerations[0], accelerations[1]]);
    assert_ne!(accelerations, model.accelerations(&state));
}

#[test]
fn a_law_of_a_closure_needs_no_annotation() {
    let (model, start) = cart_pole();
    let problem = Problem::new(&model, start).feedback(|state| balance(state) + state.v[1]);
    let controlled = problem.dynamics();
    let system = OdeSystem::new(controlled, start).unwrap();
    let mut derivative = [0.0; 4];
    system
        .derivative(start.t, &system.initial(), &mut derivative)
        .unwrap();
    let push = balance(&start) + start.v[1];
    let accelerations = model.with_inputs(push).accelerations(&start);
    assert_eq!(derivative[2..], [accelerations[0], accelerations[1]]);
}
