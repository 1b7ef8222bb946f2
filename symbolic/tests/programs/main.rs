//! Programs: what they cost, what the passes over them keep, and their Taylor series.

mod ablation;
mod chains;
mod collecting;
mod costs;
mod growth;
mod passes;
mod programs;
mod reassociation;
mod staging;
mod taylor;
mod taylor_of_external_functions;
mod verification;
