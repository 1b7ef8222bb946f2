//! The constructors: laws that hold as equality of handles, and values that they keep.

mod support;

use lagrangian_symbolic::{Binary, Expression, Graph, Node, Rational, Symbol, Unary};
use proptest::prelude::*;
use support::bounded::Bounded;
use support::evaluate;
use support::tree::{at, points, trees};

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2_000) })]

    #[test]
    fn normal_forms_keep_values(tree in trees(), point in points()) {
        let value = |symbol| Bounded::exact(at(&point, symbol));
        let written = tree.evaluate(&value);
        let mut graph = Graph::new();
        let root = tree.build(&mut graph);
        let normal = evaluate(&graph, root, value);
        if written.is_reliable() {
            prop_assert!(!normal.value.is_nan(), "{written:?} was lost: {:?}", graph.node(root));
            // Out of reach only if the bounds say so.
            prop_assert!(
                written.agrees(normal),
                "{written:?} became {normal:?}: {:?}", graph.node(root)
            );
        }
    }

    #[test]
    fn arithmetic_obeys_its_laws(trees in [trees(), trees(), trees()]) {
        let mut graph = Graph::new();
        let [x, y, z] = trees.map(|tree| tree.build(&mut graph));
        let (xy, yx) = (graph.add(x, y), graph.add(y, x));
        prop_assert_eq!(xy, yx);
        let (xy, yx) = (graph.multiply(x, y), graph.multiply(y, x));
        prop_assert_eq!(xy, yx);
        let difference = graph.subtract(x, x);
        prop_assert_eq!(difference, graph.zero());
        let yz = graph.multiply(y, z);
        prop_assert_eq!(graph.multiply(xy, z), graph.multiply(x, yz));
    }
}
