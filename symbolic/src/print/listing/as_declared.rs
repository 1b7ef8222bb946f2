//! Equations as they were declared, with their vectors and their sums, for what is long when it is written out.

use std::collections::BTreeSet;

use crate::print::printed::Printed;

/// A line that is printed as it was declared.
#[derive(Clone, Debug)]
pub struct DeclaredLine {
    /// What is defined: the name of a definition, or T, V or L.
    pub name: String,
    /// The left side.
    pub left: Printed,
    /// The right side.
    pub right: Printed,
    /// The definitions that the right side mentions.
    pub mentions: BTreeSet<String>,
}

/// The energies and the definitions as they were declared, as far as they can be printed.
#[derive(Clone, Debug, Default)]
pub struct AsDeclared {
    /// T and V, or L.
    pub energies: Vec<DeclaredLine>,
    /// The definitions, in order.
    pub definitions: Vec<DeclaredLine>,
}

impl AsDeclared {
    /// The definitions that are mentioned, and those that these mention.
    pub(crate) fn definitions_of(&self, mentioned: &BTreeSet<String>) -> Vec<&DeclaredLine> {
        let mut needed = mentioned.clone();
        // A definition mentions those before it, and members of its own family.
        for line in self.definitions.iter().rev() {
            if needed.contains(&line.name) {
                needed.extend(line.mentions.iter().cloned());
            }
        }
        let lines = self.definitions.iter();
        lines.filter(|line| needed.contains(&line.name)).collect()
    }
}
