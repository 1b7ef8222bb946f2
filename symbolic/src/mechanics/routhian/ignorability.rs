//! What makes a coordinate not ignorable.

use crate::mechanics::conservation::independent_of;
use crate::{Energies, Equations, Model, Symbol};

/// A coordinate that is not ignorable, and why.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Spoiler {
    /// The position of the coordinate.
    pub coordinate: usize,
    /// What spoils it.
    pub obstacles: Vec<Obstacle>,
}

/// What a coordinate cannot be ignorable for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Obstacle {
    /// The kinetic energy depends on it.
    Kinetic,
    /// The potential energy depends on it.
    Potential,
    /// The Lagrangian depends on it.
    Lagrangian,
    /// The clause `force` acts on it.
    Force,
    /// An input acts on it.
    Input,
    /// Dissipation acts on it.
    Dissipation,
    /// A constraint acts on it.
    Constraint,
}

/// On which coordinates the parts of L depend, and on which the forces act.
pub(super) struct Influences(Vec<(Obstacle, Vec<bool>)>);

impl Influences {
    pub(super) fn of(model: &Model, equations: &Equations) -> Self {
        let coordinates = model.coordinate_symbols();
        let depends = |expression| {
            let absent = independent_of(model, expression, &coordinates);
            absent.iter().map(|absent| !absent).collect::<Vec<_>>()
        };
        let mut found = match model.energies {
            Energies::Natural { kinetic, potential } => vec![
                (Obstacle::Kinetic, depends(kinetic)),
                (Obstacle::Potential, depends(potential)),
            ],
            Energies::General(lagrangian) => vec![(Obstacle::Lagrangian, depends(lagrangian))],
        };
        // What cancels in L does not matter.
        let whole = depends(equations.lagrangian);
        for (_, parts) in &mut found {
            for (part, whole) in parts.iter_mut().zip(&whole) {
                *part &= whole;
            }
        }
        let mut graph = model.graph.clone();
        let is_input = |symbol| matches!(symbol, Symbol::Input(_));
        let acts = |force: &_| !model.graph.vanishes(&[*force]);
        let driven = |force: &_| acts(force) && model.graph.contains(&[*force], is_input);
        let declared = |force: &_| acts(force) && !model.graph.contains(&[*force], is_input);
        found.push((Obstacle::Force, model.forces.iter().map(declared).collect()));
        found.push((Obstacle::Input, model.forces.iter().map(driven).collect()));
        let drags = graph
            .jacobian(&[model.dissipation], &model.velocity_symbols())
            .concat();
        let drags = drags.iter().map(|drag| !graph.vanishes(&[*drag]));
        found.push((Obstacle::Dissipation, drags.collect()));
        let constrained = (0..coordinates.len()).map(|i| {
            let column = equations.constraints.column(i);
            !model.graph.vanishes(&column)
        });
        found.push((Obstacle::Constraint, constrained.collect()));
        Self(found)
    }
}

/// What spoils each coordinate.
pub(super) fn spoilers(model: &Model, influences: &Influences) -> Vec<Spoiler> {
    let coordinates = 0..model.coordinates as usize;
    coordinates
        .map(|coordinate| {
            let influences = influences.0.iter();
            let on_it = influences.filter(|(_, on)| on[coordinate]);
            Spoiler {
                coordinate,
                obstacles: on_it.map(|(obstacle, _)| *obstacle).collect(),
            }
        })
        .collect()
}
