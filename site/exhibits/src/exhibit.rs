//! Exhibits behind one interface, whatever the model: what is said about one, and a motion of it.

use std::marker::PhantomData;

use lagrangian::prelude::*;
use lagrangian::quantities::{Energies, Quantities};

use crate::about::About;
use crate::motion::Playing;
use crate::scene::Scene;
use crate::values::Values;

/// Why a model, a start or a motion is refused, in a sentence.
pub type Refusal = Box<dyn std::error::Error>;

/// A ready model that is shown.
pub trait Exhibit: Sync {
    /// What is said about it.
    fn about(&self) -> &'static About;

    /// Its equations of motion in LaTeX, as the derive emits them.
    fn latex(&self) -> &'static str;

    /// The names of its coordinates.
    fn coordinates(&self) -> &'static [&'static str];

    /// Whether inputs, or supports that move by themselves, do work.
    fn is_driven(&self) -> bool;

    /// Begins the motion with these values of the sliders.
    ///
    /// # Errors
    ///
    /// A body that is not physical, a start that violates a constraint or is singular, a number that is not finite.
    fn begin(&self, values: &[f64]) -> Result<Box<dyn Motion>, Refusal>;
}

/// A motion of a model, step by step.
pub trait Motion {
    /// Takes one step, but never beyond a moment at which the law of the inputs changes them; returns the time reached.
    ///
    /// # Errors
    ///
    /// Any error of the integration.
    fn step(&mut self) -> Result<f64, Refusal>;

    /// Returns the time reached.
    fn reached(&self) -> f64;

    /// Shows the motion at a time within the last step: by dense output.
    ///
    /// # Errors
    ///
    /// The time is not within the last step.
    fn show(&mut self, t: f64) -> Result<(), Refusal>;

    /// Returns the coordinates and velocities that are shown.
    fn state(&self) -> Vec<f64>;

    /// Returns the drawing of what is shown.
    fn scene(&self) -> Scene;

    /// Returns the values of the curves at what is shown, in the units of the curves.
    fn curves(&self) -> Vec<f64>;

    /// Returns how far the balance of the energy is missed at the time reached, relative to the largest kinetic energy of the motion.
    fn energy_error(&self) -> f64;

    /// Sets the values of the control law, which continue to be read.
    fn control(&mut self, values: &[f64]);

    /// Evaluates the model at a time and any coordinates and velocities; `None` if they are of another number.
    fn evaluate(&self, t: f64, q: &[f64], v: &[f64]) -> Option<Evaluation>;
}

/// A model at a state.
#[derive(Clone, Debug)]
pub struct Evaluation {
    /// The kinetic energy T.
    pub kinetic: f64,
    /// The potential energy V.
    pub potential: f64,
    /// The accelerations q̈.
    pub accelerations: Vec<f64>,
    /// The drawing.
    pub scene: Scene,
}

/// Sets the inputs of a model from the sliders and the state.
pub(crate) type Law<M, const N: usize> = Box<dyn Fn(&mut M, &Values, &State<f64, N>)>;

/// A model with all that makes it an exhibit.
pub(crate) trait Shown<const N: usize>:
    Lagrangian<N, f64, Model = Self>
    + Quantities<N, f64>
    + Energies<N, f64>
    + Clone
    + std::fmt::Debug
    + Sized
    + 'static
{
    /// What is said about it.
    const ABOUT: About;

    /// The equations in LaTeX.
    const EQUATIONS_IN_LATEX: &'static str;

    /// The time between two changes of the inputs, if there is a law; infinity otherwise.
    const PERIOD: f64 = f64::INFINITY;

    /// Whether [`power`](Self::power) may differ from zero while inputs are held.
    const IS_DRIVEN: bool = false;

    /// The model with these parameters.
    fn with_values(values: &Values) -> Result<Self, Refusal>;

    /// The initial state.
    fn start(&self, values: &Values) -> Result<State<f64, N>, Refusal>;

    /// The law that sets the inputs.
    ///
    /// # Errors
    ///
    /// No regulator exists for these values.
    fn law(&self, values: &Values) -> Result<Law<Self, N>, Refusal> {
        let _ = values;
        Ok(Box::new(|_, _, _| {}))
    }

    /// The power of what is not in the energy function: by default that of the inputs.
    fn power(&self, state: &State<f64, N>) -> f64 {
        Lagrangian::power(self, state)
    }

    /// The drawing at a state.
    fn scene(&self, state: &State<f64, N>) -> Scene;

    /// The values of the curves, angles in radians.
    fn curves(&self, state: &State<f64, N>) -> Vec<f64>;
}

/// The exhibit of a model.
pub(crate) struct Of<M, const N: usize>(PhantomData<fn() -> M>);

impl<M, const N: usize> Of<M, N> {
    pub(crate) const NEW: Self = Self(PhantomData);
}

impl<M, const N: usize> Exhibit for Of<M, N>
where
    M: Shown<N>,
    lagrangian::EquationsOfMotion<M, f64, N>:
        lagrangian::Series<f64> + Dynamics<f64, State = Phase<f64, N>>,
{
    fn about(&self) -> &'static About {
        const { &M::ABOUT }
    }

    fn latex(&self) -> &'static str {
        M::EQUATIONS_IN_LATEX
    }

    fn coordinates(&self) -> &'static [&'static str] {
        const { &M::COORDINATES }
    }

    fn is_driven(&self) -> bool {
        M::IS_DRIVEN
    }

    fn begin(&self, values: &[f64]) -> Result<Box<dyn Motion>, Refusal> {
        let values = Values::new(&M::ABOUT, values);
        Ok(Box::new(Playing::<M, N>::begin(values)?))
    }
}
