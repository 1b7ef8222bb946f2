//! A page read line by line: what is defined gets its value, what is claimed is compared.

use std::collections::BTreeMap;

use super::formula::Formula;
use super::jet::Jet;
use super::lines::{Equation, Line, Notation};
use super::meanings::surroundings;
use super::recursion::Recursion;
use super::subject::{State, Subject, Values};
use super::surroundings::Surroundings;
use super::token::Indices;
use super::value::{Reading, Value};

/// Where a line stands.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum Part {
    Beginning,
    Events,
    Momenta,
    Energy,
    Lagrange,
    Recursion,
    Constraints,
    Solved,
}

/// The headings.
const HEADINGS: [(&str, Part); 8] = [
    ("Events, where a function vanishes:", Part::Events),
    ("Momenta ", Part::Momenta),
    ("Energy function ", Part::Energy),
    ("Lagrange's equations ", Part::Lagrange),
    ("Recursion of Newton and Euler ", Part::Recursion),
    ("Constraints:", Part::Constraints),
    ("Boltzmann", Part::Solved),
    ("Sol", Part::Solved),
];

/// What a page calls the coordinates, the momenta, the energies, L and h, unless it says otherwise.
const LETTERS: [&str; 7] = ["q", "p", "T", "V", "L", "h", "Q"];

/// Reads a page of a model at a state.
pub(super) struct Reader<'a> {
    pub(super) subject: &'a Subject,
    pub(super) notation: Notation,
    /// At accelerations at random.
    pub(super) free: Surroundings,
    pub(super) values: Values,
    /// At those of a motion.
    pub(super) moving: Surroundings,
    pub(super) part: Part,
    /// How many of Lagrange's equations were read.
    pub(super) read: usize,
    pub(super) momenta: usize,
    pub(super) constraints: usize,
    /// The values of the constraints that were not read yet.
    unread_constraints: Vec<f64>,
    pub(super) recursion: Recursion,
    /// The letters of T, V, L, h, p and q on this page.
    pub(super) letters: BTreeMap<&'static str, String>,
    /// What the sides of equations are worth, line by line.
    pub(super) found: Vec<Vec<f64>>,
}

/// Whether two numbers are equal but for rounding.
pub(super) fn close(x: f64, y: f64) -> bool {
    (x - y).abs() <= 1e-8 * (1.0 + x.abs().max(y.abs()))
}

impl<'a> Reader<'a> {
    /// None where the equations are singular.
    pub(super) fn new(
        subject: &'a Subject,
        notation: Notation,
        state: &State,
    ) -> Reading<Option<Self>> {
        let values = subject.values(state);
        let Some((accelerations, multipliers)) = values.solution() else {
            return Ok(None);
        };
        let moving = State {
            accelerations,
            multipliers,
            ..state.clone()
        };
        Ok(Some(Self {
            free: surroundings(subject, state)?,
            moving: surroundings(subject, &moving)?,
            subject,
            notation,
            unread_constraints: values.constraints.clone(),
            values,
            part: Part::Beginning,
            read: 0,
            momenta: 0,
            constraints: 0,
            recursion: Recursion::default(),
            found: Vec::new(),
            letters: LETTERS.map(|letter| (letter, letter.to_owned())).into(),
        }))
    }

    /// Reads a page; an error at the first line that is not understood or not true.
    pub(super) fn read(&mut self, page: &str) -> Reading<()> {
        for line in self.notation.lines(page)? {
            match line {
                Line::Words(words) => self.words(&words).map_err(|e| format!("{words}\n{e}"))?,
                Line::Equation(equation) => {
                    let read = self.equation(&equation);
                    read.map_err(|e| format!("{}\n{e}", equation.text))?;
                }
            }
        }
        self.end_part()
    }

    /// Begins a part.
    pub(super) fn begin(&mut self, words: &str) -> Reading<bool> {
        let heading = HEADINGS.iter().find(|(start, _)| words.starts_with(start));
        match heading {
            Some((_, part)) if words.ends_with(':') => {
                self.end_part()?;
                self.part = *part;
                if self.part == Part::Energy {
                    self.energies_left_out();
                }
                Ok(true)
            }
            _ => Ok(false),
        }
    }

    /// T and V where they are too long to be printed, so that their rates are not known.
    fn energies_left_out(&mut self) {
        if let [kinetic, potential] = &*self.values.energies {
            for (letter, energy) in [("T", *kinetic), ("V", *potential)] {
                let value = Value::Scalar(Jet([energy, f64::NAN, f64::NAN]));
                for surroundings in [&mut self.free, &mut self.moving] {
                    let names = &mut surroundings.names;
                    names
                        .entry(self.letters[letter].clone())
                        .or_insert_with(|| value.clone());
                }
            }
        }
    }

