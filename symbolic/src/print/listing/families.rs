//! Momenta and Lagrange's equations of a family of coordinates, as one equation with a sum over the family.
//!
//! For L of second degree in the velocities, equation i is Σⱼ (Mᵢⱼ q̈ⱼ + cᵢⱼ q̇ⱼ²) + gᵢ = Qᵢ, unless there are products of
//! different velocities. One pair of coordinates and one coordinate are the samples (`index_pattern.rs`). Where the diagonal
//! of M is another one, what it has besides stands beside the sum. All equations are compared with what is printed by an
//! identity test (`identity/identity_testing.rs`): where it does not say yes, nothing is folded.

use std::collections::BTreeMap;

use crate::identity::identity_testing::IdentityTest;
use crate::identity::modular_point::ModularPoint;
use crate::identity::residue;
use crate::limits::MAX_UNARRANGED_LENGTH;
use crate::print::listing::composer::Composer;
use crate::print::listing::index_pattern::{IndexPattern, Known};
use crate::print::listing::pattern_text::of_indices;
use crate::print::listing::sampling::Sampling;
use crate::print::printed::Printed;
use crate::{Equations, Expression, Graph, Rational, Symbol};

/// An entry of M that is folded has so many sums over the family at most; that of a chain of links has one.
const MAX_SUMS: u64 = 3;

/// What is folded: equations, and the samples of their terms.
struct Folding<'a> {
    equations: &'a [Expression],
    /// The part of M that concerns the family.
    mass: Vec<Vec<Expression>>,
    /// The terms of a pair, which contain Mᵢⱼ times a rate.
    pair: Expression,
    /// What is added for one coordinate.
    single: Expression,
    /// The symbol of the rate by which entries of M are multiplied.
    rate: fn(u32) -> Symbol,
    /// The values of symbols for which the terms of a pair are Mᵢⱼ.
    unit: fn(Symbol) -> Option<Rational>,
}

/// The terms of an equation of a family.
#[derive(Default)]
struct Terms {
    pair: Option<IndexPattern>,
    diagonal: Option<IndexPattern>,
    single: Option<IndexPattern>,
}

