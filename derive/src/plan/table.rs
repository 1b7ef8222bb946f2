//! The emitted methods, one row each.
//!
//! Emission, the impls beside errors, the operation counts, and the names that no output may have are read off this
//! table. To add a method, add its row here, its program in `methods.rs`, and, in the runtime, its declaration in the trait and
//! the method of `Lagrangian` that evaluates it.

/// The trait of the runtime that declares a method.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Interface {
    Quantities,
    StateJacobian,
    Constraints,
    Impacts,
    Energies,
    Inputs,
    Outputs,
    Events,
    Hamiltonian,
    EnergyBalance,
    Sensitivities,
    MultiplierSensitivities,
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
    /// What the methods of an integration's loop read: parameters, and what depends on them alone.
    Prepared,
    /// The struct of the declared outputs.
    Outputs,
    /// One value for each event.
    EventValues,
    /// A row for each coordinate and a column for each of some parameters.
    ParameterMatrix,
    /// The same for the accelerations, and with a row for each constraint for the multipliers.
    ParameterMatrices,
    /// A row for each coordinate and a column for each base parameter.
    Regressor,
    /// One component for each base parameter.
    BaseParameters,
    /// One component for each constraint.
    ConstraintVector,
    /// A row for each constraint and a column for each coordinate.
    ConstraintJacobian,
    /// One component for each coordinate, and one for each constraint.
    AccelerationsAndMultipliers,
    /// The gradient of an event function, and its derivative by the time.
    EventGradient,
}

/// What a method takes besides the inputs and the prepared array.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum Argument {
    /// The state.
    StateOnly,
    /// The state and the accelerations.
    Accelerations,
    /// The state and the momenta.
    Momenta,
    /// The state and the index of an event.
    Event,
    /// Nothing.
    Parameters,
}

/// Where a method reads the parameters, and what depends on them alone.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub(crate) enum ParameterSource {
    /// In the fields of the model.
    Fields,
    /// In the array that `prepare` returns, as do all methods of an integration's loop.
    Prepared,
}

/// A row of the table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct MethodRow {
    pub(crate) name: &'static str,
    /// The trait that declares the method.
    pub(crate) interface: Interface,
    pub(crate) result: ResultType,
    pub(crate) argument: Argument,
    pub(crate) parameters: ParameterSource,
    /// Whether inputs act on it: then it takes them.
    pub(crate) takes_inputs: bool,
    /// Whether its operations are counted in the constant `OPERATIONS` and in the documentation.
    pub(crate) is_counted: bool,
}

macro_rules! table {
    ($($method:ident: $name:literal, $interface:ident, $result:ident, $argument:ident, $parameters:ident, $inputs:literal, $counted:literal;)*) => {
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
                        parameters: ParameterSource::$parameters,
                        takes_inputs: $inputs,
                        is_counted: $counted,
                    },)*
                }
            }
        }
    };
}

