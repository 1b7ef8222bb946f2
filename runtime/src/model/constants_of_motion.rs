//! Constants of motion that follow from the declaration, and their changes along a motion.
//!
//! Goldstein, Poole and Safko, Classical Mechanics, 3rd edition 2002, sections 2.6 and 2.7.

use nalgebra::SVector;

use super::lagrangian::Lagrangian;
use super::phase::Phase;
use super::state::State;
use crate::integrate::Progress;
use crate::scalar::Scalar;

/// A model with `C` constants of motion that are known at compile time.
///
/// The constants are the momenta pᵢ = ∂L/∂q̇ᵢ of the ignorable coordinates (4.8), in their order, and then the energy
/// function h, if it is constant.
///
/// A coordinate is ignorable (cyclic) if ∂L/∂qᵢ vanishes identically and no generalized force acts on it: no `force`,
/// no `dissipation` and no input. h is constant if L depends neither on time nor on inputs, and the generalized forces
/// do no work. Both conditions are decided exactly when the model is derived, so that a coordinate may appear in L and
/// cancel. Only models with such constants implement the trait.
///
/// ```
/// use lagrangian::prelude::*;
///
/// /// The orbit of a particle about a centre of attraction.
/// #[derive(Lagrangian)]
/// #[lagrangian(
///     coordinates(r, phi),
///     kinetic = 0.5 * m * (dot(r).powi(2) + (r * dot(phi)).powi(2)),
///     potential = -m * mu / r,
/// )]
/// struct Orbit { m: f64, mu: f64 }
///
/// let orbit = Orbit { m: 2.0, mu: 1.0 };
/// let start = State::new(0.0, [1.0, 0.0], [0.0, 1.2]);
/// assert_eq!(<Orbit as ConstantsOfMotion<2, 2>>::CONSTANTS_OF_MOTION, ["p_phi", "energy"]);
/// assert_eq!(orbit.constants_of_motion(&start)[0], 2.0 * 1.2);
///
/// let mut watch = orbit.watch_constants(&start);
/// Problem::new(&orbit, start)
///     .each_step(|progress| watch.observe(progress))
///     .solve(50.0, Dop853::new().relative_tolerance(1e-10))?;
/// let [momentum, energy] = watch.largest_changes();
/// assert_eq!(energy.name, "energy");
/// assert!(momentum.change.abs() < 1e-8 && energy.change.abs() < 1e-8);
/// # Ok::<(), IntegrationError>(())
/// ```
#[diagnostic::on_unimplemented(
    message = "no constants of motion of `{Self}` are known",
    note = "a momentum is constant if the Lagrangian does not depend on its coordinate and no force, dissipation or input acts \
            on it; the energy function is, if the Lagrangian depends neither on `t` nor on an input and no force does work"
)]
pub trait ConstantsOfMotion<const N: usize, const C: usize, S: Scalar = f64>:
    Lagrangian<N, S>
{
    /// The names of the constants: `p_phi` for the momentum of the coordinate `phi`, and `energy`.
    const CONSTANTS_OF_MOTION: [&'static str; C];

    /// The indices of the ignorable coordinates, in order.
    const IGNORABLE_COORDINATES: &'static [usize];

    /// Whether the energy function is one of the constants, and then the last one. By default, whether there are more constants
    /// than ignorable coordinates.
    const CONSERVES_ENERGY: bool = C > Self::IGNORABLE_COORDINATES.len();

    /// Returns the values of the constants at a state: by default the momenta of the ignorable coordinates, and then the energy
    /// function.
    #[inline]
    fn constants_of_motion(&self, state: &State<S, N>) -> SVector<S, C> {
        const {
            let momenta = Self::IGNORABLE_COORDINATES.len();
            assert!(
                C == momenta + Self::CONSERVES_ENERGY as usize,
                "there is a constant for each ignorable coordinate, and one more if energy is conserved"
            );
        }
        let ignorable = Self::IGNORABLE_COORDINATES;
        let mut constants = SVector::<S, C>::zeros();
        if !ignorable.is_empty() {
            let momenta = self.momenta(state);
            for (constant, i) in constants.iter_mut().zip(ignorable) {
                *constant = momenta[*i];
            }
        }
        if Self::CONSERVES_ENERGY
            && let Some(last) = constants.as_mut_slice().last_mut()
        {
            *last = self.energy(state);
        }
        constants
    }

    /// Returns a watch for the changes of the constants since a state, which observes an integration by any method.
    fn watch_constants(&self, start: &State<S, N>) -> ConstantsWatch<'_, Self, S, N, C>
    where
        Self: Sized,
    {
        let initial = self.constants_of_motion(start);
        let name = |i: usize| Self::CONSTANTS_OF_MOTION[i];
        ConstantsWatch {
            model: self,
            largest: core::array::from_fn(|i| LargestChange {
                name: name(i),
                initial: initial[i],
                change: S::zero(),
                t: start.t.smallest(),
            }),
        }
    }
}

/// A watch for the changes of constants of motion in the course of an integration, at the ends of steps, at samples and
/// at events: `problem.each_step(|progress| watch.observe(progress))`.
///
/// A reaction that changes the state, such as an impact, may change constants, too.
#[derive(Clone, Debug)]
pub struct ConstantsWatch<'a, M, S: Scalar, const N: usize, const C: usize> {
    model: &'a M,
    largest: [LargestChange<S>; C],
}

/// The largest observed change of a constant of motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LargestChange<S = f64> {
    /// The name of the constant.
    pub name: &'static str,
    /// Its initial value.
    pub initial: S,
    /// The change of the largest magnitude, in the lane in which it is largest; NaN once a value is NaN.
    pub change: S,
    /// The time at which it was observed.
    pub t: f64,
}

impl<M, S: Scalar, const N: usize, const C: usize> ConstantsWatch<'_, M, S, N, C> {
    /// Returns the largest change of each constant so far.
    #[must_use]
    pub fn largest_changes(&self) -> [LargestChange<S>; C] {
        self.largest
    }
}

impl<M, S, const N: usize, const C: usize> ConstantsWatch<'_, M, S, N, C>
where
    M: ConstantsOfMotion<N, C, S>,
    S: Scalar,
{
    /// Compares the constants with their initial values.
    pub fn observe(&mut self, progress: &Progress<'_, Phase<S, N>>) {
        let state = progress.x.at_time(S::from_f64(progress.t));
        let constants = self.model.constants_of_motion(&state);
        for (largest, value) in self.largest.iter_mut().zip(constants.iter()) {
            let change = *value - largest.initial;
            let [known, found] = [largest.change, change].map(|change| change.abs().largest());
            // NaN counts as larger than any number.
            if !(found <= known || known.is_nan()) {
                largest.change = change;
                largest.t = progress.t;
            }
        }
    }
}
