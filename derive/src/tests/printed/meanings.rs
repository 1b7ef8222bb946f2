//! What the names of a model mean at a state.

use std::collections::BTreeMap;

use super::jet::Jet;
use super::subject::{State, Subject, external};
use super::surroundings::Surroundings;
use super::token::Indices;
use super::value::{Reading, Value};

impl Subject {
    /// The coordinates as they are printed.
    pub(super) fn coordinate_names(&self) -> Vec<String> {
        let names = self.declared.names.coordinates.iter();
        names
            .map(|name| self.spelled.written(name, false))
            .collect()
    }

    /// The position of the definition that is printed so.
    pub(super) fn definition(&self, written: &str) -> Option<usize> {
        let mut definitions = self.declared.definitions.iter();
        definitions.position(|(name, _)| self.spelled.written(name, false) == written)
    }
}

/// The meanings of all declared names but those of definitions.
pub(super) fn surroundings(subject: &Subject, state: &State) -> Reading<Surroundings> {
    let names = &subject.declared.names;
    let spelled = &subject.spelled;
    let mut surroundings = Surroundings {
        names: BTreeMap::new(),
        indices: Indices::new(),
        ranges: BTreeMap::new(),
        functions: subject.functions.clone(),
        external,
        rates: BTreeMap::new(),
        behind: Vec::new(),
    };
    let moving = |i: usize| {
        Jet([
            state.positions[i],
            state.velocities[i],
            state.accelerations[i],
        ])
    };
    let coordinates = names.coordinates.iter().enumerate();
    let coordinates = coordinates.map(|(i, name)| (name, moving(i), false));
    let parameters = names.parameters.iter().zip(&state.parameters);
    let parameters = parameters.map(|(name, x)| (name, Jet::constant(*x), true));
    let inputs = names.inputs.iter().zip(&state.inputs);
    let inputs = inputs.map(|(name, x)| (name, Jet([*x, f64::NAN, f64::NAN]), false));
    let multipliers = names.multipliers.iter().zip(&state.multipliers);
    let multipliers = multipliers.map(|(name, x)| (name, Jet([*x, f64::NAN, f64::NAN]), false));
    let all = coordinates.chain(parameters).chain(inputs);
    let mut whole: BTreeMap<String, Parts> = BTreeMap::new();
    for (name, value, is_parameter) in all.chain(multipliers) {
        let written = spelled.written(name, is_parameter);
        if surroundings.names.contains_key(&written) {
            return Err(format!("{written} has two meanings"));
        }
        surroundings.names.insert(written, Value::Scalar(value));
        for (stem, row) in containers(name) {
            let stem = spelled.written(&stem, is_parameter);
            whole.entry(stem).or_default().push((row, value));
        }
    }
    for (stem, parts) in whole {
        if let Some(value) = container(&parts) {
            surroundings.names.entry(stem).or_insert(value);
        }
    }
    let time = Jet([state.time, 1.0, 0.0]);
    let names = &mut surroundings.names;
    names.entry("t".into()).or_insert(Value::Scalar(time));
    Ok(surroundings)
}

/// Where components stand: in order, in a row of a matrix, at a place of a vector, or at several of a matrix.
#[derive(Clone, Copy)]
enum Place {
    Next,
    Row(usize),
    Axis(usize),
    Entry(usize, usize),
}

type Parts = Vec<(Place, Jet)>;

