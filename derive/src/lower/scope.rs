//! Name resolution: the names of a declaration, and what they refer to.

use std::collections::{BTreeMap, BTreeSet};
use std::rc::Rc;

use lagrangian_symbolic::{
    Components, Expression, ExternalFunction, Graph, Symbol, TypedGraph, TypedOperation, Value,
};
use proc_macro2::Ident;

use crate::diagnostics::similar;
use crate::lower::body::Body;
use crate::lower::quantities::Symbols;
use crate::lower::value::labelled;
use crate::syntax::body_type::BodyType;
use crate::syntax::declaration::Declaration;
use crate::syntax::field::Role;
use crate::syntax::field_type::Content;
use crate::syntax::label::{Index, Label};
use crate::syntax::names::{to_source, unraw};
use crate::syntax::scalar::has_numbers;
use crate::syntax::shape::Shape;

/// What a name refers to.
#[derive(Clone)]
pub(crate) enum Binding {
    /// A quantity.
    Quantity(Origin, Value),
    /// Several quantities, distinguished by indices.
    Family(Origin, Rc<Family>),
    /// A body, or several, distinguished by indices.
    Bodies(Rc<Family<Body>>),
    /// A quantity from `define` further down.
    DefinedLater,
    /// Poisoned: an error in its declaration has been reported.
    Poisoned,
    /// A field that is marked `skip`.
    Skipped,
    /// A quantity from `output`, which no expression refers to.
    Output,
}

/// Where a quantity comes from.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Origin {
    /// The time, and π.
    Reserved,
    /// The coordinates.
    Coordinate,
    /// A parameter or input.
    Field,
    /// `define`.
    Defined,
    /// The variable of an iteration.
    Variable,
}

/// Quantities, or bodies, that are distinguished by indices.
#[derive(Clone)]
pub(crate) struct Family<T = Value> {
    /// How many indices distinguish them.
    pub(crate) rank: usize,
    pub(crate) members: BTreeMap<Vec<usize>, T>,
}

impl<T> Family<T> {
    /// The members with these indices, if all of them exist.
    fn of(indices: Vec<Vec<usize>>, mut member: impl FnMut() -> Option<T>) -> Option<Rc<Self>> {
        let rank = indices.first().map_or(0, Vec::len);
        let members = indices.into_iter();
        let members = members.map(|indices| Some((indices, member()?)));
        let members = members.collect::<Option<_>>()?;
        Some(Rc::new(Self { rank, members }))
    }
}

/// Components with their names.
type Labelled = Vec<(Label, Expression)>;

/// The names of a declaration, with what they refer to.
pub(crate) struct Scope {
    bindings: BTreeMap<String, Binding>,
    /// The components of what is defined, by names and indices of members.
    defined: BTreeMap<String, BTreeMap<Vec<usize>, Labelled>>,
    /// The external functions.
    functions: BTreeMap<String, ExternalFunction>,
    /// Where a field is first mentioned: the emitted code accesses it with that span.
    uses: BTreeMap<String, Ident>,
    /// Unresolved names, wherever they were written.
    unknown: Vec<Ident>,
    /// Whether all names of the declaration are here. They are not where coordinates or definitions could not be
    /// parsed, or where two coordinates have one name.
    pub(crate) complete: bool,
    /// Whether all external functions are here.
    pub(crate) functions_complete: bool,
    /// Whether the fields have names, one of which an unresolved name may be misspelled for.
    names_fields: bool,
}

