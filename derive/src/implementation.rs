//! The items that are emitted for a model.

use lagrangian_symbolic::{Equations, Model, OperationCount, Program, Symbol};
use proc_macro2::{Ident, Span, TokenStream, TokenTree};
use quote::{format_ident, quote};

use crate::body::{Body, Source};
use crate::declaration::{Declaration, Role};
use crate::documentation;
use crate::methods::{Method, Methods};
use crate::names::{Locals, SymbolNames, constant, plain};
use crate::scope::Scope;

/// Everything about one model that the emitted text depends on.
pub(crate) struct Implementation<'a> {
    pub(crate) declaration: &'a Declaration,
    pub(crate) scope: &'a Scope,
    pub(crate) model: &'a Model,
    pub(crate) equations: &'a Equations,
    pub(crate) methods: &'a Methods,
    pub(crate) symbols: SymbolNames,
    pub(crate) scalar: Ident,
}

/// Where the values of inputs come from.
#[derive(Clone, Copy, PartialEq, Eq)]
enum InputsFrom {
    Fields,
    Argument,
}

struct Reader<'a> {
    implementation: &'a Implementation<'a>,
    inputs: InputsFrom,
}

impl Source for Reader<'_> {
    fn read(&self, symbol: Symbol) -> TokenStream {
        let field = |names: &[Ident], i: u32| {
            let name = &names[i as usize];
            let name = self.implementation.scope.first_use(name).unwrap_or(name);
            quote!(::lagrangian::__private::parameter(self.#name))
        };
        let names = &self.implementation.symbols;
        match symbol {
            Symbol::Time => quote!(state.t),
            Symbol::Coordinate(i) => element(&quote!(state.q), i),
            Symbol::Velocity(i) => element(&quote!(state.v), i),
            Symbol::Acceleration(i) => element(&quote!(accelerations), i),
            Symbol::Parameter(i) => field(&names.parameters, i),
            Symbol::Input(i) if self.inputs == InputsFrom::Argument => element(&quote!(inputs), i),
            Symbol::Input(i) => field(&names.inputs, i),
        }
    }
}

fn element(vector: &TokenStream, index: u32) -> TokenStream {
    let index = proc_macro2::Literal::u32_unsuffixed(index);
    quote!(#vector[#index])
}

impl<'a> Implementation<'a> {
    pub(crate) fn new(
        declaration: &'a Declaration,
        scope: &'a Scope,
        model: &'a Model,
        equations: &'a Equations,
        methods: &'a Methods,
    ) -> Self {
        let names = |role| {
            declaration
                .fields_with(role)
                .map(|field| field.name.clone())
                .collect()
        };
        Self {
            declaration,
            scope,
            model,
            equations,
            methods,
            symbols: SymbolNames {
                coordinates: declaration.clauses.coordinates.clone(),
                parameters: names(Role::Parameter),
                inputs: names(Role::Input),
            },
            scalar: Ident::new("__S", Span::mixed_site()),
        }
    }

    /// All items, in the order in which a reader wants them.
    pub(crate) fn items(&self) -> TokenStream {
        [
            self.constants(),
            self.system(),
            self.lagrangian(),
            self.energies(),
            self.inputs(),
            self.outputs(),
        ]
        .into_iter()
        .collect()
    }

    fn has_inputs(&self) -> bool {
        self.model.inputs > 0
    }

    fn coordinates(&self) -> usize {
        self.model.coordinates as usize
    }

    /// `impl<…> trait<…> for Model`, generic over the scalar.
    fn implement(&self, interface: &TokenStream, items: &TokenStream) -> TokenStream {
        let name = &self.declaration.name;
        let scalar = &self.scalar;
        let mut generics = self.declaration.generics.clone();
        generics
            .params
            .push(syn::parse_quote!(#scalar: ::lagrangian::Scalar));
        let (generics, _, _) = generics.split_for_impl();
        let (_, arguments, conditions) = self.declaration.generics.split_for_impl();
        quote! {
            #[automatically_derived]
            impl #generics #interface for #name #arguments #conditions {
                #items
            }
        }
    }

    /// What is known of the model before any number is, as constants of its type.
    fn constants(&self) -> TokenStream {
        let name = &self.declaration.name;
        let visibility = &self.declaration.visibility;
        let (generics, arguments, conditions) = self.declaration.generics.split_for_impl();
        let n = self.coordinates();
        let equations = documentation::equations(self);
        let documentation = documentation::of(self, &equations);
        let names = self.symbols.coordinates.iter().map(plain);
        let operations = self.operations();
        let indices = self
            .symbols
            .coordinates
            .iter()
            .enumerate()
            .map(|(i, coordinate)| {
                let constant = placed(&constant(coordinate), coordinate);
                let text = format!("The index of the coordinate `{}`.", plain(coordinate));
                quote!(#[doc = #text] #visibility const #constant: usize = #i;)
            });
        quote! {
            #[doc = #documentation]
            impl #generics #name #arguments #conditions {
                /// The names of the coordinates, in order.
                #visibility const COORDINATES: [&'static str; #n] = [#(#names),*];
                #(#indices)*
                /// The equations of motion as they were derived.
                #visibility const EQUATIONS: &'static str = #equations;
                /// The operation counts of the methods.
                #visibility const OPERATIONS: ::lagrangian::Operations = #operations;
            }
        }
    }

    fn operations(&self) -> TokenStream {
        let counts = self.methods.all().map(|(name, method)| {
            let name = format_ident!("{name}");
            let count = operation_count(&method.count);
            quote!(#name: #count)
        });
        quote!(::lagrangian::Operations { #(#counts),* })
    }

    fn system(&self) -> TokenStream {
        let name = &self.declaration.name;
        let (generics, arguments, conditions) = self.declaration.generics.split_for_impl();
        let n = self.coordinates();
        let structure = &self.equations.structure;
        let angles = &structure.angles;
        let singularities = structure.singularities.iter().map(|coordinates| {
            let coordinates = coordinates
                .iter()
                .map(|i| proc_macro2::Literal::u32_unsuffixed(*i));
            quote!(&[#(#coordinates),*])
        });
        quote! {
            #[automatically_derived]
            impl #generics ::lagrangian::System<#n> for #name #arguments #conditions {
                const COORDINATES: [&'static str; #n] = Self::COORDINATES;
                const ANGLES: [bool; #n] = [#(#angles),*];
                const SINGULARITIES: [&'static [usize]; #n] = [#(#singularities),*];
            }
        }
    }

    fn lagrangian(&self) -> TokenStream {
        let n = self.coordinates();
        let scalar = &self.scalar;
        let methods = self.methods;
        let vector = self.vector();
        let momenta = self.method("momenta", &[], &vector, &methods.momenta, as_vector);
        let mass = quote!(::lagrangian::__private::SMatrix<#scalar, #n, #n>);
        let mass = self.method("mass_matrix", &[], &mass, &methods.mass_matrix, |b| {
            b.columns(n)
        });
        let pivots = methods.relative_pivots.as_ref().map(|method| {
            self.method("relative_pivots", &[], &vector, method, |b| {
                b.relative_pivots(n)
            })
        });
        let driven = if self.has_inputs() {
            self.delegations()
        } else {
            self.driven(&[], "")
        };
        self.implement(
            &quote!(::lagrangian::Lagrangian<#n, #scalar>),
            &quote!(#driven #momenta #mass #pivots),
        )
    }

    /// The methods that inputs act on, with the arguments and the suffix that they then have.
    fn driven(&self, arguments: &[TokenStream], suffix: &str) -> TokenStream {
        let scalar = &self.scalar;
        let n = self.coordinates();
        let vector = self.vector();
        let methods = self.methods;
        let name = |name: &str| format!("{name}{suffix}");
        let mut with_accelerations = arguments.to_vec();
        with_accelerations.push(quote!(accelerations: &#vector));
        let scalar = quote!(#scalar);
        let linearization = quote!(::lagrangian::Linearization<#scalar, #n>);
        [
            self.method(
                &name("lagrangian"),
                arguments,
                &scalar,
                &methods.lagrangian,
                as_scalar,
            ),
            self.method(
                &name("energy"),
                arguments,
                &scalar,
                &methods.energy,
                as_scalar,
            ),
            self.method(
                &name("forcing"),
                arguments,
                &vector,
                &methods.forcing,
                as_vector,
            ),
            self.method(
                &name("generalized_forces"),
                arguments,
                &vector,
                &methods.generalized_forces,
                as_vector,
            ),
            self.method(
                &name("accelerations"),
                arguments,
                &vector,
                &methods.accelerations,
                |b| match methods.relative_pivots {
                    Some(_) => b.eliminated(n, &self.forcing(suffix)),
                    None => b.accelerations(n),
                },
            ),
            self.method(
                &name("inverse_dynamics"),
                &with_accelerations,
                &vector,
                &methods.inverse_dynamics,
                as_vector,
            ),
            self.method(
                &name("linearize"),
                arguments,
                &linearization,
                &methods.linearize,
                |b| b.linearize(n),
            ),
        ]
        .into_iter()
        .collect()
    }

    /// The forcing, as the method with a suffix computes it.
    fn forcing(&self, suffix: &str) -> TokenStream {
        let (n, u) = (self.coordinates(), self.model.inputs as usize);
        let scalar = &self.scalar;
        if suffix.is_empty() {
            quote!(::lagrangian::Lagrangian::<#n, #scalar>::forcing(self, state))
        } else {
            quote!(::lagrangian::Inputs::<#n, #u, #scalar>::forcing_with(self, state, inputs))
        }
    }

    /// The methods of `Lagrangian` for a model with inputs: those of `Inputs`, at the fields' values.
    fn delegations(&self) -> TokenStream {
        let (n, u) = (self.coordinates(), self.model.inputs as usize);
        let scalar = &self.scalar;
        let vector = self.vector();
        let inputs = quote!(&::lagrangian::Inputs::<#n, #u, #scalar>::inputs(self));
        let delegation = |name: &str, output: TokenStream| {
            let (name, with) = (format_ident!("{name}"), format_ident!("{name}_with"));
            quote! {
                fn #name(&self, state: &::lagrangian::State<#scalar, #n>) -> #output {
                    ::lagrangian::Inputs::<#n, #u, #scalar>::#with(self, state, #inputs)
                }
            }
        };
        let mut delegations: TokenStream = [
            delegation("lagrangian", quote!(#scalar)),
            delegation("energy", quote!(#scalar)),
            delegation("forcing", vector.clone()),
            delegation("generalized_forces", vector.clone()),
            delegation("accelerations", vector.clone()),
            delegation(
                "linearize",
                quote!(::lagrangian::Linearization<#scalar, #n>),
            ),
        ]
        .into_iter()
        .collect();
        delegations.extend(quote! {
            fn inverse_dynamics(
                &self,
                state: &::lagrangian::State<#scalar, #n>,
                accelerations: &#vector,
            ) -> #vector {
                ::lagrangian::Inputs::<#n, #u, #scalar>::inverse_dynamics_with(
                    self, state, #inputs, accelerations,
                )
            }
        });
        delegations
    }

    fn energies(&self) -> TokenStream {
        let Some([kinetic, potential]) = &self.methods.energies else {
            return TokenStream::new();
        };
        let n = self.coordinates();
        let scalar = &self.scalar;
        let output = quote!(#scalar);
        let kinetic = self.method("kinetic_energy", &[], &output, kinetic, as_scalar);
        let potential = self.method("potential_energy", &[], &output, potential, as_scalar);
        self.implement(
            &quote!(::lagrangian::Energies<#n, #scalar>),
            &quote!(#kinetic #potential),
        )
    }

    fn inputs(&self) -> TokenStream {
        if !self.has_inputs() {
            return TokenStream::new();
        }
        let (n, u) = (self.coordinates(), self.model.inputs as usize);
        let scalar = &self.scalar;
        let vector = quote!(::lagrangian::__private::SVector<#scalar, #u>);
        let names = self.symbols.inputs.iter().map(plain);
        let fields = &self.symbols.inputs;
        let arguments = [quote!(inputs: &#vector)];
        let driven = self.driven(&arguments, "_with");
        let matrix = quote!(::lagrangian::__private::SMatrix<#scalar, #n, #u>);
        let jacobian = self.method(
            "input_jacobian_with",
            &arguments,
            &matrix,
            &self.methods.input_jacobian,
            |b| b.input_jacobian(n),
        );
        let items = quote! {
            const INPUTS: [&'static str; #u] = [#(#names),*];

            fn inputs(&self) -> #vector {
                <#vector as ::core::convert::From<[#scalar; #u]>>::from([
                    #(::lagrangian::__private::parameter(self.#fields)),*
                ])
            }

            #driven
            #jacobian
        };
        self.implement(&quote!(::lagrangian::Inputs<#n, #u, #scalar>), &items)
    }

    fn outputs(&self) -> TokenStream {
        let outputs = &self.declaration.clauses.outputs;
        if outputs.is_empty() {
            return TokenStream::new();
        }
        let n = self.coordinates();
        let scalar = &self.scalar;
        let names: Vec<_> = outputs.iter().map(|output| &output.name).collect();
        let (results, definition) = results(self.declaration, scalar, &names);
        let output = quote!(Self::Outputs);
        let method = self.method("outputs", &[], &output, &self.methods.outputs, |b| {
            b.outputs(&results, &names)
        });
        let implementation = self.implement(
            &quote!(::lagrangian::Outputs<#n, #scalar>),
            &quote!(type Outputs = #results<#scalar>; #method),
        );
        quote!(#definition #implementation)
    }

    fn vector(&self) -> TokenStream {
        let (n, scalar) = (self.coordinates(), &self.scalar);
        quote!(::lagrangian::__private::SVector<#scalar, #n>)
    }

    /// A method of the state, with its body.
    fn method(
        &self,
        name: &str,
        arguments: &[TokenStream],
        output: &TokenStream,
        method: &Method,
        write: impl FnOnce(&mut Writer<'_>) -> TokenStream,
    ) -> TokenStream {
        let inputs = if name.ends_with("_with") {
            InputsFrom::Argument
        } else {
            InputsFrom::Fields
        };
        let reader = Reader {
            implementation: self,
            inputs,
        };
        let locals = Locals::new(&self.model.graph, self.scope, &self.symbols);
        let mut writer = Writer {
            program: &method.program,
            body: Body::new(&method.program, locals, &self.scalar, &reader),
            scalar: &self.scalar,
        };
        let body = write(&mut writer);
        let (n, scalar, name) = (self.coordinates(), &self.scalar, format_ident!("{name}"));
        let [state, arguments] = [
            quote!(state: &::lagrangian::State<#scalar, #n>),
            quote!(#(#arguments),*),
        ]
        .map(|parameters| marked_if_unused(parameters, &body));
        quote! {
            fn #name(&self, #state, #arguments) -> #output {
                #body
            }
        }
    }
}

/// The body of one method, in the shape that it returns.
struct Writer<'a> {
    program: &'a Program,
    body: Body<'a>,
    scalar: &'a Ident,
}

impl Writer<'_> {
    fn phase(&mut self, index: usize) -> (TokenStream, Vec<TokenStream>) {
        self.body.phase(&self.program.phases[index])
    }

    fn columns(&mut self, rows: usize) -> TokenStream {
        let (statements, outputs) = self.phase(0);
        let matrix = matrix(&outputs, rows);
        quote!(#statements #matrix)
    }

    /// Solves M q̈ = f.
    fn accelerations(&mut self, n: usize) -> TokenStream {
        let (statements, outputs) = self.phase(0);
        let factors = self.factors(&outputs, n);
        let forcing = vector(&outputs[outputs.len() - n..]);
        quote!(#statements #factors factors.solve(&#forcing))
    }

    /// The accelerations of an elimination whose pivots are positive; else M is factored in numbers.
    fn eliminated(&mut self, n: usize, forcing: &TokenStream) -> TokenStream {
        let (statements, outputs) = self.phase(0);
        let (pivots, accelerations) = outputs.split_at(n);
        let accelerations = vector(accelerations);
        let scalar = self.scalar;
        quote! {
            #statements
            ::lagrangian::__private::if_positive([#(#pivots),*], #accelerations, || {
                let mass = ::lagrangian::Lagrangian::<#n, #scalar>::mass_matrix(self, state);
                ::lagrangian::Factorization::new(mass).solve(&#forcing)
            })
        }
    }

    fn relative_pivots(&mut self, n: usize) -> TokenStream {
        let (statements, outputs) = self.phase(0);
        let lists = outputs.chunks(n.max(1)).map(|list| quote!([#(#list),*]));
        quote!(#statements ::lagrangian::__private::relative_pivots(#(#lists),*))
    }

    /// Solves M q̈ = f, then M ∂q̈/∂x = −∂(M q̈ − f)/∂x.
    fn linearize(&mut self, n: usize) -> TokenStream {
        let (statements, outputs) = self.phase(0);
        let factors = self.factors(&outputs, n);
        let forcing = vector(&outputs[outputs.len() - n..]);
        let (more, derivatives) = self.phase(1);
        let position = matrix(&derivatives[..n * n], n);
        let velocity = matrix(&derivatives[n * n..2 * n * n], n);
        let time = vector(&derivatives[2 * n * n..]);
        quote! {
            #statements
            #factors
            let accelerations = factors.solve(&#forcing);
            #more
            ::lagrangian::Linearization {
                position: -factors.solve(&#position),
                velocity: -factors.solve(&#velocity),
                time: -factors.solve(&#time),
            }
        }
    }

    fn input_jacobian(&mut self, n: usize) -> TokenStream {
        let (statements, outputs) = self.phase(0);
        let factors = self.factors(&outputs, n);
        let derivatives = matrix(&outputs[n * (n + 1) / 2..], n);
        quote!(#statements #factors -factors.solve(&#derivatives))
    }

    /// Factors M, whose lower triangle stands first among the outputs.
    fn factors(&self, outputs: &[TokenStream], n: usize) -> TokenStream {
        let scalar = self.scalar;
        let zero = quote!(#scalar::from_f64(0.0));
        let columns: Vec<_> = (0..n)
            .flat_map(|j| (0..n).map(move |i| (i, j)))
            .map(|(i, j)| {
                if i < j {
                    &zero
                } else {
                    &outputs[i * (i + 1) / 2 + j]
                }
            })
            .cloned()
            .collect();
        let mass = matrix(&columns, n);
        quote!(let factors = ::lagrangian::Factorization::new(#mass);)
    }

    fn outputs(&mut self, results: &Ident, names: &[&Ident]) -> TokenStream {
        let accelerates = self
            .program
            .symbols()
            .iter()
            .any(|symbol| matches!(symbol, Symbol::Acceleration(_)));
        let accelerations = accelerates.then(
            || quote!(let accelerations = ::lagrangian::Lagrangian::accelerations(self, state);),
        );
        let (statements, outputs) = self.phase(0);
        quote!(#accelerations #statements #results { #(#names: #outputs),* })
    }
}

/// The struct that holds a model's outputs: its name, and its definition.
pub(crate) fn results(
    declaration: &Declaration,
    scalar: &Ident,
    outputs: &[&Ident],
) -> (Ident, TokenStream) {
    let name = &declaration.name;
    let visibility = &declaration.visibility;
    let results = placed(&format!("{}Outputs", plain(name)), name);
    let documentation = format!("The outputs of [`{name}`].");
    let fields = outputs.iter().map(|output| {
        let mut name = (*output).clone();
        name.set_span(hygienic(output));
        let text = format!("The output `{}`.", plain(output));
        quote!(#[doc = #text] #visibility #name: #scalar)
    });
    let definition = quote! {
        #[doc = #documentation]
        #[derive(
            ::core::clone::Clone,
            ::core::marker::Copy,
            ::core::fmt::Debug,
            ::core::cmp::PartialEq,
            ::core::cmp::Eq,
        )]
        #visibility struct #results<#scalar> {
            #(#fields),*
        }
    };
    (results, definition)
}

fn as_scalar(writer: &mut Writer<'_>) -> TokenStream {
    let (statements, outputs) = writer.phase(0);
    quote!(#statements #(#outputs)*)
}

fn as_vector(writer: &mut Writer<'_>) -> TokenStream {
    let (statements, outputs) = writer.phase(0);
    let vector = vector(&outputs);
    quote!(#statements #vector)
}

/// A name where `at` stands, with the hygiene of the macro: what the user's lints would say of it does
/// not concern the user.
pub(crate) fn placed(name: &str, at: &Ident) -> Ident {
    Ident::new(name, hygienic(at))
}

fn hygienic(at: &Ident) -> Span {
    Span::mixed_site().located_at(at.span())
}

/// The parameters of a method, with an underscore before those that its body does not use.
fn marked_if_unused(parameters: TokenStream, body: &TokenStream) -> TokenStream {
    let mut tokens = Vec::new();
    for token in parameters {
        match token {
            TokenTree::Ident(name) if PARAMETERS.iter().any(|known| name == known) => {
                let unused = !mentions(body, &name);
                tokens.push(if unused {
                    format_ident!("_{name}").into()
                } else {
                    TokenTree::Ident(name)
                });
            }
            token => tokens.push(token),
        }
    }
    tokens.into_iter().collect()
}

/// The names of parameters of emitted methods.
const PARAMETERS: [&str; 3] = ["state", "inputs", "accelerations"];

fn mentions(tokens: &TokenStream, name: &Ident) -> bool {
    tokens.clone().into_iter().any(|token| match token {
        TokenTree::Ident(ident) => ident == *name,
        TokenTree::Group(group) => mentions(&group.stream(), name),
        _ => false,
    })
}

fn vector(elements: &[TokenStream]) -> TokenStream {
    quote!(::lagrangian::__private::SVector::from([#(#elements),*]))
}

/// A matrix from its elements, column by column.
fn matrix(elements: &[TokenStream], rows: usize) -> TokenStream {
    let columns = elements
        .chunks(rows.max(1))
        .map(|column| quote!([#(#column),*]));
    quote!(::lagrangian::__private::SMatrix::from([#(#columns),*]))
}

fn operation_count(count: &OperationCount) -> TokenStream {
    let OperationCount {
        additions,
        multiplications,
        divisions,
        square_roots,
        sines_and_cosines,
        functions,
    } = *count;
    quote! {
        ::lagrangian::OperationCount {
            additions: #additions,
            multiplications: #multiplications,
            divisions: #divisions,
            square_roots: #square_roots,
            sines_and_cosines: #sines_and_cosines,
            functions: #functions,
        }
    }
}
