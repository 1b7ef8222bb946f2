//! Models as a textbook declares them, in vectors, rotations and families, each with a check of its own.

mod cart_pole;
mod costs;
mod double_pendulum;
mod free_body;
mod furuta_pendulum;
mod gravitation;
mod gyroscope;
mod kapitza_pendulum;
mod robot_arm;
mod satellite;
mod spherical_pendulum;
