//! Coordinates, parameters and inputs, component by component: each component is one symbol.

use lagrangian_symbolic::{Expression, Graph, Matrix, Symbol};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{quote, quote_spanned};
use syn::Type;
use syn::spanned::Spanned as _;

use crate::lower::value::Value;
use crate::syntax::coordinate::Coordinate;
use crate::syntax::declaration::Declaration;
use crate::syntax::field::{Field, Role};
use crate::syntax::label::{Index, Label};
use crate::syntax::names::unraw;
use crate::syntax::shape::Shape;

/// Coordinates, parameters and inputs, in the order in which symbols count them.
pub(crate) struct Quantities {
    pub(crate) coordinates: Vec<Label>,
    pub(crate) parameters: Vec<Component>,
    pub(crate) inputs: Vec<Component>,
}

/// One component of a field.
pub(crate) struct Component {
    pub(crate) field: Ident,
    pub(crate) label: Label,
    /// The tokens that follow the field to read the component.
    access: TokenStream,
    /// The type of the component.
    pub(crate) element: Type,
    /// The declared type of the field, where it is declared by `type = …`.
    declared_type: Option<Type>,
}

impl Component {
    /// The components of a field, member by member and column by column; none where its type is
    /// unsupported.
    fn of(field: &Field) -> Vec<Self> {
        let Ok(field_type) = field.field_type() else {
            return Vec::new();
        };
        let accesses = field_type.accesses();
        let mut components = Vec::new();
        for member in field_type.members() {
            let indices = member.iter().map(|i| Literal::usize_unsuffixed(*i));
            let index: TokenStream = indices.map(|i| quote!([#i])).collect();
            for (i, access) in accesses.iter().enumerate() {
                let outer = member.iter().copied().map(Index::One);
                components.push(Self {
                    field: field.name.clone(),
                    label: Label {
                        stem: unraw(&field.name),
                        indices: outer.chain(field_type.shape().index(i)).collect(),
                    },
                    access: quote!(#index #access),
                    element: field_type.element.clone(),
                    declared_type: field.declared_type.clone(),
                });
            }
        }
        components
    }

    /// The expression that reads the component, with the name of the field where it is mentioned.
    pub(crate) fn read(&self, field: &Ident) -> TokenStream {
        let access = &self.access;
        let Some(declared_type) = &self.declared_type else {
            return quote!(self.#field #access);
        };
        // The compiler says so where the type is another.
        let checked = quote_spanned!(declared_type.span()=> ::core::convert::identity::<&#declared_type>(&self.#field));
        if access.is_empty() {
            quote!(*#checked)
        } else {
            quote!(#checked #access)
        }
    }
}

impl Quantities {
    pub(crate) fn new(declaration: &Declaration) -> Self {
        let components = |role| {
            let fields = declaration.fields_with(role);
            fields.flat_map(Component::of).collect()
        };
        let coordinates = declaration.clauses.coordinates.iter();
        Self {
            coordinates: coordinates.flat_map(Coordinate::labels).collect(),
            parameters: components(Role::Parameter),
            inputs: components(Role::Input),
        }
    }

    /// The name of a symbol in the emitted code.
    pub(crate) fn variable(&self, symbol: Symbol) -> String {
        let coordinate = |i: u32, suffix: &str| {
            let name = self.coordinates.get(i as usize).map(Label::variable);
            name.unwrap_or_default() + suffix
        };
        let component = |list: &[Component], i: u32| {
            let name = list.get(i as usize).map(|found| found.label.variable());
            name.unwrap_or_default()
        };
        match symbol {
            Symbol::Time => "t".to_owned(),
            Symbol::Coordinate(i) => coordinate(i, ""),
            Symbol::Velocity(i) => coordinate(i, "_dot"),
            Symbol::Acceleration(i) => coordinate(i, "_ddot"),
            Symbol::Parameter(i) => component(&self.parameters, i),
            Symbol::Input(i) => component(&self.inputs, i),
            Symbol::Invariant(i) => format!("c{i}"),
            Symbol::Argument(i) => format!("x{i}"),
            Symbol::Order => "k".to_owned(),
            Symbol::ReciprocalOrder => "k_recip".to_owned(),
            Symbol::Convolution(i) => format!("s{i}"),
            Symbol::PositionComponent(i) | Symbol::RightHandSide(i) => format!("r{i}"),
            Symbol::QuasiVelocityRate(i) => format!("w{i}_dot"),
            Symbol::QuasiVelocity(i) | Symbol::VelocityComponent(i) => format!("w{i}"),
        }
    }
}

/// Allocates the symbols of one kind, in order.
pub(crate) struct Symbols {
    kind: fn(u32) -> Symbol,
    next: u32,
}

impl Symbols {
    pub(crate) const fn of(kind: fn(u32) -> Symbol) -> Self {
        Self { kind, next: 0 }
    }

    /// The next symbol.
    pub(crate) fn scalar(&mut self, graph: &mut Graph) -> Value {
        Value::Scalar(self.take(graph))
    }

    /// A value of which each component is a symbol.
    pub(crate) fn value(&mut self, graph: &mut Graph, shape: Shape) -> Value {
        let Shape::Array { rows, columns } = shape else {
            return self.scalar(graph);
        };
        let elements = (0..rows * columns).map(|_| self.take(graph)).collect();
        Matrix::new(rows, columns, elements).map_or(Value::EmptySum, Value::Array)
    }

    fn take(&mut self, graph: &mut Graph) -> Expression {
        let symbol = (self.kind)(self.next);
        self.next = self.next.saturating_add(1);
        graph.symbol(symbol)
    }
}
