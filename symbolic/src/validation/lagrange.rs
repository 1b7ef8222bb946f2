//! Lagrange's equations, numerically: d/dt (∂L/∂q̇ᵢ) − ∂L/∂qᵢ − Qᵢ at given accelerations.
//!
//! One reverse sweep over L on hyper-dual numbers does it all. The first direction is that of time, (q̇, q̈, 1)
//! in (q, q̇, t), so that the adjoint of q̇ᵢ is pᵢ with dpᵢ/dt; the second is a variation of state and
//! inputs at fixed accelerations, which gives the directional derivatives of a linearization.

use std::collections::BTreeMap;

use crate::identity::real_point::RealPoint;
use crate::validation::hyper_dual::HyperDual;
use crate::validation::number::Number as _;
use crate::validation::perturbation::Perturbation;
use crate::validation::sum_with_size::SumWithSize;
use crate::validation::tape::{StandIns, Tape};
use crate::{Expression, Graph, Model, Symbol};

/// The energies, the dissipation and the forces of a model as they were first built.
pub(crate) struct Lagrange {
    /// T and V, or L; then D; then the forces.
    tape: Tape,
    outputs: Tape,
    /// With those that stand for multipliers.
    pub(crate) coordinates: usize,
    /// How many of them stand for multipliers: their velocities are 0.
    pub(crate) multipliers: usize,
    pub(crate) inputs: usize,
    energies: usize,
    dissipates: bool,
}

/// What the equations give at one point.
pub(crate) struct Values {
    /// The largest magnitude of all that the energies and forces are made of.
    pub(crate) largest: f64,
    pub(crate) lagrangian: f64,
    /// T and V, if they were declared.
    pub(crate) energies: Vec<f64>,
    pub(crate) momenta: Vec<f64>,
    pub(crate) generalized_forces: Vec<f64>,
    /// dp/dt − ∂L/∂q − Q.
    pub(crate) residuals: Vec<SumWithSize>,
    /// Its change along the variation.
    pub(crate) variations: Vec<SumWithSize>,
    /// M w.
    pub(crate) mass_products: Vec<f64>,
    pub(crate) outputs: Vec<f64>,
    /// ∂L/∂q + Q.
    pub(crate) momentum_rates: Vec<SumWithSize>,
    /// Q·q̇ − ∂L/∂t.
    pub(crate) energy_rate: SumWithSize,
}

/// What is varied at a point, and how fast.
pub(crate) struct Variation {
    /// δq, δq̇ and δt.
    pub(crate) state: Vec<f64>,
    /// δu.
    pub(crate) inputs: Vec<f64>,
    /// w, a direction of velocities.
    pub(crate) velocities: Vec<f64>,
    /// δπ of some parameters.
    pub(crate) parameters: BTreeMap<Symbol, f64>,
}

impl Variation {
    pub(crate) fn at(point: RealPoint, coordinates: usize, inputs: usize) -> Self {
        let weights = |kind: u64, count: usize| {
            let weights = (0..count).map(|index| point.weight(kind, index));
            weights.collect()
        };
        Self {
            state: weights(0, 2 * coordinates + 1),
            inputs: weights(1, inputs),
            velocities: weights(2, coordinates),
            parameters: BTreeMap::new(),
        }
    }

    /// Leaves the velocities of the last coordinates, which stand for multipliers, as they are.
    pub(crate) fn without_multipliers(mut self, multipliers: usize) -> Self {
        let coordinates = self.velocities.len();
        let free = coordinates - multipliers;
        self.state[coordinates + free..2 * coordinates].fill(0.0);
        self.velocities[free..].fill(0.0);
        self
    }

    /// A variation of the inputs alone.
    pub(crate) fn of_inputs(&self) -> Self {
        let parameters = BTreeMap::new();
        let none = Self::of_parameters(self.velocities.len(), 0, parameters);
        Self {
            inputs: self.inputs.clone(),
            velocities: self.velocities.clone(),
            ..none
        }
    }

    /// A variation of parameters alone.
    pub(crate) fn of_parameters(
        coordinates: usize,
        inputs: usize,
        parameters: BTreeMap<Symbol, f64>,
    ) -> Self {
        Self {
            state: vec![0.0; 2 * coordinates + 1],
            inputs: vec![0.0; inputs],
            velocities: vec![0.0; coordinates],
            parameters,
        }
    }
}

