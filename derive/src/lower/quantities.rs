//! Coordinates, parameters and inputs, component by component: each component is one symbol.

use lagrangian_symbolic::{
    Components, Expression, Matrix, Symbol, TypedGraph, TypedOperation, Value,
};
use proc_macro2::{Ident, Literal, TokenStream};
use quote::{quote, quote_spanned};
use syn::spanned::Spanned as _;
use syn::{Type, parse_quote};

use crate::syntax::body_type::{BodyNumber, BodyType};
use crate::syntax::coordinate::Coordinate;
use crate::syntax::declaration::Declaration;
use crate::syntax::field::{Field, Role};
use crate::syntax::field_type::{Content, FieldType, vector};
use crate::syntax::label::{Index, Label};
use crate::syntax::names::unraw;
use crate::syntax::root::Root;
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
    access: Access,
    /// The type of the component.
    pub(crate) element: Type,
    /// The declared type of the field, where it is declared by `type = …`.
    declared_type: Option<Type>,
    /// Whether it is a component of a vector of nalgebra, which has a letter for each.
    is_of_vector: bool,
}

/// How a component of a field is read.
enum Access {
    /// By the tokens that follow the field.
    Behind(TokenStream),
    /// By a method of the body that these tokens behind the field select.
    OfBody {
        member: TokenStream,
        ty: BodyType,
        number: BodyNumber,
    },
}

impl Component {
    /// The components of a field, member by member and column by column; none where its type is
    /// unsupported.
    fn of(field: &Field) -> Vec<Self> {
        let Ok(field_type) = field.field_type() else {
            return Vec::new();
        };
        let element = field_type.element.cloned();
        let element = element.unwrap_or_else(|| parse_quote!(::core::primitive::f64));
        let is_of_vector = vector(innermost(&field.ty)).is_some();
        let mut components = Vec::new();
        for member in field_type.members() {
            let indices = member.iter().map(|i| Literal::usize_unsuffixed(*i));
            let index: TokenStream = indices.map(|i| quote!([#i])).collect();
            for (inner, access) in accesses(&field_type, &index) {
                let outer = member.iter().copied().map(Index::One);
                components.push(Self {
                    field: field.name.clone(),
                    label: Label {
                        stem: unraw(&field.name),
                        indices: outer.chain(inner).collect(),
                    },
                    access,
                    element: element.clone(),
                    declared_type: field.declared_type.clone(),
                    is_of_vector,
                });
            }
        }
        components
    }

    /// Whether this is a number of a body whose axes are principal ones.
    pub(crate) fn is_principal(&self) -> bool {
        matches!(
            self.access,
            Access::OfBody {
                ty: BodyType::Principal | BodyType::Symmetric,
                ..
            }
        )
    }

    /// Whether it is a component of a vector of nalgebra.
    pub(crate) const fn is_of_vector(&self) -> bool {
        self.is_of_vector
    }

    /// The expression that reads the component, with the name of the field where it is mentioned.
    pub(crate) fn read(&self, field: &Ident, root: &Root) -> TokenStream {
        // The compiler says so where the type is another.
        let checked = self
            .declared_type
            .as_ref()
            .map(|ty| quote_spanned!(ty.span()=> ::core::convert::identity::<&#ty>(&self.#field)));
        match (&self.access, checked) {
            (Access::Behind(access), None) => quote!(self.#field #access),
            (Access::Behind(access), Some(checked)) if access.is_empty() => quote!(*#checked),
            (Access::Behind(access), Some(checked)) => quote!(#checked #access),
            (Access::OfBody { member, ty, number }, checked) => {
                let body = match checked {
                    None => quote!(&self.#field #member),
                    Some(checked) if member.is_empty() => checked,
                    Some(checked) => quote!(&#checked #member),
                };
                ty.read(root, *number, &body)
            }
        }
    }
}

/// The type of the elements of arrays.
fn innermost(ty: &Type) -> &Type {
    match ty {
        Type::Array(array) => innermost(&array.elem),
        Type::Group(group) => innermost(&group.elem),
        Type::Paren(paren) => innermost(&paren.elem),
        other => other,
    }
}

/// The indices of the components of a member of a field behind those of the member, and how they are read.
fn accesses(field_type: &FieldType<'_>, member: &TokenStream) -> Vec<(Vec<Index>, Access)> {
    match field_type.content() {
        Content::Numbers(shape) => {
            let accesses = field_type.accesses().into_iter().enumerate();
            accesses
                .map(|(i, access)| {
                    let indices = shape.index(i).into_iter().collect();
                    (indices, Access::Behind(quote!(#member #access)))
                })
                .collect()
        }
        Content::Body(ty) => {
            let numbers = ty.numbers().iter();
            numbers
                .map(|number| {
                    let member = member.clone();
                    let number = *number;
                    let access = Access::OfBody { member, ty, number };
                    (number.indices().collect(), access)
                })
                .collect()
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

    /// All parameters.
    pub(crate) fn parameter_symbols(&self) -> Vec<Symbol> {
        let symbols = (0..).zip(&self.parameters);
        symbols.map(|(i, _)| Symbol::Parameter(i)).collect()
    }

    /// The components of parameters with these names, in the order of the names.
    pub(crate) fn symbols_of(&self, fields: &[Ident]) -> Vec<Symbol> {
        let mut symbols = Vec::new();
        for field in fields {
            let named = (0..).zip(&self.parameters);
            let named = named.filter(|(_, component)| unraw(&component.field) == unraw(field));
            symbols.extend(named.map(|(i, _)| Symbol::Parameter(i)));
        }
        symbols
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
            Symbol::Acceleration(i) => match (i as usize).checked_sub(self.coordinates.len()) {
                Some(multiplier) => format!("lambda{multiplier}"),
                None => coordinate(i, "_ddot"),
            },
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
            Symbol::Variation(i) => format!("delta{i}"),
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

    /// A value of which each component is the next symbol.
    pub(crate) fn value(&mut self, typed: &mut TypedGraph, shape: Shape) -> Option<Value> {
        let components = match shape {
            Shape::Scalar => Components::Scalar(self.take(typed)),
            Shape::Array { rows, columns } => {
                let elements = (0..rows * columns).map(|_| self.take(typed)).collect();
                Components::Array(Matrix::new(rows, columns, elements)?)
            }
        };
        typed.add(TypedOperation::Given(components)).ok()
    }

    pub(crate) fn take(&mut self, typed: &mut TypedGraph) -> Expression {
        let symbol = (self.kind)(self.next);
        self.next = self.next.saturating_add(1);
        typed.geometry.graph.symbol(symbol)
    }
}
