//! Which rows of G depend on others for all coordinates, times and parameters.
//!
//! A dependence Σ cⱼ Gⱼ = 0 whose coefficients are the same at all configurations relates the constraints themselves: Σ cⱼ gⱼ is
//! constant. Other dependences come from geometry, and say nothing about the configurations that the constraints allow. A point
//! of a body that turns about another one moves on a sphere, so that the three components of its position have two independent
//! gradients; of n + 1 constraints on n coordinates, one always depends on the others.

use core::cell::RefCell;

use crate::identity::identity_testing::IdentityTest;
use crate::identity::modular_point::ModularPoint;
use crate::identity::row_echelon::RowEchelon;
use crate::limits::MODULAR_ATTEMPTS;
use crate::mechanics::constraints::ConstraintEquations;
use crate::{Expression, Graph};

impl ConstraintEquations {
    /// The constraints from which a dependent one follows, or which it contradicts; `None` if it is surplus.
    ///
    /// A dependence is an error in three cases: among nonholonomic constraints alone, which hold at all configurations; with constant
    /// coefficients, unless the parameters decide whether the constraints agree; and on one other constraint, if the two are
    /// functions of one another.
    pub(super) fn origin(&self, graph: &Graph, rows: &Rows<'_>, row: usize) -> Option<Vec<usize>> {
        let before: Vec<_> = (0..row).collect();
        let nonholonomic: Vec<_> = (self.positions.len()..row).collect();
        let depends = |others: &[usize]| rows.depends(row, others);
        let depends_constantly = |others: &[usize]| rows.depends_constantly(row, others);
        if depends(&nonholonomic) {
            return Some(Rows::fewest(&nonholonomic, depends));
        }
        let by_numbers = |others: &[usize]| rows.depends_by_numbers(row, others);
        if by_numbers(&before) {
            return Some(Rows::fewest(&before, by_numbers));
        }
        if depends_constantly(&before) {
            let others = Rows::fewest(&before, depends_constantly);
            return (!self.is_open(graph, row, &others)).then_some(others);
        }
        // Of one coordinate, either gradient may vanish where both constraints hold.
        let other = before.iter().copied().find(|other| depends(&[*other]))?;
        (!rows.span_one_space(&[other])).then(|| vec![other])
    }

    /// Whether parameters decide if a constraint agrees with others: the gradient of the holonomic constraint is a combination of
    /// their gradients with coefficients that contain only parameters, but the constraint itself is no such combination.
    fn is_open(&self, graph: &Graph, row: usize, others: &[usize]) -> bool {
        let holonomic = self.positions.len();
        row < holonomic
            && self
                .rows_with(graph, &self.velocities)
                .depends_constantly(row, others)
            && !self
                .rows_with(graph, &self.positions)
                .depends_constantly(row, others)
    }

    /// The first rows of G, each with a further value.
    pub(super) fn rows_with<'a>(&self, graph: &'a Graph, values: &[Expression]) -> Rows<'a> {
        let rows = self.jacobian.iter().zip(values);
        let rows = rows.map(|(row, value)| [row, &[*value][..]].concat());
        Rows::new(graph, &rows.collect::<Vec<_>>())
    }
}

/// Rows of expressions, and their values at random points.
pub(super) struct Rows<'a> {
    graph: &'a Graph,
    entries: Vec<Expression>,
    width: usize,
    test: IdentityTest,
    /// What has been evaluated: `None` outside of the domain.
    known: RefCell<Vec<(ModularPoint, Option<Vec<u64>>)>>,
}

impl<'a> Rows<'a> {
    pub(super) fn new(graph: &'a Graph, rows: &[Vec<Expression>]) -> Self {
        let entries = rows.concat();
        Self {
            graph,
            test: IdentityTest::of(graph, &entries),
            width: rows.first().map_or(1, Vec::len).max(1),
            entries,
            known: RefCell::default(),
        }
    }

