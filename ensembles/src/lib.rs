//! Many motions of the models of [`lagrangian`]: Monte Carlo studies, parameter sweeps, basins of attraction.
//!
//! A [`Study`] integrates one problem for each of its points, on all cores, by any method and with the same events,
//! samples and reactions as a single motion. [`Taylor`](lagrangian::Taylor) integrates several members at once in the
//! SIMD lanes of each core. The results are the same to the last bit, and in the same order, for any number of threads.
//!
//! ```
//! use lagrangian::prelude::*;
//! use lagrangian_ensembles::{Column, Parameter, Sample, Study};
//!
//! #[derive(Lagrangian)]
//! #[lagrangian(
//!     taylor,
//!     coordinates(theta),
//!     kinetic = 0.5 * l.powi(2) * dot(theta).powi(2),
//!     potential = -g * l * cos(theta),
//!     event(bottom = theta),
//! )]
//! struct Pendulum { l: f64, g: f64 }
//!
//! // The time in which a pendulum of uncertain length falls to the bottom.
//! let lengths = Sample::new(2000, [Parameter::normal("l", 1.0, 0.02).unit("m")]).sobol().seed(1);
//! let study = Study::new(
//!     lengths,
//!     |[l]| {
//!         Problem::new(Pendulum { l, g: 9.81 }, State::new(0.0, [0.5], [0.0]))
//!             .on(Pendulum::BOTTOM)
//!             .stop()
//!     },
//!     10.0,
//!     Taylor::new(),
//! );
//! let summary = study.summary([Column::new("fall").unit("s")], |fall| [fall.t])?;
//! let [l, fall] = ["l", "fall"].map(|name| summary.column(name).expect("it is a column"));
//! assert_eq!(fall.count(), 2000);
//! // The time is proportional to √l.
//! assert!((fall.standard_deviation() / fall.mean() - 0.01).abs() < 1e-4);
//! assert!((l.mean() - 1.0).abs() < 1e-4);
//! assert!(summary.correlation("l", "fall") > Some(0.999));
//! # Ok::<(), lagrangian_ensembles::Error>(())
//! ```
//!
//! - Points are the [`Range`](std::ops::Range) of the indices, a `Vec` of anything, a [`Grid`], or a [`Sample`] of
//!   distributions: random, a Latin hypercube, Sobol's or Halton's sequence.
//! - [`Study::solve`] returns all motions, [`Study::table`] numbers of each, [`Study::summary`] their statistics.
//! - With the feature `parquet`, `Study::write` writes tables chunk by chunk into a folder. A study that was
//!   interrupted continues after its finished chunks, and parts of it ([`Shard`]) are computed by different machines.
//!   With the feature `csv`, tables are written as text.

mod limits;
mod error;
mod column;
mod metadata;
mod points;
mod progress;
mod grid;
mod normal;
mod parameter;
mod sample;
mod motion;
mod mutex;
mod end;
mod members;
mod chunks;
mod collector;
mod workers;
mod rows;
mod table;
mod moments;
mod summary;
mod histogram;
mod tree;
mod shard;
mod sinks;
mod study;
#[cfg(feature = "csv")]
mod csv;
#[cfg(feature = "parquet")]
mod parquet;
#[cfg(feature = "parquet")]
mod manifest;
#[cfg(feature = "parquet")]
mod results;
#[cfg(feature = "parquet")]
mod folder;
#[cfg(feature = "mpi")]
mod ranks;

pub use column::Column;
pub use error::Error;
#[cfg(feature = "parquet")]
pub use folder::Folder;
pub use grid::{Axis, Grid};
pub use histogram::Histogram;
pub use members::Members;
pub use motion::{Failure, Motion};
#[cfg(feature = "mpi")]
pub use mpi;
pub use parameter::Parameter;
pub use points::Points;
pub use progress::Progress;
#[cfg(feature = "parquet")]
pub use results::Results;
pub use rows::Rows;
pub use sample::Sample;
pub use shard::Shard;
pub use statrs;
pub use study::Study;
pub use summary::{ColumnSummary, Summary};
pub use table::{FailedMember, Table};

/// The programs of the README.
#[allow(missing_docs)]
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
