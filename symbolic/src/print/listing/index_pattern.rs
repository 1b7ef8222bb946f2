//! One expression for all pairs of members of families, and one for all members: anti-unification (Plotkin, A note on
//! inductive generalization, 1970) of a sample with what the equations are at random points modulo primes.
//!
//! Of a sample such as that of the members 5 and 13, each symbol of the member 5 becomes one of a member i, each of the member
//! 13 one of j; parameters may be those of the greater or of the lesser index, and sums over a family of parameters, as
//! m₁₃ + … + m₁₉, may begin or end at any of these. A number by which samples differ is linear in an index. Which of these
//! it is, is decided by values; that a pattern holds, by an identity test (`families.rs`).

use std::collections::BTreeMap;

use crate::identity::homomorphic_image::{Images, KnownImages};
use crate::identity::modular_point::ModularPoint;
use crate::identity::rational_reconstruction::rational;
use crate::identity::residue;
use crate::limits::MAX_PATTERNS;
use crate::print::listing::index_families::Families;
use crate::{Expression, Graph, Node, Rational, Symbol};

/// An index: where a sum over a family begins or ends, or which member it is.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Bound {
    Fixed(i64),
    /// The first or the second index.
    Index(usize),
    Greater,
    Lesser,
}

impl Bound {
    pub(crate) fn at(self, indices: &[i64]) -> i64 {
        match self {
            Self::Fixed(value) => value,
            Self::Index(k) => indices[k],
            Self::Greater => indices.iter().copied().max().unwrap_or(0),
            Self::Lesser => indices.iter().copied().min().unwrap_or(0),
        }
    }

    /// What the end of a sum may be, the likely ones first.
    fn of_end(number: i64, sample: &[i64]) -> Vec<Self> {
        let position = sample.iter().position(|index| *index == number);
        match (position, sample.len()) {
            (None, _) => vec![Self::Fixed(number)],
            (Some(0), 2) => vec![Self::Lesser, Self::Index(0), Self::Fixed(number)],
            (Some(_), 2) => vec![Self::Greater, Self::Index(1), Self::Fixed(number)],
            (Some(k), _) => vec![Self::Index(k), Self::Fixed(number)],
        }
    }

    /// Of what a number may be a linear function.
    const fn all(indices: usize) -> &'static [Self] {
        match indices {
            1 => &[Self::Index(0)],
            _ => &[Self::Greater, Self::Lesser, Self::Index(0), Self::Index(1)],
        }
    }
}

/// What `Symbol::Argument(k)` stands for in a pattern: a sum over a family of parameters, or one of its members.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Argument {
    family: usize,
    /// The first and the last one; of a member, twice the same.
    pub(crate) bounds: [Bound; 2],
    /// A member, as it is printed in the sample, and its index.
    pub(crate) member: Symbol,
    pub(crate) index: i64,
    pub(crate) is_sum: bool,
}

/// α + β n, where n is an index.
#[derive(Clone, PartialEq, Eq, Debug)]
pub(crate) struct LinearFactor {
    pub(crate) constant: Rational,
    pub(crate) slope: Rational,
    pub(crate) of: Bound,
}

impl LinearFactor {
    const ONE: Self = Self {
        constant: Rational::ONE,
        slope: Rational::ZERO,
        of: Bound::Fixed(0),
    };

    fn at(&self, indices: &[i64]) -> Rational {
        let index = Rational::integer(self.of.at(indices));
        &self.constant + &(&self.slope * &index)
    }
}

/// An expression of one or of two indices.
#[derive(Clone, Debug)]
pub(crate) struct IndexPattern {
    /// The sample with arguments, in a graph of its own, and in the graph of the model.
    graph: Graph,
    root: Expression,
    pub(crate) sample_with_arguments: Expression,
    /// The members of which the expression is.
    pub(crate) sample: Vec<i64>,
    pub(crate) arguments: Vec<Argument>,
    /// By what it is multiplied; 1 for the sample.
    pub(crate) factor: LinearFactor,
}

