//! Models with constraints.

mod bicycle;
mod bricard;
mod chained_loops;
mod closed_forms;
mod consistency;
mod dense;
mod door;
mod four_bars;
mod freedom;
mod joints;
mod junctions;
mod light_bodies;
mod linkages;
mod mechanisms;
mod pendulum;
mod reactions;
mod redundant;
mod references;
mod singular;
mod same_bits;
