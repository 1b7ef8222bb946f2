//! Mutexes of a study.

use std::sync::{Mutex, MutexGuard, PoisonError};

/// Locks a mutex. A thread that panics with the lock ends the study with its panic, so that what it leaves is not used.
pub(crate) fn lock<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
