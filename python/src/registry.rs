//! The descriptions of all classes of the module.

use std::sync::{Mutex, PoisonError};

use pyo3::prelude::*;
use pyo3::types::PyType;

use crate::description::Description;

/// A class has its place in the list as an attribute.
static DESCRIPTIONS: Mutex<Vec<&'static Description>> = Mutex::new(Vec::new());

/// The name of this attribute.
pub(crate) const INDEX: &str = "_index";

/// Adds a description and returns its place.
pub(crate) fn register(description: &'static Description) -> usize {
    let mut all = DESCRIPTIONS.lock().unwrap_or_else(PoisonError::into_inner);
    all.push(description);
    all.len() - 1
}

/// The description of a class, or of the class that it is derived from; `None` for `Model` itself.
pub(crate) fn description(class: &Bound<'_, PyType>) -> Option<&'static Description> {
    let index: usize = class.getattr(INDEX).ok()?.extract().ok()?;
    let all = DESCRIPTIONS.lock().unwrap_or_else(PoisonError::into_inner);
    all.get(index).copied()
}
