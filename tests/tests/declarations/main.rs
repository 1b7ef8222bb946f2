//! What can be declared: vectors, families, bodies, clauses, functions with corners.

mod arrays;
mod at_rest;
mod bodies;
mod branches;
mod composition;
mod forces;
mod outputs;
mod reflect;
mod vector_coordinates;
mod vectors_in_frames;
mod external_functions;
mod three_spellings;
