//! What is measured, and how: the part of the benchmark that the written model crates call.
//!
//! The program of this package writes one crate for each model, as a user would: a struct with the
//! derive, and a `main` that hands it to [`measure`]. Peers are C functions `void accelerations(const
//! double *x, double *a)` in shared objects, x being coordinates and then velocities.
//!
//! What is timed is one call through a function pointer that the compiler cannot look through, ours
//! (a reference to the model, one to the state, one to the result) as theirs (two pointers); so
//! neither side is inlined into the loop, and nothing is hoisted out of it. Our parameters are fields,
//! read at run time; theirs are constants that their compiler has folded. All are measured in turn in
//! one process, round after round, and the fastest round of each counts: the machine is the same for all.

mod agreement;
mod derived;
mod energy_errors;
mod evaluation;
mod integrate;
mod measure;
mod motions;
mod protocol;
mod question;
mod reduced_step;
mod rounding;
mod shared_object;
mod stopwatch;
mod thread_time;

pub use integrate::{Contestant, integrate, integrate_alone, integrate_precisely};
pub use measure::{measure, measure_dynamics, measure_with_rounding};
pub use motions::LANES;
pub use protocol::{Answers, Library, Measurement, Operations, Report, Request};
pub use question::{
    EnergyErrors, Integrated, Integration, Question, Throughput, answer, answer_questions,
};
pub use reduced_step::compare_steps;
pub use thread_time::fewest_seconds;
