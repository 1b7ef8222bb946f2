//! The formula of one member of a family as one of any member i, with sums over all others.

use crate::print::index::{Index, Range};
use crate::print::listing::index_letters::IndexLetters;
use crate::print::printed::{Part, Printed};

/// A sum over the others is written for so many terms.
const MIN_OTHERS: usize = 2;

impl Printed {
    /// The formula of the member `own` of a family as one of any member i, where all of its sums are over the other members or over
    /// all, and no other index occurs. Whether it is the formula of the other members, their values decide.
    pub(crate) fn of_any_member(
        mut self,
        own: i64,
        range: [i64; 2],
        letters: IndexLetters,
    ) -> Option<Self> {
        self.sort_terms(own);
        self.fold_sums(MIN_OTHERS, letters);
        let any = Member {
            own,
            range,
            variable: letters.text('i'),
        };
        any.generalize(&mut self).then_some(self)
    }

    /// Puts the terms of each sum in an order in which those that differ in the indices of other members only stand one
    /// behind the other.
    fn sort_terms(&mut self, own: i64) {
        for part in self.parts_mut() {
            part.sort_terms(own);
        }
        let Part::Sum(terms) = &mut self.0 else {
            return;
        };
        let mut groups: Vec<Group> = Vec::new();
        for (negative, term) in core::mem::take(terms) {
            let (mut shape, mut others) = (term.clone(), Vec::new());
            shape.visit_indices(&mut |index| match index {
                Index::Number(number) if *number != own => others.push(core::mem::take(number)),
                _ => {}
            });
            let mut known = groups.iter_mut();
            match known.find(|group| group.negative == negative && group.shape == shape) {
                Some(group) => group.terms.push((others, term)),
                None => groups.push(Group {
                    negative,
                    shape,
                    terms: vec![(others, term)],
                }),
            }
        }
        if let Some(positive) = groups.iter().position(|group| !group.negative) {
            groups[..=positive].rotate_right(1);
        }
        for mut group in groups {
            group.terms.sort_by(|(one, _), (other, _)| one.cmp(other));
            let sorted = group.terms.into_iter();
            terms.extend(sorted.map(|(_, term)| (group.negative, term)));
        }
    }
}

/// Terms that differ in the indices of other members only.
struct Group {
    negative: bool,
    /// A term without these indices.
    shape: Printed,
    /// These indices and the terms.
    terms: Vec<(Vec<i64>, Printed)>,
}

/// A member of a family whose indices are in a range.
struct Member {
    own: i64,
    range: [i64; 2],
    /// What any member is called.
    variable: String,
}

impl Member {
    /// Puts any member in place of this one; whether all else is sums over the others or over all.
    fn generalize(&self, formula: &mut Printed) -> bool {
        let [first, last] = self.range;
        let is_general = match &mut formula.0 {
            Part::Name(name) => name.indices.iter_mut().all(|index| match index {
                Index::Number(number) if *number == self.own => {
                    *index = Index::Variable(self.variable.clone(), 0);
                    true
                }
                Index::Variable(_, offset) => *offset == 0,
                other => !matches!(other, Index::Number(_)),
            }),
            Part::SumOver(
                Range {
                    variable,
                    first: Index::Number(begin),
                    last: Index::Number(end),
                },
                term,
            ) => {
                let others = [(first, [first + 1, last]), (last, [first, last - 1])];
                let bounds = [*begin, *end];
                if others.contains(&(self.own, bounds)) {
                    let term = core::mem::replace(&mut **term, Printed::zero());
                    let [j, i] = [variable, &self.variable];
                    let below = [format!("_({j}≠{i})"), format!("{{{j} \\ne {i}}}")];
                    *formula = term.summed_over(below.each_ref().map(|text| &**text));
                    true
                } else {
                    bounds == self.range
                }
            }
            _ => true,
        };
        let mut parts = formula.parts_mut().into_iter();
        is_general && parts.all(|part| self.generalize(part))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::print::notation::Notation;

    fn member(stem: &str, index: i64) -> Printed {
        Printed::name(stem, true, vec![Index::Number(index)], 0)
    }

    fn m(i: i64) -> Printed {
        member("m", i)
    }

    fn x(i: i64) -> Printed {
        member("x", i)
    }

    fn k() -> Printed {
        Printed::name("k", true, Vec::new(), 0)
    }

    fn of_member(formula: Printed, own: i64, last: i64) -> Option<String> {
        let any = formula.of_any_member(own, [0, last], IndexLetters::default())?;
        Some(any.written(Notation::Unicode))
    }

    #[test]
    fn sums_are_over_all_others() {
        let distances = x(1).plus(x(0), true).plus(x(2), false).plus(x(0), true);
        let first = of_member(m(0).times(distances), 0, 2);
        assert_eq!(first.as_deref(), Some("mᵢ (Σ_(j≠i) xⱼ − xᵢ − xᵢ)"));
        let pair = |i, j| k().times(Printed::sum([i, j].map(|i| m(i).times(x(i)))));
        let of = |i| m(i).times(x(i));
        let any = "mᵢ xᵢ − k (Σ_(j≠i) mⱼ xⱼ)";
        assert_eq!(
            of_member(of(0).plus(pair(1, 2), true), 0, 2).as_deref(),
            Some(any)
        );
        assert_eq!(
            of_member(of(2).plus(pair(0, 1), true), 2, 2).as_deref(),
            Some(any)
        );
        let twice = Printed::number(&crate::Rational::integer(2)).times(x(0));
        let apart = k().times(x(1).plus(twice, true).plus(x(2), false));
        let apart = of_member(apart, 0, 2);
        assert_eq!(apart.as_deref(), Some("k (Σ_(j≠i) xⱼ − 2 xᵢ)"));
        let bars = Printed::bars(x(1).plus(x(0), true).plus(x(2), false));
        assert_eq!(of_member(bars, 0, 2).as_deref(), Some("|Σ_(j≠i) xⱼ − xᵢ|"));
        let all = x(0).plus(k().times(Printed::sum([0, 1, 2].map(m))), false);
        assert_eq!(of_member(all, 0, 2).as_deref(), Some("xᵢ + k (Σⱼ₌₀² mⱼ)"));
    }

    #[test]
    fn sums_over_some_and_single_members_are_not_folded() {
        let some = Printed::sum([x(0), m(1), m(2)]);
        assert_eq!(of_member(some.clone(), 0, 3), None);
        assert_eq!(of_member(some.plus(x(2), false), 0, 2), None);
    }
}
