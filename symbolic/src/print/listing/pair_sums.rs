//! Lagrange's equations of members of a family that act on each other in pairs, such as bodies that attract each other, as one
//! equation of any member with sums over all others.
//!
//! The equation of the first or of the last member is the sample. An equation of the member i with the same sums over all
//! others is the sample with the members exchanged; that each equation is, an identity test says
//! (`identity/identity_testing.rs`), and where it does not, nothing is folded.

use std::collections::{BTreeMap, BTreeSet};

use crate::identity::identity_testing::IdentityTest;
use crate::limits::{MAX_UNARRANGED_LENGTH, MIN_FOLDED_LINES, MIN_FOLDED_SECTION};
use crate::print::index::{Index, Range};
use crate::print::listing::composer::{Composer, arranged_lagrange};
use crate::print::listing::index_families::Families;
use crate::print::listing::section::Section;
use crate::print::names::Letters;
use crate::print::printed::{Part, Printed};
use crate::{Equations, Expression, Graph, Node, Symbol};

/// The coordinates of a family, from the first index on.
struct Members {
    first: i64,
    positions: Vec<usize>,
}

impl Composer<'_> {
    /// The section of Lagrange's equations, or the one in which families have one equation with sums over pairs where that is
    /// half as long.
    pub(crate) fn shorter_by_pairs(
        &mut self,
        equations: &Equations,
        section: Section,
        empty: Section,
    ) -> Section {
        let length = section.written_length(&self.letters);
        if length < MIN_FOLDED_SECTION {
            return section;
        }
        match self.by_pairs(equations, empty) {
            Some(folded) if 2 * folded.written_length(&self.letters) <= length => folded,
            _ => section,
        }
    }

    /// The section with one equation for each family that has sums over pairs, if there are such families.
    fn by_pairs(&mut self, equations: &Equations, mut section: Section) -> Option<Section> {
        let families = Families::of(&self.declared.names);
        let mut folded = BTreeMap::new();
        let mut said = BTreeSet::new();
        for (first, positions) in families.of_coordinates() {
            let members = Members { first, positions };
            if members.positions.len() >= MIN_FOLDED_LINES
                && let Some(sides) = self.equation_of_any(equations, &families, &members)
            {
                folded.insert(members.positions[0], (sides, members.positions.len()));
                said.extend(members.positions);
            }
        }
        if folded.is_empty() {
            return None;
        }
        for i in 0..self.model.coordinates as usize {
            if let Some(([left, right], count)) = folded.remove(&i) {
                self.push_arranged(&mut section, left, right);
                section.stands_for_more(count - 1);
            } else if !said.contains(&i) {
                self.push_lagrange(&mut section, equations, i);
            }
        }
        Some(section)
    }

    /// The sides of the equation of any member, from the first or from the last one.
    fn equation_of_any(
        &mut self,
        equations: &Equations,
        families: &Families,
        members: &Members,
    ) -> Option<[Printed; 2]> {
        let letters = self.letters.of_symbols();
        let graph = &mut self.model.graph;
        [members.first, members.last()].into_iter().find_map(|own| {
            let position = members.position(own)?;
            let whole = [
                equations.inverse_dynamics[position],
                equations.generalized_forces[position],
            ];
            if graph.written_symbols(&whole, &letters) > MAX_UNARRANGED_LENGTH
                || !has_plain_indices(graph, families, &whole, &letters)
            {
                return None;
            }
            let sample = arranged_lagrange(graph, equations, position, &letters);
            let indices = letters.index_letters();
            let range = [members.first, members.last()];
            let [left, right] = sample.map(|x| {
                let formula = graph.written_out(x, &letters)?;
                formula.of_any_member(own, range, indices)
            });
            let (mut left, right) = (left?, right?);
            let mut has_pairs = false;
            left.visit(&mut |part| has_pairs |= matches!(part.0, Part::SumBelow(..)));
            if !has_pairs || !members.are_alike(graph, equations, families, (own, sample)) {
                return None;
            }
            let [first, last] = range.map(Index::Number);
            let range = Range {
                variable: indices.text('i'),
                first,
                last,
            };
            let right = right.for_all(vec![range]);
            Some([left, right])
        })
    }
}

impl Members {
    fn last(&self) -> i64 {
        self.first + i64::try_from(self.positions.len()).unwrap_or(1) - 1
    }

    fn position(&self, index: i64) -> Option<usize> {
        let place = usize::try_from(index - self.first).ok()?;
        self.positions.get(place).copied()
    }

    /// Whether the equation of each member is identically the sample with the members exchanged.
    fn are_alike(
        &self,
        graph: &mut Graph,
        equations: &Equations,
        families: &Families,
        (own, sample): (i64, [Expression; 2]),
    ) -> bool {
        let symbols = graph.symbols(&sample);
        (self.first..).zip(&self.positions).all(|(index, i)| {
            let force = equations.generalized_forces[*i];
            let left = graph.add(equations.inverse_dynamics[*i], force);
            let mut exchanged = BTreeMap::new();
            for symbol in &symbols {
                let Some(moved) = families.moved(*symbol, &[(own, index), (index, own)]) else {
                    return false;
                };
                exchanged.insert(*symbol, graph.symbol(moved));
            }
            let found = graph.substitute(&sample, &exchanged);
            let all = [left, force, found[0], found[1]];
            let graph: &Graph = graph;
            IdentityTest::of(graph, &all).holds(|point| {
                let values = point.evaluate(graph, &all)?;
                Some(values[..2] == values[2..])
            })
        })
    }
}

/// Whether each index that is printed is the one by which a symbol is a member of a family.
fn has_plain_indices(
    graph: &Graph,
    families: &Families,
    sides: &[Expression],
    letters: &Letters,
) -> bool {
    let mut symbols = graph.symbols(sides).into_iter();
    let are_plain = symbols.all(|symbol: Symbol| {
        let own = families.place(symbol).map(|(_, index)| index);
        let name = letters.symbol(symbol);
        let numbers = name.indices.iter().filter_map(|index| match index {
            Index::Number(number) => Some(*number),
            _ => None,
        });
        numbers.eq(own)
    });
    let parts = graph.descendants(sides);
    are_plain
        && parts
            .into_iter()
            .all(|part| !matches!(graph.node(part), Node::Application(..)))
}