impl Scope {
    /// The scope of a checked declaration, before its definitions.
    pub(crate) fn new(declaration: &Declaration, typed: &mut TypedGraph) -> Self {
        let mut bindings = reserved(typed);
        add_fields(&mut bindings, declaration, typed);
        add_coordinates(&mut bindings, declaration, typed);
        add_names_without_values(&mut bindings, declaration);
        let clauses = &declaration.clauses;
        let names: BTreeSet<String> = clauses
            .coordinates
            .iter()
            .map(|coordinate| unraw(&coordinate.name))
            .collect();
        let repeated = names.len() < clauses.coordinates.len();
        Self {
            bindings,
            defined: BTreeMap::new(),
            functions: BTreeMap::new(),
            uses: BTreeMap::new(),
            unknown: Vec::new(),
            functions_complete: !clauses.functions_unreadable,
            names_fields: declaration.names_fields,
            complete: !clauses.names_unreadable && !clauses.coordinates.is_empty() && !repeated,
        }
    }

    /// What `name` refers to, if anything.
    pub(crate) fn resolve(&mut self, name: &Ident) -> Option<Binding> {
        let written = unraw(name);
        let binding = self.bindings.get(&written)?.clone();
        if let Binding::Quantity(Origin::Field, _)
        | Binding::Family(Origin::Field, _)
        | Binding::Bodies(..) = binding
        {
            self.uses.entry(written).or_insert_with(|| name.clone());
        }
        Some(binding)
    }

    /// Whether a name refers to anything.
    pub(crate) fn is_bound(&self, name: &str) -> bool {
        self.bindings.contains_key(name)
    }

    /// Gives the name of a definition its value, unless the name is taken.
    pub(crate) fn define(&mut self, typed: &TypedGraph, name: &Ident, value: Value) {
        if let Some(later @ Binding::DefinedLater) = self.bindings.get_mut(&unraw(name)) {
            *later = Binding::Quantity(Origin::Defined, value);
            self.note_components(typed, name, &[], value);
        }
    }

    /// Adds a member to a family of definitions, unless the name is taken. Says whether the member is
    /// new.
    pub(crate) fn define_member(
        &mut self,
        typed: &TypedGraph,
        name: &Ident,
        indices: &[usize],
        value: Value,
    ) -> bool {
        let Some(binding) = self.bindings.get_mut(&unraw(name)) else {
            return true;
        };
        if let Binding::DefinedLater = binding {
            let rank = indices.len();
            let members = BTreeMap::new();
            *binding = Binding::Family(Origin::Defined, Rc::new(Family { rank, members }));
        }
        match binding {
            Binding::Family(Origin::Defined, family) => {
                let members = &mut Rc::make_mut(family).members;
                let is_new = members.insert(indices.to_vec(), value).is_none();
                self.note_components(typed, name, indices, value);
                is_new
            }
            _ => true,
        }
    }

    /// Keeps the components of what is defined, which the emitted code and the printed equations have names for.
    fn note_components(
        &mut self,
        typed: &TypedGraph,
        name: &Ident,
        indices: &[usize],
        value: Value,
    ) {
        let stem = unraw(name);
        let label = |inner: Vec<Index>| {
            let outer = indices.iter().copied().map(Index::One);
            Label {
                stem: stem.clone(),
                indices: outer.chain(inner).collect(),
            }
        };
        let components = labelled(typed, value).into_iter();
        let components = components.map(|(inner, component)| (label(inner), component));
        let members = self.defined.entry(stem.clone()).or_default();
        members.insert(indices.to_vec(), components.collect());
    }

    /// How many indices distinguish the members of a family of definitions, if there are any yet.
    pub(crate) fn rank_of_definition(&self, name: &Ident) -> Option<usize> {
        match self.bindings.get(&unraw(name))? {
            Binding::Family(Origin::Defined, family) => Some(family.rank),
            _ => None,
        }
    }

    /// Poisons a definition with an error, or a family of them with an error in one of them.
    pub(crate) fn poison_definition(&mut self, name: &Ident) {
        if let Some(binding @ (Binding::DefinedLater | Binding::Family(Origin::Defined, _))) =
            self.bindings.get_mut(&unraw(name))
        {
            *binding = Binding::Poisoned;
            self.defined.remove(&unraw(name));
        }
    }

