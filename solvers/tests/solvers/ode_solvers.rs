//! `ode_solvers`. Its dense output extrapolates to the final time where the steps are shorter than the interval of the output: the
//! ends of steps are exact.

use lagrangian::prelude::{Problem, Taylor};
use lagrangian_solvers::OdeSystem;
use ode_solvers::dop_shared::IntegrationError;
use ode_solvers::{DVector, Dop853, Dopri5, OutputType, SVector};

use crate::closeness::assert_close;
use crate::models::{balance, cart_pole, runaway, top, van_der_pol};

#[test]
fn a_heavy_top_moves_as_by_taylor() {
    let (model, start) = top();
    let expected = Problem::new(&model, start)
        .solve(5.0, Taylor::new())
        .unwrap();
    let system = OdeSystem::new(&model, start).unwrap();

    let initial = DVector::from(system.initial());
    let mut solver = Dop853::new(&system, 0.0, 5.0, 5.0, initial, 1e-13, 1e-13);
    solver.set_output(OutputType::Sparse);
    solver.integrate().unwrap();
    let last = solver.y_out().last().unwrap();
    let end = system.state(5.0, last.as_slice()).unwrap();
    assert_close(&end.x, &expected.x, 1e-11);

    let initial = SVector::<f64, 6>::from(system.initial_array().unwrap());
    let mut solver = Dopri5::new(system.clone(), 0.0, 5.0, 5.0, initial, 1e-11, 1e-11);
    solver.set_output(OutputType::Sparse);
    solver.integrate().unwrap();
    let last = solver.y_out().last().unwrap();
    let end = system.state(5.0, last.as_slice()).unwrap();
    assert_close(&end.x, &expected.x, 1e-9);
}

/// By `Dopri5`: the nodes of `Dop853` in version 0.6.2 are wrong for equations that contain the time.
#[test]
fn a_law_moves_a_cart_as_by_our_method() {
    let (model, start) = cart_pole();
    let problem = Problem::new(&model, start).feedback(balance);
    let controlled = problem.dynamics();
    let ours = lagrangian::Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let expected = Problem::new(controlled, start).solve(4.0, ours).unwrap();
    let system = OdeSystem::new(controlled, start).unwrap();
    let initial = DVector::from(system.initial());
    let mut solver = Dopri5::new(&system, start.t, 4.0, 3.5, initial, 1e-11, 1e-11);
    solver.set_output(OutputType::Sparse);
    solver.integrate().unwrap();
    let last = solver.y_out().last().unwrap();
    let end = system.state(4.0, last.as_slice()).unwrap();
    assert_close(&end.x, &expected.x, 1e-10);
}

#[test]
fn failures_are_values() {
    let (model, start, end) = van_der_pol();
    let system = OdeSystem::new(&model, start).unwrap();
    let initial = DVector::from(system.initial());
    let mut solver = Dop853::new(&system, 0.0, end, 1.0, initial, 1e-3, 1e-3);
    let failed = solver.integrate();
    assert!(
        matches!(failed, Err(IntegrationError::StiffnessDetected { .. })),
        "{failed:?}"
    );

    let (model, start) = runaway();
    let system = OdeSystem::new(&model, start).unwrap();
    let initial = DVector::from(system.initial());
    let mut solver = Dop853::new(&system, 0.0, 2.0, 1.0, initial, 1e-8, 1e-8);
    let failed = solver.integrate();
    assert!(failed.is_err(), "{failed:?}");
}

#[test]
fn states_of_other_sizes_have_no_derivative() {
    let (model, start, _) = van_der_pol();
    let system = OdeSystem::new(&model, start).unwrap();
    let other = DVector::from(vec![1.0; 3]);
    let mut derivative = other.clone();
    ode_solvers::System::system(&system, 0.0, &other, &mut derivative);
    assert!(derivative.iter().all(|component| component.is_nan()));
    let mut solver = Dop853::new(&system, 0.0, 1.0, 1.0, other, 1e-6, 1e-6);
    let failed = solver.integrate();
    assert!(failed.is_err(), "{failed:?}");
}
