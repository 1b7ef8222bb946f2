//! The quantities of a body that expressions name.

/// A quantity of a body in expressions, as in `body.mass`. It is called like the method that reads it.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum BodyQuantity {
    Mass,
    Center,
    Inertia,
}

impl BodyQuantity {
    pub(crate) const ALL: [Self; 3] = [Self::Mass, Self::Center, Self::Inertia];

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Mass => "mass",
            Self::Center => "center",
            Self::Inertia => "inertia",
        }
    }
}