table! {
    // method            name                  trait       result         argument       parameters inputs counted
    Lagrangian:        "lagrangian",         Quantities, Scalar,        StateOnly,     Prepared,  true,  true;
    Energy:            "energy",             Quantities, Scalar,        StateOnly,     Fields,    true,  true;
    Momenta:           "momenta",            Quantities, Vector,        StateOnly,     Prepared,  false, true;
    MassMatrix:        "mass_matrix",        Quantities, SquareMatrix,  StateOnly,     Prepared,  false, true;
    Forcing:           "forcing",            Quantities, Vector,        StateOnly,     Prepared,  true,  true;
    GeneralizedForces: "generalized_forces", Quantities, Vector,        StateOnly,     Fields,    true,  true;
    Prepare:           "prepare",            Quantities, Prepared,      Parameters,    Fields,    false, true;
    Accelerations:     "accelerations",      Quantities, Vector,        StateOnly,     Prepared,  true,  true;
    InverseDynamics:   "inverse_dynamics",   Quantities, Vector,        Accelerations, Prepared,  true,  true;
    Linearize:         "linearize",          StateJacobian, Linearization, StateOnly,     Fields,    true,  true;
    RelativePivots:    "relative_pivots",    Quantities, Vector,        StateOnly,     Prepared,  false, false;
    AccelerationsAndMultipliers: "accelerations_and_multipliers", Constraints, AccelerationsAndMultipliers, StateOnly, Prepared, true, false;
    ConstraintPositions: "constraint_positions", Constraints, ConstraintVector, StateOnly, Prepared, false, false;
    ConstraintVelocities: "constraint_velocities", Constraints, ConstraintVector, StateOnly, Prepared, false, false;
    ConstraintJacobian: "constraint_jacobian", Constraints, ConstraintJacobian, StateOnly, Prepared, false, false;
    Compliances:       "compliances",        Constraints, ConstraintVector, Parameters, Prepared,  false, false;
    ConstraintRates:   "constraint_rates",  Constraints, ConstraintVector, StateOnly,  Prepared,  false, false;
    KineticEnergy:     "kinetic_energy",     Energies,   Scalar,        StateOnly,     Fields,    true,  false;
    PotentialEnergy:   "potential_energy",   Energies,   Scalar,        StateOnly,     Fields,    true,  false;
    InputJacobian:     "input_jacobian",     Inputs,     InputMatrix,   StateOnly,     Fields,    true,  false;
    Outputs:           "outputs",            Outputs,    Outputs,       StateOnly,     Fields,    true,  false;
    EventFunctions:    "event_functions",    Events,     EventValues,   StateOnly,     Prepared,  true,  false;
    EventGradient:     "event_gradient",    Impacts,    EventGradient, Event,         Prepared,  true,  false;
    MomentumRates:     "momentum_rates",     Hamiltonian, Vector,       StateOnly,     Prepared,  true,  false;
    SolvedVelocities:  "solved_velocities",  Hamiltonian, Vector,       Momenta,       Prepared,  false, false;
    EnergyRate:        "energy_rate",        EnergyBalance, Scalar,     StateOnly,     Fields,    true,  false;
    Sensitivities:     "sensitivities",      Sensitivities, ParameterMatrix, StateOnly, Fields,    true,  false;
    SensitivitiesAndMultipliers: "accelerations_and_multipliers_by_parameters", MultiplierSensitivities, ParameterMatrices, StateOnly, Fields, true, false;
    Regressor:         "regressor",          Regressor,  Regressor,     Accelerations, Fields,    true,  false;
    KnownTerms:        "known_terms",        Regressor,  Vector,        Accelerations, Fields,    true,  false;
    BaseParameters:    "base_parameters",    Regressor,  BaseParameters, Parameters,   Fields,    false, false;
}

/// The methods that the traits of the runtime have besides.
const PROVIDED: [&str; 15] = [
    "assemble",
    "constraint_residuals",
    "constrained_response",
    "degrees_of_freedom",
    "impact",
    "multipliers",
    "multiplier_sensitivities",
    "dynamics",
    "into_dynamics",
    "taylor_series",
    "event_series",
    "inputs",
    "with_inputs",
    "constants_of_motion",
    "watch_constants",
];

/// The names of the parameters of emitted methods, which no local variable has.
pub(crate) const PARAMETERS: [&str; 7] = [
    "event",
    "state",
    "inputs",
    "accelerations",
    "momenta",
    "prepared",
    "arguments",
];

/// Whether a method of every model is called `name`.
pub(crate) fn is_method(name: &str) -> bool {
    let mut emitted = EmittedMethod::ALL.iter().map(|method| method.row());
    PROVIDED.contains(&name) || emitted.any(|row| row.name == name)
}

impl MethodRow {
    /// Whether the method is one of the state.
    pub(crate) fn takes_state(self) -> bool {
        self.argument != Argument::Parameters
    }

    /// Whether it takes the prepared array.
    pub(crate) fn takes_prepared(self) -> bool {
        self.parameters == ParameterSource::Prepared
    }
}
