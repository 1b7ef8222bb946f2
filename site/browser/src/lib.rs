//! The exhibits in WebAssembly: what the page in the browser calls.
//!
//! A step is a call, so that the page decides how many fit into a frame. Errors are the sentences of the library.

use lagrangian_exhibits::{Camera, Motion, Picture, Trails, exhibits, palette};
use wasm_bindgen::prelude::wasm_bindgen;

/// Returns what is said about all exhibits, in JSON.
#[wasm_bindgen]
#[must_use]
pub fn description() -> String {
    lagrangian_exhibits::description(&exhibits())
}

/// Returns the colours of the drawing: those of the first tone by brightness, then those of the next one, and so on.
#[wasm_bindgen]
#[must_use]
pub fn colors(dark: bool) -> Vec<String> {
    let tones = 0..7;
    tones
        .flat_map(|tone| (0..palette::SHADES).map(move |shade| palette::color(dark, tone, shade)))
        .collect()
}

/// How many points a path has at most.
const TRAIL: usize = 240;

/// A motion that is shown.
#[wasm_bindgen]
pub struct Player {
    motion: Box<dyn Motion>,
    trails: Trails,
}

#[wasm_bindgen]
impl Player {
    /// Begins the motion of an exhibit with these values of its sliders.
    ///
    /// # Errors
    ///
    /// The sentence that says what is wrong with the values.
    #[wasm_bindgen(constructor)]
    pub fn new(exhibit: usize, values: &[f64]) -> Result<Player, String> {
        let exhibits = exhibits();
        let exhibit = exhibits.get(exhibit).ok_or("There is no such exhibit.")?;
        let motion = exhibit.begin(values).map_err(|error| error.to_string())?;
        Ok(Self {
            motion,
            trails: Trails::new(TRAIL),
        })
    }

    /// Takes one step and returns the time reached.
    ///
    /// # Errors
    ///
    /// The sentence that says why the motion ends.
    pub fn step(&mut self) -> Result<f64, String> {
        self.motion.step().map_err(|error| error.to_string())
    }

    /// The time that the steps have reached.
    #[wasm_bindgen(getter)]
    #[must_use]
    pub fn reached(&self) -> f64 {
        self.motion.reached()
    }

    /// Shows the motion at a time within the last step, and continues the paths.
    ///
    /// # Errors
    ///
    /// The time is not within the last step.
    pub fn show(&mut self, time: f64) -> Result<(), String> {
        self.motion.show(time).map_err(|error| error.to_string())?;
        self.trails.add(&self.motion.scene());
        Ok(())
    }

    /// Sets the values of the control law.
    pub fn control(&mut self, values: &[f64]) {
        self.motion.control(values);
    }

    /// Paints what is shown, as [`Picture::numbers`].
    #[must_use]
    pub fn picture(
        &self,
        azimuth: f64,
        height: f64,
        zoom: f64,
        width: f64,
        across: f64,
    ) -> Vec<f32> {
        let camera = Camera {
            azimuth,
            height,
            zoom,
            size: [width, across],
        };
        Picture::of(&self.motion.scene(), &self.trails.paths(), &camera).numbers()
    }

    /// The values of the curves.
    #[must_use]
    pub fn curves(&self) -> Vec<f64> {
        self.motion.curves()
    }

    /// How far the balance of the energy is missed, relative to the largest kinetic energy.
    #[wasm_bindgen(getter, js_name = energyError)]
    #[must_use]
    pub fn energy_error(&self) -> f64 {
        self.motion.energy_error()
    }

    /// The accelerations at states, given and returned one behind the other: t, q, q̇.
    #[must_use]
    pub fn accelerations(&self, states: &[f64], coordinates: usize) -> Vec<f64> {
        let mut found = Vec::new();
        for state in states.chunks_exact(2 * coordinates + 1) {
            let (t, phase) = state.split_at(1);
            let (q, v) = phase.split_at(coordinates);
            let t = t.first().copied().unwrap_or(f64::NAN);
            found.extend(
                self.motion
                    .evaluate(t, q, v)
                    .into_iter()
                    .flat_map(|at| at.accelerations),
            );
        }
        found
    }
}
