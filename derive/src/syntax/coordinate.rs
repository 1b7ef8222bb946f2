//! The coordinates of a declaration: scalars and vectors, one by one or in families.

use core::ops::Range;

use proc_macro2::{Ident, TokenStream, TokenTree};
use quote::quote;
use syn::parse::ParseStream;
use syn::{LitInt, Token, Type, token};

use crate::limits::MAX_FAMILY;
use crate::syntax::field_type::{members, vector};
use crate::syntax::grammar::{ends, list, position, word};
use crate::syntax::label::{Index, Label};
use crate::syntax::names::unraw;
use crate::syntax::shape::Shape;

/// A generalized coordinate, or several under one name.
#[derive(Clone)]
pub(crate) struct Coordinate {
    pub(crate) name: Ident,
    /// How many there are of a family for each index, `theta[5]`; none for one alone.
    pub(crate) lengths: Vec<usize>,
    /// The vector that it is, or each of the family.
    vector: Option<Vector>,
}

/// How a vector of coordinates is declared.
#[derive(Clone)]
struct Vector {
    rows: usize,
    /// Its type, `Vector3`; none for the last of several indices, `r[5][3]`.
    ty: Option<Type>,
}

impl Coordinate {
    /// A coordinate that is a number.
    pub(crate) const fn scalar(name: Ident) -> Self {
        Self {
            name,
            lengths: Vec::new(),
            vector: None,
        }
    }

    /// The shape of the coordinate, or of each of a family.
    pub(crate) fn shape(&self) -> Shape {
        match &self.vector {
            None => Shape::Scalar,
            Some(vector) => Shape::Array {
                rows: vector.rows,
                columns: 1,
            },
        }
    }

    /// How many scalars there are under this name.
    pub(crate) fn count(&self) -> usize {
        self.lengths.iter().product::<usize>() * self.shape().count()
    }

    /// The indices of the members of a family, in row-major order; one empty list for one alone.
    pub(crate) fn members(&self) -> Vec<Vec<usize>> {
        members(&self.lengths)
    }

    /// The type of the components of a vector, where it is written.
    pub(crate) fn element(&self) -> Option<&Type> {
        vector(self.vector.as_ref()?.ty.as_ref()?)?.1
    }

