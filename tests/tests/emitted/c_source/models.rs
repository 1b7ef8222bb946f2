//! Models that are written in C, each with its comparison.

mod arm;
mod carts;
mod chains;
mod functions;
mod guided;
mod indefinite;
mod mechanisms;
mod names;
mod slider;

pub(super) use arm::arm;
pub(super) use carts::cart_pole;
pub(super) use chains::{chain, long_chain};
pub(super) use functions::elementary_functions;
pub(super) use guided::guided;
pub(super) use indefinite::indefinite;
pub(super) use mechanisms::{four_bar, points_of_disc, points_of_four_bar, rolling_disc};
pub(super) use names::{names, oscillator};
pub(super) use slider::radial;
