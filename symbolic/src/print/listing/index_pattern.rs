//! One expression for all pairs of members of families, and one for all members: anti-unification (Plotkin, A note on
//! inductive generalization, 1970) of a sample with what the equations are at random real points.
//!
//! Of a sample such as that of the members 5 and 13, each symbol of the member 5 becomes one of a member i, each of the member
//! 13 one of j, and sums over a family of parameters, as m₁₃ + … + m₁₉, begin or end at i, at j or at the greater of both. A
//! pattern is taken if the sums over it have the values of all equations.

use std::collections::BTreeMap;

use crate::identity::real_point::RealPoint;
use crate::limits::MOST_PATTERNS;
use crate::print::names::Names;
use crate::{Expression, Graph, Node, Symbol};

/// The members of families among coordinates and parameters.
pub(crate) struct Families {
    /// Of each family the member at an index.
    members: Vec<BTreeMap<i64, Symbol>>,
    /// The family and the index of a member.
    places: BTreeMap<Symbol, (usize, i64)>,
}

impl Families {
    pub(crate) fn of(names: &Names) -> Self {
        let mut families = Self {
            members: Vec::new(),
            places: BTreeMap::new(),
        };
        let mut numbers = BTreeMap::new();
        for (kind, names) in [&names.coordinates, &names.parameters]
            .into_iter()
            .enumerate()
        {
            let symbol = [Symbol::Coordinate, Symbol::Parameter][kind];
            for (i, name) in (0..).zip(names) {
                let Some((stem, index, rest)) = taken_apart(name) else {
                    continue;
                };
                let count = numbers.len();
                let family = *numbers.entry((kind, stem, rest)).or_insert(count);
                families.members.resize(numbers.len(), BTreeMap::new());
                families.members[family].insert(index, symbol(i));
                families.places.insert(symbol(i), (family, index));
            }
        }
        families
    }

    /// The indices of the coordinates if all are members of one family and counted without gaps.
    pub(crate) fn of_all_coordinates(&self, coordinates: u32) -> Option<(i64, i64)> {
        let (family, first) = *self.places.get(&Symbol::Coordinate(0))?;
        let last = first + i64::from(coordinates) - 1;
        let in_order = (first..=last).zip(0..coordinates);
        let mut in_order = in_order
            .map(|(index, i)| self.members[family].get(&index) == Some(&Symbol::Coordinate(i)));
        in_order.all(|one| one).then_some((first, last))
    }

    /// The symbol of another member, or the same one if it is of none that moves.
    fn moved(&self, symbol: Symbol, moves: &[(i64, i64)]) -> Option<Symbol> {
        let (base, back): (Symbol, fn(u32) -> Symbol) = match symbol {
            Symbol::Velocity(i) => (Symbol::Coordinate(i), Symbol::Velocity),
            Symbol::Acceleration(i) => (Symbol::Coordinate(i), Symbol::Acceleration),
            Symbol::Parameter(_) => (symbol, Symbol::Parameter),
            _ => (symbol, Symbol::Coordinate),
        };
        let Some((family, index)) = self.places.get(&base) else {
            return Some(symbol);
        };
        let Some((_, to)) = moves.iter().find(|(from, _)| from == index) else {
            return Some(symbol);
        };
        match self.members[*family].get(to)? {
            Symbol::Coordinate(i) | Symbol::Parameter(i) => Some(back(*i)),
            _ => None,
        }
    }

    /// The family, first and last index of a sum of consecutive parameters.
    fn range(&self, graph: &Graph, x: Expression) -> Option<(usize, i64, i64)> {
        let Node::Sum(terms) = graph.node(x) else {
            return None;
        };
        let mut indices = Vec::new();
        let mut family = None;
        for (term, coefficient) in terms {
            let Node::Symbol(symbol @ Symbol::Parameter(_)) = graph.node(*term) else {
                return None;
            };
            let (of, index) = *self.places.get(symbol)?;
            if !coefficient.is_one() || *family.get_or_insert(of) != of {
                return None;
            }
            indices.push(index);
        }
        indices.sort_unstable();
        let consecutive = indices.windows(2).all(|pair| pair[1] == pair[0] + 1);
        let (first, last) = (*indices.first()?, *indices.last()?);
        (consecutive && first < last).then_some((family?, first, last))
    }
}

