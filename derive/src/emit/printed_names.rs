//! The names under which quantities are printed.
//!
//! The numbers of a body are called as books call them: m, the coordinates of the centre of gravity `x_C`, and the elements of
//! the inertia tensor about it `I₁₁`, `I₁₂`, or where its axes are principal ones I₁, I₂, I₃. Of several bodies each has its name
//! behind: `m_upper`. Where one of these is the name of something else, all are called by their place in the struct.

use std::collections::{BTreeMap, BTreeSet};

use lagrangian_symbolic::{Expression, Names};
use proc_macro2::Ident;

use crate::lower::Lowered;
use crate::lower::quantities::Component;
use crate::syntax::body_quantity::BodyQuantity;
use crate::syntax::declaration::Declaration;
use crate::syntax::label::{Index, Label};
use crate::syntax::names::unraw;

/// The names of coordinates, parameters and inputs.
pub(crate) fn printed_names(lowered: &Lowered) -> Names {
    let quantities = &lowered.quantities;
    let inputs = quantities.inputs.iter();
    let coordinates = quantities.coordinates.iter();
    let names = BodyNames::of(lowered);
    let parameters = quantities.parameters.iter();
    let name = |component: &Component| {
        let label = by_axes(&component.label, component.is_of_vector());
        names.name(component, &label)
    };
    Names {
        coordinates: coordinates.map(ToString::to_string).collect(),
        parameters: parameters.map(name).collect(),
        inputs: inputs
            .map(|component| by_axes(&component.label, component.is_of_vector()).to_string())
            .collect(),
        multipliers: multipliers(lowered),
        ..Names::default()
    }
}

/// The names of multipliers: λ where there is one, else with the name of the constraint.
fn multipliers(lowered: &Lowered) -> Vec<String> {
    let labels = lowered.constraints.labels();
    match labels.as_slice() {
        [_] => vec!["lambda".to_owned()],
        labels => labels
            .iter()
            .map(|label| format!("lambda_{label}"))
            .collect(),
    }
}

/// A label whose last index is a letter, if it is that of a component of a vector.
pub(super) fn by_axes(label: &Label, is_of_vector: bool) -> Label {
    let mut label = label.clone();
    if is_of_vector
        && let Some(last) = label.indices.last_mut()
        && let Index::One(i) = *last
        && i < Index::AXES.len()
    {
        *last = Index::Axis(i);
    }
    label
}

/// Vectors, each with how many indices stand before the letter of a component.
pub(super) fn vectors(declaration: &Declaration, lowered: &Lowered) -> BTreeMap<String, usize> {
    let quantities = &lowered.quantities;
    let fields = quantities.parameters.iter().chain(&quantities.inputs);
    let fields = fields.map(|component| by_axes(&component.label, component.is_of_vector()));
    let definitions = declaration.clauses.definitions.iter();
    let definitions = definitions.flat_map(|named| defined(lowered, &named.name));
    let coordinates = quantities.coordinates.iter().cloned();
    let labels = coordinates
        .chain(fields)
        .chain(definitions.map(|(label, _)| label));
    let vectors = labels.filter_map(|label| match label.indices.as_slice() {
        [outer @ .., Index::Axis(_)] => Some((label.stem, outer.len())),
        _ => None,
    });
    vectors.collect()
}

/// The components of what is defined, of vectors in space and in the plane by their letters.
pub(super) fn defined(lowered: &Lowered, name: &Ident) -> Vec<(Label, Expression)> {
    let scope = &lowered.scope;
    let outer = scope.rank_of_definition(name).unwrap_or(0);
    let components = scope.defined(&unraw(name));
    let last = components
        .iter()
        .filter_map(|(label, _)| match *label.indices.get(outer)? {
            Index::One(i) => Some(i),
            _ => None,
        });
    let is_of_vector = last.max().is_some_and(|last| (1..3).contains(&last));
    components
        .into_iter()
        .map(|(label, x)| {
            let is_component = label.indices.len() == outer + 1;
            (by_axes(&label, is_of_vector && is_component), x)
        })
        .collect()
}

/// How the numbers of bodies are called.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(super) enum BodyNames {
    /// Without the name of the body, which is the only one.
    Alone,
    /// With the name of the body behind.
    WithBody,
    /// By their labels.
    Labels,
}

impl BodyNames {
    /// The first way in which nothing else has one of the names.
    pub(super) fn of(lowered: &Lowered) -> Self {
        let parameters = &lowered.quantities.parameters;
        let (of_bodies, others): (Vec<_>, Vec<_>) = parameters
            .iter()
            .partition(|component| quantity(&component.label).is_some());
        let fields: BTreeSet<_> = of_bodies.iter().map(|c| &c.label.stem).collect();
        let others = others.into_iter().map(|component| &component.label.stem);
        let named = lowered.scope.quantities().into_iter();
        let taken: BTreeSet<_> = others
            .map(String::as_str)
            .chain(named)
            .map(letters)
            .collect();
        let ways = [Self::Alone, Self::WithBody];
        let mut ways = ways.into_iter().skip(usize::from(fields.len() > 1));
        let free = |way: &Self| {
            let names = of_bodies.iter().flat_map(|component| {
                let angular = way.angular_velocity(&component.label);
                angular
                    .into_iter()
                    .chain([way.name(component, &component.label)])
            });
            names
                .into_iter()
                .all(|name| !taken.contains(&letters(&name)))
        };
        ways.find(free).unwrap_or(Self::Labels)
    }

    /// The name of a parameter with this label.
    fn name(self, component: &Component, label: &Label) -> String {
        let Some((quantity, index)) = quantity(label).filter(|_| self != Self::Labels) else {
            return label.to_string();
        };
        let body = self.body(label);
        match (quantity, index) {
            (BodyQuantity::Center, Some(Index::Axis(i))) => {
                let axis = Index::AXES.get(i).copied().unwrap_or_default();
                format!("{axis}_C{body}")
            }
            (BodyQuantity::Inertia, Some(Index::Pair { row, column })) => {
                let second = (!component.is_principal()).then(|| (column + 1).to_string());
                format!("I{body}_{}{}", row + 1, second.unwrap_or_default())
            }
            _ => format!("m{body}"),
        }
    }

    /// The names of the components of the angular velocity of a body, of which this is the label of one of its numbers.
    pub(super) fn angular_velocity(self, label: &Label) -> [String; 3] {
        let body = self.body(label);
        [1, 2, 3].map(|i| format!("omega{body}_{i}"))
    }

    /// The letter of a quantity of a body, without the indices of a family.
    pub(super) fn with_name(self, letter: &str, body: &str) -> String {
        match self {
            Self::Alone => letter.to_owned(),
            _ => format!("{letter}_{body}"),
        }
    }

    /// What follows the letter of a number: the name of the body, if there are several, and its index.
    fn body(self, label: &Label) -> String {
        let indices = label.indices.iter();
        let indices = indices.take_while(|index| matches!(index, Index::One(_)));
        let indices: String = indices.map(ToString::to_string).collect();
        match self {
            Self::Alone => indices,
            _ => format!("_{}{indices}", label.stem),
        }
    }
}

/// Which number of a body a label means.
fn quantity(label: &Label) -> Option<(BodyQuantity, Option<Index>)> {
    let position = label
        .indices
        .iter()
        .position(|index| matches!(index, Index::Quantity(_)))?;
    match label.indices[position] {
        Index::Quantity(quantity) => Some((quantity, label.indices.get(position + 1).copied())),
        _ => None,
    }
}

/// A name without what is printed differently anyway.
fn letters(name: &str) -> String {
    name.chars().filter(|c| c.is_alphanumeric()).collect()
}
