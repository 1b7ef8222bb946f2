//! The emitted methods, one row each.
//!
//! Emission, the impls beside errors, the operation counts, the delegations of models with inputs, and the names
//! that no output may have are read off this table. To add a method, add its row here, its program in `methods.rs`,
//! and its declaration in the trait of the runtime.

/// The trait of the runtime that declares a method.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Interface {
    Lagrangian,
    Energies,
    Inputs,
    Outputs,
    Events,
    Hamiltonian,
    EnergyBalance,
    Sensitivities,
    Regressor,
}

/// What a method returns.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum ResultType {
    Scalar,
    /// One component for each coordinate.
    Vector,
    /// A row and a column for each coordinate.
    SquareMatrix,
    /// A row for each coordinate and a column for each input.
    InputMatrix,
    /// The derivatives of the accelerations by q, q̇ and t.
    Linearization,
    /// The invariants of an integration: what depends on the parameters alone.
    Invariants,
    /// The struct of the declared outputs.
    Outputs,
    /// One value for each event.
    EventValues,
    /// A row for each coordinate and a column for each of some parameters.
    ParameterMatrix,
    /// A row for each coordinate and a column for each base parameter.
    Regressor,
    /// One component for each base parameter.
    BaseParameters,
}

/// What a method takes besides the inputs.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Argument {
    /// The state.
    StateOnly,
    /// The state and the accelerations.
    Accelerations,
    /// The state and the momenta.
    Momenta,
    /// Nothing.
    Parameters,
}

/// Whether what depends on the parameters alone is computed within a method.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Invariants {
    Within,
    /// A second method, whose name ends in `_prepared`, takes the hoisted invariants.
    Hoisted,
}

/// A row of the table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MethodRow {
    pub(crate) name: &'static str,
    /// The trait that declares the method; where it takes inputs, that of models without them.
    pub(crate) interface: Interface,
    pub(crate) result: ResultType,
    pub(crate) argument: Argument,
    pub(crate) invariants: Invariants,
    /// Whether inputs act on it: then models with inputs have a second method, whose name ends in `_with`.
    pub(crate) takes_inputs: bool,
    /// Whether its operations are counted in the constant `OPERATIONS` and in the documentation.
    pub(crate) is_counted: bool,
}

macro_rules! table {
    ($($method:ident: $name:literal, $interface:ident, $result:ident, $argument:ident, $invariants:ident, $inputs:literal, $counted:literal;)*) => {
        /// A method that is emitted for a model.
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub(crate) enum EmittedMethod {
            $($method,)*
        }

        impl EmittedMethod {
            /// All methods, in the order in which they are counted and emitted.
            pub(crate) const ALL: &'static [Self] = &[$(Self::$method),*];

            /// What the table says of the method.
            pub(crate) const fn row(self) -> MethodRow {
                match self {
                    $(Self::$method => MethodRow {
                        name: $name,
                        interface: Interface::$interface,
                        result: ResultType::$result,
                        argument: Argument::$argument,
                        invariants: Invariants::$invariants,
                        takes_inputs: $inputs,
                        is_counted: $counted,
                    },)*
                }
            }
        }
    };
}

