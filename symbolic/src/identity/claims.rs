//! Claims about expressions that hold identically, or at random real points.

use std::collections::BTreeSet;

use crate::identity::homomorphic_image::{FewImages, KnownImages};
use crate::identity::identity_testing::IdentityTest;
use crate::identity::incremental_evaluation::IncrementalEvaluation;
use crate::identity::real_point::RealPoint;
use crate::identity::tested_value::TestedValue;
use crate::limits::{REAL_POINTS, ROUNDED_CONSTANT};
use crate::{Expression, Graph, Symbol};

impl Graph {
    /// Whether all expressions vanish identically.
    pub(crate) fn vanishes(&self, expressions: &[Expression]) -> bool {
        let descendants = self.descendants(expressions);
        IdentityTest::of_parts(self, descendants.iter().copied()).holds(|point| {
            let evaluation =
                IncrementalEvaluation::of_descendants(self, expressions, &descendants, point)?;
            Some(evaluation.values().iter().all(|value| *value == 0))
        })
    }

    /// Whether an expression vanishes for arbitrary values of `atoms`, which are not taken apart. Then it vanishes
    /// identically.
    pub(crate) fn vanishes_over(&self, root: Expression, atoms: &BTreeSet<Expression>) -> bool {
        let mut parts = BTreeSet::new();
        let mut open = vec![root];
        while let Some(part) = open.pop() {
            if parts.insert(part) && !atoms.contains(&part) {
                self.node(part).for_each_operand(|x| open.push(x));
            }
        }
        let whole = parts.iter().filter(|part| !atoms.contains(part));
        IdentityTest::of_parts(self, whole.copied()).holds(|point| {
            let mut images = FewImages::default();
            for part in &parts {
                let image = if atoms.contains(part) {
                    point.indeterminate(*part)
                } else {
                    point.image(self.node(*part), &images)?
                };
                images.set(*part, image);
            }
            Some(images.get(root).value == 0)
        })
    }

    /// Whether one of `roots` depends on `symbol`, which may occur in it without effect.
    pub(crate) fn depends_on(&self, roots: &[Expression], symbol: Symbol) -> bool {
        roots.iter().any(|root| {
            let roots = [*root];
            let test = IdentityTest::of(self, &roots);
            !test.independent(self, &roots, &[symbol], TestedValue::First)[0]
        })
    }

    /// Whether expressions vanish at random real points, up to rounding.
    pub(crate) fn vanishes_at_real_points(&self, expressions: &[Expression]) -> bool {
        let points = (0..REAL_POINTS).map(RealPoint::new);
        let values = points.map(|point| self.evaluate(expressions, |symbol| point.value(symbol)));
        let mut known = values.filter(|values| values.iter().all(|value| value.is_finite()));
        known.next().is_some_and(|first| {
            core::iter::once(first)
                .chain(known)
                .flatten()
                .all(|x| x.abs() < ROUNDED_CONSTANT)
        })
    }
}
