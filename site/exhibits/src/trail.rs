//! The paths of the traced points of a scene.

use std::collections::VecDeque;

use lagrangian::prelude::*;

use crate::scene::Scene;

/// The last points of each path.
#[derive(Clone, Debug)]
pub struct Trails {
    longest: usize,
    paths: Vec<VecDeque<Vector3<f64>>>,
}

impl Trails {
    /// Paths of so many points at most.
    #[must_use]
    pub fn new(longest: usize) -> Self {
        Self {
            longest,
            paths: Vec::new(),
        }
    }

    /// Adds the points of a scene.
    pub fn add(&mut self, scene: &Scene) {
        self.paths.resize(scene.traced.len(), VecDeque::new());
        for (path, point) in self.paths.iter_mut().zip(&scene.traced) {
            if path.len() >= self.longest {
                path.pop_front();
            }
            path.push_back(*point);
        }
    }

    /// The paths, oldest points first.
    #[must_use]
    pub fn paths(&self) -> Vec<Vec<Vector3<f64>>> {
        self.paths
            .iter()
            .map(|path| path.iter().copied().collect())
            .collect()
    }
}
