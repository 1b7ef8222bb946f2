//! Momenta and Lagrange's equations of a family of coordinates, as one equation with a sum over the family.
//!
//! For L of second degree in the velocities, equation i is Σⱼ (Mᵢⱼ q̈ⱼ + cᵢⱼ q̇ⱼ²) + gᵢ = Qᵢ, unless there are products of
//! different velocities. One pair of coordinates and one coordinate are the samples, and a pattern is taken only if it
//! has the values of all equations (`index_pattern.rs`).

use crate::identity::real_point::RealPoint;
use crate::limits::FEWEST_FOLDED_LINES;
use crate::print::folding::token::{MARKS, lowered};
use crate::print::listing::as_declared::print_sum_sign;
use crate::print::listing::composer::Composer;
use crate::print::listing::index_pattern::{Bound, Families, IndexPattern};
use crate::print::listing::section::Side;
use crate::print::names::Letters;
use crate::{Equations, Expression, Graph, Node, Rational, Symbol};

/// The names of the indices.
const INDICES: [&str; 2] = ["i", "j"];
/// What a sum is called until it is printed.
const FIRST_SIGN: u32 = 0xE010;
/// The points at which patterns are compared with the equations, whose numbers are near one.
const POINTS: [u64; 2] = [0, 4];
/// The largest relative difference, from rounding.
const TOLERANCE: f64 = 1e-9;

/// A family of coordinates, the first and the last index, and a pair of members that is not special.
struct Sampling {
    families: Families,
    first: i64,
    last: i64,
    pair: [i64; 2],
}

/// A pattern with its text in Unicode and in LaTeX.
struct Printed {
    pattern: IndexPattern,
    texts: [String; 2],
    is_sum: bool,
}