    /// Gives the name of a function its binding, unless there is one already.
    pub(crate) fn declare_function(&mut self, name: &Ident, function: ExternalFunction) {
        self.functions.entry(unraw(name)).or_insert(function);
    }

    /// The external function that is called `name`.
    pub(crate) fn function(&self, name: &Ident) -> Option<ExternalFunction> {
        self.functions.get(&unraw(name)).copied()
    }

    /// The external function that was probably meant by an unknown name.
    pub(crate) fn suggest_function(&self, name: &Ident) -> Option<&str> {
        similar(&unraw(name), self.functions.keys().map(String::as_str))
    }

    /// Binds a name, which shadows what it referred to until [`release`](Self::release).
    pub(crate) fn bind(&mut self, name: &Ident, value: Value) -> Option<Binding> {
        let binding = Binding::Quantity(Origin::Variable, value);
        self.bindings.insert(unraw(name), binding)
    }

    pub(crate) fn release(&mut self, name: &Ident, before: Option<Binding>) {
        match before {
            Some(binding) => self.bindings.insert(unraw(name), binding),
            None => self.bindings.remove(&unraw(name)),
        };
    }

    /// Poisons a name: no more errors are reported for it.
    pub(crate) fn silence(&mut self, name: &Ident) {
        self.bindings.insert(unraw(name), Binding::Poisoned);
    }

    /// Whether there is a coordinate, or a family of them, called `name`.
    pub(crate) fn is_coordinate(&self, name: &str) -> bool {
        matches!(
            self.bindings.get(name),
            Some(Binding::Quantity(Origin::Coordinate, _) | Binding::Family(Origin::Coordinate, _))
        )
    }

    /// The quantity that was probably meant by an unknown name.
    pub(crate) fn suggest(&self, name: &Ident) -> Option<String> {
        let meant = similar(&unraw(name), self.bindings.keys().map(String::as_str))?;
        match self.bindings[meant] {
            Binding::Skipped | Binding::Output => None,
            _ => Some(to_source(meant)),
        }
    }

    /// Notes an unresolved name, which an editor may complete to a field. Says whether it is to be
    /// reported: once, and only where fields have names.
    pub(crate) fn note_unknown(&mut self, name: &Ident) -> bool {
        let is_new = self.unknown.iter().all(|noted| noted != name);
        self.unknown.push(name.clone());
        is_new && self.names_fields
    }

    /// The names of fields, coordinates, definitions and variables.
    pub(crate) fn quantities(&self) -> Vec<&str> {
        let is_quantity = |binding: &Binding| match binding {
            Binding::Quantity(kind, _) | Binding::Family(kind, _) => *kind != Origin::Reserved,
            Binding::Bodies(..) => true,
            _ => false,
        };
        let known = self.bindings.iter();
        let known = known.filter(|(_, binding)| is_quantity(binding));
        known.map(|(name, _)| name.as_str()).collect()
    }

    /// The unresolved names, wherever they were written.
    pub(crate) fn unknown(&self) -> impl Iterator<Item = &Ident> {
        self.unknown.iter()
    }

    /// Where the field called `name` is first mentioned.
    pub(crate) fn first_use(&self, name: &Ident) -> Option<&Ident> {
        self.uses.get(&unraw(name))
    }

    /// The components of what is defined as `name`.
    pub(crate) fn defined(&self, name: &str) -> Labelled {
        let members = self.defined.get(name).into_iter().flatten();
        members
            .flat_map(|(_, components)| components.iter().cloned())
            .collect()
    }

    /// The components of all that is defined, but for constants.
    pub(crate) fn definitions<'a>(
        &'a self,
        graph: &'a Graph,
    ) -> impl Iterator<Item = (Label, Expression)> + 'a {
        let components = self.defined.keys().flat_map(|name| self.defined(name));
        components.filter(|(_, expression)| graph.as_constant(*expression).is_none())
    }
}

type Meanings = BTreeMap<String, Binding>;