/// The vector or matrix of which a name is a component: `center[0]` of `center[0].x`; of a body, `r_C` of `x_C` and I of `I_12`.
fn containers(name: &str) -> Vec<(String, Place)> {
    let mut found = Vec::new();
    if let Some((stem, pair)) = name.rsplit_once("[(") {
        let row = pair.split_once(',').and_then(|(row, _)| row.parse().ok());
        found.push((stem.to_owned(), Place::Row(row.unwrap_or(0))));
    } else if let Some((stem, _)) = name.rsplit_once('[').filter(|_| name.ends_with(']')) {
        found.push((stem.to_owned(), Place::Next));
    } else if let Some((stem, _)) = name.rsplit_once('.') {
        found.push((stem.to_owned(), Place::Next));
    }
    let parts: Vec<&str> = name.split('_').collect();
    if let [axis, center, rest @ ..] = &*parts
        && center.starts_with('C')
        && let Some(axis) = ["x", "y", "z"].iter().position(|other| other == axis)
    {
        let stem = [&["r", *center], rest].concat().join("_");
        found.push((stem, Place::Axis(axis)));
    }
    if let [first @ .., digits] = &*parts
        && first.first().is_some_and(|first| first.starts_with('I'))
    {
        let digits: Option<Vec<_>> = digits.chars().map(|c| c.to_digit(10)).collect();
        let digits = digits.unwrap_or_default();
        let index = |digit: u32| (digit as usize).saturating_sub(1).min(2);
        match &*digits {
            [k] => found.push((first.join("_"), Place::Entry(index(*k), index(*k)))),
            [i, j] => found.push((first.join("_"), Place::Entry(index(*i), index(*j)))),
            _ => {}
        }
    }
    found
}

fn container(parts: &Parts) -> Option<Value> {
    let mut rows: Vec<Vec<Jet>> = Vec::new();
    let mut next = Vec::new();
    for (place, value) in parts {
        match place {
            Place::Next => next.push(*value),
            Place::Axis(axis) => {
                next.resize(3, Jet::ZERO);
                next[*axis] = *value;
            }
            Place::Row(row) => {
                rows.resize(rows.len().max(row + 1), Vec::new());
                rows[*row].push(*value);
            }
            Place::Entry(i, j) => {
                rows.resize(3, vec![Jet::ZERO; 3]);
                rows[*i][*j] = *value;
                rows[*j][*i] = *value;
            }
        }
    }
    // A symmetric body has I₁ about both axes across.
    let is_given = |axis: usize| {
        let mut places = parts.iter();
        places.any(|(place, _)| matches!(place, Place::Entry(i, j) if (*i, *j) == (axis, axis)))
    };
    if is_given(0) && !is_given(1) {
        rows[1][1] = rows[0][0];
    }
    match (rows.is_empty(), next.is_empty()) {
        (true, false) => Some(Value::Vector(next)),
        (false, true) => Some(Value::Matrix(rows)),
        _ => None,
    }
}

impl Surroundings {
    /// Gives a name its value, and those of its components theirs.
    pub(super) fn define_with_components(&mut self, written: &str, value: Value) -> Reading<()> {
        if let Value::Vector(components) = &value {
            for (axis, component) in ["x", "y", "z"].into_iter().zip(components) {
                let component = Value::Scalar(*component);
                self.names.insert(format!("{written}_{axis}"), component);
            }
        }
        self.define(written, value)
    }
}

/// The solution of M x = f by elimination with the largest pivots; none where M is singular.
pub(super) fn linear_solution(mass: &[f64], forcing: &[f64]) -> Option<Vec<f64>> {
    let n = forcing.len();
    let mut rows: Vec<Vec<f64>> = (0..n)
        .map(|i| [&mass[i * n..(i + 1) * n], &forcing[i..=i]].concat())
        .collect();
    for k in 0..n {
        let best = (k..n).max_by(|i, j| rows[*i][k].abs().total_cmp(&rows[*j][k].abs()))?;
        rows.swap(k, best);
        if rows[k][k].abs() < 1e-7 {
            return None;
        }
        for i in 0..n {
            if i != k {
                let factor = rows[i][k] / rows[k][k];
                let pivot = rows[k].clone();
                rows[i]
                    .iter_mut()
                    .zip(&pivot)
                    .for_each(|(x, p)| *x -= factor * p);
            }
        }
    }
    Some((0..n).map(|k| rows[k][n] / rows[k][k]).collect())
}
