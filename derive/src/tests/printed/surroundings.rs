//! What names in print mean at a state, and the values of formulas there.

use std::collections::BTreeMap;

use super::formula::Formula;
use super::jet::Jet;
use super::reader::close;
use super::token::{FUNCTIONS, Indices, Name, index_value};
use super::value::{Join, Reading, Value};

/// The value of an external function at some arguments.
pub(super) type External = fn(&str, &[f64]) -> f64;

/// What names mean.
#[derive(Clone, Debug)]
pub(super) struct Surroundings {
    /// By what is printed, without dots.
    pub(super) names: BTreeMap<String, Value>,
    pub(super) indices: Indices,
    /// The first and the last value of the indices of an equation.
    pub(super) ranges: BTreeMap<String, (i64, i64)>,
    pub(super) functions: Vec<String>,
    pub(super) external: External,
    /// Names with dots that are given by equations of their own, as those of a recursion.
    pub(super) rates: BTreeMap<(String, usize), Value>,
    /// The links behind the one that is spoken of.
    pub(super) behind: Vec<i64>,
}

impl Surroundings {
    /// Gives a name its meaning; an error where it has another one.
    pub(super) fn define(&mut self, written: &str, value: Value) -> Reading<()> {
        let found: Vec<f64> = value.components().iter().map(|x| x.value()).collect();
        let Some(before) = self.names.insert(written.to_owned(), value) else {
            return Ok(());
        };
        let before = before.components();
        let is_known = before.len() == found.len()
            && before.iter().zip(found).all(|(x, y)| close(x.value(), y));
        if is_known {
            return Ok(());
        }
        Err(format!("{written} has two meanings"))
    }

    /// The value of a formula.
    pub(super) fn value(&mut self, formula: &Formula) -> Reading<Value> {
        match formula {
            Formula::Number(number) => Ok(Value::Scalar(Jet::constant(*number))),
            Formula::Name(name) => self.named(name),
            Formula::Call(name, arguments) => self.call(name, arguments),
            Formula::Negative(x) => Ok(self.value(x)?.negated()),
            Formula::Terms(terms) => {
                let mut sum = Value::Scalar(Jet::ZERO);
                for (negative, term) in terms {
                    let term = self.value(term)?;
                    sum = sum.plus(&if *negative { term.negated() } else { term })?;
                }
                Ok(sum)
            }
            Formula::Product(x, y, join) => self.value(x)?.times(&self.value(y)?, *join),
            Formula::Quotient(x, y) => self.value(x)?.over(&self.value(y)?),
            Formula::Cross(x, y) => match (self.value(x)?, self.value(y)?) {
                (Value::Scalar(x), Value::Scalar(y)) if !x.is_zero() && !y.is_zero() => {
                    Ok(Value::Scalar(x * y))
                }
                (x, y) => x.cross(&y),
            },
            Formula::Power(x, exponent) => {
                let exponent = self.value(exponent)?.scalar()?;
                Ok(Value::Scalar(self.value(x)?.scalar()?.power(exponent)))
            }
            Formula::Transposed(x) => self.value(x)?.transposed(),
            Formula::Bars(x) => Ok(Value::Scalar(self.value(x)?.length()?)),
            Formula::Root(x) => Ok(Value::Scalar(self.value(x)?.scalar()?.sqrt())),
            Formula::List(list) => self.list(list),
            Formula::Rate(x) => Ok(self.value(x)?.rate()),
            Formula::Component(x, axis) => self.value(x)?.component(*axis),
            Formula::Sum {
                variable,
                bounds,
                term,
            } => {
                let [first, last] = bounds.each_ref().map(|bound| {
                    let index = index_value(bound, &self.indices);
                    index.ok_or(format!("the bound {bound} is no integer"))
                });
                self.sum(variable, first?..=last?, term)
            }
            Formula::SumOfOthers(variable, but, term) => {
                let range = self.ranges.get(but).zip(self.indices.get(but));
                let ((first, last), own) = range.ok_or(format!("others than which {but}?"))?;
                let (first, last, own) = (*first, *last, *own);
                let others = (first..=last).filter(move |index| *index != own);
                self.sum(variable, others, term)
            }
            Formula::SumOfLinks(variable, term) => self.sum_of_links(variable, term),
        }
    }

    /// A vector, or a matrix by its rows.
    fn list(&mut self, list: &[Formula]) -> Reading<Value> {
        let list = list.iter().map(|x| self.value(x));
        let list: Vec<_> = list.collect::<Reading<_>>()?;
        if list.iter().any(|row| matches!(row, Value::Vector(_))) {
            let rows = list.iter().map(Value::vector);
            return Ok(Value::Matrix(rows.collect::<Reading<_>>()?));
        }
        let list = list.iter().map(Value::scalar);
        Ok(Value::Vector(list.collect::<Reading<_>>()?))
    }