impl Composer<'_> {
    /// All momenta as one equation.
    pub(crate) fn momentum_of_family(&mut self, equations: &Equations) -> Option<(Side, Side)> {
        let sampling = self.sampling()?;
        let [i, j] = sampling
            .pair
            .map(|index| usize::try_from(index - sampling.first).unwrap_or(0));
        let velocities = self.model.velocity_symbols();
        let velocity = self.model.graph.symbol(velocities[j]);
        let pair = self.model.graph.multiply(equations.mass[i][j], velocity);
        let pairs = self.printed(&sampling, pair, &sampling.pair);
        let right = sampling.fitting(&pairs, &[], &self.values(&equations.momenta))?;
        let name = self
            .letters
            .print_both(Symbol::Coordinate(u32::try_from(i).ok()?));
        let name = [format!("p_{}", name[0]), format!("p_{{{}}}", name[1])];
        let left = with_indices(name, &sampling.pair[..1]);
        Some((Side::texts(&left), Side::texts(&sampling.with_range(right))))
    }

    /// All of Lagrange's equations as one.
    pub(crate) fn lagrange_of_family(&mut self, equations: &Equations) -> Option<(Side, Side)> {
        let sampling = self.sampling()?;
        let [i, j] = sampling
            .pair
            .map(|index| usize::try_from(index - sampling.first).unwrap_or(0));
        let velocities = self.model.velocity_symbols();
        let force = equations.generalized_forces[i];
        let graph = &mut self.model.graph;
        let rest = graph.subtract(force, equations.forcing[i]);
        let squared = graph.derivatives(&[rest], velocities[j])[0];
        let squared = graph.derivatives(&[squared], velocities[j])[0];
        let velocity = graph.symbol(velocities[j]);
        let acceleration = graph.symbol(Symbol::Acceleration(u32::try_from(j).ok()?));
        let centrifugal =
            graph.product([(squared, Rational::ONE), (velocity, Rational::integer(2))]);
        let inertial = graph.multiply(equations.mass[i][j], acceleration);
        let pair = graph.sum([(inertial, Rational::ONE), (centrifugal, Rational::HALF)]);
        let zero = graph.zero();
        let at_rest = velocities
            .iter()
            .map(|velocity| (*velocity, zero))
            .collect();
        let single = graph.substitute(&[rest], &at_rest)[0];
        let pairs = self.printed(&sampling, pair, &sampling.pair);
        let singles = self.printed(&sampling, single, &sampling.pair[..1]);
        let forces = equations.generalized_forces.clone();
        let graph = &mut self.model.graph;
        let sides = equations.inverse_dynamics.iter().zip(&forces);
        let sides: Vec<_> = sides.map(|(x, y)| graph.add(*x, *y)).collect();
        let left = sampling.fitting(&pairs, &singles, &self.values(&sides))?;
        let right = self.printed(&sampling, force, &sampling.pair[..1]);
        let right = sampling.fitting(&[], &right, &self.values(&forces))?;
        let right = sampling.with_range(right);
        Some((Side::texts(&left), Side::texts(&right)))
    }

    /// A family of all coordinates, of as many members that two of them are neither neighbours nor at an end.
    fn sampling(&self) -> Option<Sampling> {
        let families = Families::of(&self.declared.names);
        let (first, last) = families.of_all_coordinates(self.model.coordinates)?;
        let count = last - first + 1;
        if count <= FEWEST_FOLDED_LINES.try_into().ok()? {
            return None;
        }
        let pair = [first + count / 4, first + count / 4 + (count + 1) / 3];
        (pair[1] < last).then_some(Sampling {
            families,
            first,
            last,
            pair,
        })
    }

    /// The values of equations at the points.
    fn values(&self, equations: &[Expression]) -> Vec<Vec<f64>> {
        let points = POINTS.iter().map(|point| {
            let point = RealPoint::new(*point);
            let graph = &self.model.graph;
            graph.evaluate(equations, |symbol| point.value(symbol))
        });
        points.collect()
    }

    /// The patterns of which an expression may be a sample.
    fn printed(&mut self, sampling: &Sampling, x: Expression, sample: &[i64]) -> Vec<Printed> {
        let arranged = self.arranged(x);
        let graph = &mut self.model.graph;
        let (replaced, patterns) =
            IndexPattern::candidates(graph, &sampling.families, arranged, sample);
        let mut letters = self.letters.clone();
        let sums = patterns.first().map_or(0, |pattern| pattern.sums.len());
        for (k, sign) in (0..).zip(FIRST_SIGN..).take(sums) {
            let argument = graph.symbol(Symbol::Argument(k));
            letters = letters.with_sign(argument, char::from_u32(sign).unwrap_or('Σ'));
        }
        let texts = texts(graph, &letters, replaced);
        let is_sum = matches!(graph.node(replaced), Node::Sum(terms) if terms.len() > 1);
        let patterns = patterns.into_iter().map(|pattern| {
            let mut texts = texts.clone();
            for (sum, sign) in pattern.sums.iter().zip(FIRST_SIGN..) {
                let [first, last] = sum.bounds.map(bound);
                let member = self.letters.print_both(sum.member);
                let index = format!("{}{}{}", MARKS[0], sum.index, MARKS[1]);
                let [unicode, latex] = print_sum_sign("k", &first, &last);
                let signs = [
                    unicode,
                    latex.replace("max", "\\max").replace("min", "\\min"),
                ];
                let brackets = [["(", ")"], ["\\left(", "\\right)"]];
                let sign = char::from_u32(sign).unwrap_or('Σ');
                for (notation, below) in [lowered("k"), "k".into()].iter().enumerate() {
                    let member = member[notation].replace(&index, below);
                    let [open, close] = brackets[notation];
                    let sum = format!("{open}{}{member}{close}", signs[notation]);
                    texts[notation] = texts[notation].replace(sign, &sum);
                }
            }
            let texts = with_indices(texts, &pattern.sample);
            Printed {
                pattern,
                texts,
                is_sum,
            }
        });
        patterns.collect()
    }
}

