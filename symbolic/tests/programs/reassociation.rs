//! Terms of the sums of long programs are added in the order in which they are known.

use lagrangian_symbolic::{
    Expression, Graph, Operand, Pass, Passes, Program, Rational, Symbol, Unary,
};

/// Enough other operations that a program is long.
const OTHERS: usize = 700;

/// A chain of so many operations behind x.
fn chain(graph: &mut Graph, x: Expression, length: usize) -> Expression {
    (0..length).fold(x, |x, _| {
        let square = graph.square(x);
        let sum = graph.add(square, x);
        graph.opaque(sum)
    })
}

fn parameter(graph: &mut Graph, i: usize) -> Expression {
    graph.symbol(Symbol::Parameter(u32::try_from(i).unwrap()))
}

/// Expressions that make a program long.
fn filling(graph: &mut Graph) -> Vec<Expression> {
    let x = parameter(graph, 99);
    let sines = (0..OTHERS).map(|i| {
        let factor = parameter(graph, 100 + i);
        let scaled = graph.multiply(x, factor);
        graph.unary(Unary::Sin, scaled)
    });
    sines.collect()
}

/// A program of these roots and those that make it long, before and after its sums are reassociated.
fn programs(graph: &mut Graph, roots: &[Expression]) -> [Program; 2] {
    let filling = filling(graph);
    let roots = [roots, &filling].concat();
    let program = Program::schedule(graph, &[&roots]);
    let reassociated = program.clone().reassociated(Passes::default());
    for program in [&program, &reassociated] {
        assert_eq!(program.verify(graph, &[&roots]), Ok(()));
    }
    assert_eq!(program.count(), reassociated.count());
    [program, reassociated]
}

/// The number of operations in the longest chain that ends with an output.
fn height(program: &Program, output: usize) -> usize {
    let mut heights = vec![0; program.instructions().count() + 1];
    let of =
        |operand: &Operand, heights: &[usize]| operand.value().map_or(0, |value| heights[value]);
    for instruction in program.instructions() {
        let operands = instruction.operation.operands();
        let longest = operands.map(|operand| of(operand, &heights)).max();
        heights[instruction.value] = 1 + longest.unwrap_or(0);
    }
    of(&program.groups[0].outputs[output], &heights)
}

#[test]
fn the_last_term_that_is_known_waits_for_no_other() {
    let mut graph = Graph::new();
    // Terms are in the order in which the graph has them; the third is the last to be known.
    let terms: Vec<_> = (0..9)
        .map(|i| {
            let x = parameter(&mut graph, i);
            chain(&mut graph, x, if i == 2 { 20 } else { 1 })
        })
        .collect();
    for sign in [Rational::ONE, Rational::MINUS_ONE] {
        let signed = terms.iter().enumerate().map(|(i, term)| match i {
            2 => (*term, sign.clone()),
            _ => (*term, Rational::ONE),
        });
        let sum = graph.sum(signed);
        let [before, after] = programs(&mut graph, &[terms[2], sum]);
        assert_eq!(height(&after, 1), height(&after, 0) + 1);
        if sign == Rational::ONE {
            assert_eq!(height(&before, 1), height(&before, 0) + 7);
        }
    }
}

#[test]
fn terms_that_are_known_at_once_are_added_in_two_sums() {
    let mut graph = Graph::new();
    let terms: Vec<_> = (0..8)
        .map(|i| {
            let x = parameter(&mut graph, i);
            chain(&mut graph, x, 12)
        })
        .collect();
    let sum = graph.sum(terms.iter().map(|term| (*term, Rational::ONE)));
    let [before, after] = programs(&mut graph, &[terms[0], sum]);
    assert_eq!(height(&before, 1), height(&before, 0) + 7);
    assert_eq!(height(&after, 1), height(&after, 0) + 4);
}

/// Sums of products whose factors are chains of random lengths, with random signs.
#[test]
fn random_sums_have_the_same_values() {
    let mut state = 1_u64;
    let mut random = |below: u64| {
        state = state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1);
        usize::try_from((state >> 33) % below).unwrap()
    };
    for _ in 0..20 {
        let mut graph = Graph::new();
        let mut roots = Vec::new();
        for _ in 0..12 {
            let count = 3 + random(9);
            let mut terms = Vec::new();
            for _ in 0..count {
                let [x, y] = [random(6), random(6)].map(|i| parameter(&mut graph, i));
                let length = random(4);
                let factor = chain(&mut graph, x, length);
                let term = if random(2) == 0 {
                    factor
                } else {
                    graph.multiply(factor, y)
                };
                let sign = [Rational::ONE, Rational::MINUS_ONE][random(2)].clone();
                terms.push((term, sign));
            }
            roots.push(graph.sum(terms));
        }
        programs(&mut graph, &roots);
    }
}

#[test]
fn what_a_later_group_uses_stays() {
    let mut graph = Graph::new();
    // Passes over sums would give the shared part a name.
    let passes = [Pass::SharedSums, Pass::Collecting];
    graph.passes = passes.into_iter().fold(graph.passes, Passes::without);
    let terms: Vec<_> = (0..8)
        .map(|i| {
            let x = parameter(&mut graph, i);
            chain(&mut graph, x, 12)
        })
        .collect();
    let mut signed = terms.iter().map(|term| (*term, Rational::ONE));
    let sum = graph.sum(signed.clone());
    let first = graph.sum(signed.by_ref().take(3));
    let filling = filling(&mut graph);
    let groups: [&[Expression]; 2] = [&[&[sum], &*filling].concat(), &[first]];
    let program = Program::schedule(&graph, &groups);
    assert_eq!(program.groups[1].instructions.len(), 0);
    let reassociated = program.reassociated(Passes::default());
    assert_eq!(reassociated.verify(&graph, &groups), Ok(()));
}