impl Lagrange {
    /// The equations of `model`, whose graph may have become `graph` and whose last coordinates stand for so many
    /// multipliers.
    pub(crate) fn new(
        model: &Model,
        graph: &Graph,
        multipliers: usize,
        stand_ins: &StandIns,
    ) -> Self {
        let (energies, _) = model.energies.weighted();
        let mut roots = energies.clone();
        roots.push(model.dissipation);
        roots.extend(&model.forces);
        let tape = |roots: &[Expression]| {
            let mut tape = Tape::of_expressions(graph, roots);
            tape.use_stand_ins(stand_ins);
            tape
        };
        Self {
            tape: tape(&roots),
            outputs: tape(&model.outputs),
            coordinates: model.coordinates as usize,
            multipliers,
            inputs: model.inputs as usize,
            energies: energies.len(),
            dissipates: !model.graph.is_zero(model.dissipation),
        }
    }

    /// The values at a point with these accelerations; none outside of the domain.
    pub(crate) fn values(
        &self,
        point: RealPoint,
        variation: &Variation,
        accelerations: &[f64],
        perturbation: Perturbation,
    ) -> Option<Values> {
        let n = self.coordinates;
        let symbol = |symbol: Symbol| self.moving(point, symbol, variation, accelerations);
        let values = self.tape.run(&symbol, perturbation);
        let largest = values.iter().map(|x| x.value.abs()).fold(0.0, f64::max);
        let slots = self.tape.outputs();
        let at = |position: usize| values[slots[position] as usize];
        let lagrangian = self.gradient(&values, &self.lagrangian_weights(), perturbation);
        let dissipation = if self.dissipates {
            self.gradient(&values, &[(self.energies, 1.0)], perturbation)
        } else {
            Gradient::zero(n)
        };
        let mut result = Values {
            largest,
            lagrangian: 0.0,
            energies: Vec::new(),
            momenta: Vec::with_capacity(n),
            generalized_forces: Vec::with_capacity(n),
            residuals: Vec::with_capacity(n),
            variations: Vec::with_capacity(n),
            mass_products: self.mass_products(point, &variation.velocities, perturbation),
            outputs: Vec::new(),
            momentum_rates: Vec::with_capacity(n),
            energy_rate: SumWithSize::default(),
        };
        for (position, weight) in self.lagrangian_weights() {
            let energy = at(position).value;
            result.lagrangian += weight * energy;
            if self.energies == 2 {
                result.energies.push(energy);
            }
        }
        if !result.lagrangian.is_finite() {
            return None;
        }
        for i in 0..n {
            result.add_equation(Equation {
                momentum: lagrangian.velocities[i],
                slope: lagrangian.coordinates[i],
                force: at(self.energies + 1 + i),
                drag: dissipation.velocities[i],
            })?;
            let velocity = self.at(point, Symbol::Velocity(position(i)));
            result
                .energy_rate
                .add(result.generalized_forces[i] * velocity);
        }
        result.energy_rate.add(-lagrangian.time.value);
        let state = |symbol: Symbol| match symbol {
            Symbol::Acceleration(i) => accelerations[i as usize],
            _ => point.value(symbol),
        };
        result.outputs = self.outputs.evaluate(&state, perturbation);
        Some(result)
    }

    /// The value of a symbol; of a velocity that stands for a multiplier, 0.
    pub(crate) fn at(&self, point: RealPoint, symbol: Symbol) -> f64 {
        let free = self.coordinates - self.multipliers;
        match symbol {
            Symbol::Velocity(i) if i as usize >= free => 0.0,
            _ => point.value(symbol),
        }
    }

    /// L as a sum of roots.
    fn lagrangian_weights(&self) -> Vec<(usize, f64)> {
        let weights = [(0, 1.0), (1, -1.0)];
        weights[..self.energies].to_vec()
    }

    fn gradient(
        &self,
        values: &[HyperDual],
        weights: &[(usize, f64)],
        perturbation: Perturbation,
    ) -> Gradient {
        let mut gradient = Gradient::zero(self.coordinates);
        let slots = self.tape.outputs();
        let mut weighted = Vec::with_capacity(weights.len());
        for (position, weight) in weights {
            weighted.push((slots[*position], *weight));
        }
        let mut receive = |symbol: Symbol, adjoint: HyperDual| match symbol {
            Symbol::Coordinate(i) => gradient.coordinates[i as usize] = adjoint,
            Symbol::Velocity(i) => gradient.velocities[i as usize] = adjoint,
            Symbol::Time => gradient.time = adjoint,
            _ => {}
        };
        self.tape
            .gradient(values, &weighted, perturbation, &mut receive);
        gradient
    }

