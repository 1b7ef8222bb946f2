//! Tapes: expressions and programs as lists of elementary operations, run forward on numbers and backward
//! for gradients (reverse accumulation: Griewank and Walther, Evaluating Derivatives, 2nd edition 2008,
//! chapter 3).
//!
//! An expression is recorded node by node, without simplification. A run may perturb every result a little.

mod expressions;
mod programs;
mod stand_ins;

pub(crate) use stand_ins::StandIns;

use crate::validation::hyper_dual::HyperDual;
use crate::validation::number::Number;
use crate::validation::perturbation::Perturbation;
use crate::{Binary, ExternalFunction, Symbol, Unary};

/// The position of a result on a tape.
type Slot = u32;

/// One elementary operation.
#[derive(Clone, Copy, Debug)]
enum Entry {
    Symbol(Symbol),
    Constant(f64),
    Add(Slot, Slot),
    Subtract(Slot, Slot),
    Multiply(Slot, Slot),
    Divide(Slot, Slot),
    Scale(f64, Slot),
    Power(f64, Slot),
    Unary(Unary, Slot),
    Binary(Binary, Slot, Slot),
    /// An external function: the start and number of its arguments, and whether as many partial derivatives follow
    /// them.
    Apply(ExternalFunction, Slot, Slot, bool),
}

/// A list of operations, and where the results are.
#[derive(Clone, Debug, Default)]
pub struct Tape {
    entries: Vec<Entry>,
    /// Arguments and partial derivatives of external functions.
    arguments: Vec<Slot>,
    outputs: Vec<Slot>,
}

/// The value of an external function, which is unknown: a smooth, positive function, different for each.
#[allow(clippy::cast_precision_loss)] // The index is small.
fn unknown_function<N: Number>(function: ExternalFunction, arguments: &[N]) -> f64 {
    let mut phase = function.index() as f64;
    for (position, x) in arguments.iter().enumerate() {
        phase += (0.7 + 0.2 * position as f64) * x.value();
    }
    1.3 + 0.7 * libm::sin(phase)
}

/// Whether a result is below the smallest normal number, where rounding is no longer relative to it.
fn is_lost<N: Number>(entry: &Entry, result: N, values: &[N]) -> bool {
    if result.value().abs() >= f64::MIN_POSITIVE {
        return false;
    }
    let exists = |slot: Slot| values[slot as usize].value().abs() > 0.0;
    match *entry {
        Entry::Multiply(x, y) => exists(x) && exists(y),
        Entry::Divide(x, _) | Entry::Power(_, x) => exists(x),
        Entry::Scale(factor, x) => factor.abs() > 0.0 && exists(x),
        Entry::Unary(function, _) => matches!(
            function,
            Unary::Exp | Unary::Sech | Unary::Logistic | Unary::Softplus
        ),
        _ => false,
    }
}

impl Tape {
    fn application(
        &mut self,
        function: ExternalFunction,
        arguments: &[Slot],
        slopes: &[Slot],
    ) -> Entry {
        let start = position(self.arguments.len());
        self.arguments.extend_from_slice(arguments);
        self.arguments.extend_from_slice(slopes);
        let has_slopes = !slopes.is_empty();
        Entry::Apply(function, start, position(arguments.len()), has_slopes)
    }

    fn push(&mut self, entry: Entry) -> Slot {
        self.entries.push(entry);
        position(self.entries.len() - 1)
    }

    /// The positions of the outputs.
    pub(crate) fn outputs(&self) -> &[Slot] {
        &self.outputs
    }

    /// The values of the outputs alone.
    pub(crate) fn evaluate<N: Number>(
        &self,
        symbol: &dyn Fn(Symbol) -> N,
        perturbation: Perturbation,
    ) -> Vec<N> {
        self.outputs_of(&self.run(symbol, perturbation))
    }

    /// The values of the outputs among those of all entries.
    pub(crate) fn outputs_of<N: Number>(&self, values: &[N]) -> Vec<N> {
        let outputs = self.outputs.iter();
        outputs.map(|slot| values[*slot as usize]).collect()
    }