/// The names that every declaration has.
fn reserved(typed: &mut TypedGraph) -> Meanings {
    let graph = &mut typed.geometry.graph;
    let reserved = [("t", graph.symbol(Symbol::Time)), ("PI", graph.pi())];
    let reserved = reserved.into_iter().filter_map(|(name, expression)| {
        let given = TypedOperation::Given(Components::Scalar(expression));
        let value = typed.add(given).ok()?;
        Some((name.to_owned(), Binding::Quantity(Origin::Reserved, value)))
    });
    reserved.collect()
}

/// Adds parameters and inputs.
fn add_fields(bindings: &mut Meanings, declaration: &Declaration, typed: &mut TypedGraph) {
    let kinds = [
        (Role::Parameter, Symbol::Parameter as fn(u32) -> Symbol),
        (Role::Input, Symbol::Input),
    ];
    for (role, kind) in kinds {
        let mut symbols = Symbols::of(kind);
        for field in declaration.fields_with(role) {
            let binding = match field.field_type() {
                Ok(field_type) if has_numbers(declaration, &field_type) => {
                    let indices = (field_type.rank() > 0).then(|| field_type.members());
                    match field_type.content() {
                        Content::Numbers(shape) => {
                            symbols.binding(typed, Origin::Field, shape, indices)
                        }
                        Content::Body(_) if role == Role::Input => Binding::Poisoned,
                        Content::Body(ty) => symbols.bodies(typed, ty, indices),
                    }
                }
                Ok(_) | Err(_) => Binding::Poisoned,
            };
            bindings.insert(unraw(&field.name), binding);
        }
    }
}

fn add_coordinates(bindings: &mut Meanings, declaration: &Declaration, typed: &mut TypedGraph) {
    let mut symbols = Symbols::of(Symbol::Coordinate);
    for coordinate in &declaration.clauses.coordinates {
        let is_family = !coordinate.lengths.is_empty();
        let indices = is_family.then(|| coordinate.members());
        let binding = symbols.binding(typed, Origin::Coordinate, coordinate.shape(), indices);
        bindings.insert(unraw(&coordinate.name), binding);
    }
}

/// Adds names without a value, or without one yet. A name that is taken keeps its binding: an output may be
/// called like what it shows.
fn add_names_without_values(bindings: &mut Meanings, declaration: &Declaration) {
    let clauses = &declaration.clauses;
    let definitions = clauses.definitions.iter().map(|named| &named.name);
    let skipped = declaration.fields_with(Role::Skipped);
    let skipped = skipped.map(|field| &field.name);
    let outputs = clauses.outputs.iter().map(|named| &named.name);
    let others = definitions
        .map(|name| (name, Binding::DefinedLater))
        .chain(skipped.map(|name| (name, Binding::Skipped)))
        .chain(outputs.map(|name| (name, Binding::Output)));
    for (name, binding) in others {
        bindings.entry(unraw(name)).or_insert(binding);
    }
}

impl Symbols {
    /// A quantity of which each component is a symbol, or a family of those with these indices.
    fn binding(
        &mut self,
        typed: &mut TypedGraph,
        kind: Origin,
        shape: Shape,
        indices: Option<Vec<Vec<usize>>>,
    ) -> Binding {
        let mut value = || self.value(typed, shape);
        let binding = match indices {
            None => value().map(|value| Binding::Quantity(kind, value)),
            Some(indices) => Family::of(indices, value).map(|family| Binding::Family(kind, family)),
        };
        binding.unwrap_or(Binding::Poisoned)
    }

    /// A body whose numbers are symbols, or a family of those with these indices.
    fn bodies(
        &mut self,
        typed: &mut TypedGraph,
        ty: BodyType,
        indices: Option<Vec<Vec<usize>>>,
    ) -> Binding {
        let indices = indices.unwrap_or_else(|| vec![Vec::new()]);
        let family = Family::of(indices, || Body::of_symbols(ty, self, typed));
        family.map_or(Binding::Poisoned, Binding::Bodies)
    }
}
