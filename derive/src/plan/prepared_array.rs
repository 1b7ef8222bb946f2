//! The array that `prepare` returns: all that the methods of an integration's loop read beside the state and the inputs.

use lagrangian_symbolic::{Operand, OutputGroup, Rational, Symbol};

use super::method::Method;
use super::methods::Methods;
use super::reduced_methods::ReducedMethods;
use super::series_methods::SeriesMethods;

/// The parameters that these methods read, in the order of their declaration, and behind them what depends on parameters alone.
#[derive(Clone, Debug, Default)]
pub(crate) struct PreparedArray {
    /// In order.
    parameters: Vec<Symbol>,
    /// How many values there are that depend on parameters alone.
    derived: usize,
    /// Whether the rank of the constraints stands behind all others.
    has_rank: bool,
}

impl PreparedArray {
    /// That of a model with these methods.
    pub(crate) fn of(methods: &Methods, series: Option<&SeriesMethods>) -> Self {
        let groups = &methods.prepare.program.groups;
        let mut array = Self {
            parameters: Vec::new(),
            derived: groups.first().map_or(0, |group| group.outputs.len()),
            has_rank: methods.constraints.is_some(),
        };
        for (emitted, method) in methods.all() {
            if emitted.row().takes_prepared() {
                array.add(method);
            }
        }
        let constraints = methods.constraints.as_ref();
        if let Some(pivots) = constraints.and_then(|methods| methods.pivots.as_ref()) {
            array.add(pivots);
        }
        if let Some(series) = series {
            array.add(&series.motion.initial);
            let events = series.events.iter().map(|events| &events.series);
            let branches = series.branches.iter().map(|branches| &branches.series);
            for series in events.chain(branches) {
                array.add(&series.initial);
            }
        }
        array
    }

    /// Adds what the methods of a reduced model read besides.
    pub(crate) fn add_reduced(&mut self, methods: &ReducedMethods) {
        self.add(&methods.ignorable_velocities);
        if let Some(series) = &methods.series {
            self.add(&series.initial);
        }
    }

    fn add(&mut self, method: &Method) {
        let symbols = method.program.symbols().into_iter();
        let parameters = symbols.filter(|symbol| matches!(symbol, Symbol::Parameter(_)));
        self.parameters.extend(parameters);
        self.parameters.sort_unstable();
        self.parameters.dedup();
    }

    pub(crate) fn len(&self) -> usize {
        self.parameters.len() + self.derived + usize::from(self.has_rank)
    }

    /// The index of the rank of the constraints.
    pub(crate) fn rank(&self) -> Option<usize> {
        self.has_rank.then(|| self.len() - 1)
    }

    /// The index of the value of a symbol, if it is in the array.
    pub(crate) fn index(&self, symbol: Symbol) -> Option<usize> {
        match symbol {
            Symbol::Invariant(i) => Some(self.parameters.len() + i as usize),
            _ => self.parameters.binary_search(&symbol).ok(),
        }
    }

    /// The method that computes the array: the program for the values that depend on parameters alone, with the parameters before
    /// its outputs.
    pub(crate) fn method(&self, prepare: &Method) -> Method {
        let mut program = prepare.program.clone();
        if self.has_rank && program.groups.is_empty() {
            program.groups.push(OutputGroup::default());
        }
        if let Some(group) = program.groups.first_mut() {
            let parameters = self.parameters.iter().copied().map(Operand::Symbol);
            group.outputs.splice(..0, parameters);
            if self.has_rank {
                group.outputs.push(Operand::Constant(Rational::ZERO));
            }
        }
        Method {
            count: prepare.count,
            ..Method::preparation(program)
        }
    }
}
