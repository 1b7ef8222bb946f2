//! Formulas and equations in print.

mod formulas;
mod listing;
mod print_back;