/// `m[3]` as m, 3 and what follows.
fn taken_apart(name: &str) -> Option<(&str, i64, &str)> {
    let (stem, rest) = name.split_once('[')?;
    let (index, rest) = rest.split_once(']')?;
    Some((stem, index.parse().ok()?, rest))
}

/// Where a sum over a family begins or ends.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Bound {
    Fixed(i64),
    /// The first or the second index.
    Index(usize),
    Greater,
    Lesser,
}

impl Bound {
    fn at(self, indices: &[i64]) -> i64 {
        match self {
            Self::Fixed(value) => value,
            Self::Index(k) => indices[k],
            Self::Greater => indices.iter().copied().max().unwrap_or(0),
            Self::Lesser => indices.iter().copied().min().unwrap_or(0),
        }
    }

    /// What a number in a sample may be.
    fn candidates(number: i64, sample: &[i64]) -> Vec<Self> {
        let position = sample.iter().position(|index| *index == number);
        match (position, sample.len()) {
            (None, _) => vec![Self::Fixed(number)],
            (Some(0), 2) => vec![Self::Lesser, Self::Index(0)],
            (Some(_), 2) => vec![Self::Greater, Self::Index(1)],
            (Some(k), _) => vec![Self::Index(k)],
        }
    }
}

/// A sum over a family of parameters.
#[derive(Clone, Debug)]
pub(crate) struct RangeSum {
    family: usize,
    pub(crate) bounds: [Bound; 2],
    /// A member, as it is printed in the sample.
    pub(crate) member: Symbol,
    pub(crate) index: i64,
}

/// An expression of one or of two indices.
#[derive(Clone, Debug)]
pub(crate) struct IndexPattern {
    graph: Graph,
    root: Expression,
    /// The members of which the expression is.
    pub(crate) sample: Vec<i64>,
    /// What `Symbol::Argument(k)` stands for.
    pub(crate) sums: Vec<RangeSum>,
}

impl IndexPattern {
    /// The patterns of which `expression` may be a sample, none where they are too many, and the expression with arguments in place of sums.
    pub(crate) fn candidates(
        graph: &mut Graph,
        families: &Families,
        expression: Expression,
        sample: &[i64],
    ) -> (Expression, Vec<Self>) {
        let mut arguments = BTreeMap::new();
        let mut found = Vec::new();
        for part in graph.descendants(&[expression]) {
            if let Some(range) = families.range(graph, part) {
                let argument = u32::try_from(found.len()).unwrap_or(u32::MAX);
                arguments.insert(part, graph.symbol(Symbol::Argument(argument)));
                found.push(range);
            }
        }
        let replaced = graph.replace(&[expression], &arguments)[0];
        let mut small = Graph::new();
        let root = small.imported(graph, &[replaced])[0];
        let mut patterns = vec![Self {
            graph: small,
            root,
            sample: sample.to_vec(),
            sums: Vec::new(),
        }];
        for (family, first, last) in found {
            let [first, last] = [first, last].map(|end| (end, Bound::candidates(end, sample)));
            let mut longer = Vec::new();
            for pattern in &patterns {
                for (begin, end) in first
                    .1
                    .iter()
                    .flat_map(|x| last.1.iter().map(move |y| (x, y)))
                {
                    let mut pattern = pattern.clone();
                    pattern.sums.push(RangeSum {
                        family,
                        bounds: [*begin, *end],
                        member: families.members[family][&first.0],
                        index: first.0,
                    });
                    longer.push(pattern);
                }
            }
            patterns = longer;
            if patterns.len() > MOST_PATTERNS {
                return (replaced, Vec::new());
            }
        }
        (replaced, patterns)
    }

    /// The value for other members; NaN where there are none.
    pub(crate) fn value(&self, families: &Families, indices: &[i64], point: RealPoint) -> f64 {
        let moves: Vec<_> = self
            .sample
            .iter()
            .copied()
            .zip(indices.iter().copied())
            .collect();
        let value = |symbol| match symbol {
            Symbol::Argument(k) => {
                let sum = &self.sums[k as usize];
                let [first, last] = sum.bounds.map(|bound| bound.at(indices));
                let members = families.members[sum.family].iter();
                let members = members.filter(|(index, _)| (first..=last).contains(index));
                members.map(|(_, member)| point.value(*member)).sum()
            }
            symbol => families
                .moved(symbol, &moves)
                .map_or(f64::NAN, |symbol| point.value(symbol)),
        };
        self.graph.evaluate(&[self.root], value)[0]
    }
}