    /// The values of all entries.
    pub(crate) fn run<N: Number>(
        &self,
        symbol: &dyn Fn(Symbol) -> N,
        perturbation: Perturbation,
    ) -> Vec<N> {
        let mut results = vec![N::constant(0.0); self.entries.len()];
        // Macros run without optimization: a plain loop over slices.
        let (values, entries) = (&mut results[..], &self.entries[..]);
        let mut position = 0;
        while position < entries.len() {
            let value = match entries[position] {
                Entry::Symbol(x) => symbol(x),
                Entry::Constant(x) => N::constant(x),
                Entry::Add(x, y) => values[x as usize] + values[y as usize],
                Entry::Subtract(x, y) => values[x as usize] - values[y as usize],
                Entry::Multiply(x, y) => values[x as usize] * values[y as usize],
                Entry::Divide(x, y) => values[x as usize] / values[y as usize],
                Entry::Scale(factor, x) => values[x as usize].scaled(factor),
                Entry::Power(k, x) => values[x as usize].power(k),
                Entry::Unary(function, x) => values[x as usize].unary(function),
                Entry::Binary(function, x, y) => {
                    values[x as usize].binary(function, values[y as usize])
                }
                Entry::Apply(function, start, count, has_slopes) => {
                    let [arguments, slopes] = self.operands(values, start, count, has_slopes);
                    let value = unknown_function(function, &arguments);
                    N::composed(value, &slopes, &arguments)
                }
            };
            let is_loaded = matches!(entries[position], Entry::Symbol(_) | Entry::Constant(_));
            values[position] = match perturbation.0 {
                Some(_) if !is_loaded => {
                    let value = value.scaled(perturbation.factor(position));
                    if is_lost(&entries[position], value, values) {
                        value.shifted(perturbation.shift(position))
                    } else {
                        value
                    }
                }
                _ => value,
            };
            position += 1;
        }
        results
    }

    /// The arguments of an external function, and its partial derivatives if they are known.
    fn operands<N: Number>(
        &self,
        values: &[N],
        start: Slot,
        count: Slot,
        has_slopes: bool,
    ) -> [Vec<N>; 2] {
        let (start, count) = (start as usize, count as usize);
        let of = |slots: &[Slot]| slots.iter().map(|slot| values[*slot as usize]).collect();
        let arguments = of(&self.arguments[start..start + count]);
        let slopes = if has_slopes {
            of(&self.arguments[start + count..start + 2 * count])
        } else {
            Vec::new()
        };
        [arguments, slopes]
    }

    /// The derivatives of Σ wᵢ·outputᵢ by the symbols, which `receive` gets one by one; `values` are those of
    /// all entries.
    pub(crate) fn gradient(
        &self,
        values: &[HyperDual],
        weights: &[(Slot, f64)],
        perturbation: Perturbation,
        receive: &mut dyn FnMut(Symbol, HyperDual),
    ) {
        let mut adjoints = vec![HyperDual::default(); self.entries.len()];
        let (adjoints, entries) = (&mut adjoints[..], &self.entries[..]);
        for (slot, weight) in weights {
            let adjoint = &mut adjoints[*slot as usize];
            *adjoint = *adjoint + HyperDual::constant(*weight);
        }
        let mut next = entries.len();
        while next > 0 {
            next -= 1;
            let mut adjoint = adjoints[next];
            if adjoint.is_zero() {
                continue;
            }
            if perturbation.0.is_some() {
                adjoint = adjoint.scaled(perturbation.factor(entries.len() + next));
            }
            let mut add = |slot: Slot, change: HyperDual| {
                adjoints[slot as usize] = adjoints[slot as usize] + change;
            };
            if let Entry::Symbol(symbol) = entries[next] {
                receive(symbol, adjoint);
            }
            self.propagate(values, next, adjoint, &mut add);
        }
    }

    /// Adds the adjoint of the entry at `position` to those of its operands, each times the partial derivative.
    fn propagate(
        &self,
        values: &[HyperDual],
        position: usize,
        adjoint: HyperDual,
        add: &mut dyn FnMut(Slot, HyperDual),
    ) {
        match self.entries[position] {
            Entry::Symbol(_) | Entry::Constant(_) => {}
            Entry::Add(x, y) => {
                add(x, adjoint);
                add(y, adjoint);
            }
            Entry::Subtract(x, y) => {
                add(x, adjoint);
                add(y, -adjoint);
            }
            Entry::Multiply(x, y) => {
                add(x, adjoint * values[y as usize]);
                add(y, adjoint * values[x as usize]);
            }
            Entry::Divide(x, y) => {
                let change = adjoint * values[y as usize].reciprocal();
                add(x, change);
                add(y, -(change * values[position]));
            }
            Entry::Scale(factor, x) => add(x, adjoint.scaled(factor)),
            Entry::Power(k, x) => add(x, adjoint * values[x as usize].power_slope(k)),
            Entry::Unary(function, x) => add(x, adjoint * values[x as usize].slope(function)),
            Entry::Binary(function, x, y) => {
                let slopes = values[x as usize].slopes(function, values[y as usize]);
                add(x, adjoint * slopes[0]);
                add(y, adjoint * slopes[1]);
            }
            Entry::Apply(_, start, count, has_slopes) => {
                let [_, slopes] = self.operands(values, start, count, has_slopes);
                for (slope, x) in slopes.iter().zip(&self.arguments[start as usize..]) {
                    add(*x, adjoint * *slope);
                }
            }
        }
    }
}

fn position(index: usize) -> Slot {
    // Four billion entries do not fit into a compiler's memory.
    Slot::try_from(index).unwrap_or(Slot::MAX)
}
