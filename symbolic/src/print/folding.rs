//! Formulas that differ in their indices only, folded to one: sums over an index, and one equation for the members of a
//! family (anti-unification: Plotkin, A note on inductive generalization, 1970).
//!
//! An equation of a family is taken only if, with its index put in and its sums written out, it is again the one that was
//! to be printed.

pub(crate) mod others;

use crate::limits::{MIN_FOLDED_LINES, MIN_FOLDED_TERMS};
use crate::print::index::{Index, Range};
use crate::print::listing::index_letters::IndexLetters;
use crate::print::printed::{Part, Printed};

/// A formula without the numbers of its indices, and these.
struct TakenApart {
    shape: Printed,
    numbers: Vec<i64>,
}

impl TakenApart {
    /// By how much each index grows from one formula to another, by one or not at all; none if they differ in more.
    fn steps(&self, next: &Self) -> Option<Vec<i64>> {
        let steps = self.numbers.iter().zip(&next.numbers).map(|(x, y)| y - x);
        let steps: Vec<_> = steps.collect();
        let are_small = steps.iter().all(|step| (0..=1).contains(step));
        (are_small && steps.contains(&1) && self.shape == next.shape).then_some(steps)
    }
}

impl Printed {
    fn taken_apart(&self) -> TakenApart {
        let (mut shape, mut numbers) = (self.clone(), Vec::new());
        shape.visit_indices(&mut |index| {
            if let Index::Number(number) = index {
                numbers.push(core::mem::take(number));
            }
        });
        TakenApart { shape, numbers }
    }

    /// Its first index that is a number.
    fn first_number(&mut self) -> Option<i64> {
        let mut first = None;
        self.visit_indices(&mut |index| {
            if let Index::Number(number) = index {
                first.get_or_insert(*number);
            }
        });
        first
    }

    /// The formula with a variable, which is `start` here, in place of the indices that grow.
    fn generalized(mut self, steps: &[i64], variable: &str, start: i64) -> Self {
        let mut steps = steps.iter();
        self.visit_indices(&mut |index| {
            if let Index::Number(number) = index
                && steps.next() == Some(&1)
            {
                *index = Index::Variable(variable.to_owned(), *number - start);
            }
        });
        self
    }

    /// The formula with a number in place of a variable.
    fn at(&self, variable: &str, value: i64) -> Self {
        let mut formula = self.clone();
        formula.visit_indices(&mut |index| {
            if let Index::Variable(name, offset) = index
                && name == variable
            {
                *index = Index::Number(value + *offset);
            }
        });
        formula
    }

    /// Puts sums over an index in place of so many terms or more that differ by one in some of their indices.
    fn fold_sums(&mut self, fewest: usize, letters: IndexLetters) {
        for part in self.parts_mut() {
            part.fold_sums(fewest, letters);
        }
        let Part::Sum(terms) = &mut self.0 else {
            return;
        };
        if terms.len() < fewest {
            return;
        }
        let parts: Vec<_> = terms.iter().map(|(_, term)| term.taken_apart()).collect();
        let steps = terms
            .windows(2)
            .zip(parts.windows(2))
            .map(|(terms, parts)| {
                let steps = parts[0].steps(&parts[1]);
                steps.filter(|_| terms[0].0 == terms[1].0)
            });
        // The steps to the next term; none behind the last one.
        let steps: Vec<_> = steps.chain([None]).collect();
        let mut folded = Vec::new();
        let mut start = 0;
        while let Some((negative, first)) = terms.get(start) {
            let alike = steps[start..]
                .iter()
                .take_while(|next| next.is_some() && **next == steps[start]);
            let count = 1 + alike.count();
            let sum = steps[start].as_ref().filter(|_| count >= fewest);
            let sum = sum.and_then(|steps| first.sum_from(steps, count, letters));
            let end = start + if count < fewest { 1 } else { count };
            match sum {
                Some(sum) => folded.push((*negative, sum)),
                None => folded.extend(terms[start..end].iter().cloned()),
            }
            start = end;
        }
        *terms = folded;
    }

