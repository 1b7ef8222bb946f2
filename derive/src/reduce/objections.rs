//! Why a model has no reduced one.

use lagrangian_symbolic::{Model, NoReduction, Obstacle, Spoiler};

use crate::lower::Lowered;

/// Why there is no reduced model.
pub(super) fn message(reason: &NoReduction, lowered: &Lowered, model: &Model) -> String {
    let name = |i: &usize| format!("`{}`", lowered.quantities.coordinates[*i]);
    match reason {
        NoReduction::NoneIgnorable(spoilers) => {
            let all = spoilers
                .iter()
                .map(|spoiler| spoiled(spoiler, &name(&spoiler.coordinate)));
            let all: Vec<String> = all.collect();
            format!(
                "no coordinate is ignorable, so there is nothing to reduce: {}; leave `routhian` out, or write the model in \
                 coordinates of which one neither matters to the Lagrangian nor is acted on by a force",
                all.join("; ")
            )
        }
        NoReduction::NoneRemains => {
            let all: Vec<String> = (0..model.coordinates as usize).map(|i| name(&i)).collect();
            format!(
                "all coordinates are ignorable, {}, so that none remains: all momenta are constant, and \
                 `constants_of_motion` has them; leave `routhian` out",
                all.join(", ")
            )
        }
        NoReduction::ForceDependsOn(acted, on) => format!(
            "the generalized force on {} depends on {}, which would be ignorable otherwise: the other coordinates do not \
             move independently of it; leave `routhian` out, or write the force in other coordinates",
            name(acted),
            name(on)
        ),
        NoReduction::ConstraintDependsOn {
            constraint,
            coordinate,
        } => {
            let labels = lowered.constraints.labels();
            let constraint = labels.get(*constraint).map(ToString::to_string);
            format!(
                "the constraint `{}` depends on {}, which would be ignorable otherwise: the other coordinates do not move \
                 independently of it; leave `routhian` out, or write the constraint in other coordinates",
                constraint.unwrap_or_default(),
                name(coordinate)
            )
        }
        NoReduction::NotQuadratic(coordinate) => format!(
            "{} is ignorable, but the Lagrangian is not quadratic in its velocity, so that the velocity cannot be \
             eliminated: leave `routhian` out",
            name(coordinate)
        ),
    }
}

/// What spoils a coordinate.
fn spoiled(spoiler: &Spoiler, name: &str) -> String {
    let reasons = spoiler.obstacles.iter().map(|obstacle| match obstacle {
        Obstacle::Kinetic => "the kinetic energy depends on it",
        Obstacle::Potential => "the potential energy depends on it",
        Obstacle::Lagrangian => "the Lagrangian depends on it",
        Obstacle::Force => "a force acts on it",
        Obstacle::Input => "an input acts on it",
        Obstacle::Dissipation => "dissipation acts on it",
        Obstacle::Constraint => "a constraint acts on it",
    });
    let reasons: Vec<&str> = reasons.collect();
    format!("{name} is not, since {}", reasons.join(" and "))
}