/// What is known of a pattern at one point: its values for some indices, and the values of some symbols.
pub(crate) struct Known<'a> {
    pub(crate) families: &'a Families,
    pub(crate) point: ModularPoint,
    pub(crate) values: &'a [(Vec<i64>, u64)],
    pub(crate) symbols: fn(Symbol) -> Option<Rational>,
}

impl IndexPattern {
    /// The patterns of which `expression` may be a sample, none where they are too many.
    pub(crate) fn candidates(
        graph: &mut Graph,
        families: &Families,
        expression: Expression,
        sample: &[i64],
    ) -> Vec<Self> {
        if !families.have_single_indices(graph, expression) {
            return Vec::new();
        }
        let choices = choices(graph, families, expression, sample);
        let count = choices.iter().map(|(_, choices)| choices.len());
        if count.fold(1, usize::saturating_mul) > MAX_PATTERNS {
            return Vec::new();
        }
        let mut chosen = vec![Vec::new()];
        for (part, choices) in choices {
            let longer = choices.iter().flat_map(|choice| {
                chosen.iter().map(|before: &Vec<(Expression, Argument)>| {
                    let added = choice.map(|argument| (part, argument));
                    before.iter().copied().chain(added).collect()
                })
            });
            chosen = longer.collect();
        }
        let patterns = chosen.into_iter().map(|chosen| {
            let symbols = (0..).map(Symbol::Argument);
            let replaced: BTreeMap<_, _> = chosen
                .iter()
                .zip(symbols)
                .map(|((part, _), symbol)| (*part, graph.symbol(symbol)))
                .collect();
            let sample_with_arguments = graph.replace(&[expression], &replaced)[0];
            let mut small = Graph::new();
            Self {
                root: small.imported(graph, &[sample_with_arguments])[0],
                graph: small,
                sample_with_arguments,
                sample: sample.to_vec(),
                arguments: chosen.into_iter().map(|(_, argument)| argument).collect(),
                factor: LinearFactor::ONE,
            }
        });
        patterns.collect()
    }

    /// The value modulo p for other members; none where there are none, or outside of the domain.
    pub(crate) fn value(
        &self,
        families: &Families,
        indices: &[i64],
        point: ModularPoint,
        symbols: fn(Symbol) -> Option<Rational>,
    ) -> Option<u64> {
        let moves: Vec<_> = self.moves(indices).collect();
        let parts = self.graph.descendants(&[self.root]);
        let mut images = Images::zeros(self.root.index() + 1);
        let of_symbol = |symbol, images: &Images| match symbols(symbol) {
            Some(number) => point.image(&Node::Constant(number), images),
            None => point.image(&Node::Symbol(symbol), images),
        };
        for part in parts {
            let image = match self.graph.node(part) {
                Node::Symbol(Symbol::Argument(k)) => {
                    let members = self.arguments[*k as usize].members(families, indices);
                    let members = members.map(|member| of_symbol(member, &images));
                    point.total(members.collect::<Option<Vec<_>>>()?)
                }
                Node::Symbol(symbol) => of_symbol(families.moved(*symbol, &moves)?, &images)?,
                node => point.image(node, &images)?,
            };
            images.set(part, image);
        }
        let factor = point.constant(&self.factor.at(indices))?;
        let value = images.get(self.root).value;
        Some(residue::multiply(factor, value, point.p()))
    }

    /// The same pattern with the factor with which it has the known values, if there is one.
    pub(crate) fn fitted(mut self, known: &Known<'_>) -> Option<Self> {
        let p = known.point.p();
        let value = |pattern: &Self, indices: &[i64]| {
            pattern.value(known.families, indices, known.point, known.symbols)
        };
        let has_values = |pattern: &Self| {
            let mut all = known.values.iter();
            all.all(|(indices, expected)| value(pattern, indices) == Some(*expected))
        };
        // The first one that does not have the value of the sample says how the factor grows.
        let mut ratios = known.values.iter().filter_map(|(indices, expected)| {
            let own = value(&self, indices)?;
            let ratio = residue::multiply(*expected, residue::reciprocal(own, p)?, p);
            (ratio != 1).then_some((indices, ratio))
        });
        let Some((indices, ratio)) = ratios.next() else {
            return has_values(&self).then_some(self);
        };
        let growth = &rational(ratio, p)? - &Rational::ONE;
        for of in Bound::all(self.sample.len()) {
            let [start, end] = [&self.sample, indices].map(|indices| of.at(indices));
            let Some(slope) = Rational::integer(end - start).reciprocal() else {
                continue;
            };
            let slope = &growth * &slope;
            self.factor = LinearFactor {
                constant: &Rational::ONE - &(&slope * &Rational::integer(start)),
                slope,
                of: *of,
            };
            if has_values(&self) {
                return Some(self);
            }
        }
        None
    }

