//! `differential-equations`. Its `radau5` loosens a tolerance that is one number once for each component, and takes no `Vec`: tolerances
//! and states are arrays.

use differential_equations::error::Error;
use differential_equations::linalg::Matrix;
use differential_equations::ode::ODE;
use differential_equations::prelude::{
    BackwardDifferentiationFormula, ExplicitRungeKutta, IVP, ImplicitRungeKutta, Solution,
};
use lagrangian::prelude::{Lagrangian, Problem, Taylor};
use lagrangian_solvers::OdeSystem;

use crate::closeness::{assert_close, error};
use crate::models::{Balanced, balance, cart_pole, runaway, top, van_der_pol};

/// By Radau's method of order 5, whose own tolerance is 0.1 of the power ⅔ of this one.
fn radau5<F: ODE<f64, [f64; SIZE]>, const SIZE: usize>(
    system: &F,
    (start, end): (f64, f64),
    initial: [f64; SIZE],
    tolerance: f64,
) -> Result<Solution<f64, [f64; SIZE]>, Error<f64, [f64; SIZE]>> {
    let method = ImplicitRungeKutta::radau5();
    let method = method.rtol([tolerance; SIZE]).atol([tolerance; SIZE]);
    IVP::ode(system, start, end, initial).method(method).solve()
}

#[test]
fn a_heavy_top_moves_as_by_taylor() {
    let (model, start) = top();
    let expected = Problem::new(&model, start)
        .solve(5.0, Taylor::new())
        .unwrap();
    let system = OdeSystem::new(&model, start).unwrap();

    let method = ExplicitRungeKutta::dop853().rtol(1e-13).atol(1e-13);
    let solution = IVP::ode(&system, 0.0, 5.0, system.initial())
        .method(method)
        .solve()
        .unwrap();
    let end = system.state(5.0, solution.y.last().unwrap()).unwrap();
    assert_close(&end.x, &expected.x, 1e-11);

    let initial: [f64; 6] = system.initial_array().unwrap();
    let solution = radau5(&system, (0.0, 5.0), initial, 1e-12).unwrap();
    let end = system.state(5.0, solution.y.last().unwrap()).unwrap();
    assert_close(&end.x, &expected.x, 1e-8);
}

#[test]
fn a_stiff_oscillator_relaxes_as_by_taylor() {
    let (model, start, end) = van_der_pol();
    let expected = Problem::new(&model, start)
        .solve(end, Taylor::new())
        .unwrap();
    let system = OdeSystem::new(&model, start).unwrap();
    let initial: [f64; 2] = system.initial_array().unwrap();
    let solution = radau5(&system, (0.0, end), initial, 1e-12).unwrap();
    let found = system.state(end, solution.y.last().unwrap()).unwrap();
    assert_close(&found.x, &expected.x, 1e-9);
    assert!(solution.evals.jacobian > 100, "{:?}", solution.evals);
}

#[test]
fn a_law_moves_a_cart_as_by_our_method() {
    let (model, start) = cart_pole();
    let problem = Problem::new(&model, start).feedback(balance);
    let controlled = problem.dynamics();
    let ours = lagrangian::Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let expected = Problem::new(controlled, start).solve(4.0, ours).unwrap();
    let balanced = Balanced(&model);
    let system = OdeSystem::new(&balanced, start)
        .unwrap()
        .jacobian_by(&balanced);
    let initial: [f64; 4] = system.initial_array().unwrap();

    let solution = radau5(&system, (start.t, 4.0), initial, 1e-12).unwrap();
    let end = system.state(4.0, solution.y.last().unwrap()).unwrap();
    assert_close(&end.x, &expected.x, 1e-9);

    let method = BackwardDifferentiationFormula::adaptive()
        .rtol(1e-10)
        .atol(1e-10);
    let solution = IVP::ode(&system, start.t, 4.0, initial)
        .method(method)
        .solve()
        .unwrap();
    let end = system.state(4.0, solution.y.last().unwrap()).unwrap();
    assert_close(&end.x, &expected.x, 1e-8);

    // Without a Jacobian it is differenced.
    let system = OdeSystem::new(controlled, start).unwrap();
    let solution = radau5(&system, (start.t, 4.0), initial, 1e-12).unwrap();
    let end = system.state(4.0, solution.y.last().unwrap()).unwrap();
    assert_close(&end.x, &expected.x, 1e-9);
}

#[test]
fn the_jacobian_is_the_exact_one() {
    let (model, start) = cart_pole();
    let system = OdeSystem::new(&model, start).unwrap();
    let x = system.initial();
    let mut expected = vec![0.0; 16];
    system.jacobian(0.5, &x, &mut expected).unwrap();
    let mut found = Matrix::zeros(4, 4);
    ODE::jacobian(&system, 0.5, &x, &mut found);
    assert_eq!(found.to_dense_vec(), expected);

    // Without one it is differenced, and has errors.
    let dynamics = model.dynamics();
    let system = OdeSystem::new(&dynamics, start).unwrap();
    ODE::jacobian(&system, 0.5, &x, &mut found);
    let error = error(&found.to_dense_vec(), &expected);
    assert!((1e-12..1e-5).contains(&error), "{error:e}");
}

#[test]
fn failures_are_values() {
    let (model, start, end) = van_der_pol();
    let system = OdeSystem::new(&model, start).unwrap();
    let initial: [f64; 2] = system.initial_array().unwrap();
    let failed = IVP::ode(&system, 0.0, end, initial)
        .method(ImplicitRungeKutta::radau5().max_steps(10))
        .solve();
    assert!(matches!(failed, Err(Error::MaxSteps { .. })), "{failed:?}");

    let (model, start) = runaway();
    let system = OdeSystem::new(&model, start).unwrap();
    let initial: [f64; 2] = system.initial_array().unwrap();
    let failed = radau5(&system, (0.0, 2.0), initial, 1e-8);
    assert!(failed.is_err(), "{failed:?}");
}

#[test]
fn states_of_other_sizes_have_no_derivative() {
    let (model, start, end) = van_der_pol();
    let system = OdeSystem::new(&model, start).unwrap();
    let method = ExplicitRungeKutta::dop853().rtol(1e-10).atol(1e-10);
    let failed = IVP::ode(&system, 0.0, end, [1.0; 3]).method(method).solve();
    assert!(failed.is_err(), "{failed:?}");
    // It ends with NaN.
    let solution = radau5(&system, (0.0, end), [1.0; 3], 1e-10).unwrap();
    assert!(
        solution
            .y
            .last()
            .unwrap()
            .iter()
            .all(|component| component.is_nan())
    );
    let mut jacobian = Matrix::zeros(3, 3);
    ODE::jacobian(&system, 0.0, &[1.0; 3], &mut jacobian);
    assert!(
        jacobian
            .to_dense_vec()
            .iter()
            .all(|component| component.is_nan())
    );
}