    fn end_part(&mut self) -> Reading<()> {
        let n = self.subject.coordinates;
        match self.part {
            Part::Momenta if self.momenta != n => {
                Err(format!("{} of {n} momenta are spoken of", self.momenta))
            }
            Part::Lagrange if self.read != n => {
                Err(format!("{} of {n} equations are spoken of", self.read))
            }
            Part::Constraints if self.constraints != self.values.constraints.len() => {
                let (read, all) = (self.constraints, self.values.constraints.len());
                Err(format!("{read} of {all} constraints are spoken of"))
            }
            Part::Recursion => {
                let expected = &self.values.inverse_dynamics;
                self.recursion.check(&mut self.free, expected)
            }
            _ => Ok(()),
        }
    }

    fn equation(&mut self, equation: &Equation) -> Reading<()> {
        let mut found = Vec::new();
        let raw = equation.sides[0].as_str();
        if self.part == Part::Recursion {
            let [left, right] = equation
                .sides
                .each_ref()
                .map(|side| self.notation.formula(side));
            self.recursion.note(left?, right?, &equation.cases());
            return Ok(());
        }
        let energy = &self.letters["h"];
        if [
            format!("d{energy}/dt"),
            format!("\\frac{{d{energy}}}{{dt}}"),
        ]
        .contains(&raw.to_owned())
        {
            let right = self.notation.formula(&equation.sides[1])?;
            return self.rate_of_energy(&right);
        }
        if let Some(event) = self.event(raw) {
            let right = self.notation.formula(&equation.sides[1])?;
            let value = self.free.value(&right)?.scalar()?.value();
            self.found.push(vec![value]);
            return same(value, self.values.events[event?]);
        }
        let [left, right] = equation
            .sides
            .each_ref()
            .map(|side| self.notation.formula(side));
        let (left, right) = (left?, right?);
        let ranges = equation.ranges.iter();
        let ranges = ranges.map(|(variable, first, last)| (variable.clone(), (*first, *last)));
        let ranges: BTreeMap<_, _> = ranges.collect();
        for case in equation.cases() {
            let case_text = format!("{case:?}");
            for surroundings in [&mut self.free, &mut self.moving] {
                surroundings.indices.clone_from(&case);
                surroundings.ranges.clone_from(&ranges);
            }
            let read = self.case(&left, &right, &case);
            for surroundings in [&mut self.free, &mut self.moving] {
                surroundings.indices.clear();
                surroundings.ranges.clear();
            }
            found.extend(read.map_err(|e| format!("{e} at {case_text}"))?);
        }
        self.found.push(found);
        Ok(())
    }

    /// Reads an equation for some values of its indices.
    fn case(&mut self, left: &Formula, right: &Formula, case: &Indices) -> Reading<Vec<f64>> {
        if let Formula::Name(name) = left
            && name.dots == 0
        {
            let written = name.written(case);
            if written == self.letters["q"] && self.part == Part::Beginning && self.found.is_empty()
            {
                return self.coordinates(right);
            }
            if let Some(i) = self.momentum(&written) {
                self.momenta += 1;
                let value = self.define(&written, right)?;
                same(value.scalar()?.value(), self.values.momenta[i])?;
                return Ok(vec![value.scalar()?.value()]);
            }
            if let Some(expected) = self.declared(&written) {
                let value = self.define(&written, right)?;
                same(value.scalar()?.value(), expected)?;
                return Ok(vec![expected]);
            }
            if !self.free.names.contains_key(&written) {
                let value = self.define(&written, right)?;
                return Ok(value.components().iter().map(|x| x.value()).collect());
            }
        }
        match self.part {
            Part::Lagrange => self.equation_of_motion(left, right),
            Part::Constraints => self.constraint(left, right),
            Part::Solved => {
                let sides = [left, right].map(|side| self.moving.value(side)?.scalar());
                let [left, right] = sides;
                let (left, right) = (left?.value(), right?.value());
                same(left, right)?;
                Ok(vec![left, right])
            }
            part => Err(format!("what is this in {part:?}?")),
        }
    }

    fn coordinates(&self, right: &Formula) -> Reading<Vec<f64>> {
        let list = match right {
            Formula::List(list) => list.clone(),
            only => vec![only.clone()],
        };
        let mut surroundings = self.free.clone();
        let values = list.iter().map(|x| surroundings.value(x)?.scalar());
        let values: Vec<Jet> = values.collect::<Reading<_>>()?;
        let expected = self.subject.coordinate_names();
        let expected = expected
            .iter()
            .map(|name| self.free.names.get(name).cloned());
        let expected: Vec<_> = expected.collect();
        let found: Vec<_> = values.iter().map(|x| Some(Value::Scalar(*x))).collect();
        if found != expected {
            return Err("these are not the coordinates".into());
        }
        Ok(values.iter().map(|x| x.value()).collect())
    }