    /// M w, the change of p where velocities change by w.
    fn mass_products(
        &self,
        point: RealPoint,
        velocities: &[f64],
        perturbation: Perturbation,
    ) -> Vec<f64> {
        let symbol = |symbol: Symbol| {
            let first = match symbol {
                Symbol::Velocity(i) => velocities[i as usize],
                _ => 0.0,
            };
            HyperDual {
                first,
                ..HyperDual::constant(self.at(point, symbol))
            }
        };
        let values = self.tape.run(&symbol, perturbation);
        let gradient = self.gradient(&values, &self.lagrangian_weights(), perturbation);
        let momenta = gradient.velocities.iter();
        momenta.map(|momentum| momentum.first).collect()
    }
}

/// The terms of one of Lagrange's equations, dp/dt − ∂L/∂q − force + drag.
#[derive(Clone, Copy)]
struct Equation {
    momentum: HyperDual,
    slope: HyperDual,
    force: HyperDual,
    drag: HyperDual,
}

impl Values {
    /// Adds the balance of one equation; none where a term is not finite.
    fn add_equation(&mut self, equation: Equation) -> Option<()> {
        let Equation {
            momentum,
            slope,
            force,
            drag,
        } = equation;
        let parts = [momentum, slope, force, drag];
        if !parts.iter().all(|part| part.is_finite()) {
            return None;
        }
        let (mut residual, mut change) = (SumWithSize::default(), SumWithSize::default());
        for (rate, mixed) in [
            (momentum.first, momentum.mixed),
            (-slope.value, -slope.second),
            (-force.value, -force.second),
            (drag.value, drag.second),
        ] {
            residual.add(rate);
            change.add(mixed);
        }
        let mut rate = SumWithSize::default();
        for term in [slope.value, force.value, -drag.value] {
            rate.add(term);
        }
        self.momentum_rates.push(rate);
        self.momenta.push(momentum.value);
        self.generalized_forces.push(force.value - drag.value);
        self.residuals.push(residual);
        self.variations.push(change);
        Some(())
    }
}

/// The derivatives by coordinates, velocities and time.
struct Gradient {
    coordinates: Vec<HyperDual>,
    velocities: Vec<HyperDual>,
    time: HyperDual,
}

impl Gradient {
    fn zero(coordinates: usize) -> Self {
        let zero = vec![HyperDual::constant(0.0); coordinates];
        Self {
            coordinates: zero.clone(),
            velocities: zero,
            time: HyperDual::constant(0.0),
        }
    }
}

impl Lagrange {
    /// A symbol that moves in time and with the variation.
    pub(crate) fn moving(
        &self,
        point: RealPoint,
        symbol: Symbol,
        variation: &Variation,
        accelerations: &[f64],
    ) -> HyperDual {
        let n = accelerations.len();
        let mut number = HyperDual::constant(self.at(point, symbol));
        match symbol {
            Symbol::Coordinate(i) => {
                let i = i as usize;
                // q̇ varies, too.
                number.first = self.at(point, Symbol::Velocity(position(i)));
                number.second = variation.state[i];
                number.mixed = variation.state[n + i];
            }
            Symbol::Velocity(i) => {
                number.first = accelerations[i as usize];
                number.second = variation.state[n + i as usize];
            }
            Symbol::Time => {
                number.first = 1.0;
                number.second = variation.state[2 * n];
            }
            Symbol::Input(i) => number.second = variation.inputs[i as usize],
            Symbol::Parameter(_) => {
                number.second = variation.parameters.get(&symbol).copied().unwrap_or(0.0);
            }
            Symbol::Acceleration(_)
            | Symbol::Invariant(_)
            | Symbol::Argument(_)
            | Symbol::Order
            | Symbol::ReciprocalOrder
            | Symbol::Convolution(_)
            | Symbol::QuasiVelocity(_)
            | Symbol::QuasiVelocityRate(_)
            | Symbol::RightHandSide(_)
            | Symbol::PositionComponent(_)
            | Symbol::VelocityComponent(_)
            | Symbol::Variation(_) => {}
        }
        number
    }
}

fn position(index: usize) -> u32 {
    u32::try_from(index).unwrap_or(u32::MAX)
}
