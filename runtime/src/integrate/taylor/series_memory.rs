//! Memory for the terms of Taylor series.

#[cfg(feature = "alloc")]
use alloc::boxed::Box;
#[cfg(feature = "alloc")]
use core::any::Any;

/// Memory in which [`Series::series`](crate::Series::series) keeps the terms of convolutions, so that they need not be
/// cleared for each series.
///
/// An [`Ensemble`](crate::Ensemble) has one for its lanes. Series on `f64` do not use it, and without the feature `alloc` it keeps
/// nothing.
#[derive(Debug, Default)]
pub struct SeriesMemory {
    #[cfg(feature = "alloc")]
    kept: Option<Box<dyn Any>>,
}

#[cfg(feature = "alloc")]
impl SeriesMemory {
    /// Returns the value that is kept, or a new one if it has another type; `None` if nothing can be kept.
    #[inline]
    pub(crate) fn keep<T: 'static>(&mut self, new: impl FnOnce() -> T) -> Option<&mut T> {
        let is_kept = self.kept.as_ref().is_some_and(|kept| (**kept).is::<T>());
        if !is_kept {
            self.kept = Some(Box::new(new()));
        }
        self.kept.as_mut()?.downcast_mut()
    }
}

#[cfg(not(feature = "alloc"))]
impl SeriesMemory {
    /// Returns `None`.
    #[inline]
    pub(crate) fn keep<T>(&mut self, _: impl FnOnce() -> T) -> Option<&mut T> {
        None
    }
}
