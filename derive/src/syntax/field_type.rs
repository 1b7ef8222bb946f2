//! The types that parameters and inputs can have.

use proc_macro2::{Literal, TokenStream};
use quote::quote;
use syn::{Expr, GenericArgument, Lit, PathArguments, Type};

use crate::limits::MAX_COMPONENTS;
use crate::syntax::body_type::BodyType;
use crate::syntax::shape::Shape;

/// The type of a field, analysed: a number, a vector, a matrix or a body, or an array of those.
pub(crate) struct FieldType<'a> {
    /// The type of one component; none where it is not written, as that of a `RigidBody` of plain numbers.
    pub(crate) element: Option<&'a Type>,
    layout: ComponentLayout,
    /// The lengths of the arrays around a vector, a matrix or a body, from the outermost.
    lengths: Vec<usize>,
}

/// What a field, or each member of an array, holds.
#[derive(Clone, Copy)]
pub(crate) enum Content {
    /// Numbers of this shape.
    Numbers(Shape),
    Body(BodyType),
}

/// How the components of a quantity are laid out.
#[derive(Clone, Copy)]
enum ComponentLayout {
    Scalar,
    /// `[f64; N]`, or a vector of nalgebra.
    Vector(usize),
    /// A matrix of nalgebra with so many rows and columns.
    Matrix(usize, usize),
    /// A body.
    Body(BodyType),
}

/// Why a type is unsupported for parameters.
pub(crate) enum UnsupportedType {
    /// It is neither a number nor an array, vector or matrix.
    Unknown,
    /// A number of components is not written as a number.
    Length,
    /// There are more than [`MAX_COMPONENTS`].
    TooMany,
}

impl<'a> FieldType<'a> {
    /// Analyses a type.
    pub(crate) fn read(ty: &'a Type) -> Result<Self, UnsupportedType> {
        let read = Self::parts(ty)?;
        let each = match read.content() {
            Content::Numbers(Shape::Scalar) => [1, 1],
            Content::Numbers(Shape::Array { rows, columns }) => [rows, columns],
            Content::Body(body) => [body.numbers().len(), 1],
        };
        let lengths = read.lengths.iter().copied().chain(each);
        if lengths.fold(1, usize::saturating_mul) > MAX_COMPONENTS {
            return Err(UnsupportedType::TooMany);
        }
        Ok(read)
    }

    fn parts(ty: &'a Type) -> Result<Self, UnsupportedType> {
        match ty {
            Type::Group(group) => Self::parts(&group.elem),
            Type::Paren(paren) => Self::parts(&paren.elem),
            Type::Array(array) => {
                let length = length(&array.len)?;
                let mut inner = Self::parts(&array.elem)?;
                match inner.layout {
                    ComponentLayout::Scalar => inner.layout = ComponentLayout::Vector(length),
                    ComponentLayout::Vector(_)
                    | ComponentLayout::Matrix(..)
                    | ComponentLayout::Body(_) => {
                        inner.lengths.insert(0, length);
                    }
                }
                Ok(inner)
            }
            Type::Path(path) => {
                let last = path.path.segments.last().ok_or(UnsupportedType::Unknown)?;
                let body = BodyType::named(&last.ident);
                match &last.arguments {
                    PathArguments::None => Ok(Self {
                        element: body.is_none().then_some(ty),
                        layout: body.map_or(ComponentLayout::Scalar, ComponentLayout::Body),
                        lengths: Vec::new(),
                    }),
                    PathArguments::AngleBracketed(arguments) => {
                        let mut arguments = arguments.args.iter();
                        let Some(GenericArgument::Type(element)) = arguments.next() else {
                            return Err(UnsupportedType::Unknown);
                        };
                        let layout = match body {
                            Some(body) if arguments.len() == 0 => ComponentLayout::Body(body),
                            _ => ComponentLayout::of_nalgebra(&last.ident.to_string(), arguments)?,
                        };
                        Ok(Self {
                            element: Some(element),
                            layout,
                            lengths: Vec::new(),
                        })
                    }
                    PathArguments::Parenthesized(_) => Err(UnsupportedType::Unknown),
                }
            }
            _ => Err(UnsupportedType::Unknown),
        }
    }

    /// What the field holds, or each member of an array of vectors, matrices or bodies.
    pub(crate) const fn content(&self) -> Content {
        Content::Numbers(match self.layout {
            ComponentLayout::Scalar => Shape::Scalar,
            ComponentLayout::Vector(rows) => Shape::Array { rows, columns: 1 },
            ComponentLayout::Matrix(rows, columns) => Shape::Array { rows, columns },
            ComponentLayout::Body(body) => return Content::Body(body),
        })
    }

    /// The lengths of the arrays around a vector, a matrix or a body, from the outermost.
    pub(crate) fn array_lengths(&self) -> &[usize] {
        &self.lengths
    }

    /// How many indices distinguish the members of an array of vectors, matrices or bodies; 0 for no such array.
    pub(crate) const fn rank(&self) -> usize {
        self.lengths.len()
    }