impl Sampling {
    /// The first patterns whose sums over the family have these values; where there are none to choose from, nothing is
    /// added.
    fn fitting(
        &self,
        pairs: &[Printed],
        singles: &[Printed],
        values: &[Vec<f64>],
    ) -> Option<[String; 2]> {
        let pairs = or_none(pairs);
        let singles = or_none(singles);
        for pair in &pairs {
            for single in &singles {
                if self.holds(*pair, *single, values) {
                    return Some(self.sum_of(*pair, *single));
                }
            }
        }
        None
    }

    /// Whether Σⱼ pair(i, j) + single(i) has these values for all i.
    fn holds(&self, pair: Option<&Printed>, single: Option<&Printed>, values: &[Vec<f64>]) -> bool {
        let value = |printed: Option<&Printed>, indices: &[i64], point| {
            printed.map_or(0.0, |x| x.pattern.value(&self.families, indices, point))
        };
        POINTS.iter().zip(values).all(|(point, values)| {
            let point = RealPoint::new(*point);
            (self.first..=self.last).zip(values).all(|(i, expected)| {
                let alone = value(single, &[i], point);
                let mut total = alone;
                let mut size = alone.abs() + expected.abs();
                for j in self.first..=self.last {
                    let term = value(pair, &[i, j], point);
                    total += term;
                    size += term.abs();
                }
                (total - expected).abs() <= TOLERANCE * size
            })
        })
    }

    /// Σⱼ pair + single in print.
    fn sum_of(&self, pair: Option<&Printed>, single: Option<&Printed>) -> [String; 2] {
        let mut texts = single.map_or_else(Default::default, |single| single.texts.clone());
        let Some(pair) = pair else {
            return texts;
        };
        let [first, last] = [self.first, self.last].map(|index| index.to_string());
        let signs = print_sum_sign(INDICES[1], &first, &last);
        let brackets = [["(", ")"], ["\\left(", "\\right)"]];
        for (notation, text) in texts.iter_mut().enumerate() {
            let single = core::mem::take(text);
            let [open, close] = if pair.is_sum {
                brackets[notation]
            } else {
                [""; 2]
            };
            let sum = format!("{}{open}{}{close}", signs[notation], pair.texts[notation]);
            *text = match single.strip_prefix(['−', '-']) {
                _ if single.is_empty() || single == "0" => sum,
                Some(rest) if notation == 0 => format!("{sum} − {rest}"),
                Some(rest) => format!("{sum} - {rest}"),
                None => format!("{sum} + {single}"),
            };
        }
        texts
    }

    /// With the range of the index behind.
    fn with_range(&self, [unicode, latex]: [String; 2]) -> [String; 2] {
        let (i, first, last) = (INDICES[0], self.first, self.last);
        [
            format!("{unicode}  ({i} = {first}, …, {last})"),
            format!("{latex} \\quad ({i} = {first}, \\ldots, {last})"),
        ]
    }
}

/// All of them, or none once.
fn or_none(printed: &[Printed]) -> Vec<Option<&Printed>> {
    match printed {
        [] => vec![None],
        some => some.iter().map(Some).collect(),
    }
}

/// An expression in Unicode and in LaTeX.
fn texts(graph: &Graph, letters: &Letters, x: Expression) -> [String; 2] {
    let formula = graph.display_in(x, letters);
    [formula.to_string(), formula.in_latex().to_string()]
}

/// The numbers of a sample as indices.
fn with_indices(mut texts: [String; 2], sample: &[i64]) -> [String; 2] {
    for (number, name) in sample.iter().zip(INDICES) {
        let marked = format!("{}{number}{}", MARKS[0], MARKS[1]);
        texts[0] = texts[0].replace(&marked, &lowered(name));
        texts[1] = texts[1].replace(&marked, name);
    }
    texts
}

/// A bound as it is printed.
fn bound(bound: Bound) -> String {
    let [i, j] = INDICES;
    match bound {
        Bound::Fixed(number) => number.to_string(),
        Bound::Index(k) => INDICES[k].to_owned(),
        Bound::Greater => format!("max({i},{j})"),
        Bound::Lesser => format!("min({i},{j})"),
    }
}
