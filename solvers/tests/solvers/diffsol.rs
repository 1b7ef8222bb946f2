//! `diffsol`.

use diffsol::{
    DiffsolError, FaerLU, FaerMat, FaerSparseLU, FaerSparseMat, NalgebraLU, NalgebraMat,
    NonLinearOpJacobian, OdeEquationsImplicit, OdeSolverMethod, OdeSolverProblem,
    OdeSolverStopReason, Vector,
};
use lagrangian::prelude::{Problem, Taylor};
use lagrangian_solvers::OdeSystem;

use crate::closeness::assert_close;
use crate::models::{Balanced, balance, cart_pole, runaway, top, van_der_pol};

type M = NalgebraMat<f64>;
type LU = NalgebraLU<f64>;

#[test]
fn a_heavy_top_moves_as_by_taylor() {
    let (model, start) = top();
    let expected = Problem::new(&model, start)
        .solve(5.0, Taylor::new())
        .unwrap();
    let system = OdeSystem::new(&model, start).unwrap();
    let problem = system
        .diffsol_builder::<M>()
        .rtol(1e-10)
        .atol([1e-10])
        .build()
        .unwrap();

    let mut solver = problem.tsit45().unwrap();
    solver.solve(5.0).unwrap();
    let end = system.state(5.0, &solver.state().y.clone_as_vec()).unwrap();
    assert_close(&end.x, &expected.x, 1e-8);

    let mut solver = problem.bdf::<LU>().unwrap();
    solver.solve(5.0).unwrap();
    let end = system.state(5.0, &solver.state().y.clone_as_vec()).unwrap();
    assert_close(&end.x, &expected.x, 1e-7);
}

#[test]
fn a_stiff_oscillator_relaxes_as_by_taylor() {
    let (model, start, end) = van_der_pol();
    let expected = Problem::new(&model, start)
        .solve(end, Taylor::new())
        .unwrap();
    let system = OdeSystem::new(&model, start).unwrap();
    let problem = system
        .diffsol_builder::<M>()
        .rtol(1e-9)
        .atol([1e-9])
        .build()
        .unwrap();
    let mut solver = problem.bdf::<LU>().unwrap();
    solver.solve(end).unwrap();
    let found = system.state(end, &solver.state().y.clone_as_vec()).unwrap();
    assert_close(&found.x, &expected.x, 1e-6);

    let mut solver = problem.esdirk34::<LU>().unwrap();
    solver.solve(end).unwrap();
    let found = system.state(end, &solver.state().y.clone_as_vec()).unwrap();
    assert_close(&found.x, &expected.x, 1e-6);
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

    let problem = system
        .diffsol_builder::<FaerMat<f64>>()
        .rtol(1e-9)
        .atol([1e-9])
        .build()
        .unwrap();
    let mut solver = problem.bdf::<FaerLU<f64>>().unwrap();
    solver.solve(4.0).unwrap();
    let end = system.state(4.0, &solver.state().y.clone_as_vec()).unwrap();
    assert_close(&end.x, &expected.x, 1e-7);

    let problem = system
        .diffsol_builder::<FaerSparseMat<f64>>()
        .rtol(1e-9)
        .atol([1e-9])
        .build()
        .unwrap();
    let mut solver = problem.tr_bdf2::<FaerSparseLU<f64>>().unwrap();
    solver.solve(4.0).unwrap();
    let end = system.state(4.0, &solver.state().y.clone_as_vec()).unwrap();
    assert_close(&end.x, &expected.x, 1e-6);

    // Explicit methods need no Jacobian.
    let system = OdeSystem::new(controlled, start).unwrap();
    let problem = system
        .diffsol_builder::<M>()
        .rtol(1e-10)
        .atol([1e-10])
        .build()
        .unwrap();
    let mut solver = problem.tsit45().unwrap();
    solver.solve(4.0).unwrap();
    let end = system.state(4.0, &solver.state().y.clone_as_vec()).unwrap();
    assert_close(&end.x, &expected.x, 1e-8);
}

/// The Jacobian of the right-hand side of a problem, column by column.
fn columns<E>(problem: &OdeSolverProblem<E>, t: f64, x: &[f64]) -> Vec<f64>
where
    E: OdeEquationsImplicit<T = f64>,
{
    let vector = |components: &[f64]| E::V::from_slice(components, problem.context().clone());
    let column = |index| {
        let mut unit = vec![0.0; x.len()];
        unit[index] = 1.0;
        let product = problem.eqn.rhs().jac_mul(&vector(x), t, &vector(&unit));
        product.clone_as_vec()
    };
    (0..x.len()).flat_map(column).collect()
}

#[test]
fn the_jacobian_is_the_exact_one() {
    let (model, start) = cart_pole();
    let system = OdeSystem::new(&model, start).unwrap();
    let problem = system.diffsol_builder::<M>().build().unwrap();
    assert_eq!(problem.t0, 0.5);
    // Another state, and then another time.
    for (t, x) in [
        (0.5, [0.1, 0.2, 0.3, 0.4]),
        (0.5, [0.1, 0.6, 0.3, 0.4]),
        (0.7, [0.1, 0.6, 0.3, 0.4]),
    ] {
        let mut expected = [0.0; 16];
        system.jacobian(t, &x, &mut expected).unwrap();
        let found = columns(&problem, t, &x);
        for (index, component) in expected.iter().enumerate() {
            assert_eq!(found[index % 4 * 4 + index / 4], *component);
        }
    }
}

#[test]
fn settings_of_the_builder_are_kept() {
    let (model, start) = top();
    let system = OdeSystem::new(&model, start).unwrap();
    let builder = system.diffsol_builder::<M>().rtol(1e-10).atol([1e-10]);
    // θ̇ turns from positive to negative where the top is lowest.
    let problem = builder
        .root(|x, _, _, root| root[0] = x[4], 1)
        .build()
        .unwrap();
    let mut solver = problem.bdf::<LU>().unwrap();
    let (_, times, stop) = solver.solve(5.0).unwrap();
    assert!(matches!(stop, OdeSolverStopReason::RootFound(..)));
    let lowest = Problem::new(&model, start)
        .when(|x| x.v[1])
        .falling()
        .stop()
        .solve(5.0, Taylor::new())
        .unwrap();
    let found = times.last().unwrap();
    assert!(
        (found - lowest.t).abs() < 1e-7,
        "{found} is not {}",
        lowest.t
    );
}

#[test]
fn failures_are_values() {
    let (model, start, _) = van_der_pol();
    let system = OdeSystem::new(&model, start).unwrap();
    let wrong = system.diffsol_builder::<M>().atol([1e-6; 3]).build();
    assert!(matches!(
        wrong.map(|_| ()),
        Err(DiffsolError::OdeSolverError(_))
    ));

    let problem = system.diffsol_builder::<M>().build().unwrap();
    let mut solver = problem.bdf::<LU>().unwrap();
    assert!(matches!(
        solver.set_stop_time(-1.0),
        Err(DiffsolError::OdeSolverError(_))
    ));

    let (model, start) = runaway();
    let system = OdeSystem::new(&model, start).unwrap();
    let problem = system.diffsol_builder::<M>().build().unwrap();
    let failed = problem.bdf::<LU>().unwrap().solve(2.0).map(|_| ());
    assert!(
        matches!(failed, Err(DiffsolError::OdeSolverError(_))),
        "{failed:?}"
    );
}
