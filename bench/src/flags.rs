//! For what processor both sides are compiled.

/// The flags of one run.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Flags {
    /// For this processor.
    Native,
    /// For any of its family, as the compilers do unless they are told.
    Default,
    /// For processors with vectors of 256 bits: the widest that valgrind knows.
    Vectors256,
}

impl Flags {
    pub(crate) const ALL: [Self; 2] = [Self::Native, Self::Default];

    /// In the names of files.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Native => "native",
            Self::Default => "default",
            Self::Vectors256 => "vectors-256",
        }
    }

    /// For rustc.
    pub(crate) fn rust(self) -> &'static str {
        match self {
            Self::Native => "-C target-cpu=native",
            Self::Default => "",
            Self::Vectors256 => "-C target-cpu=x86-64-v3",
        }
    }

    /// For gcc.
    pub(crate) fn c(self) -> &'static [&'static str] {
        match self {
            Self::Native => &["-O3", "-march=native"],
            Self::Default => &["-O3"],
            Self::Vectors256 => &["-O3", "-march=x86-64-v3"],
        }
    }
}
