//! The types of bodies that a parameter may have, and the numbers that they consist of.
//!
//! A macro sees the name of a type only, so that what is zero in a body is told by its type.

use proc_macro2::{Ident, Literal, Span, TokenStream};
use quote::quote;

use crate::syntax::body_quantity::BodyQuantity;
use crate::syntax::label::Index;
use crate::syntax::root::Root;

/// A type of bodies of `lagrangian::rigid_body`.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum BodyType {
    /// `RigidBody`: mass, centre of gravity and inertia tensor.
    Rigid,
    /// `PrincipalBody`: along principal axes through the centre of gravity.
    Principal,
    /// `SymmetricBody`: about an axis of symmetry.
    Symmetric,
}

/// One of the numbers of a body: a component of one of its quantities.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) struct BodyNumber {
    pub(crate) quantity: BodyQuantity,
    pub(crate) index: Option<Index>,
}

const MASS: BodyNumber = BodyNumber {
    quantity: BodyQuantity::Mass,
    index: None,
};

const fn center(axis: usize) -> BodyNumber {
    BodyNumber {
        quantity: BodyQuantity::Center,
        index: Some(Index::Axis(axis)),
    }
}

const fn inertia(row: usize, column: usize) -> BodyNumber {
    BodyNumber {
        quantity: BodyQuantity::Inertia,
        index: Some(Index::Pair { row, column }),
    }
}

const RIGID: [BodyNumber; 10] = [
    MASS,
    center(0),
    center(1),
    center(2),
    inertia(0, 0),
    inertia(1, 1),
    inertia(2, 2),
    inertia(0, 1),
    inertia(0, 2),
    inertia(1, 2),
];

const PRINCIPAL: [BodyNumber; 4] = [MASS, inertia(0, 0), inertia(1, 1), inertia(2, 2)];

const SYMMETRIC: [BodyNumber; 4] = [MASS, center(2), inertia(0, 0), inertia(2, 2)];

impl BodyType {
    pub(crate) const ALL: [Self; 3] = [Self::Rigid, Self::Principal, Self::Symmetric];

    /// The type of this name.
    pub(crate) fn named(name: &Ident) -> Option<Self> {
        Self::ALL.into_iter().find(|ty| name == ty.name())
    }

    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Rigid => "RigidBody",
            Self::Principal => "PrincipalBody",
            Self::Symmetric => "SymmetricBody",
        }
    }

    /// The numbers that are not zero, in the order in which symbols count them; of equal ones the first.
    pub(crate) const fn numbers(self) -> &'static [BodyNumber] {
        match self {
            Self::Rigid => &RIGID,
            Self::Principal => &PRINCIPAL,
            Self::Symmetric => &SYMMETRIC,
        }
    }

    /// The expression that reads a number of the body to which an expression refers.
    pub(crate) fn read(
        self,
        root: &Root,
        number: BodyNumber,
        reference: &TokenStream,
    ) -> TokenStream {
        let [ty, method] =
            [self.name(), number.quantity.name()].map(|name| Ident::new(name, Span::mixed_site()));
        let quantity = quote!(#root::rigid_body::#ty::#method(#reference));
        let literal = Literal::usize_unsuffixed;
        match number.index {
            Some(Index::Pair { row, column }) => {
                let [row, column] = [row, column].map(literal);
                quote!(#quantity.matrix()[(#row, #column)])
            }
            Some(Index::Axis(i) | Index::One(i)) => {
                let i = literal(i);
                quote!(#quantity[#i])
            }
            Some(Index::Quantity(_)) | None => quantity,
        }
    }
}

impl BodyNumber {
    /// The indices behind the name of the body.
    pub(crate) fn indices(self) -> impl Iterator<Item = Index> {
        [Index::Quantity(self.quantity)]
            .into_iter()
            .chain(self.index)
    }
}
