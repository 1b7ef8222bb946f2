//! Robots, declared from published tables, against an inverse dynamics that shares nothing with the library's.

mod crane;
mod panda;
mod puma560;
mod recursion;
mod satellite_with_panels;
mod solo12;
mod ur5;