    /// The names of the scalars, in order.
    pub(crate) fn labels(&self) -> impl Iterator<Item = Label> + '_ {
        let components = (0..self.shape().count()).map(|i| self.component(i));
        let components: Vec<_> = components.collect();
        self.members().into_iter().flat_map(move |member| {
            let label = |component: &Option<Index>| Label {
                stem: unraw(&self.name),
                indices: member
                    .iter()
                    .copied()
                    .map(Index::One)
                    .chain(*component)
                    .collect(),
            };
            components.iter().map(label).collect::<Vec<_>>()
        })
    }

    /// How a component of a vector is written: by its axis where the type has a name for it.
    fn component(&self, i: usize) -> Option<Index> {
        let vector = self.vector.as_ref()?;
        let has_axes = vector.ty.is_some() && vector.rows <= Index::AXES.len();
        Some(if has_axes {
            Index::Axis(i)
        } else {
            Index::One(i)
        })
    }

    /// The type and the value of the constant with the indices of the scalars, of which `first` is the first.
    pub(crate) fn constant(&self, first: usize) -> (TokenStream, TokenStream) {
        let vector = self.vector.iter().map(|vector| vector.rows);
        let lengths: Vec<usize> = self.lengths.iter().copied().chain(vector).collect();
        let mut ty = quote!(usize);
        let indices = first..first + self.count();
        let mut values: Vec<TokenStream> = indices.map(|i| quote!(#i)).collect();
        for length in lengths.into_iter().rev() {
            ty = quote!([#ty; #length]);
            let arrays = values.chunks(length);
            values = arrays.map(|values| quote!([#(#values),*])).collect();
        }
        (ty, quote!(#(#values)*))
    }

    /// What the constant with the indices holds.
    pub(crate) fn documentation(&self) -> String {
        let name = unraw(&self.name);
        let what = if self.vector.is_some() {
            "components of the coordinate"
        } else {
            "coordinate"
        };
        match (self.lengths.len(), &self.vector) {
            (0, None) => format!("The index of the coordinate `{name}`."),
            (0, Some(_)) => format!("The indices of the {what} `{name}`."),
            (rank, _) => {
                let rest = "[0]".repeat(rank - 1);
                format!(
                    "The indices of the {what}s `{name}{rest}[0]`, `{name}{rest}[1]` and so on."
                )
            }
        }
    }
}

/// `(name, name, …)` after the keyword.
pub(crate) fn coordinates(
    keyword: &Ident,
    input: ParseStream<'_>,
    names: &mut Vec<Coordinate>,
) -> syn::Result<()> {
    let mut within_type = false;
    list(keyword, input, "a comma between coordinates", |input| {
        if within_type {
            // A comma behind `<` that is not closed separates no coordinates.
            while !ends(input) {
                input.parse::<TokenTree>()?;
            }
            return Ok(());
        }
        let ahead = input.fork();
        names.push(coordinate(input).inspect_err(|_| within_type = opens_type(&ahead))?);
        Ok(())
    })
}

/// Whether a `<` is not closed in what follows.
fn opens_type(input: ParseStream<'_>) -> bool {
    let rest: TokenStream = input.parse().unwrap_or_default();
    let count = |sign| {
        let tokens = rest.clone().into_iter();
        let is =
            |token: &TokenTree| matches!(token, TokenTree::Punct(punct) if punct.as_char() == sign);
        tokens.filter(is).count()
    };
    count('<') > count('>')
}

fn coordinate(input: ParseStream<'_>) -> syn::Result<Coordinate> {
    let name = word(
        input,
        "coordinates are names: write `coordinates(theta, phi)`",
    )?;
    let mut lengths = Vec::new();
    while input.peek(token::Bracket) {
        lengths.push(family_length(&name, input, lengths.iter().product())?);
    }
    let colon: Option<Token![:]> = input.parse()?;
    let vector = match colon {
        Some(_) => {
            if ends(input) {
                return Err(syn::Error::new(position(&name, input), how_to_type(&name)));
            }
            Some(read_vector(&name, &lengths, input)?)
        }
        // As in `[[f64; 3]; 5]`, what the last index counts are the components of a vector.
        None if lengths.len() > 1 => lengths.pop().map(|rows| Vector { rows, ty: None }),
        None => None,
    };
    Ok(Coordinate {
        name,
        lengths,
        vector,
    })
}

/// The type behind a colon.
fn read_vector(name: &Ident, lengths: &[usize], input: ParseStream<'_>) -> syn::Result<Vector> {
    let ty: Type = input
        .parse()
        .map_err(|error| syn::Error::new(error.span(), how_to_type(name)))?;
    let Some((rows, _)) = vector(&ty) else {
        return Err(syn::Error::new_spanned(&ty, how_to_type(name)));
    };
    let count = lengths.iter().product::<usize>().saturating_mul(rows);
    if count > MAX_FAMILY {
        return Err(syn::Error::new_spanned(&ty, too_many(name)));
    }
    Ok(Vector { rows, ty: Some(ty) })
}

fn how_to_type(name: &Ident) -> String {
    format!(
        "a coordinate is a number, `{name}`, or a vector, `{name}: Vector3`, and several are a family, `{name}[5]` or \
         `{name}[5]: Vector3`; an orientation is written in angles, as in `rotation_zxz(phi, theta, psi)`"
    )
}

fn too_many(name: &Ident) -> String {
    format!("at most {MAX_FAMILY} coordinates are called `{name}`: there are more of them here")
}

/// `[5]` behind the name of coordinates, of which there are `before` without it.
fn family_length(name: &Ident, input: ParseStream<'_>, before: usize) -> syn::Result<usize> {
    let content;
    let bracket = syn::bracketed!(content in input);
    let message =
        format!("the size of a family is a number from 1 to {MAX_FAMILY}: write `{name}[5]`");
    let length: LitInt = content.parse().map_err(|error| {
        let span = if content.is_empty() {
            bracket.span.join()
        } else {
            error.span()
        };
        syn::Error::new(span, &message)
    })?;
    if !content.is_empty() {
        return Err(content.error(message));
    }
    match length.base10_parse::<usize>() {
        Ok(number @ 1..=MAX_FAMILY) if length.suffix().is_empty() => {
            if number * before > MAX_FAMILY {
                return Err(syn::Error::new(length.span(), too_many(name)));
            }
            Ok(number)
        }
        _ => Err(syn::Error::new(length.span(), message)),
    }
}

/// The coordinates as they were declared, each with its index, or the indices of the members of a family.
pub(crate) fn indices(
    coordinates: &[Coordinate],
) -> impl Iterator<Item = (&Coordinate, Range<usize>)> {
    coordinates.iter().scan(0, |next, coordinate| {
        let start = *next;
        *next += coordinate.count();
        Some((coordinate, start..*next))
    })
}
