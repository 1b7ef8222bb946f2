//! A pass changes what results cost and not what they are: with each of them switched off, and with all,
//! the accelerations solve the equations of motion and the programs compute them.

use lagrangian_symbolic::{
    Dynamics, Energies, Equations, Expression, Graph, Model, Pass, Passes, Program, Rational,
    Symbol, Unary,
};

/// Every pass off by itself, and all together.
fn choices() -> Vec<Passes> {
    let all = Passes::default();
    let each = Pass::ALL.iter().map(|pass| all.without(*pass));
    let none = Pass::ALL.iter().fold(all, |some, pass| some.without(*pass));
    each.chain([all, none]).collect()
}

fn model(
    coordinates: u32,
    passes: Passes,
    energies: impl FnOnce(&mut Graph) -> [Expression; 2],
) -> Model {
    let mut graph = Graph::new();
    graph.passes = passes;
    let [kinetic, potential] = energies(&mut graph);
    let zero = graph.zero();
    Model {
        graph,
        coordinates,
        inputs: 0,
        energies: Energies::Natural { kinetic, potential },
        dissipation: zero,
        forces: vec![zero; coordinates as usize],
        outputs: Vec::new(),
    }
}

fn half_squares(graph: &mut Graph, terms: &[(Expression, Expression)]) -> Expression {
    let mut sum = Vec::new();
    for (inertia, velocity) in terms {
        let square = graph.square(*velocity);
        sum.push((graph.multiply(*inertia, square), Rational::HALF));
    }
    graph.sum(sum)
}

/// A heavy body pinned at a point, in z-x-z Euler angles (4.5).
fn top(graph: &mut Graph) -> [Expression; 2] {
    let [sine, cosine] = [Unary::Sin, Unary::Cos].map(|function| {
        [1, 2].map(|i| {
            let angle = graph.symbol(Symbol::Coordinate(i));
            graph.unary(function, angle)
        })
    });
    let [phi, theta, psi] = [0, 1, 2].map(|i| graph.symbol(Symbol::Velocity(i)));
    let across = graph.multiply(phi, sine[0]);
    let [a, b] = [(across, sine[1]), (theta, cosine[1])].map(|(x, y)| graph.multiply(x, y));
    let first = graph.add(a, b);
    let [a, b] = [(across, cosine[1]), (theta, sine[1])].map(|(x, y)| graph.multiply(x, y));
    let second = graph.subtract(a, b);
    let along = graph.multiply(phi, cosine[0]);
    let third = graph.add(along, psi);
    let [i1, i2, i3, weight] = [0, 1, 2, 3].map(|i| graph.symbol(Symbol::Parameter(i)));
    let kinetic = half_squares(graph, &[(i1, first), (i2, second), (i3, third)]);
    [kinetic, graph.multiply(weight, cosine[0])]
}

/// A chain of equal point masses on massless rods.
fn chain(graph: &mut Graph, links: u32) -> [Expression; 2] {
    let [mass, length, gravity] = [0, 1, 2].map(|i| graph.symbol(Symbol::Parameter(i)));
    let mut position = [graph.zero(); 2];
    let (mut speeds, mut heights) = (Vec::new(), Vec::new());
    for i in 0..links {
        let angle = graph.symbol(Symbol::Coordinate(i));
        let rod = [Unary::Sin, Unary::Cos].map(|function| {
            let direction = graph.unary(function, angle);
            graph.multiply(length, direction)
        });
        position = [
            graph.add(position[0], rod[0]),
            graph.subtract(position[1], rod[1]),
        ];
        let velocity = graph.time_derivatives(&position, links);
        speeds.extend(velocity.into_iter().map(|component| (mass, component)));
        heights.push((position[1], Rational::ONE));
    }
    let height = graph.sum(heights);
    let weight = graph.multiply(mass, gravity);
    [half_squares(graph, &speeds), graph.multiply(weight, height)]
}

#[track_caller]
fn check(mut model: Model) {
    let passes = model.graph.passes;
    let equations = Equations::derive(&mut model).unwrap();
    let dynamics = Dynamics::cheapest(&mut model, &equations);
    let mut roots = dynamics.forcing.clone();
    if let Some(solution) = dynamics.solution {
        assert!(solution.holds(&model.graph, &equations), "{passes:?}");
        roots.extend(solution.accelerations);
    }
    let program = Program::schedule_for_preparation(&model.graph, &[&roots]);
    assert_eq!(
        program.verify(&model.graph, &[&roots]),
        Ok(()),
        "{passes:?}"
    );
    let parts = program.prepared(passes);
    let prepared = parts.before.instructions().count();
    assert_eq!(
        prepared + parts.after.instructions().count(),
        program.instructions().count()
    );
    assert!(passes.has(Pass::Preparation) || prepared == 0);
}

#[test]
fn a_top_moves_the_same_without_any_pass() {
    for passes in choices() {
        check(model(3, passes, top));
    }
}

#[test]
fn a_chain_moves_the_same_without_any_pass() {
    for links in [2, 5] {
        for passes in choices() {
            check(model(links, passes, |graph| chain(graph, links)));
        }
    }
}
