//! For what processor both sides are compiled.

/// The flags of one run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Flags {
    /// For this processor.
    Native,
    /// For any of its family, as the compilers do unless they are told.
    Default,
}

impl Flags {
    pub(crate) const ALL: [Self; 2] = [Self::Native, Self::Default];

    /// In the names of files.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Native => "native",
            Self::Default => "default",
        }
    }

    /// For rustc.
    pub(crate) fn rust(self) -> &'static str {
        match self {
            Self::Native => "-C target-cpu=native",
            Self::Default => "",
        }
    }

    /// For gcc.
    pub(crate) fn c(self) -> &'static [&'static str] {
        match self {
            Self::Native => &["-O3", "-march=native"],
            Self::Default => &["-O3"],
        }
    }
}