    /// The indices of the members of an array of vectors, matrices or bodies, in row-major order; one
    /// empty list for no such array.
    pub(crate) fn members(&self) -> Vec<Vec<usize>> {
        members(&self.lengths)
    }

    /// The tokens that follow a member of numbers to read each of them, in column-major order.
    pub(crate) fn accesses(&self) -> Vec<TokenStream> {
        let Content::Numbers(shape) = self.content() else {
            return Vec::new();
        };
        let literal = Literal::usize_unsuffixed;
        let access = |component: usize| match self.layout {
            ComponentLayout::Scalar | ComponentLayout::Body(_) => TokenStream::new(),
            ComponentLayout::Vector(_) => {
                let i = literal(component);
                quote!([#i])
            }
            ComponentLayout::Matrix(rows, _) => {
                let (row, column) = (literal(component % rows), literal(component / rows));
                quote!([(#row, #column)])
            }
        };
        (0..shape.count()).map(access).collect()
    }
}

impl ComponentLayout {
    /// The layout of nalgebra's type with this name, and with these arguments behind that of its elements.
    fn of_nalgebra<'a>(
        name: &str,
        arguments: impl Iterator<Item = &'a GenericArgument>,
    ) -> Result<Self, UnsupportedType> {
        let lengths: Vec<usize> = arguments
            .map(|argument| match argument {
                GenericArgument::Const(number) => length(number),
                _ => Err(UnsupportedType::Length),
            })
            .collect::<Result<_, _>>()?;
        let square = |n: Option<usize>| n.map(|n| Self::Matrix(n, n));
        let layout = match (name, lengths.as_slice()) {
            ("SVector", [rows]) => Some(Self::Vector(*rows)),
            ("SMatrix", [rows, columns]) => Some(Self::Matrix(*rows, *columns)),
            ("RowSVector", [columns]) => Some(Self::Matrix(1, *columns)),
            (_, []) => [
                (
                    "RowVector",
                    (|n| digit(n).map(|n| Self::Matrix(1, n))) as fn(&str) -> _,
                ),
                ("Vector", |n| digit(n).map(Self::Vector)),
                ("Point", |n| digit(n).map(Self::Vector)),
            ]
            .into_iter()
            .find_map(|(stem, layout)| layout(name.strip_prefix(stem)?))
            .or_else(|| square(digit(name.strip_prefix("Rotation")?)))
            .or_else(|| {
                let dimensions = name.strip_prefix("Matrix")?;
                match dimensions.split_once('x') {
                    Some((rows, columns)) => Some(Self::Matrix(digit(rows)?, digit(columns)?)),
                    None => square(digit(dimensions)),
                }
            }),
            _ => None,
        };
        layout.ok_or(UnsupportedType::Unknown)
    }
}

/// All indices below some lengths, in row-major order.
pub(crate) fn members(lengths: &[usize]) -> Vec<Vec<usize>> {
    let mut members = vec![Vec::new()];
    for length in lengths {
        let longer = |member: &Vec<usize>, i| {
            let mut longer = member.clone();
            longer.push(i);
            longer
        };
        members = members
            .iter()
            .flat_map(|member| (0..*length).map(move |i| longer(member, i)))
            .collect();
    }
    members
}

/// How many components a vector of nalgebra has, and their type, which may be left out.
pub(crate) fn vector(ty: &Type) -> Option<(usize, Option<&Type>)> {
    let path = match ty {
        Type::Group(group) => return vector(&group.elem),
        Type::Paren(paren) => return vector(&paren.elem),
        Type::Path(path) => path,
        _ => return None,
    };
    let last = path.path.segments.last()?;
    let arguments: Vec<_> = match &last.arguments {
        PathArguments::None => Vec::new(),
        PathArguments::AngleBracketed(arguments) => arguments.args.iter().collect(),
        PathArguments::Parenthesized(_) => return None,
    };
    let (element, lengths) = match arguments.as_slice() {
        [GenericArgument::Type(element), lengths @ ..] => (Some(element), lengths),
        lengths => (None, lengths),
    };
    match ComponentLayout::of_nalgebra(&last.ident.to_string(), lengths.iter().copied()) {
        Ok(ComponentLayout::Vector(rows)) => Some((rows, element)),
        _ => None,
    }
}

/// The one digit from 1 to 6 of a name such as `Vector3`.
fn digit(written: &str) -> Option<usize> {
    written.parse().ok().filter(|n| (1..=6).contains(n))
}

/// A number of components, at least 1.
fn length(written: &Expr) -> Result<usize, UnsupportedType> {
    match written {
        Expr::Group(inner) => length(&inner.expr),
        Expr::Paren(inner) => length(&inner.expr),
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(number) => {
                let number = number.base10_parse().map_err(|_| UnsupportedType::Length)?;
                Some(number)
                    .filter(|n| *n > 0)
                    .ok_or(UnsupportedType::Unknown)
            }
            _ => Err(UnsupportedType::Length),
        },
        Expr::Block(block) => match block.block.stmts.as_slice() {
            [syn::Stmt::Expr(only, None)] => length(only),
            _ => Err(UnsupportedType::Length),
        },
        _ => Err(UnsupportedType::Length),
    }
}
