//! Derivatives of reactions, and of motions by their initial values.

use lagrangian::StateTransition;
use lagrangian::analysis::{StateSpace, TangentBasis, TangentSpace, Variable};
use lagrangian::prelude::*;
use lagrangian::quantities::{DirectionalDerivatives, Quantities};

use super::mechanisms::*;

/// λ = m (g y − v²)/(2 l²), by the state and, with g as a dual number, by a parameter.
#[test]
fn reactions_are_differentiated() {
    let bob = Bob::EXAMPLE;
    let state = bob.at(0.8, 1.7);
    let tangent = TangentSpace::at(&bob, &state).along_motion();
    let basis: TangentBasis<f64, 2, 2> = tangent.basis().expect("regular");
    let scale = 0.5 * bob.m / (bob.l * bob.l);
    assert!(
        (bob.multipliers(&state)[0] - scale * (bob.g * state.q[1] - state.v.norm_squared())).abs()
            < 1e-13
    );
    for j in 0..2 {
        let (q, v) = (
            basis.q.column(j).into_owned(),
            basis.v.column(j).into_owned(),
        );
        let inputs = Quantities::<2>::inputs(&bob);
        let found = bob.derivatives_along(&state, &inputs, &State::new(0.0, q, v));
        let expected = scale * (bob.g * q[1] - 2.0 * state.v.dot(&v));
        assert!((found.multipliers[0] - expected).abs() < 1e-12);
        assert!(found.constraint_velocities.amax() < 1e-14);
    }
}

/// Independent variables after a time, by those at its beginning: exp(A t), which a zero-order hold has, too.
fn compare<M, const N: usize, const C: usize, const D: usize, const K: usize>(
    model: &M,
    tangent: &TangentSpace<'_, M, f64, N, C>,
    transition: &StateTransition<N, K>,
) where
    M: Lagrangian<N, Model: DirectionalDerivatives<N, C>>,
{
    let basis = tangent.basis::<D>().expect("steady");
    let plant = StateSpace::<f64, D, 0, D>::reduced_free(tangent).expect("steady");
    let expected = plant.discretized(transition.state.t).a;
    for (j, column) in (0..D).map(|j| (j, [basis.q.column(j), basis.v.column(j)])) {
        let [q, v] = [&transition.q, &transition.v].map(|rows| {
            let by_coordinates = rows.fixed_columns::<N>(0) * column[0];
            by_coordinates + rows.fixed_columns::<N>(N) * column[1]
        });
        for (i, variable) in basis.variables.iter().enumerate() {
            let found = match *variable {
                Variable::Coordinate(i) => q[i],
                Variable::Velocity(i) => v[i],
                Variable::Input(_) => f64::NAN,
            };
            let error = (found - expected[(i, j)]).abs() / expected.amax();
            assert!(
                error < 1e-10,
                "{error:e} in {i}, {j} of {:?}",
                model.model().prepare().as_ref().len()
            );
        }
    }
}

#[test]
fn transitions_of_steady_motions_are_exponentials() {
    let bob = Bob::EXAMPLE;
    let hanging = bob.at(0.0, 0.0);
    let method = Dop853::new()
        .relative_tolerance(1e-13)
        .absolute_tolerance(1e-13);
    let transition = StateTransition::<2, 4>::over(&method, &bob.dynamics(), &hanging, 1.3);
    let transition = transition.expect("a motion");
    compare::<_, 2, 1, 2, 4>(&bob, &TangentSpace::at(&bob, &hanging), &transition);

    let disc = Disc {
        m: 0.4,
        r: 0.4,
        g: 9.81,
    };
    let rolling = disc.upright(4.0);
    let transition = StateTransition::<6, 12>::over(&method, &disc.dynamics(), &rolling, 1.3);
    let transition = transition.expect("a motion");
    let tangent = TangentSpace::at(&disc, &rolling)
        .without([Disc::X, Disc::Y, Disc::PHI, Disc::PSI])
        .velocities([Disc::PHI, Disc::THETA, Disc::PSI]);
    compare::<_, 6, 3, 4, 12>(&disc, &tangent, &transition);
}
