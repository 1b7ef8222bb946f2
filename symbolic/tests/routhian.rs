//! Routh's reduction: what is eliminated, and what the reduced model costs.

use lagrangian_symbolic::{
    Energies, Equations, Kinetics, Names, OperationCount, PoleForm, Program, Reduction,
};
use lagrangian_symbolic_testing::systems::{euler_rates, top};

fn count(form: PoleForm) -> (OperationCount, Program) {
    let mut model = top(euler_rates, [0, 0, 2]);
    let equations = Equations::derive(&mut model).unwrap();
    let mut reduction = Reduction::of(&model, &equations, 6, form).unwrap();
    let model = &mut reduction.model;
    if let Energies::Natural { kinetic, potential } = model.energies {
        println!(
            "T = {}\nV = {}",
            model.graph.display(
                kinetic,
                &Names {
                    coordinates: vec!["th".into()],
                    parameters: ["I", "x", "Is", "mgl", "y", "z", "Cphi", "Cpsi"]
                        .map(String::from)
                        .to_vec(),
                    ..Names::default()
                }
            ),
            model.graph.display(
                potential,
                &Names {
                    coordinates: vec!["th".into()],
                    parameters: ["I", "x", "Is", "mgl", "y", "z", "Cphi", "Cpsi"]
                        .map(String::from)
                        .to_vec(),
                    ..Names::default()
                }
            )
        );
    }
    println!(
        "V_eff = {}",
        model.graph.display(
            reduction.effective_potential,
            &Names {
                coordinates: vec!["th".into()],
                parameters: ["I", "x", "Is", "mgl", "y", "z", "Cphi", "Cpsi"]
                    .map(String::from)
                    .to_vec(),
                ..Names::default()
            }
        )
    );
    for u in &reduction.ignorable_velocities {
        println!(
            "u = {}",
            model.graph.display(
                *u,
                &Names {
                    coordinates: vec!["th".into()],
                    parameters: ["I", "x", "Is", "mgl", "y", "z", "Cphi", "Cpsi"]
                        .map(String::from)
                        .to_vec(),
                    ..Names::default()
                }
            )
        );
    }
    let equations = Equations::derive(model).unwrap();
    println!(
        "f = {}",
        model.graph.display(
            equations.forcing[0],
            &Names {
                coordinates: vec!["th".into()],
                parameters: ["I", "x", "Is", "mgl", "y", "z", "Cphi", "Cpsi"]
                    .map(String::from)
                    .to_vec(),
                ..Names::default()
            }
        )
    );
    let solution = Kinetics::cheapest(model, &equations).solution.unwrap();
    let roots = [&*solution.pivots, &solution.accelerations];
    let program = Program::schedule_for_staging(&model.graph, &roots);
    let kernel = program.hoist_invariants().kernel;
    println!("{kernel:?}");
    (kernel.count(), kernel)
}

#[test]
fn look() {
    for form in [PoleForm::Direct, PoleForm::HalfAngles] {
        let (count, _) = count(form);
        println!("{form:?} {count:?} {}", count.cost());
    }
}
