//! Routh's reduction: what is eliminated, what spoils it, and what the reduced model costs.

use lagrangian_symbolic::{
    Energies, Equations, Kinetics, Model, NoReduction, Obstacle, PoleForm, Program, Reduction,
    ReductionCheck, Symbol,
};
use lagrangian_symbolic_testing::Draft;
use lagrangian_symbolic_testing::systems::{euler_rates, top};

/// The number of parameters of the top.
const PARAMETERS: u32 = 4;

fn reduction(model: &mut Model, form: PoleForm) -> Result<Reduction, NoReduction> {
    let equations = Equations::derive(model).unwrap();
    Reduction::of(model, &equations, PARAMETERS, form)
}

fn operations(mut model: Model) -> (usize, usize) {
    let equations = Equations::derive(&mut model).unwrap();
    let solution = Kinetics::cheapest(&mut model, &equations).solution.unwrap();
    let roots = [&*solution.pivots, &solution.accelerations];
    let program = Program::schedule_for_staging(&model.graph, &roots);
    let kernel = program.hoist_invariants().kernel;
    (kernel.instructions().count(), kernel.count().cost())
}

#[test]
fn a_symmetric_top_is_left_with_one_angle() {
    let mut full = top(euler_rates, [0, 0, 2]);
    let forms = [(PoleForm::Direct, 11, 26), (PoleForm::HalfAngles, 14, 33)];
    for (form, most, cost) in forms {
        let found = reduction(&mut full, form).unwrap();
        assert_eq!(
            (&*found.ignorable, &*found.remaining),
            (&[0, 2][..], &[1][..])
        );
        assert!(ReductionCheck::new(&full, &found, PARAMETERS).agrees());
        let counted = operations(found.model);
        assert!(
            counted.0 <= most && counted.1 <= cost,
            "{form:?}: {counted:?}"
        );
    }
}

#[test]
fn a_wrong_reduction_is_found() {
    let mut full = top(euler_rates, [0, 0, 2]);
    let right = reduction(&mut full, PoleForm::Direct).unwrap();
    let agrees = |found: &Reduction| ReductionCheck::new(&full, found, PARAMETERS).agrees();
    let mut wrong = right.clone();
    wrong.ignorable_velocities.swap(0, 1);
    assert!(!agrees(&wrong));
    let mut wrong = right.clone();
    let Energies::Natural { kinetic, potential } = wrong.model.energies else {
        unreachable!()
    };
    wrong.effective_potential = kinetic;
    assert!(!agrees(&wrong));
    let mut wrong = right.clone();
    wrong.model.energies = Energies::Natural {
        kinetic,
        potential: wrong.model.graph.negate(potential),
    };
    wrong.effective_potential = wrong.model.graph.negate(potential);
    assert!(!agrees(&wrong));
    let mut wrong = right.clone();
    wrong.model.evaluated = Some(Energies::Natural {
        kinetic,
        potential: kinetic,
    });
    assert!(!agrees(&wrong));
    let mut wrong = right;
    wrong.model.forces[0] = kinetic;
    assert!(!agrees(&wrong));
}

/// Velocities and accelerations of ignorable coordinates are eliminated; what depends on one itself is not determined.
#[test]
fn outputs_are_expressed_through_the_constants() {
    let draft = Draft::new(2);
    let ([r, phi], [_, turning]) = (draft.qs::<2>(), draft.vs::<2>());
    let outputs = [
        r * r * turning,
        turning.dot(),
        (r * phi.cos()).squared() + (r * phi.sin()).squared() + r.dot(),
        r * phi.cos(),
    ];
    let outputs = outputs.map(Into::into).to_vec();
    let kinetic = (r.dot().squared() + r.squared() * turning.squared()) / 2;
    let mut full = draft.natural(kinetic, -r.recip());
    full.outputs = outputs;
    let mut found = reduction(&mut full, PoleForm::Direct).unwrap();
    let agrees = |found: &Reduction| ReductionCheck::new(&full, found, PARAMETERS).agrees();
    assert!(agrees(&found));
    assert_eq!(found.outputs[3], Err(1));
    assert_eq!(found.outputs.iter().flatten().count(), 3);
    // r² φ̇ is the constant.
    let graph = &found.model.graph;
    let constant = Symbol::Parameter(PARAMETERS);
    let areal = found.outputs[0].unwrap();
    assert!(graph.contains(&[areal], |symbol| symbol == constant));
    assert!(!graph.contains(&[areal], |symbol| symbol == Symbol::Coordinate(0)));
    let mut wrong = found.clone();
    wrong.outputs.swap(0, 1);
    assert!(!agrees(&wrong));
    found.retain_outputs(&[1, 3, 2]);
    assert_eq!(found.model.outputs.len(), 2);
}

#[test]
fn what_spoils_a_coordinate_is_named() {
    let draft = Draft::new(2);
    let ([x, _], [u, v]) = (draft.qs::<2>(), draft.vs::<2>());
    let dissipation = (v * v).into();
    let mut model = draft.natural(u * u + v * v, x * x);
    model.dissipation = dissipation;
    let Err(NoReduction::NoneIgnorable(spoilers)) = reduction(&mut model, PoleForm::Direct) else {
        panic!("there is no ignorable coordinate");
    };
    let obstacles: Vec<_> = spoilers
        .into_iter()
        .map(|spoiler| spoiler.obstacles)
        .collect();
    assert_eq!(obstacles, [[Obstacle::Potential], [Obstacle::Dissipation]]);
}

#[test]
fn a_velocity_in_which_the_lagrangian_is_not_quadratic_is_refused() {
    let draft = Draft::new(2);
    let (x, [u, v]) = (draft.q(0), draft.vs::<2>());
    let mut model = draft.general(u * u + v * v + x * x * v.powi(4));
    let found = reduction(&mut model, PoleForm::Direct).map(|found| found.ignorable);
    assert_eq!(found, Err(NoReduction::NotQuadratic(1)));
}