    /// The sum over as many terms, of which this is the first.
    fn sum_from(&self, steps: &[i64], count: usize, letters: IndexLetters) -> Option<Self> {
        let mut used = Vec::new();
        self.clone().visit(&mut |part| {
            if let Part::SumOver(range, _) = &part.0 {
                used.push(range.variable.clone());
            }
        });
        let mut variables = ['j', 'k', 'l', 'm']
            .map(|letter| letters.text(letter))
            .into_iter();
        let variable = variables.find(|letter| !used.contains(letter))?;
        let mut moving = self
            .taken_apart()
            .numbers
            .into_iter()
            .zip(steps)
            .filter(|(_, step)| **step == 1);
        let (start, _) = moving.next()?;
        let last = start + i64::try_from(count).ok()? - 1;
        let term = self.clone().generalized(steps, &variable, start);
        Some(term.summed(Range {
            variable,
            first: Index::Number(start),
            last: Index::Number(last),
        }))
    }

    /// Writes sums over numbers out; whether none of them is empty. One term is no sum.
    fn unfold_sums(&mut self) -> bool {
        let mut are_filled = true;
        if let Part::Sum(terms) = &mut self.0 {
            let all = core::mem::take(terms).into_iter();
            let all = all.flat_map(|(negative, term)| match term.0 {
                Part::SumOver(
                    Range {
                        variable,
                        first: Index::Number(first),
                        last: Index::Number(last),
                    },
                    term,
                ) => {
                    are_filled &= first <= last;
                    let terms = (first..=last).map(|index| (negative, term.at(&variable, index)));
                    terms.collect()
                }
                _ => vec![(negative, term)],
            });
            *self = Self::of_terms(all.collect());
        }
        let parts = self.parts_mut().into_iter();
        parts.fold(are_filled, |all, part| part.unfold_sums() && all)
    }

    /// What the equations of a family have in common: the first term of the left side without the indices that are equal to its
    /// first one, and of a single name only without the first.
    fn family(&self) -> Option<Self> {
        let Part::Equation(sides) = &self.0 else {
            return None;
        };
        let mut term = sides[0].clone();
        let mut names = 0;
        term.visit(&mut |part| match &mut part.0 {
            Part::Sum(terms) => terms.truncate(1),
            Part::Name(_) => names += 1,
            _ => {}
        });
        let first = term.first_number()?;
        let mut found = false;
        term.visit_indices(&mut |index| {
            if *index == Index::Number(first) && !(names == 1 && found) {
                found = true;
                *index = Index::Number(-1);
            }
        });
        Some(term)
    }
}

/// An equation, or one for several members of a family.
#[derive(Clone, Debug)]
pub(crate) struct Folded {
    pub(crate) equation: Printed,
    /// The positions of the equations that it stands for.
    pub(crate) members: Vec<usize>,
}

/// Equations with sums, and one in place of the members of each family, where it is the same for most of them.
pub(crate) fn folded(equations: &[&Printed], letters: IndexLetters) -> Vec<Folded> {
    let mut sums: Vec<Printed> = equations.iter().copied().cloned().collect();
    for equation in &mut sums {
        // Without the index of a member nothing is folded.
        if equation.first_number().is_some() {
            equation.fold_sums(MIN_FOLDED_TERMS, letters);
        }
    }
    let mut families: Vec<(Printed, Vec<usize>)> = Vec::new();
    for (position, equation) in equations.iter().enumerate() {
        let Some(family) = equation.family() else {
            continue;
        };
        match families.iter_mut().find(|(known, _)| *known == family) {
            Some((_, members)) => members.push(position),
            None => families.push((family, vec![position])),
        }
    }
    let found = families
        .iter()
        .map(|(_, positions)| equation_of_family(equations, &sums, positions, letters));
    let found: Vec<_> = found.collect();
    let single = |(position, equation)| {
        Some(Folded {
            equation,
            members: vec![position],
        })
    };
    let mut folded: Vec<_> = (0..).zip(sums).map(single).collect();
    for family in found.into_iter().flatten() {
        for position in &family.members {
            folded[*position] = None;
        }
        let position = family.members[0];
        folded[position] = Some(family);
    }
    folded.into_iter().flatten().collect()
}

