//! What the program asks of a model crate, and what that reports.

use lagrangian::OperationCount;
use serde::{Deserialize, Serialize};

/// What a model crate is to measure.
#[derive(Debug, Serialize, Deserialize)]
pub struct Request {
    /// The name of the model, for messages.
    pub model: String,
    /// Coordinates and velocities, one row a state; and accelerations, if inverse dynamics is measured instead of these.
    pub states: Vec<Vec<f64>>,
    /// The peers that can be called.
    pub libraries: Vec<Library>,
    /// What peers that cannot be called have computed.
    pub answers: Vec<Answers>,
    /// How many times each is measured.
    pub rounds: usize,
}

/// A peer in a shared object.
#[derive(Debug, Serialize, Deserialize)]
pub struct Library {
    /// The name of the peer.
    pub name: String,
    /// The path of the shared object.
    pub path: String,
}

/// The accelerations that a peer has computed at the states of the request.
#[derive(Debug, Serialize, Deserialize)]
pub struct Answers {
    /// The name of the peer.
    pub name: String,
    /// One row a state.
    pub accelerations: Vec<Vec<f64>>,
}

/// What a model crate has found.
#[derive(Debug, Serialize, Deserialize)]
pub struct Report {
    /// What our accelerations cost.
    pub operations: Operations,
    /// Our accelerations, one row a state.
    pub accelerations: Vec<Vec<f64>>,
    /// How much our accelerations are off in single precision, if that was asked for: the root of the mean
    /// square over all states, relative to the accelerations, in units of the precision.
    pub rounding: Option<f64>,
    /// Ours first, then the peers that can be called, then those that cannot.
    pub measurements: Vec<Measurement>,
}

/// One side, measured.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub struct Measurement {
    /// The name of the peer, or of this library.
    pub name: String,
    /// Nanoseconds for each of independent evaluations, of peers that can be called.
    pub throughput: Option<f64>,
    /// Nanoseconds for each of evaluations that wait for the one before.
    pub latency: Option<f64>,
    /// The greatest difference from ours over all states, relative to the accelerations.
    pub difference: f64,
}

/// The operations of our accelerations, by kind.
#[derive(Clone, Copy, Debug, Serialize, Deserialize)]
pub struct Operations {
    /// Additions, subtractions and changes of sign.
    pub additions: usize,
    /// Multiplications.
    pub multiplications: usize,
    /// Divisions.
    pub divisions: usize,
    /// Square roots.
    pub square_roots: usize,
    /// Sines and cosines; the pair of one angle counts once.
    pub sines_and_cosines: usize,
    /// All other functions.
    pub functions: usize,
    /// All, each function counted as one.
    pub total: usize,
}

impl From<OperationCount> for Operations {
    fn from(count: OperationCount) -> Self {
        Self {
            additions: count.additions,
            multiplications: count.multiplications,
            divisions: count.divisions,
            square_roots: count.square_roots,
            sines_and_cosines: count.sines_and_cosines,
            functions: count.functions,
            total: count.total(),
        }
    }
}