    /// Whether the rows are independent at some random point, and so at almost all.
    pub(super) fn are_independent(&self) -> bool {
        ModularPoint::attempts().any(|point| {
            let Some(values) = self.at(point) else {
                return false;
            };
            let mut echelon = RowEchelon::new(point.p());
            let mut rows = values.chunks(self.width);
            rows.all(|row| echelon.add(row.to_vec()))
        })
    }

    /// Whether a row depends on others at each point, as far as random points tell.
    pub(super) fn depends(&self, row: usize, others: &[usize]) -> bool {
        self.is_combination(row, others, |point| Some(vec![self.at(point)?]))
    }

    /// Whether a row is a combination of others with coefficients that contain only parameters, as far as random points tell.
    pub(super) fn depends_constantly(&self, row: usize, others: &[usize]) -> bool {
        let count = others.len() + 1;
        self.is_combination(row, others, |point| self.in_motions(point, count))
    }

    /// Whether a row is a combination of others whose coefficients are numbers, as far as random points tell.
    pub(super) fn depends_by_numbers(&self, row: usize, others: &[usize]) -> bool {
        let count = others.len() + 1;
        self.is_combination(row, others, |point| {
            self.in_motions(point.moving_parameters(), count)
        })
    }

    /// Whether a row depends on others in all motions at once that a point stands for.
    fn is_combination(
        &self,
        row: usize,
        others: &[usize],
        motions: impl Fn(ModularPoint) -> Option<Vec<Vec<u64>>>,
    ) -> bool {
        self.test.holds(|point| {
            let motions = motions(point)?;
            let mut echelon = RowEchelon::new(point.p());
            let rows = others.iter().chain([&row]).map(|i| {
                let entries = motions.iter().flat_map(|values| self.row(values, *i));
                echelon.add(entries.copied().collect())
            });
            // The last one is the row itself.
            Some(!rows.last().unwrap_or(true))
        })
    }

    /// Whether independent rows span one space at all configurations, as far as random points tell.
    pub(super) fn span_one_space(&self, rows: &[usize]) -> bool {
        self.test.holds(|point| {
            let motions = self.in_motions(point, self.width + 1)?;
            let mut echelon = RowEchelon::new(point.p());
            for values in &motions {
                for i in rows {
                    echelon.add(self.row(values, *i).to_vec());
                }
            }
            Some(echelon.rank() == rows.len())
        })
    }

    /// A minimal subset of rows that fulfils a condition which all of them together fulfil. Earlier rows are preferred.
    pub(super) fn fewest(rows: &[usize], fulfil: impl Fn(&[usize]) -> bool) -> Vec<usize> {
        let mut fewest = rows.to_vec();
        for left_out in rows.iter().rev() {
            let fewer: Vec<_> = fewest.iter().copied().filter(|i| i != left_out).collect();
            if fulfil(&fewer) {
                fewest = fewer;
            }
        }
        fewest
    }

    fn row<'b>(&self, values: &'b [u64], row: usize) -> &'b [u64] {
        &values[row * self.width..(row + 1) * self.width]
    }

    /// The values in so many motions with the parameters of a point.
    fn in_motions(&self, point: ModularPoint, count: usize) -> Option<Vec<Vec<u64>>> {
        let motions = (1..=MODULAR_ATTEMPTS * count as u64).map(|motion| point.in_motion(motion));
        let values: Vec<_> = motions
            .filter_map(|point| self.at(point))
            .take(count)
            .collect();
        (values.len() == count).then_some(values)
    }

    fn at(&self, point: ModularPoint) -> Option<Vec<u64>> {
        let mut known = self.known.borrow_mut();
        if let Some((_, values)) = known.iter().find(|(other, _)| *other == point) {
            return values.clone();
        }
        let values = point.evaluate(self.graph, &self.entries);
        known.push((point, values.clone()));
        values
    }
}
