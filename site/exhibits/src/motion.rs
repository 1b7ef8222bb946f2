//! A motion of one model, by the Taylor series that the derive emits.

use lagrangian::prelude::*;
use lagrangian::problem::Run;
use lagrangian::{EnergyResidual, EquationsOfMotion, Series};

use crate::about::Group;
use crate::exhibit::{Evaluation, Law, Motion, Refusal, Shown};
use crate::scene::Scene;
use crate::values::Values;

/// A motion with its sliders and its balance of energy.
pub(crate) struct Playing<M, const N: usize>
where
    M: Shown<N>,
    EquationsOfMotion<M, f64, N>: Series<f64> + Dynamics<f64, State = Phase<f64, N>>,
{
    run: Run<f64, EquationsOfMotion<M, f64, N>, Taylor>,
    values: Values,
    law: Law<M, N>,
    shown: State<f64, N>,
    /// How often the inputs were set.
    held: u32,
    energy: f64,
    balance: EnergyResidual,
    largest: f64,
}

/// A time that no step reaches.
const FAR: f64 = 1e9;

impl<M, const N: usize> Playing<M, N>
where
    M: Shown<N>,
    EquationsOfMotion<M, f64, N>: Series<f64> + Dynamics<f64, State = Phase<f64, N>>,
{
    pub(crate) fn begin(values: Values) -> Result<Self, Refusal> {
        let mut model = M::with_values(&values)?;
        let start = model.start(&values)?;
        let law = model.law(&values)?;
        law(&mut model, &values, &start);
        let energy = Lagrangian::energy(&model, &start);
        let largest = Lagrangian::kinetic_energy(&model, &start).abs();
        let run = Problem::new(model.into_dynamics(), start).start(Taylor::new())?;
        Ok(Self {
            run,
            values,
            law,
            shown: start,
            held: 1,
            energy,
            balance: EnergyResidual::default(),
            largest,
        })
    }

    fn model(&self) -> &M {
        self.run.dynamics().model()
    }

    /// Sets the inputs, if it is time to.
    fn hold(&mut self) -> Result<(), Refusal> {
        if self.run.state().t < M::PERIOD * f64::from(self.held) {
            return Ok(());
        }
        let (law, values) = (&self.law, &self.values);
        self.run.change(|state, dynamics| {
            dynamics.change(|model| law(model, values, state));
        })?;
        self.held += 1;
        Ok(())
    }

    /// Adds the last step to the balance of the energy.
    fn balance(&mut self) -> Result<(), Refusal> {
        let (before, here) = (self.run.previous_time(), self.run.state());
        let model = self.run.dynamics().model().clone();
        let energy = Lagrangian::energy(&model, &here);
        self.largest = self
            .largest
            .max(Lagrangian::kinetic_energy(&model, &here).abs());
        let change = energy - self.energy;
        self.energy = energy;
        if !M::IS_DRIVEN {
            self.balance.last += change;
            return Ok(());
        }
        let run = std::cell::RefCell::new(&mut self.run);
        self.balance.add_step((before, here.t), change, |t| {
            let state = run.borrow_mut().at(t)?;
            Ok::<_, IntegrationError>(Shown::power(&model, &state))
        })?;
        Ok(())
    }
}

impl<M, const N: usize> Motion for Playing<M, N>
where
    M: Shown<N>,
    EquationsOfMotion<M, f64, N>: Series<f64> + Dynamics<f64, State = Phase<f64, N>>,
{
    fn step(&mut self) -> Result<f64, Refusal> {
        self.hold()?;
        let target = if M::PERIOD.is_finite() {
            M::PERIOD * f64::from(self.held)
        } else {
            FAR
        };
        self.run.step(target).map_err(|partial| partial.error())?;
        self.balance()?;
        Ok(self.reached())
    }

    fn reached(&self) -> f64 {
        self.run.state().t
    }

    fn show(&mut self, t: f64) -> Result<(), Refusal> {
        self.shown = self.run.at(t)?;
        Ok(())
    }

    fn state(&self) -> Vec<f64> {
        self.shown
            .q
            .iter()
            .chain(self.shown.v.iter())
            .copied()
            .collect()
    }

    fn scene(&self) -> Scene {
        self.model().scene(&self.shown)
    }

    fn curves(&self) -> Vec<f64> {
        let values = self.model().curves(&self.shown);
        let units = M::ABOUT.curves.iter().map(|curve| curve.unit);
        units
            .zip(values)
            .map(|(unit, x)| {
                if unit.starts_with('°') {
                    x.to_degrees()
                } else {
                    x
                }
            })
            .collect()
    }

    fn energy_error(&self) -> f64 {
        if self.balance.last == 0.0 {
            0.0
        } else {
            (self.balance.last / self.largest).abs()
        }
    }

    fn control(&mut self, values: &[f64]) {
        debug_assert!(
            M::ABOUT
                .quantities
                .iter()
                .any(|quantity| quantity.group == Group::Control)
        );
        self.values = Values::new(&M::ABOUT, values);
    }

    fn evaluate(&self, t: f64, q: &[f64], v: &[f64]) -> Option<Evaluation> {
        let (q, v): ([f64; N], [f64; N]) = (q.try_into().ok()?, v.try_into().ok()?);
        let (model, state) = (self.model(), State::new(t, q, v));
        Some(Evaluation {
            kinetic: Lagrangian::kinetic_energy(model, &state),
            potential: Lagrangian::potential_energy(model, &state),
            accelerations: Lagrangian::accelerations(model, &state)
                .iter()
                .copied()
                .collect(),
            scene: model.scene(&state),
        })
    }
}