    fn sum_of_links(&mut self, variable: &String, term: &Formula) -> Reading<Value> {
        let mut sum = Value::Scalar(Jet::ZERO);
        for link in self.behind.clone() {
            self.indices.insert(variable.clone(), link);
            sum = sum.plus(&self.value(term)?)?;
        }
        self.indices.remove(variable);
        Ok(sum)
    }

    fn sum(
        &mut self,
        variable: &str,
        values: impl Iterator<Item = i64>,
        term: &Formula,
    ) -> Reading<Value> {
        if self.indices.contains_key(variable) || self.names.contains_key(variable) {
            return Err(format!("the index {variable} has another meaning"));
        }
        let mut sum = Value::Scalar(Jet::ZERO);
        for index in values {
            self.indices.insert(variable.to_owned(), index);
            let term = self.value(term);
            self.indices.remove(variable);
            sum = sum.plus(&term?)?;
        }
        Ok(sum)
    }

    fn named(&self, name: &Name) -> Reading<Value> {
        let written = name.written(&self.indices);
        if name.dots == 0
            && name.below.is_empty()
            && let Some(index) = self.indices.get(&name.letter)
        {
            #[allow(clippy::cast_precision_loss)] // Indices are small.
            return Ok(Value::Scalar(Jet::constant(*index as f64)));
        }
        if written == "π" {
            return Ok(Value::Scalar(Jet::constant(core::f64::consts::PI)));
        }
        if let Some(value) = self.rates.get(&(written.clone(), name.dots)) {
            return Ok(value.clone());
        }
        let Some(value) = self.names.get(&written) else {
            return unit_vector(name).ok_or(format!("{written} has no meaning"));
        };
        Ok(match name.dots {
            0 => value.clone(),
            1 => value.rate(),
            _ => value.rate().rate(),
        })
    }

    fn call(&mut self, name: &Name, arguments: &[Formula]) -> Reading<Value> {
        let arguments = arguments.iter().map(|argument| self.value(argument));
        let arguments: Vec<_> = arguments.collect::<Reading<_>>()?;
        let written = name.written(&self.indices);
        if self.functions.contains(&written) {
            let numbers = arguments.iter().map(|x| Ok(x.scalar()?.value()));
            let numbers: Vec<f64> = numbers.collect::<Reading<_>>()?;
            let value = (self.external)(&written, &numbers);
            return Ok(Value::Scalar(Jet([value, f64::NAN, f64::NAN])));
        }
        match (&*name.letter, &*name.below, &*arguments) {
            ("R", [axes], angles) => {
                let axes: Option<Vec<_>> = axes.chars().map(|axis| "xyz".find(axis)).collect();
                let axes = axes.ok_or("no axes")?;
                if axes.len() != angles.len() {
                    return Err(format!("{written} of {} angles", angles.len()));
                }
                let mut product = Value::Scalar(Jet::ONE);
                for (axis, angle) in axes.iter().zip(angles) {
                    let turn = Value::rotation(*axis, angle.scalar()?);
                    product = product.times(&turn, Join::Juxtaposed)?;
                }
                Ok(product)
            }
            ("ω", [], [rotation]) => rotation.angular_velocity(),
            ("diag", [], [only @ Value::Vector(diagonal)]) => {
                let components = only.components();
                let row = |i: usize| {
                    let mut row = vec![Jet::ZERO; diagonal.len()];
                    row[i] = components[i];
                    row
                };
                Ok(Value::Matrix((0..diagonal.len()).map(row).collect()))
            }
            ("diag", [], [x, y, z]) => {
                let diagonal = [x.scalar()?, y.scalar()?, z.scalar()?];
                let row = |i: usize| {
                    let mut row = vec![Jet::ZERO; 3];
                    row[i] = diagonal[i];
                    row
                };
                Ok(Value::Matrix((0..3).map(row).collect()))
            }
            ("atan2", [], [y, x]) => Ok(Value::Scalar(Jet::atan2(y.scalar()?, x.scalar()?))),
            (which @ ("min" | "max"), [], [x, y]) => {
                let (x, y) = (x.scalar()?, y.scalar()?);
                let first = (x.value() < y.value()) == (which == "min");
                Ok(Value::Scalar(if first { x } else { y }))
            }
            (function, [], [x]) if FUNCTIONS.contains(&function) => {
                let value = x.scalar()?.function(function);
                Ok(Value::Scalar(value.ok_or("no such function")?))
            }
            _ => Err(format!("{written} is no function")),
        }
    }
}

/// e with an axis below.
fn unit_vector(name: &Name) -> Option<Value> {
    let [axis] = &*name.below else {
        return None;
    };
    let axis = ["x", "y", "z"]
        .into_iter()
        .position(|other| other == axis)?;
    if name.letter != "e" || name.dots > 0 {
        return None;
    }
    let mut components = vec![Jet::ZERO; 3];
    components[axis] = Jet::ONE;
    Some(Value::Vector(components))
}
