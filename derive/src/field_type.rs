//! The types that parameters and inputs can have.

use proc_macro2::TokenStream;
use quote::quote;
use syn::{Expr, GenericArgument, Lit, PathArguments, Type};

use crate::value::Shape;

/// The type of a field, taken apart.
pub(crate) struct FieldType<'a> {
    /// The type of one component.
    pub(crate) element: &'a Type,
    form: Form,
}

/// How the components are held.
#[derive(Clone, Copy)]
enum Form {
    Scalar,
    /// `[f64; N]`, or a vector of nalgebra.
    Vector(usize),
    /// `[[f64; COLUMNS]; ROWS]`.
    Rows(usize, usize),
    /// A matrix of nalgebra with so many rows and columns.
    Matrix(usize, usize),
}

/// Why a type is none that a parameter can have.
pub(crate) enum Unfit {
    /// It is nothing that is known here.
    Unknown,
    /// A number of components is not written as a number.
    Length,
}

impl<'a> FieldType<'a> {
    /// Takes a type apart.
    pub(crate) fn read(ty: &'a Type) -> Result<Self, Unfit> {
        match ty {
            Type::Group(group) => Self::read(&group.elem),
            Type::Paren(paren) => Self::read(&paren.elem),
            Type::Array(array) => {
                let length = length(&array.len)?;
                let inner = Self::read(&array.elem)?;
                let form = match inner.form {
                    Form::Scalar => Form::Vector(length),
                    Form::Vector(columns) if matches!(&*array.elem, Type::Array(_)) => {
                        Form::Rows(length, columns)
                    }
                    _ => return Err(Unfit::Unknown),
                };
                Ok(Self { form, ..inner })
            }
            Type::Path(path) => {
                let last = path.path.segments.last().ok_or(Unfit::Unknown)?;
                match &last.arguments {
                    PathArguments::None => Ok(Self {
                        element: ty,
                        form: Form::Scalar,
                    }),
                    PathArguments::AngleBracketed(arguments) => {
                        let mut arguments = arguments.args.iter();
                        let Some(GenericArgument::Type(element)) = arguments.next() else {
                            return Err(Unfit::Unknown);
                        };
                        let form = Form::of_nalgebra(&last.ident.to_string(), arguments)?;
                        Ok(Self { element, form })
                    }
                    PathArguments::Parenthesized(_) => Err(Unfit::Unknown),
                }
            }
            _ => Err(Unfit::Unknown),
        }
    }

    pub(crate) const fn shape(&self) -> Shape {
        match self.form {
            Form::Scalar => Shape::Scalar,
            Form::Vector(rows) => Shape::Array { rows, columns: 1 },
            Form::Rows(rows, columns) | Form::Matrix(rows, columns) => {
                Shape::Array { rows, columns }
            }
        }
    }

    /// What stands behind a field to read each of its components, column by column.
    pub(crate) fn accesses(&self) -> Vec<TokenStream> {
        let literal = proc_macro2::Literal::usize_unsuffixed;
        let count = self.shape().count();
        let access = |component: usize| match self.form {
            Form::Scalar => TokenStream::new(),
            Form::Vector(_) => {
                let i = literal(component);
                quote!([#i])
            }
            Form::Rows(rows, _) => {
                let (row, column) = (literal(component % rows), literal(component / rows));
                quote!([#row][#column])
            }
            Form::Matrix(rows, _) => {
                let (row, column) = (literal(component % rows), literal(component / rows));
                quote!([(#row, #column)])
            }
        };
        (0..count).map(access).collect()
    }
}

impl Form {
    /// The form of nalgebra's type with this name, and with these arguments behind that of its elements.
    fn of_nalgebra<'a>(
        name: &str,
        arguments: impl Iterator<Item = &'a GenericArgument>,
    ) -> Result<Self, Unfit> {
        let lengths: Vec<usize> = arguments
            .map(|argument| match argument {
                GenericArgument::Const(number) => length(number),
                _ => Err(Unfit::Length),
            })
            .collect::<Result<_, _>>()?;
        let square = |n: Option<usize>| n.map(|n| Self::Matrix(n, n));
        let form = match (name, lengths.as_slice()) {
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
            .find_map(|(stem, form)| form(name.strip_prefix(stem)?))
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
        form.ok_or(Unfit::Unknown)
    }
}

/// The one digit from 1 to 6 of a name such as `Vector3`.
fn digit(written: &str) -> Option<usize> {
    written.parse().ok().filter(|n| (1..=6).contains(n))
}

/// A number of components, at least 1.
fn length(written: &Expr) -> Result<usize, Unfit> {
    match written {
        Expr::Group(inner) => length(&inner.expr),
        Expr::Paren(inner) => length(&inner.expr),
        Expr::Lit(literal) => match &literal.lit {
            Lit::Int(number) => {
                let number = number.base10_parse().map_err(|_| Unfit::Length)?;
                Some(number).filter(|n| *n > 0).ok_or(Unfit::Unknown)
            }
            _ => Err(Unfit::Length),
        },
        Expr::Block(block) => match block.block.stmts.as_slice() {
            [syn::Stmt::Expr(only, None)] => length(only),
            _ => Err(Unfit::Length),
        },
        _ => Err(Unfit::Length),
    }
}
