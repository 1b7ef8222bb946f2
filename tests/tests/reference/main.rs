//! Values that other programs computed, and closed forms.

mod closed_forms;
mod elementary_functions;
mod equations_page;
mod flow;
mod near_the_poles;
mod powers_from_zero;
mod public_cases;
mod shared;
mod sine_cosine;
mod taylor_series;
mod trajectories;
