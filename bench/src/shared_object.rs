//! Their side: a C function in a shared object. The only file that may call what Rust cannot check.

#![allow(
    unsafe_code,
    reason = "a function of another language can be called in no other way"
)]

use libloading::Library;
use nalgebra::{SMatrix, SVector};

use crate::evaluation::Evaluation;

type Accelerations = unsafe extern "C" fn(*const f64, *mut f64);

/// A peer's function of K N numbers that writes N: coordinates, velocities and, of inverse dynamics, accelerations.
///
/// Sound as long as the shared object is what the program of this package has compiled for a model of N
/// coordinates: its initialization does nothing, and its `accelerations` has the type above, reads K N
/// numbers, writes N, and keeps neither pointer. Nothing can check that here; paths come from the
/// program alone.
pub(crate) struct SharedObject<const N: usize, const K: usize = 2> {
    accelerations: Accelerations,
    /// Keeps the function in memory.
    _library: Library,
}

impl<const N: usize, const K: usize> SharedObject<N, K> {
    pub(crate) fn load(path: &str) -> Result<Self, libloading::Error> {
        // SAFETY: what the program has compiled runs nothing when it is loaded.
        let library = unsafe { Library::new(path) }?;
        // SAFETY: the type is the one that every peer is written with.
        let accelerations = *unsafe { library.get::<Accelerations>(b"accelerations\0") }?;
        Ok(Self {
            accelerations,
            _library: library,
        })
    }
}

impl<const N: usize, const K: usize> Evaluation<N> for SharedObject<N, K> {
    /// Coordinates, then velocities, then accelerations, without a gap.
    type State = SMatrix<f64, N, K>;

    fn state(row: &[f64]) -> Self::State {
        SMatrix::from_column_slice(row)
    }

    #[inline]
    fn moved(state: &Self::State, by: &SVector<f64, N>) -> Self::State {
        let mut moved = *state;
        for mut column in moved.column_iter_mut() {
            column += by;
        }
        moved
    }

    #[inline]
    fn evaluate(&self, state: &Self::State, accelerations: &mut SVector<f64, N>) {
        let (x, a) = (state.as_slice(), accelerations.as_mut_slice());
        // SAFETY: x has K N numbers and a has N; both live until the call returns.
        unsafe { (self.accelerations)(x.as_ptr(), a.as_mut_ptr()) }
    }
}