    /// The expression for other members.
    pub(crate) fn instantiated(
        &self,
        graph: &mut Graph,
        families: &Families,
        indices: &[i64],
    ) -> Option<Expression> {
        let moves: Vec<_> = self.moves(indices).collect();
        let mut values = BTreeMap::new();
        for symbol in graph.symbols(&[self.sample_with_arguments]) {
            let value = match symbol {
                Symbol::Argument(k) => {
                    let members = self.arguments[k as usize].members(families, indices);
                    let members: Vec<_> = members.collect();
                    let members = members
                        .into_iter()
                        .map(|x| (graph.symbol(x), Rational::ONE));
                    let members: Vec<_> = members.collect();
                    graph.sum(members)
                }
                symbol => graph.symbol(families.moved(symbol, &moves)?),
            };
            values.insert(symbol, value);
        }
        let value = graph.substitute(&[self.sample_with_arguments], &values)[0];
        Some(graph.scale(value, &self.factor.at(indices)))
    }

    fn moves(&self, indices: &[i64]) -> impl Iterator<Item = (i64, i64)> {
        self.sample.iter().copied().zip(indices.iter().copied())
    }
}

impl Argument {
    fn members(&self, families: &Families, indices: &[i64]) -> impl Iterator<Item = Symbol> {
        families.members(self.family, self.bounds.map(|bound| bound.at(indices)))
    }
}

/// The parts of a sample that may stand for different things, each with what these are; none: itself, at the same index.
fn choices(
    graph: &Graph,
    families: &Families,
    expression: Expression,
    sample: &[i64],
) -> Vec<(Expression, Vec<Option<Argument>>)> {
    let mut found = Vec::new();
    for part in graph.descendants(&[expression]) {
        if let Some((family, first, last)) = families.range(graph, part)
            && let Some(member) = families.member(family, first)
        {
            let [begins, ends] = [first, last].map(|end| Bound::of_end(end, sample));
            let bounds = begins
                .iter()
                .flat_map(|x| ends.iter().map(move |y| [*x, *y]));
            let arguments = bounds.map(|bounds| {
                Some(Argument {
                    family,
                    bounds,
                    member,
                    index: first,
                    is_sum: true,
                })
            });
            found.push((part, arguments.collect()));
        } else if let Node::Symbol(member @ Symbol::Parameter(_)) = graph.node(part)
            && let Some((family, index)) = families.place(*member)
            && let ([_, _], Some(position)) = (sample, sample.iter().position(|x| *x == index))
        {
            let argument = Argument {
                family,
                bounds: [[Bound::Lesser, Bound::Greater][position]; 2],
                member: *member,
                index,
                is_sum: false,
            };
            found.push((part, vec![None, Some(argument)]));
        }
    }
    // Parameters that are only summed over do not stand for themselves.
    found.retain(|(part, _)| {
        let is_symbol = matches!(graph.node(*part), Node::Symbol(_));
        !is_symbol || stands_alone(graph, families, expression, *part)
    });
    found
}

/// Whether a parameter stands elsewhere than in sums over its family.
fn stands_alone(
    graph: &Graph,
    families: &Families,
    expression: Expression,
    symbol: Expression,
) -> bool {
    let parts = graph.descendants(&[expression]);
    symbol == expression
        || parts.into_iter().any(|part| {
            let mut is_operand = false;
            graph
                .node(part)
                .for_each_operand(|x| is_operand |= x == symbol);
            is_operand && families.range(graph, part).is_none()
        })
}