    /// Gives a name the value of a formula.
    fn define(&mut self, written: &str, right: &Formula) -> Reading<Value> {
        let moving = self.moving.value(right)?;
        self.moving.define_with_components(written, moving)?;
        let value = self.free.value(right)?;
        self.free.define_with_components(written, value.clone())?;
        Ok(value)
    }

    /// The value that a name has by the declaration or by the equations, if it has one.
    fn declared(&self, written: &str) -> Option<f64> {
        let energies = match self.values.energies.len() {
            1 => &["L"][..],
            _ => &["T", "V"],
        };
        let names = energies.iter().chain(&["h"]);
        let values = self.values.energies.iter().chain([&self.values.energy]);
        let mut own = names.zip(values);
        let own = own.find(|(name, _)| self.letters[*name] == written);
        if let Some((_, value)) = own {
            return Some(*value);
        }
        let position = self.subject.definition(written)?;
        self.values.definitions.get(position).copied()
    }

    fn momentum(&self, written: &str) -> Option<usize> {
        let coordinate = written
            .strip_prefix(&self.letters["p"])?
            .strip_prefix('_')?;
        if self.part != Part::Momenta {
            return None;
        }
        let names = self.subject.coordinate_names();
        names.iter().position(|name| name == coordinate)
    }

    /// The function of which event this is the left side.
    fn event(&self, left: &str) -> Option<Reading<usize>> {
        if self.part != Part::Events {
            return None;
        }
        let name = match self.notation {
            Notation::Unicode => left.strip_prefix("g[")?.strip_suffix(']')?.to_owned(),
            Notation::Latex => {
                let name = left.strip_prefix("g_{\\mathrm{")?.strip_suffix("}}")?;
                name.replace("\\_", "_")
            }
        };
        let mut events = self.subject.declared.events.iter();
        let position = events.position(|(event, _)| *event == name);
        Some(position.ok_or(format!("no event {name}")))
    }

    /// The next of Lagrange's equations of which both sides are these.
    fn equation_of_motion(&mut self, left: &Formula, right: &Formula) -> Reading<Vec<f64>> {
        let left = self.free.value(left)?.scalar()?.value();
        let right = self.free.value(right)?.scalar()?.value();
        let Values {
            inverse_dynamics,
            forces,
            ..
        } = &self.values;
        let mut rows = inverse_dynamics.iter().zip(forces).enumerate();
        let fits = |(_, (residual, force)): &(usize, (&f64, &f64))| {
            close(left - right, **residual) && close(right, **force)
        };
        match rows.find(fits) {
            Some(_) => {
                self.read += 1;
                Ok(vec![left, right])
            }
            None => Err(format!(
                "{left} − {right} = {} is none of {inverse_dynamics:?}, with {right} of {forces:?}",
                left - right
            )),
        }
    }

    /// A constraint that was not read before; families are printed component by component.
    fn constraint(&mut self, left: &Formula, right: &Formula) -> Reading<Vec<f64>> {
        let sides = [left, right].map(|side| self.free.value(side)?.scalar());
        let [left, right] = sides;
        let (left, right) = (left?.value(), right?.value());
        self.constraints += 1;
        let unread = &mut self.unread_constraints;
        let found = unread.iter().position(|x| close(left - right, *x));
        let Some(position) = found else {
            return Err(format!("{left} − {right} is none of {unread:?}"));
        };
        unread.swap_remove(position);
        Ok(vec![left, right])
    }

    fn rate_of_energy(&mut self, right: &Formula) -> Reading<()> {
        let found = self.moving.value(right)?.scalar()?.value();
        self.found.push(vec![found]);
        same_if_known(self.rate(&self.letters["h"]), found)
    }

    /// The rate of what is called so, in a motion.
    pub(super) fn rate(&self, written: &str) -> f64 {
        let value = self.moving.names.get(written);
        value.map_or(f64::NAN, |value| value.rate().components()[0].value())
    }
}

/// An error where numbers differ.
pub(super) fn same(found: f64, expected: f64) -> Reading<()> {
    if close(found, expected) {
        return Ok(());
    }
    Err(format!("{found} is printed, {expected} is computed"))
}

/// The same where the second is a number: rates of external functions are not known.
pub(super) fn same_if_known(known: f64, found: f64) -> Reading<()> {
    if known.is_nan() {
        return Ok(());
    }
    same(found, known)
}
