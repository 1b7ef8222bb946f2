//! The clauses of the struct's `#[lagrangian(…)]` attributes.

use proc_macro2::Ident;
use syn::parse::ParseStream;
use syn::{Attribute, Expr, MacroDelimiter, Meta, Token, Type, token};

use crate::diagnostics::{Diagnostics, similar};
use crate::syntax::coordinate::{Coordinate, coordinates};
use crate::syntax::external_function::FunctionDeclaration;
use crate::syntax::grammar::{ends, equals, equated, once, separated, word};
use crate::syntax::named::{NamedExpression, named_expressions};
use crate::syntax::other_clauses;
use crate::syntax::parameter_list::{ParameterList, word_alone};
use crate::syntax::placed_body::PlacedBody;
use crate::syntax::root::Root;
use crate::syntax::routhian::RouthianClause;

/// All clauses of the struct's `#[lagrangian(…)]` attributes.
#[derive(Default)]
pub(crate) struct Clauses {
    pub(crate) coordinates: Vec<Coordinate>,
    pub(crate) functions: Vec<FunctionDeclaration>,
    pub(crate) definitions: Vec<NamedExpression>,
    pub(crate) kinetic: Vec<Clause>,
    pub(crate) potential: Vec<Clause>,
    pub(crate) lagrangian: Vec<Clause>,
    /// The bodies of `body(…)`, whose energies are among the others.
    pub(crate) bodies: Vec<PlacedBody>,
    /// The acceleration of gravity, `gravity = …`.
    pub(crate) gravity: Option<Clause>,
    pub(crate) dissipation: Vec<Clause>,
    /// The forces of each clause: those of one clause act on different coordinates, several clauses add up.
    pub(crate) forces: Vec<Vec<NamedExpression>>,
    /// The holonomic constraints.
    pub(crate) constraints: Vec<NamedExpression>,
    pub(crate) nonholonomic: Vec<NamedExpression>,
    /// The compliances of constraints.
    pub(crate) compliances: Vec<NamedExpression>,
    pub(crate) outputs: Vec<NamedExpression>,
    pub(crate) events: Vec<NamedExpression>,
    /// The word `taylor`.
    pub(crate) taylor: Option<Ident>,
    /// The word `hamiltonian`.
    pub(crate) hamiltonian: Option<Ident>,
    /// The word `energy_balance`.
    pub(crate) energy_balance: Option<Ident>,
    /// By which parameters accelerations are differentiated.
    pub(crate) sensitivities: Option<ParameterList>,
    /// Which parameters are unknown in the regressor.
    pub(crate) regressor: Option<ParameterList>,
    /// The word `c`.
    pub(crate) c: Option<Ident>,
    /// The word `reflect`.
    pub(crate) reflect: Option<Ident>,
    /// The reduced model that is asked for.
    pub(crate) routhian: Option<RouthianClause>,
    /// The type of `scalar = …`.
    pub(crate) scalar: Option<Type>,
    /// The path of `crate = …`.
    pub(crate) root: Option<Root>,
    /// Whether something could not be parsed, so that nothing is reported as missing.
    pub(crate) unreadable: bool,
    /// Whether functions could not be parsed, so that none is reported as unknown.
    pub(crate) functions_unreadable: bool,
    /// Whether coordinates or definitions could not be parsed, so that no name is reported as unknown.
    pub(crate) names_unreadable: bool,
}

/// `keyword = expression`.
pub(crate) struct Clause {
    pub(crate) keyword: Ident,
    pub(crate) expression: Expr,
}

const KEYWORDS: [&str; 24] = [
    "coordinates",
    "function",
    "define",
    "kinetic",
    "potential",
    "lagrangian",
    "body",
    "gravity",
    "dissipation",
    "force",
    "constraint",
    "nonholonomic",
    "compliance",
    "output",
    "event",
    "scalar",
    "taylor",
    "hamiltonian",
    "energy_balance",
    "sensitivities",
    "regressor",
    "c",
    "reflect",
    "routhian",
];

