//! Which passes of the derivation are switched off.

use lagrangian_symbolic::Pass;

/// What is switched off.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Off {
    Nothing,
    One(Pass),
    Everything,
}

impl Off {
    /// The lines of the table.
    pub(crate) fn all() -> impl Iterator<Item = Self> {
        let one = Pass::ALL.iter().copied().map(Self::One);
        let first = [Self::Nothing].into_iter();
        first.chain(one).chain([Self::Everything])
    }

    /// In the table, and in the names of files.
    pub(crate) fn label(self) -> &'static str {
        match self {
            Self::Nothing => "nothing",
            Self::One(pass) => pass.name(),
            Self::Everything => "everything",
        }
    }

    /// As the derive reads it.
    pub(crate) fn passes(self) -> String {
        let off = match self {
            Self::Nothing => Vec::new(),
            Self::One(pass) => vec![pass.name()],
            Self::Everything => Pass::ALL.iter().map(|pass| pass.name()).collect(),
        };
        off.join(",")
    }
}
