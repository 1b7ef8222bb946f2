//! Long programs run in an order in which fewer values wait in memory, and compute the same.

use std::collections::{BTreeMap, BTreeSet};

use lagrangian_symbolic::{Expression, Graph, Operand};

use super::*;

#[test]
fn an_order_for_registers_loads_less_and_computes_the_same() {
    for links in [6, 10] {
        let mut derived = derive(arm(links));
        let kinetics = Kinetics::cheapest(&mut derived.model, &derived.equations);
        let solution = kinetics.solution.unwrap();
        let graph = &derived.model.graph;
        let [before, without, after] =
            loads_of_orders(graph, &solution.accelerations, &solution.recursion);
        assert!(10 * without < 9 * before, "{links}: {without}, {before}");
        // Six joints have no recursion: M is factored.
        if !solution.recursion.is_empty() {
            assert!(10 * after < 9 * without, "{links}: {after}, {without}");
        }
        assert_eq!(solution.recursion.is_empty(), links == 6);
        if links == 10 {
            let [before, without, after] =
                loads_of_orders(graph, &kinetics.inverse_dynamics, &kinetics.recursion);
            assert!(10 * after < 4 * before, "{after}, {before}");
            assert!(10 * after < 9 * without, "{after}, {without}");
        }
    }
}

/// The loads of a program as scheduled, in the order without a recursion, and in that of the recursion, which has the values
/// and the operations of the first.
fn loads_of_orders(graph: &Graph, roots: &[Expression], recursion: &[Expression]) -> [usize; 3] {
    let scheduled = Program::schedule(graph, &[roots]);
    let reassociated = scheduled.clone().reassociated(graph.passes);
    assert_eq!(reassociated.verify(graph, &[roots]), Ok(()));
    let ordered = reassociated.ordered(graph, recursion);
    assert_eq!(ordered.verify(graph, &[roots]), Ok(()));
    assert_eq!(ordered.count(), scheduled.count());
    let value = |symbol| match symbol {
        Symbol::Coordinate(i) => f64::from(i).sin(),
        Symbol::Velocity(i) => f64::from(i).cos(),
        Symbol::Acceleration(i) => f64::from(i + 1).sin(),
        Symbol::Parameter(i) => 1.0 + f64::from(i) / 64.0,
        _ => f64::NAN,
    };
    let pairs = scheduled.evaluate(value).concat().into_iter();
    for (x, y) in pairs.zip(ordered.evaluate(value).concat()) {
        assert!((x - y).abs() < 1e-13 * x.abs().max(1.0), "{x}, {y}");
    }
    let without_recursion = scheduled.clone().ordered(graph, &[]);
    [&scheduled, &without_recursion, &ordered].map(loads)
}

/// How many values are loaded again with thirty registers, of which the one is free that is needed last (Belady, A study of
/// replacement algorithms for a virtual-storage computer, 1966).
fn loads(program: &Program) -> usize {
    let values = |operand: &Operand| match operand {
        Operand::Value(value) => Some(*value),
        _ => None,
    };
    let instructions: Vec<_> = program.instructions().collect();
    let mut uses: BTreeMap<usize, BTreeSet<usize>> = BTreeMap::new();
    for (time, instruction) in instructions.iter().enumerate() {
        for value in instruction.operation.operands().filter_map(values) {
            uses.entry(value).or_default().insert(time);
        }
    }
    let next = |value: usize, time: usize| {
        let uses = uses.get(&value)?;
        uses.range(time + 1..).next().copied()
    };
    let (mut registers, mut loads) = (BTreeSet::new(), 0);
    for (time, instruction) in instructions.iter().enumerate() {
        let operands: BTreeSet<usize> = instruction
            .operation
            .operands()
            .filter_map(values)
            .collect();
        loads += operands.difference(&registers).count();
        registers.extend(&operands);
        registers.extend((0..instruction.operation.results()).map(|i| instruction.value + i));
        registers.retain(|value| next(*value, time).is_some());
        while registers.len() > 30 {
            let last = registers
                .iter()
                .copied()
                .max_by_key(|value| next(*value, time));
            registers.remove(&last.unwrap_or(0));
        }
    }
    loads
}