impl Composer<'_> {
    /// All momenta as one equation.
    pub(crate) fn momentum_of_family(
        &mut self,
        equations: &Equations,
    ) -> Option<(Printed, Printed)> {
        let sampling = self.sampling(equations)?;
        let [i, j] = sampling.positions();
        let velocity = self.model.velocity_symbols()[j];
        let at_rest = self.at_rest(&sampling);
        let graph = &mut self.model.graph;
        let velocity = graph.symbol(velocity);
        let folding = Folding {
            equations: &equations.momenta[sampling.rows()],
            mass: sampling.block(&equations.mass),
            pair: graph.multiply(equations.mass[i][j], velocity),
            single: graph.substitute(&[equations.momenta[i]], &at_rest)[0],
            rate: Symbol::Velocity,
            unit: |symbol| match symbol {
                Symbol::Velocity(_) => Some(Rational::ONE),
                _ => None,
            },
        };
        let right = self.folded(&sampling, &folding)?;
        let symbol = Symbol::Coordinate(u32::try_from(i).ok()?);
        let indices = self.letters.index_letters();
        let left = of_indices(self.momentum(symbol), &sampling.pair[..1], indices);
        let right = right.for_all(vec![sampling.range('i', indices)]);
        Some((left, right))
    }

    /// All of Lagrange's equations as one.
    pub(crate) fn lagrange_of_family(
        &mut self,
        equations: &Equations,
    ) -> Option<(Printed, Printed)> {
        let sampling = self.sampling(equations)?;
        let [i, j] = sampling.positions();
        let velocities = self.model.velocity_symbols();
        let forces = &equations.generalized_forces;
        let at_rest = self.at_rest(&sampling);
        let graph = &mut self.model.graph;
        let rest = graph.subtract(forces[i], equations.forcing[i]);
        let squared = graph.derivatives(&[rest], velocities[j])[0];
        let squared = graph.derivatives(&[squared], velocities[j])[0];
        let velocity = graph.symbol(velocities[j]);
        let acceleration = graph.symbol(Symbol::Acceleration(u32::try_from(j).ok()?));
        let centrifugal =
            graph.product([(squared, Rational::ONE), (velocity, Rational::integer(2))]);
        let inertial = graph.multiply(equations.mass[i][j], acceleration);
        // What coordinates of other kinds do to the family.
        let mut besides = vec![(graph.substitute(&[rest], &at_rest)[0], Rational::ONE)];
        for (other, entry) in (0..).zip(&equations.mass[i]) {
            if !sampling.rows().contains(&(other as usize)) {
                let acceleration = graph.symbol(Symbol::Acceleration(other));
                besides.push((graph.multiply(*entry, acceleration), Rational::ONE));
            }
        }
        let sides = equations.inverse_dynamics.iter().zip(forces);
        let sides: Vec<_> = sides.map(|(x, y)| graph.add(*x, *y)).collect();
        let folding = Folding {
            equations: &sides[sampling.rows()],
            mass: sampling.block(&equations.mass),
            pair: graph.sum([(inertial, Rational::ONE), (centrifugal, Rational::HALF)]),
            single: graph.sum(besides),
            rate: Symbol::Acceleration,
            unit: |symbol| match symbol {
                Symbol::Velocity(_) => Some(Rational::ZERO),
                Symbol::Acceleration(_) => Some(Rational::ONE),
                _ => None,
            },
        };
        let left = self.folded(&sampling, &folding)?;
        let right = self.folded_forces(&sampling, &forces[sampling.rows()])?;
        let range = sampling.range('i', self.letters.index_letters());
        let right = right.for_all(vec![range]);
        Some((left, right))
    }

    /// The velocities of a family as zero.
    fn at_rest(&mut self, sampling: &Sampling) -> BTreeMap<Symbol, Expression> {
        let zero = self.model.graph.zero();
        let velocities = &self.model.velocity_symbols()[sampling.rows()];
        velocities
            .iter()
            .map(|velocity| (*velocity, zero))
            .collect()
    }

    /// What is sampled, unless Mᵢⱼ is so long that what contains it would be left out: nothing is arranged for that.
    fn sampling(&self, equations: &Equations) -> Option<Sampling> {
        let sampling = Sampling::of(self)?;
        let [i, j] = sampling.positions();
        let entry = *equations.mass.get(i)?.get(j)?;
        // Sums over the family become shorter.
        let count = u64::try_from(sampling.last - sampling.first + 1).ok()?;
        let longest = MAX_UNARRANGED_LENGTH + MAX_SUMS * count;
        let length = self.model.graph.written_symbols(&[entry], &self.letters);
        (length <= longest).then_some(sampling)
    }

    /// Q of all coordinates as one.
    fn folded_forces(&mut self, sampling: &Sampling, forces: &[Expression]) -> Option<Printed> {
        let graph = &self.model.graph;
        if forces.iter().all(|force| graph.is_zero(*force)) {
            return Some(Printed::zero());
        }
        let force = forces[sampling.positions()[0] - sampling.place];
        let point = self.first_point(forces)?;
        let values = point.evaluate(&self.model.graph, forces)?;
        let single = self.fitted(
            sampling,
            force,
            &sampling.pair[..1],
            |_| None,
            (point, &values),
        )?;
        let terms = Terms {
            single: Some(single),
            ..Terms::default()
        };
        self.printed_if_equal(sampling, &terms, forces)
    }

    /// The terms of all equations in print.
    fn folded(&mut self, sampling: &Sampling, folding: &Folding<'_>) -> Option<Printed> {
        if self.model.graph.is_zero(folding.pair) {
            return None;
        }
        let mass: Vec<_> = folding.mass.concat();
        let point = self.first_point(&[&mass, folding.equations].concat())?;
        let mass = point.evaluate(&self.model.graph, &mass)?;
        let values = point.evaluate(&self.model.graph, folding.equations)?;
        let arranged = self.plainly_arranged(folding.pair);
        let graph = &mut self.model.graph;
        let pairs = IndexPattern::candidates(graph, &sampling.families, arranged, &sampling.pair);
        let off_diagonal: Vec<_> = sampling
            .pairs()
            .zip(&mass)
            .filter(|([i, j], _)| i != j)
            .map(|(pair, value)| (pair.to_vec(), *value))
            .collect();
        let known = Known {
            families: &sampling.families,
            point,
            values: &off_diagonal,
            symbols: folding.unit,
        };
        for pair in pairs {
            let Some(pair) = pair.fitted(&known) else {
                continue;
            };
            let mut terms = Terms {
                pair: Some(pair),
                ..Terms::default()
            };
            if self.fit_diagonal(sampling, folding, &mut terms, (point, &mass)) != Some(())
                || self.fit_single(sampling, folding, &mut terms, (point, &values)) != Some(())
            {
                continue;
            }
            let printed = self.printed_if_equal(sampling, &terms, folding.equations);
            if printed.is_some() {
                return printed;
            }
        }
        None
    }

    /// Finds what the diagonal of M has besides.
    fn fit_diagonal(
        &mut self,
        sampling: &Sampling,
        folding: &Folding<'_>,
        terms: &mut Terms,
        (point, mass): (ModularPoint, &[u64]),
    ) -> Option<()> {
        let p = point.p();
        let pair = terms.pair.as_ref()?;
        let families = &sampling.families;
        let mut others = Vec::new();
        for ([i, j], entry) in sampling.pairs().zip(mass) {
            if i == j {
                let own = pair.value(families, &[i, i], point, folding.unit)?;
                others.push(residue::add(*entry, residue::negate(own, p), p));
            }
        }
        if others.iter().all(|other| *other == 0) {
            return Some(());
        }
        let index = sampling.pair[0];
        let position = sampling.positions()[0];
        let graph = &mut self.model.graph;
        let own = pair.instantiated(graph, families, &[index, index])?;
        let rate = graph.symbol((folding.rate)(u32::try_from(position).ok()?));
        let row = position - sampling.place;
        let entry = graph.multiply(folding.mass[row][row], rate);
        let besides = graph.subtract(entry, own);
        let known = (point, &*others);
        let diagonal = self.fitted(sampling, besides, &[index], folding.unit, known)?;
        terms.diagonal = Some(diagonal);
        Some(())
    }

    /// Finds what is added for each coordinate.
    fn fit_single(
        &mut self,
        sampling: &Sampling,
        folding: &Folding<'_>,
        terms: &mut Terms,
        (point, values): (ModularPoint, &[u64]),
    ) -> Option<()> {
        let p = point.p();
        let mut rest = Vec::new();
        for (i, value) in (sampling.first..=sampling.last).zip(values) {
            let found = terms.value(sampling, i, point)?;
            rest.push(residue::add(*value, residue::negate(found, p), p));
        }
        if rest.iter().any(|other| *other != 0) {
            let known = (point, &*rest);
            let index = &sampling.pair[..1];
            terms.single = Some(self.fitted(sampling, folding.single, index, |_| None, known)?);
        }
        Some(())
    }

    /// The first pattern of one index with these values.
    fn fitted(
        &mut self,
        sampling: &Sampling,
        sample: Expression,
        index: &[i64],
        symbols: fn(Symbol) -> Option<Rational>,
        (point, values): (ModularPoint, &[u64]),
    ) -> Option<IndexPattern> {
        let values = (sampling.first..=sampling.last).zip(values);
        let values: Vec<_> = values.map(|(i, value)| (vec![i], *value)).collect();
        let known = Known {
            families: &sampling.families,
            point,
            values: &values,
            symbols,
        };
        let sample = self.plainly_arranged(sample);
        let graph = &mut self.model.graph;
        let candidates = IndexPattern::candidates(graph, &sampling.families, sample, index);
        candidates
            .into_iter()
            .find_map(|pattern| pattern.fitted(&known))
    }

    /// An expression as it is short to read without definitions.
    fn plainly_arranged(&mut self, x: Expression) -> Expression {
        self.model.graph.arranged(x, &self.letters.of_symbols())
    }

    /// A point at which all expressions have values.
    fn first_point(&self, expressions: &[Expression]) -> Option<ModularPoint> {
        let mut points = ModularPoint::attempts().map(ModularPoint::uninterpreted);
        points.find(|point| point.evaluate(&self.model.graph, expressions).is_some())
    }

    /// The terms in print, if they are identically the equations.
    fn printed_if_equal(
        &mut self,
        sampling: &Sampling,
        terms: &Terms,
        equations: &[Expression],
    ) -> Option<Printed> {
        let graph: &Graph = &self.model.graph;
        let equal = IdentityTest::of(graph, equations).holds(|point| {
            let values = point.evaluate(graph, equations)?;
            let mut all = (sampling.first..=sampling.last).zip(values);
            Some(all.all(|(i, value)| terms.value(sampling, i, point) == Some(value)))
        });
        if !equal {
            return None;
        }
        let letters = self.letters.of_symbols();
        let graph = &mut self.model.graph;
        let mut print = |pattern: &Option<IndexPattern>| match pattern {
            Some(pattern) => pattern.printed(graph, &letters),
            None => Some(Printed::zero()),
        };
        let pair = print(&terms.pair)?;
        let range = sampling.range('j', letters.index_letters());
        let sum = if pair.is_zero() {
            pair
        } else {
            pair.summed(range)
        };
        Some(Printed::sum([
            sum,
            print(&terms.diagonal)?,
            print(&terms.single)?,
        ]))
    }
}

impl Terms {
    /// The value of equation i modulo p.
    fn value(&self, sampling: &Sampling, i: i64, point: ModularPoint) -> Option<u64> {
        let value = |pattern: &Option<IndexPattern>, indices: &[i64]| match pattern {
            Some(pattern) => pattern.value(&sampling.families, indices, point, |_| None),
            None => Some(0),
        };
        let p = point.p();
        let diagonal = value(&self.diagonal, &[i])?;
        let mut total = residue::add(diagonal, value(&self.single, &[i])?, p);
        if self.pair.is_some() {
            for j in sampling.first..=sampling.last {
                total = residue::add(total, value(&self.pair, &[i, j])?, p);
            }
        }
        Some(total)
    }
}