impl Clauses {
    /// Parses one attribute, with recovery: what can be parsed is kept.
    pub(crate) fn read(&mut self, attribute: &Attribute, diagnostics: &mut Diagnostics) {
        let clauses = |input: ParseStream<'_>| {
            separated(input, "a comma between clauses, or an operator,", |input| {
                if input.peek(Token![crate]) {
                    return self.read_root(input);
                }
                if let Some(error) = other_clauses::keyword(input) {
                    return Err(error);
                }
                let keyword = word(input, &no_clause())?;
                self.read_clause(keyword, input)
            })
        };
        let read = match &attribute.meta {
            Meta::List(list) if matches!(list.delimiter, MacroDelimiter::Paren(_)) => {
                attribute.parse_args_with(clauses)
            }
            meta => Err(syn::Error::new_spanned(
                meta,
                "write `#[lagrangian(coordinates(theta), kinetic = …)]`",
            )),
        };
        if let Err(error) = read {
            self.unreadable = true;
            diagnostics.add(error);
        }
    }

    fn read_root(&mut self, input: ParseStream<'_>) -> syn::Result<()> {
        let (keyword, root) = Root::read(input)?;
        let message = "the crate is named already: keep one `crate = …`";
        once(&mut self.root, root, keyword.span(), message)
    }

    fn read_scalar(&mut self, keyword: &Ident, input: ParseStream<'_>) -> syn::Result<()> {
        let message = "write `scalar = f64`, with the type on which the model is evaluated";
        equals(keyword, message, input)?;
        let scalar = input
            .parse()
            .map_err(|error| syn::Error::new(error.span(), message))?;
        let message = "the scalar is named already: keep one `scalar = …`";
        once(&mut self.scalar, scalar, keyword.span(), message)
    }

    fn read_gravity(&mut self, keyword: Ident, input: ParseStream<'_>) -> syn::Result<()> {
        let gravity = Clause::read(keyword, input)?;
        let span = gravity.keyword.span();
        let message = "gravity is given already: keep one `gravity = …`";
        once(&mut self.gravity, gravity, span, message)
    }

    /// Adds the energies of the bodies to the others.
    pub(crate) fn add_bodies(&mut self) {
        for body in &self.bodies {
            let energy = |expression| Clause {
                keyword: body.keyword.clone(),
                expression,
            };
            self.kinetic.push(energy(body.kinetic()));
            let gravity = self.gravity.iter();
            let weights = gravity.map(|gravity| energy(body.potential(&gravity.expression)));
            self.potential.extend(weights);
        }
    }

    fn read_taylor(&mut self, keyword: Ident, input: ParseStream<'_>) -> syn::Result<()> {
        if !ends(input) {
            let message = "write `taylor` alone: the order and the tolerance are those of the integrator `Taylor`";
            return Err(syn::Error::new(input.span(), message));
        }
        let span = keyword.span();
        let message = "the Taylor series is asked for already: keep one `taylor`";
        once(&mut self.taylor, keyword, span, message)
    }

    fn read_routhian(&mut self, keyword: Ident, input: ParseStream<'_>) -> syn::Result<()> {
        let span = keyword.span();
        let clause = RouthianClause::read(keyword, input)?;
        let message = "the reduced model is asked for already: keep one `routhian`";
        once(&mut self.routhian, clause, span, message)
    }

    fn read_clause(&mut self, keyword: Ident, input: ParseStream<'_>) -> syn::Result<()> {
        match keyword.to_string().as_str() {
            "coordinates" => {
                let read = coordinates(&keyword, input, &mut self.coordinates);
                self.names_unreadable |= read.is_err();
                read?;
            }
            "function" => {
                let read = FunctionDeclaration::read(&keyword, input, &mut self.functions);
                self.functions_unreadable |= read.is_err();
                read?;
            }
            "define" => {
                let read = named_expressions(&keyword, input, &mut self.definitions);
                self.names_unreadable |= read.is_err();
                read?;
            }
            "force" => {
                self.forces.push(Vec::new());
                if let Some(forces) = self.forces.last_mut() {
                    named_expressions(&keyword, input, forces)?;
                }
            }
            "constraint" => named_expressions(&keyword, input, &mut self.constraints)?,
            "nonholonomic" => named_expressions(&keyword, input, &mut self.nonholonomic)?,
            "compliance" => named_expressions(&keyword, input, &mut self.compliances)?,
            "output" => named_expressions(&keyword, input, &mut self.outputs)?,
            "event" => named_expressions(&keyword, input, &mut self.events)?,
            "kinetic" => self.kinetic.push(Clause::read(keyword, input)?),
            "potential" => self.potential.push(Clause::read(keyword, input)?),
            "lagrangian" => self.lagrangian.push(Clause::read(keyword, input)?),
            "dissipation" => self.dissipation.push(Clause::read(keyword, input)?),
            "body" => PlacedBody::read(&keyword, input, &mut self.bodies)?,
            "gravity" => self.read_gravity(keyword, input)?,
            "scalar" => self.read_scalar(&keyword, input)?,
            "taylor" => self.read_taylor(keyword, input)?,
            "hamiltonian" => word_alone(keyword, input, &mut self.hamiltonian)?,
            "energy_balance" => word_alone(keyword, input, &mut self.energy_balance)?,
            "sensitivities" => ParameterList::read(keyword, input, &mut self.sensitivities)?,
            "regressor" => ParameterList::read(keyword, input, &mut self.regressor)?,
            "c" => word_alone(keyword, input, &mut self.c)?,
            "reflect" => word_alone(keyword, input, &mut self.reflect)?,
            "routhian" => self.read_routhian(keyword, input)?,
            written => {
                if let Some(place) = other_clauses::said_elsewhere(written) {
                    let message = format!("unknown clause `{written}`: {place}");
                    return Err(syn::Error::new(keyword.span(), message));
                }
                // Functions stand in parentheses.
                let fits = |meant: &&str| *meant != "function" || input.peek(token::Paren);
                let meant = other_clauses::called_otherwise(written)
                    .or_else(|| similar(written, KEYWORDS).filter(fits))
                    .or_else(|| abbreviated(written));
                let hint = match meant {
                    Some(meant) => format!("did you mean `{meant}`?"),
                    None => no_clause(),
                };
                let message = format!("unknown clause `{written}`: {hint}");
                let mut error = syn::Error::new(keyword.span(), message);
                if let Some(meant) = meant {
                    // Parsed as the clause it is misspelled for, it leaves nothing missing.
                    let read = self.read_clause(Ident::new(meant, keyword.span()), input);
                    read.unwrap_or_else(|more| error.combine(more));
                }
                return Err(error);
            }
        }
        Ok(())
    }
}

impl Clause {
    fn read(keyword: Ident, input: ParseStream<'_>) -> syn::Result<Self> {
        let expression = equated(&keyword, input)?;
        Ok(Self {
            keyword,
            expression,
        })
    }
}

/// The clause that is the first word of what was written: `kinetic_energy` is `kinetic`.
fn abbreviated(written: &str) -> Option<&'static str> {
    let first = written.split('_').next().unwrap_or_default();
    KEYWORDS.into_iter().find(|keyword| *keyword == first)
}

fn no_clause() -> String {
    format!("write a clause: one of `{}`", KEYWORDS.join("`, `"))
}
