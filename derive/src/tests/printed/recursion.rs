//! The recursion of Newton and Euler as a page states it: its statements are carried out for each link.

use super::formula::Formula;
use super::jet::Jet;
use super::reader::close;
use super::surroundings::Surroundings;
use super::token::{Indices, Name};
use super::value::{Reading, Value};

/// The lines of a recursion.
#[derive(Default)]
pub(super) struct Recursion {
    lines: Vec<(Formula, Formula, Vec<Indices>)>,
    base: Option<Formula>,
}

/// What a line says.
enum Kind<'a> {
    /// A quantity of link i.
    Statement(&'a Name),
    /// The link before another.
    Before(i64),
    /// A quantity of a link with a number.
    Row(&'a Name),
    /// An equation of motion.
    Equation,
}

fn kind<'a>(left: &'a Formula, cases: &[Indices], has_equations: bool) -> Kind<'a> {
    match left {
        Formula::Name(name)
            if name.below.first().is_some_and(|index| index == "i")
                && cases == [Indices::new()] =>
        {
            Kind::Statement(name)
        }
        Formula::Call(name, arguments) if name.letter == "p" => match &**arguments {
            #[allow(clippy::cast_possible_truncation)] // The number of a link.
            [Formula::Number(link)] => Kind::Before(*link as i64),
            _ => Kind::Equation,
        },
        Formula::Name(name) if name.below.len() == 1 && !has_equations => Kind::Row(name),
        _ => Kind::Equation,
    }
}

/// Whether links behind are spoken of, so that the last link comes first.
fn goes_inward(formula: &Formula) -> bool {
    format!("{formula:?}").contains("\"i+1\"") || format!("{formula:?}").contains("SumOfLinks")
}

impl Recursion {
    pub(super) fn begin_with(&mut self, base: Formula) {
        self.base = Some(base);
    }

    pub(super) fn note(&mut self, left: Formula, right: Formula, cases: &[Indices]) {
        self.lines.push((left, right, cases.to_vec()));
    }

    /// Carries out the statements, and compares the equations of motion with what is expected.
    pub(super) fn check(&self, around: &mut Surroundings, expected: &[f64]) -> Reading<()> {
        let (mut statements, mut equations) = (Vec::new(), Vec::new());
        let (mut links, mut before) = (Vec::new(), Indices::new());
        for (left, right, cases) in &self.lines {
            match kind(left, cases, !equations.is_empty()) {
                Kind::Statement(name) => statements.push((name, right)),
                Kind::Before(link) => {
                    let parent = around.value(right)?.scalar()?.value();
                    #[allow(clippy::cast_possible_truncation)] // The number of a link.
                    before.insert(link.to_string(), parent as i64);
                }
                Kind::Row(name) => {
                    for case in cases {
                        around.indices.clone_from(case);
                        let value = around.value(right)?;
                        let written = name.written(case);
                        around.define(&written, value)?;
                        let index = super::token::index_value(&name.below[0], case);
                        links.extend(index.filter(|index| !links.contains(index)));
                    }
                    around.indices.clear();
                }
                Kind::Equation => equations.push((left, right)),
            }
        }
        links.sort_unstable();
        let before = |link: i64| *before.get(&link.to_string()).unwrap_or(&(link - 1));
        self.ends(around, &statements, (&links, &before))?;
        for inward in [false, true] {
            let mut order = links.clone();
            if inward {
                order.reverse();
            }
            for link in order {
                around.behind = links
                    .iter()
                    .copied()
                    .filter(|j| before(*j) == link)
                    .collect();
                around.indices.insert("i".into(), link);
                around.indices.insert("p".into(), before(link));
                for (name, right) in &statements {
                    if goes_inward(right) == inward {
                        let value = around.value(right)?;
                        let written = name.written(&around.indices);
                        around.rates.insert((written, name.dots), value);
                    }
                }
            }
        }
        around.indices.clear();
        for ((written, dots), value) in around.rates.clone() {
            if dots == 0 {
                around.names.remove(&written);
                around.define_with_components(&written, value)?;
            }
        }
        compare(around, &equations, expected)
    }

    /// What stands before the first link and behind the last one.
    fn ends(
        &self,
        around: &mut Surroundings,
        statements: &[(&Name, &Formula)],
        (links, before): (&[i64], &dyn Fn(i64) -> i64),
    ) -> Reading<()> {
        let base = self
            .base
            .as_ref()
            .ok_or("where does the recursion begin?")?;
        let base = around.value(base)?;
        let last = links.last().copied().unwrap_or(0);
        for link in links {
            let place = before(*link);
            if links.contains(&place) {
                continue;
            }
            let indices = Indices::from([("i".to_owned(), place)]);
            // The angular velocity, its rate and the acceleration come first.
            for (number, (name, _)) in statements.iter().enumerate() {
                let value = match number {
                    2 => base.clone(),
                    _ => Value::Vector(vec![Jet::ZERO; 3]),
                };
                around
                    .rates
                    .insert((name.written(&indices), name.dots), value);
            }
        }
        let behind = Indices::from([("i".to_owned(), last + 1)]);
        for letter in statements.iter().map(|(name, _)| *name) {
            let zero = Value::Scalar(Jet::ZERO);
            around
                .rates
                .insert((letter.written(&behind), letter.dots), zero);
        }
        for (left, ..) in &self.lines {
            if let Formula::Name(name) = left
                && name.below.len() == 1
            {
                let name = Name {
                    below: vec!["i".into()],
                    ..name.clone()
                };
                let written = name.written(&behind);
                let zero = Value::Scalar(Jet::ZERO);
                around.names.entry(written).or_insert(zero);
            }
        }
        Ok(())
    }
}

/// The equations of motion are all that are expected, each once.
fn compare(
    around: &mut Surroundings,
    equations: &[(&Formula, &Formula)],
    expected: &[f64],
) -> Reading<()> {
    let mut rest = expected.to_vec();
    for (left, right) in equations {
        let [left, right] = [left, right].map(|side| around.value(side)?.scalar());
        let residual = left?.value() - right?.value();
        let position = rest.iter().position(|other| close(*other, residual));
        let position = position.ok_or(format!("{residual} is none of {expected:?}"))?;
        rest.remove(position);
    }
    match rest.len() {
        0 => Ok(()),
        count => Err(format!("{count} equations are missing")),
    }
}
