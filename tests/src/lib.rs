//! What the tests share: reference values, the models they were computed for, scalars other
//! than numbers, and one way to compare.

mod closeness;
mod arithmetic;
mod dual;
mod figures;
mod random;
mod reference;
mod motion;
mod model;

pub use closeness::{assert_close, relative_error};
pub use dual::Dual;
pub use figures::Figures;
pub use lagrangian::DoubleDouble;
pub use model::{Law, Observed, Parametrized, rows};
pub use motion::{Motion, motions};
pub use random::Random;
pub use reference::{
    array, bicycle, bricard, governor, linear_control, list, near_the_poles, number, numbers,
    public_cases, references, regulators, snakeboard, text,
};

/// The models of the random Lagrangians, written by the build script; `public_cases!` lists them.
#[rustfmt::skip]
pub mod public_case {
    use lagrangian::Lagrangian;

    use crate::Parametrized;

    include!(concat!(env!("OUT_DIR"), "/public_case.rs"));
}

/// The models whose trajectories are listed, written by the build script; `trajectories!` lists
/// them.
#[rustfmt::skip]
pub mod trajectory {
    use lagrangian::{Lagrangian, State};

    use crate::{Law, Observed, Parametrized};

    include!(concat!(env!("OUT_DIR"), "/trajectory.rs"));
}
