//! What the tests share: wrong comparisons fail, and data are read as they are written. These tests are not beside the functions, so
//! that the library, with its hundreds of models, is compiled once.

mod closeness;
mod figures;
mod model;
mod random;
mod data;
