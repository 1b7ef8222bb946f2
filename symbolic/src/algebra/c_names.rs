//! The names of the elementary functions in C.

use crate::{Binary, Unary};

impl Unary {
    /// The name in `<math.h>`; none where C has no such function, or one that rounds otherwise than that of Rust.
    #[must_use]
    pub const fn c_name(self) -> Option<&'static str> {
        match self {
            Self::Sin
            | Self::Cos
            | Self::Sech
            | Self::Logistic
            | Self::Softplus
            | Self::LogCosh
            | Self::Signum => None,
            Self::Ln => Some("log"),
            Self::Abs => Some("fabs"),
            Self::Tan
            | Self::Asin
            | Self::Acos
            | Self::Atan
            | Self::Sinh
            | Self::Cosh
            | Self::Tanh
            | Self::Asinh
            | Self::Acosh
            | Self::Atanh
            | Self::Exp => Some(self.name()),
        }
    }
}

impl Binary {
    /// The name in `<math.h>`; none where C has no such function.
    #[must_use]
    pub const fn c_name(self) -> Option<&'static str> {
        match self {
            Self::Atan2 => Some("atan2"),
            Self::Min => Some("fmin"),
            Self::Max => Some("fmax"),
            Self::Power => Some("pow"),
            Self::Scale => None,
        }
    }
}
