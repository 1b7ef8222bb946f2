//! Systems of textbooks, chains and robots: their equations, what these cost, and their parameters.

mod base_parameters;
mod closed_loops;
mod derivatives_along_links;
mod pendulum_chain;
mod regressors;
mod regressors_of_bodies;
mod models;
mod robots;