/// The equation of most members of a family.
fn equation_of_family(
    equations: &[&Printed],
    sums: &[Printed],
    positions: &[usize],
    letters: IndexLetters,
) -> Option<Folded> {
    if positions.len() < MIN_FOLDED_LINES {
        return None;
    }
    let middle = positions.len() / 2;
    let [one, next] = [positions[middle], positions[middle + 1]];
    let steps = sums[one].taken_apart().steps(&sums[next].taken_apart())?;
    let variable = letters.text('i');
    let start = equations[one].clone().first_number()?;
    let pattern = sums[one].clone().generalized(&steps, &variable, start);
    let covered = positions.iter().filter_map(|position| {
        let equation = equations[*position];
        let number = equation.clone().first_number()?;
        let mut member = pattern.at(&variable, number);
        (member.unfold_sums() && member == *equation).then_some((number, *position))
    });
    let (numbers, members): (Vec<_>, Vec<_>) = covered.unzip();
    let (first, last) = (*numbers.first()?, *numbers.last()?);
    let consecutive = numbers.windows(2).all(|pair| pair[1] == pair[0] + 1);
    let range = Range {
        variable,
        first: Index::Number(first),
        last: Index::Number(last),
    };
    (consecutive && members.len() >= MIN_FOLDED_LINES).then(|| Folded {
        equation: pattern.for_all(vec![range]),
        members,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::notation::Notation;

    fn name(name: &str) -> Printed {
        Printed::name(name, true, Vec::new(), 0)
    }

    /// The member of a family with an index.
    fn member(stem: &str, index: i64) -> Printed {
        Printed::name(stem, true, vec![Index::Number(index)], 0)
    }

    fn texts(equations: &[Printed]) -> Vec<String> {
        let equations: Vec<_> = equations.iter().collect();
        let folded = folded(&equations, IndexLetters::default()).into_iter();
        folded
            .map(|fold| fold.equation.written(Notation::Unicode))
            .collect()
    }

    #[test]
    fn sums_over_an_index() {
        let weight = |i| member("m", i).times(member("y", i));
        let terms = [2, 3, 4, 5].into_iter().map(weight);
        let sum = Printed::sum([weight(1).plus(name("a"), true)].into_iter().chain(terms));
        let right = name("g").times(sum);
        let found = texts(&[name("V").equals(right)]);
        assert_eq!(found, ["V = g (m₁ y₁ − a + Σⱼ₌₂⁵ mⱼ yⱼ)"]);
        let three = Printed::sum((1..4).map(|i| member("m", i)));
        assert_eq!(texts(&[name("T").equals(three)]), ["T = m₁ + m₂ + m₃"]);
        // Steps of two, and a sign that differs.
        let mut sum = Printed::sum([0, 2, 4, 6].map(|i| member("m", i)));
        sum = sum.plus(member("m", 7), true);
        sum = (8..12).fold(sum, |sum, i| sum.plus(member("m", i), false));
        let found = texts(&[name("T").equals(sum)]);
        assert_eq!(found, ["T = m₀ + m₂ + m₄ + m₆ − m₇ + Σⱼ₌₈¹¹ mⱼ"]);
    }

    #[test]
    fn families_with_sums_whose_length_differs() {
        let lines: Vec<_> = (0..6)
            .map(|i| {
                let terms = (0..=i).map(|j| {
                    let cosine = Printed::function("cos").expect("a function");
                    (true, member("l", j).times(cosine(member("theta", j))))
                });
                member("y", i).equals(Printed::of_terms(terms.collect()))
            })
            .collect();
        assert_eq!(texts(&lines), ["yᵢ = −Σⱼ₌₀ⁱ lⱼ cos θⱼ  (i = 0, …, 5)"]);
    }

    #[test]
    fn a_member_that_differs_stands_alone() {
        let line = |i| member("a", i).equals(member("b", i + 1));
        let mut lines: Vec<_> = (1..5).map(line).collect();
        lines.insert(0, member("a", 0).equals(name("x")));
        let rest = "aᵢ = bᵢ₊₁  (i = 1, …, 4)";
        assert_eq!(texts(&lines), ["a₀ = x", rest]);
        lines[3] = member("a", 3).equals(member("b", 5));
        assert_eq!(texts(&lines).len(), 5);
    }
}
