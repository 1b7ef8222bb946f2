//! What is emitted for constraints: their names and indices, the impl of `Constraints`, and the projection of states.

use proc_macro2::{Ident, Literal, TokenStream};
use quote::quote;

use super::emitter::Emitter;
use super::on_another_scalar::{OnAnotherScalar, scalar_parameter};
use crate::lower::constraints::Constraints;
use crate::plan::{EmittedMethod, Interface, ParameterSource};
use crate::syntax::declaration::Declaration;
use crate::syntax::names::{constant_name, hygienic_ident, unraw};

impl Emitter<'_> {
    pub(super) fn constraint_count(&self) -> usize {
        self.equations.constraints.len()
    }

    /// How many unknowns the equations of motion have: the accelerations and the multipliers.
    pub(super) fn unknowns(&self) -> usize {
        self.coordinates() + self.constraint_count()
    }

    /// The generic arguments of a saddle point problem: the scalar and the numbers of coordinates, constraints and unknowns.
    fn dimensions(&self) -> TokenStream {
        let scalar = &self.scalar;
        let (n, c, k) = (self.coordinates(), self.constraint_count(), self.unknowns());
        quote!(#scalar, #n, #c, #k)
    }

    pub(super) fn is_constrained(&self) -> bool {
        self.constraint_count() > 0
    }

    /// The impl of `Constraints`, for a model that declares some.
    pub(super) fn constraints(&self) -> TokenStream {
        if !self.is_constrained() {
            return TokenStream::new();
        }
        let constants = self.constants_of_constraints();
        let signatures = self.signatures();
        let (root, scalar, state) = (&self.declaration.root, &self.scalar, signatures.state());
        let (vector, prepared) = (signatures.vector(), &signatures.prepared);
        let (n, c) = (self.coordinates(), self.constraint_count());
        let arguments = self.dimensions();
        let items = quote! {
            #constants
            fn constrained_response(
                &self,
                state: #state,
                prepared: &#prepared,
                impulse_and_residuals: (&#vector, &#root::__private::SVector<#scalar, #c>),
                held: &[::core::primitive::bool; #n],
                count: ::core::primitive::usize,
            ) -> #vector {
                #root::__private::constrained_response::<Self, #arguments>(
                    self, state, prepared, impulse_and_residuals, held, count,
                )
            }
        };
        self.interface(Interface::Constraints, items)
    }

    /// The constants of the impl of `Constraints`.
    fn constants_of_constraints(&self) -> TokenStream {
        let constraints = &self.lowered.constraints;
        let (count, holonomic) = (constraints.len(), constraints.holonomic());
        let equations = &self.equations.constraints;
        let kinds = (0..count).map(|i| equations.restricts_coordinates(i));
        let (n, constant) = (self.coordinates(), equations.constant_columns(self.model));
        let freedom = (!equations.surplus.is_empty()).then(|| {
            let least = (self.coordinates() + equations.surplus.len()).saturating_sub(count);
            quote!(const MIN_DEGREES_OF_FREEDOM: usize = #least;)
        });
        quote! {
            const CONSTRAINTS: [&'static str; #count] = Self::CONSTRAINTS;
            const HOLONOMIC: usize = #holonomic;
            const INTEGRABLE: [bool; #count] = [#(#kinds),*];
            const CONSTANT_COLUMNS: [bool; #n] = [#(#constant),*];
            #freedom
        }
    }

    /// The impl of `DirectionalDerivatives`, for a model with constraints that is one on dual numbers, or is with them in place of
    /// its type parameter. External functions have derivatives on dual numbers that may not be the declared ones.
    pub(super) fn directional_derivatives(&self) -> TokenStream {
        let has_functions = self.model.graph.functions().next().is_some();
        if !self.is_constrained() || has_functions {
            return TokenStream::new();
        }
        let Declaration { root, generics, .. } = self.declaration;
        let signatures = self.signatures();
        let (n, c, scalar) = (self.coordinates(), self.constraint_count(), &self.scalar);
        let interface = quote!(#root::quantities::DirectionalDerivatives::<#n, #c, #scalar>);
        if scalar.is_generic() {
            let methods = signatures.directional_derivatives(
                |method, arguments| quote!(#root::__private::#method(self, #arguments)),
            );
            return self.implement(&interface, &methods);
        }
        let Some(parameter) = scalar_parameter(generics, scalar) else {
            return TokenStream::new();
        };
        let dual = quote!(#root::Dual<#scalar, 1>);
        let OnAnotherScalar { bounds, value } =
            OnAnotherScalar::of(self.declaration, &parameter, [&quote!(#scalar), &dual]);
        let methods = signatures.directional_derivatives(
            |method, arguments| quote!(#root::__private::#method(&#value, #arguments)),
        );
        self.implement_under(&interface, &bounds, &methods)
    }

    /// The impl of `StateJacobian`, for a model without constraints.
    pub(super) fn state_jacobian(&self) -> TokenStream {
        if self.is_constrained() {
            return TokenStream::new();
        }
        self.interface(Interface::StateJacobian, TokenStream::new())
    }

    pub(super) fn constraint_constants(&self) -> TokenStream {
        constants(self.declaration, &self.lowered.constraints)
    }

    /// What kind each constraint is, and how many degrees of freedom there are at least.
    pub(super) fn constraints_in_words(&self) -> String {
        if !self.is_constrained() {
            return String::new();
        }
        let (constraints, holonomic) = (
            &self.lowered.constraints,
            self.lowered.constraints.holonomic(),
        );
        let labels = constraints.labels().into_iter().enumerate();
        let kinds = labels.map(|(i, label)| {
            let kind = match self.equations.constraints.restricts_coordinates(i) {
                _ if i < holonomic => "holonomic",
                true => "declared as nonholonomic, and holonomic in disguise: it can be integrated to a relation of coordinates",
                false => "nonholonomic",
            };
            format!("- `{label}` is {kind}.\n")
        });
        let (n, surplus) = (self.coordinates(), self.equations.constraints.surplus.len());
        let independent = self.constraint_count() - surplus;
        let surplus = match surplus {
            0 => String::new(),
            _ => format!(", on which {surplus} more depend"),
        };
        format!(
            "\n# Constraints\n\n{}\nThere are at least {} degrees of freedom, {n} coordinates less {independent} constraints{surplus}. Where \
             constraints depend on others, there are more, and λ is not unique.\n",
            kinds.collect::<String>(),
            n.saturating_sub(independent),
        )
    }

    /// The items of `Quantities` by which a model with constraints is kept on them.
    pub(super) fn projection(&self) -> TokenStream {
        if !self.is_constrained() {
            return TokenStream::new();
        }
        let (root, arguments) = (&self.declaration.root, self.dimensions());
        let (n, c) = (self.coordinates(), self.constraint_count());
        let signatures = self.signatures();
        let (state, prepared) = (signatures.state(), &signatures.prepared);
        let scalar = &self.scalar;
        let declared = self.methods.get(EmittedMethod::Compliances);
        let check = declared.map(|_| {
            quote! {
                fn invalid_compliance(
                    &self,
                    prepared: &#prepared,
                ) -> ::core::option::Option<(::core::primitive::usize, ::core::primitive::f64)> {
                    #root::__private::invalid_compliance::<Self, #scalar, #n, #c>(self, prepared)
                }
            }
        });
        let constraints = self.methods.constraints.as_ref();
        let pivots = constraints.and_then(|methods| methods.pivots.as_ref());
        let pivoted = if let Some(pivots) = pivots {
            let body = self.body(pivots, ParameterSource::Prepared, &[]);
            quote!(::core::option::Option::Some({ #body }))
        } else {
            quote!(::core::option::Option::None)
        };
        quote! {
            #check
            const CONSTRAINTS: &'static [&'static str] = &Self::CONSTRAINTS;
            fn project(
                &self,
                state: #state,
                prepared: &#prepared,
            ) -> ::core::option::Option<#root::problem::Projection<#scalar, #root::Phase<#scalar, #n>>> {
                ::core::option::Option::Some(
                    #root::__private::project::<Self, #arguments>(self, state, prepared, #pivoted),
                )
            }
            fn sizes_in_metric(
                &self,
                state: #state,
                prepared: &#prepared,
                sizes: &#root::Phase<#scalar, #n>,
            ) -> ::core::option::Option<#root::Phase<#scalar, #n>> {
                ::core::option::Option::Some(#root::__private::sizes_in_metric(self, state, prepared, sizes))
            }
            fn fix_rank(&self, state: #state, prepared: &mut #prepared) {
                #root::__private::fix_rank::<Self, #arguments>(self, state, prepared);
            }
            fn violated_constraint(
                &self,
                state: #state,
                prepared: &#prepared,
            ) -> ::core::option::Option<(::core::primitive::usize, #scalar)> {
                #root::__private::violated_constraint::<Self, #scalar, #n, #c>(self, state, prepared)
            }
        }
    }

    /// The items of `Quantities` by which a model with constraints tells how nearly they depend on each other.
    pub(super) fn conditioning(&self) -> TokenStream {
        if !self.is_constrained() {
            return TokenStream::new();
        }
        let (root, arguments) = (&self.declaration.root, self.dimensions());
        let (n, c, scalar) = (self.coordinates(), self.constraint_count(), &self.scalar);
        let signatures = self.signatures();
        let (state, vector, prepared) = (
            signatures.state(),
            signatures.vector(),
            &signatures.prepared,
        );
        quote! {
            fn relative_pivots(&self, state: #state, prepared: &#prepared) -> #vector {
                #root::__private::constrained_pivots::<Self, #arguments>(self, state, prepared).0
            }
            fn constraint_sine(
                &self,
                state: #state,
                prepared: &#prepared,
            ) -> ::core::option::Option<#scalar> {
                ::core::option::Option::Some(
                    #root::__private::constraint_sine::<Self, #scalar, #n, #c>(self, state, prepared),
                )
            }
            fn pivots(
                &self,
                state: #state,
                prepared: &#prepared,
            ) -> (#vector, ::core::option::Option<(::core::primitive::usize, ::core::primitive::f64)>) {
                let (coordinates, constraints) = #root::__private::constrained_pivots::<Self, #arguments>(self, state, prepared);
                (coordinates, #root::__private::least_pivot(&constraints))
            }
        }
    }

    /// The statement that names the parts of a solution that these tokens mention: the accelerations, and with constraints
    /// the multipliers.
    pub(super) fn parts_of_solution(
        &self,
        solution: &TokenStream,
        readers: &TokenStream,
    ) -> TokenStream {
        if !self.is_constrained() {
            return quote!(let accelerations = #solution;);
        }
        let parts = self.split(solution);
        let pattern = pattern_of_parts(readers);
        quote!(let #pattern = #parts;)
    }

    /// The accelerations and the multipliers of a solution.
    pub(super) fn split(&self, solution: &TokenStream) -> TokenStream {
        let (root, arguments) = (&self.declaration.root, self.dimensions());
        quote!(#root::__private::parts::<#arguments>(&#solution))
    }

    /// The factors of the saddle point problem with this matrix.
    pub(super) fn saddle_point(
        &self,
        matrix: &TokenStream,
        source: ParameterSource,
    ) -> TokenStream {
        let (root, arguments, rank) =
            (&self.declaration.root, self.dimensions(), self.rank(source));
        let compliances = self.compliances(source);
        quote!(#root::__private::SaddlePoint::<#arguments>::new(#matrix, #rank)#compliances)
    }

    /// The call that gives factors the declared compliances; nothing where only accelerations are solved for.
    fn compliances(&self, source: ParameterSource) -> TokenStream {
        let declared = self.methods.get(EmittedMethod::Compliances);
        if declared.is_none() || source == ParameterSource::Fields {
            return TokenStream::new();
        }
        let constraints = self.signatures().interface(Interface::Constraints);
        quote!(.with_compliances(&#constraints::compliances(self, prepared)))
    }

    /// The number of independent constraints, or 0 where it is not known.
    fn rank(&self, source: ParameterSource) -> TokenStream {
        let functions = self.scalar.functions();
        let index = self.prepared.rank().map(Literal::usize_unsuffixed);
        if let (ParameterSource::Prepared, Some(index)) = (source, index) {
            quote!(prepared[#index])
        } else {
            quote!(#functions::from_f64(0.0))
        }
    }

    /// The factors of M, or of the saddle point problem of a constrained model, by the methods of the model.
    pub(super) fn factors(&self, source: ParameterSource) -> TokenStream {
        let root = &self.declaration.root;
        let mass = self.call(EmittedMethod::MassMatrix, source);
        if !self.is_constrained() {
            return quote!(#root::Factorization::new(#mass));
        }
        let jacobian = self.call(EmittedMethod::ConstraintJacobian, source);
        let (arguments, rank) = (self.dimensions(), self.rank(source));
        let compliances = self.compliances(source);
        quote!(#root::__private::saddle_point::<#arguments>(&#mass, &#jacobian, #rank)#compliances)
    }

    /// f, and with constraints behind it γ, by the methods of the model.
    pub(super) fn right_hand_side(&self, source: ParameterSource) -> TokenStream {
        let root = &self.declaration.root;
        let forcing = self.call(EmittedMethod::Forcing, source);
        if !self.is_constrained() {
            return forcing;
        }
        let rates = self.call(EmittedMethod::ConstraintRates, source);
        let arguments = self.dimensions();
        quote!(#root::__private::joined::<#arguments>(&#forcing, &#rates))
    }
}

/// The pattern for accelerations and multipliers, as far as these tokens mention them.
pub(super) fn pattern_of_parts(readers: &TokenStream) -> TokenStream {
    let [accelerations, multipliers] = ["accelerations", "multipliers"].map(|name| {
        if super::parameters::mentions(readers, name) {
            let name = Ident::new(name, proc_macro2::Span::call_site());
            quote!(#name)
        } else {
            quote!(_)
        }
    });
    quote!((#accelerations, #multipliers))
}

/// The names and the indices of the constraints, as constants of the type; nothing where there are none.
pub(super) fn constants(declaration: &Declaration, constraints: &Constraints) -> TokenStream {
    let count = constraints.len();
    if count == 0 {
        return TokenStream::new();
    }
    let visibility = &declaration.visibility;
    let labels = constraints.labels();
    let labels = labels.iter().map(ToString::to_string);
    let indices = constraints.names().into_iter().map(|(name, indices, is_single)| {
        let constant = hygienic_ident(&constant_name(name), name);
        let written = unraw(name);
        let length = indices.len();
        let indices = indices.into_iter().map(Literal::usize_unsuffixed);
        if is_single {
            let text = format!("The index of the constraint `{written}`.");
            quote!(#[doc = #text] #visibility const #constant: ::core::primitive::usize = #(#indices)*;)
        } else {
            let text = format!("The indices of the components of the constraint `{written}`.");
            quote! {
                #[doc = #text]
                #visibility const #constant: [::core::primitive::usize; #length] = [#(#indices),*];
            }
        }
    });
    quote! {
        /// The names of the constraints, in order.
        #visibility const CONSTRAINTS: [&'static str; #count] = [#(#labels),*];
        #(#indices)*
    }
}
