//! The fields of the struct: parameters, inputs, and fields that the model ignores.

use proc_macro2::Ident;
use syn::parse::{Parse, ParseStream};
use syn::punctuated::Punctuated;
use syn::{Attribute, Expr, Lit, Meta, Token, Type, Visibility};

use crate::diagnostics::Diagnostics;
use crate::syntax::field_type::{FieldType, UnsupportedType};
use crate::syntax::grammar::own;

/// A named field of the struct.
#[derive(Clone)]
pub(crate) struct Field {
    pub(crate) name: Ident,
    pub(crate) ty: Type,
    /// What its type is an alias of: `#[lagrangian(type = Matrix3<f64>)]`.
    pub(crate) declared_type: Option<Type>,
    pub(crate) role: Role,
    /// Whether its attributes could be read.
    pub(crate) readable: bool,
    pub(crate) visibility: Visibility,
    /// Its documentation, line by line.
    pub(crate) documentation: String,
}

/// What a field is to the model.
#[derive(Clone, Copy, Default, PartialEq, Eq)]
pub(crate) enum Role {
    /// Constant in time.
    #[default]
    Parameter,
    /// An input of the system, set by a controller: `#[lagrangian(input)]`.
    Input,
    /// Ignored by the model: `#[lagrangian(skip)]`.
    Skipped,
}

impl Field {
    pub(crate) fn read(field: syn::Field, diagnostics: &mut Diagnostics) -> Option<Self> {
        let mut attributes = FieldAttributes::default();
        let mut readable = true;
        for attribute in own(&field.attrs) {
            match attribute
                .parse_args_with(Punctuated::<FieldAttribute, Token![,]>::parse_terminated)
            {
                Ok(found) if !found.is_empty() => {
                    for attribute in found {
                        attributes.add(attribute, diagnostics);
                    }
                }
                Ok(_) => diagnostics.error(&attribute.meta, HOW_TO_WRITE),
                Err(error) => {
                    readable = false;
                    diagnostics.error_at(error.span(), HOW_TO_WRITE);
                }
            }
        }
        Some(Self {
            documentation: documentation(&field.attrs),
            name: field.ident?,
            ty: field.ty,
            declared_type: attributes.declared_type,
            role: attributes.role,
            readable,
            visibility: field.vis,
        })
    }

    /// The declared type of the field: what its type is an alias of, or that type.
    pub(crate) fn declared_type(&self) -> &Type {
        self.declared_type.as_ref().unwrap_or(&self.ty)
    }

    /// The field's type, analysed, or why it is unsupported.
    pub(crate) fn field_type(&self) -> Result<FieldType<'_>, UnsupportedType> {
        FieldType::read(self.declared_type())
    }
}

/// The lines of the comments `///`.
pub(super) fn documentation(attributes: &[Attribute]) -> String {
    let lines = attributes
        .iter()
        .filter_map(|attribute| match &attribute.meta {
            Meta::NameValue(pair) if pair.path.is_ident("doc") => match &pair.value {
                Expr::Lit(literal) => match &literal.lit {
                    Lit::Str(text) => Some(text.value()),
                    _ => None,
                },
                _ => None,
            },
            _ => None,
        });
    lines.collect::<Vec<_>>().join("\n")
}

/// One attribute of a field.
enum FieldAttribute {
    Word(Ident),
    Type(Box<Type>),
}

impl Parse for FieldAttribute {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        if input.parse::<Option<Token![type]>>()?.is_none() {
            return input.parse().map(Self::Word);
        }
        input.parse::<Token![=]>()?;
        input.parse().map(Box::new).map(Self::Type)
    }
}

/// All attributes of a field together.
#[derive(Default)]
struct FieldAttributes {
    role: Role,
    declared_type: Option<Type>,
}

impl FieldAttributes {
    fn add(&mut self, attribute: FieldAttribute, diagnostics: &mut Diagnostics) {
        let word = match attribute {
            FieldAttribute::Type(ty) => {
                if self.declared_type.is_some() {
                    let message = "the type of this field is given twice: keep one of them";
                    diagnostics.error(&ty, message);
                }
                self.declared_type = Some(*ty);
                return;
            }
            FieldAttribute::Word(word) => word,
        };
        let role = match word.to_string().as_str() {
            "input" => Role::Input,
            "skip" => Role::Skipped,
            written => {
                let message = format!(
                    "unknown field attribute `{written}`: write `input`, `skip` or `type = Matrix3<f64>`"
                );
                return diagnostics.error(word, message);
            }
        };
        if self.role == Role::Parameter || self.role == role {
            self.role = role;
        } else {
            let message = "a field is an input or it is skipped: keep one of `input` and `skip`";
            diagnostics.error(word, message);
        }
    }
}

const HOW_TO_WRITE: &str = "write `#[lagrangian(input)]`, `#[lagrangian(skip)]` or `#[lagrangian(type = …)]` on a \
                           field";