table! {
    // method            name                  trait       result         argument       invariants  inputs counted
    Lagrangian:        "lagrangian",         Lagrangian, Scalar,        StateOnly,     Within,    true,  true;
    Energy:            "energy",             Lagrangian, Scalar,        StateOnly,     Within,    true,  true;
    Momenta:           "momenta",            Lagrangian, Vector,        StateOnly,     Within,    false, true;
    MassMatrix:        "mass_matrix",        Lagrangian, SquareMatrix,  StateOnly,     Within,    false, true;
    Forcing:           "forcing",            Lagrangian, Vector,        StateOnly,     Within,    true,  true;
    GeneralizedForces: "generalized_forces", Lagrangian, Vector,        StateOnly,     Within,    true,  true;
    Prepare:           "prepare",            Lagrangian, Invariants,    Parameters,    Within,    false, true;
    Accelerations:     "accelerations",      Lagrangian, Vector,        StateOnly,     Hoisted,   true,  true;
    InverseDynamics:   "inverse_dynamics",   Lagrangian, Vector,        Accelerations, Hoisted,   true,  true;
    Linearize:         "linearize",          Lagrangian, Linearization, StateOnly,     Within,    true,  true;
    RelativePivots:    "relative_pivots",    Lagrangian, Vector,        StateOnly,     Within,    false, false;
    KineticEnergy:     "kinetic_energy",     Energies,   Scalar,        StateOnly,     Within,    false, false;
    PotentialEnergy:   "potential_energy",   Energies,   Scalar,        StateOnly,     Within,    false, false;
    InputJacobian:     "input_jacobian",     Inputs,     InputMatrix,   StateOnly,     Within,    true,  false;
    Outputs:           "outputs",            Outputs,    Outputs,       StateOnly,     Within,    true,  false;
    EventFunctions:    "event_functions",    Events,     EventValues,   StateOnly,     Within,    true,  false;
    MomentumRates:     "momentum_rates",     Hamiltonian, Vector,       StateOnly,     Within,    true,  false;
    SolvedVelocities:  "solved_velocities",  Hamiltonian, Vector,       Momenta,       Within,    false, false;
    EnergyRate:        "energy_rate",        EnergyBalance, Scalar,     StateOnly,     Within,    true,  false;
    Sensitivities:     "sensitivities",      Sensitivities, ParameterMatrix, StateOnly, Within,   true,  false;
    Regressor:         "regressor",          Regressor,  Regressor,     Accelerations, Within,    true,  false;
    KnownTerms:        "known_terms",        Regressor,  Vector,        Accelerations, Within,    true,  false;
    BaseParameters:    "base_parameters",    Regressor,  BaseParameters, Parameters,   Within,    false, false;
}

/// The methods that the traits of the runtime have besides.
const PROVIDED: [&str; 11] = [
    "dynamics",
    "into_dynamics",
    "taylor_series",
    "event_series",
    "inputs",
    "with_inputs",
    "input_matrix",
    "controlled_by",
    "with_controller",
    "constants_of_motion",
    "watch_constants",
];

/// The names of the parameters of emitted methods, which no local variable has.
pub(crate) const PARAMETERS: [&str; 6] = [
    "state",
    "inputs",
    "accelerations",
    "momenta",
    "prepared",
    "arguments",
];

/// Whether a method of every model is called `name`.
pub(crate) fn is_method(name: &str) -> bool {
    let emitted = EmittedMethod::ALL.iter().map(|method| method.row());
    let mut variants = emitted.flat_map(MethodRow::variants);
    PROVIDED.contains(&name) || variants.any(|variant| variant.name() == name)
}

impl MethodRow {
    /// Whether the method is one of the state.
    pub(crate) fn takes_state(self) -> bool {
        self.argument != Argument::Parameters
    }

    /// Whether the method stands in the trait `Inputs`, with the inputs as a parameter.
    pub(crate) fn is_of_inputs(self) -> bool {
        self.takes_inputs && matches!(self.interface, Interface::Lagrangian | Interface::Inputs)
    }

    /// The function that takes no invariants.
    pub(crate) const fn unprepared(self) -> Variant {
        Variant {
            row: self,
            is_prepared: false,
        }
    }

    /// The emitted functions of the row: two where the invariants are computed apart.
    pub(crate) fn variants(self) -> impl Iterator<Item = Variant> {
        let prepared = self.invariants == Invariants::Hoisted;
        let variant = move |is_prepared| Variant {
            row: self,
            is_prepared,
        };
        [false, true]
            .into_iter()
            .filter(move |is_prepared| prepared || !is_prepared)
            .map(variant)
    }
}

/// One of the emitted functions of a row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Variant {
    pub(crate) row: MethodRow,
    /// Whether it takes the hoisted invariants.
    pub(crate) is_prepared: bool,
}

impl Variant {
    /// Its name in models without inputs.
    pub(crate) fn name(self) -> String {
        let suffix = if self.is_prepared { "_prepared" } else { "" };
        format!("{}{suffix}", self.row.name)
    }

    /// Whether it takes the accelerations.
    pub(crate) fn takes_accelerations(self) -> bool {
        self.row.argument == Argument::Accelerations
    }
}
