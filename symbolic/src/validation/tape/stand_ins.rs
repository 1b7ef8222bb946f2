//! External functions that stand for others which have the same values.

use std::collections::BTreeMap;

use crate::ExternalFunction;
use crate::validation::tape::{Entry, Tape};

/// External functions, and which others have their values.
#[derive(Clone, Default, Debug)]
pub(crate) struct StandIns(BTreeMap<ExternalFunction, ExternalFunction>);

impl StandIns {
    /// Lets `other` stand for `function`, for which nothing stands yet, nor it for `other`.
    pub(crate) fn replace(&mut self, function: ExternalFunction, other: ExternalFunction) {
        for stand_in in self.0.values_mut() {
            if *stand_in == function {
                *stand_in = other;
            }
        }
        self.0.insert(function, other);
    }

    /// The function that stands for this one.
    pub(crate) fn of(&self, function: ExternalFunction) -> ExternalFunction {
        self.0.get(&function).copied().unwrap_or(function)
    }
}

impl Tape {
    /// Applies the functions that stand for others in their place.
    pub(crate) fn use_stand_ins(&mut self, stand_ins: &StandIns) {
        for entry in &mut self.entries {
            if let Entry::Apply(function, ..) = entry {
                *function = stand_ins.of(*function);
            }
        }
    }
}
