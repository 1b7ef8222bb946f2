//! How long an expression is in print.

use std::collections::BTreeMap;

use crate::print::names::Letters;
use crate::{Expression, Graph, Node};

impl Graph {
    /// The number of symbols, numbers and functions of an expression that is written out.
    pub(crate) fn written_symbols(&self, roots: &[Expression], letters: &Letters) -> u64 {
        let mut sizes: BTreeMap<Expression, u64> = BTreeMap::new();
        for part in self.descendants(roots) {
            let named = !roots.contains(&part) && letters.definition(part).is_some();
            let mut size = match self.node(part) {
                Node::Sum(_) | Node::Product(_) | Node::Opaque(_) if !named => 0,
                _ => 1,
            };
            if !named {
                self.node(part).for_each_operand(|operand| {
                    size = u64::saturating_add(size, sizes[&operand]);
                });
            }
            sizes.insert(part, size);
        }
        let sizes = roots.iter().map(|root| sizes[root]);
        sizes.fold(0, u64::saturating_add)
    }
}
