//! The constants that a model has besides the indices of its coordinates and inputs.

/// The constants of its type that every model has.
pub(crate) const CONSTANTS: [&str; 4] = ["COORDINATES", "OPERATIONS", "EQUATIONS", "LATEX"];

/// The constants of traits that a model has; a constant of the type would hide them.
pub(crate) const CONSTANTS_OF_SYSTEMS: [&str; 6] = [
    "ANGLES",
    "PERIODS",
    "IGNORABLE",
    "SINGULARITIES",
    "STAYS_REGULAR",
    "POLES",
];
/// The constants of a model with constants of motion. Whether it has any is known after its equations: no model has
/// others of these names.
pub(crate) const CONSTANTS_OF_CONSERVATION: [&str; 3] = [
    "CONSTANTS_OF_MOTION",
    "IGNORABLE_COORDINATES",
    "CONSERVES_ENERGY",
];
/// The constants of a model with inputs.
pub(crate) const CONSTANTS_OF_INPUTS: [&str; 1] = ["INPUTS"];
/// The constants of a model with external functions.
pub(crate) const CONSTANTS_OF_FUNCTIONS: [&str; 1] = ["FUNCTIONS"];
/// The constants of a model with derivatives by parameters.
pub(crate) const CONSTANTS_OF_SENSITIVITIES: [&str; 1] = ["PARAMETERS"];
/// The constants of a model with a regressor.
pub(crate) const CONSTANTS_OF_REGRESSORS: [&str; 2] = ["BASE_PARAMETERS", "WITHOUT_EFFECT"];
/// The constants of a model that is written in C.
pub(crate) const CONSTANTS_OF_C: [&str; 3] = ["C_SOURCE", "C_HEADER", "C_CASADI"];
/// The constants of a reduced model.
pub(crate) const CONSTANTS_OF_REDUCED_MODELS: [&str; 1] = ["ELIMINATED"];
/// The constants of a model with events.
pub(crate) const CONSTANTS_OF_EVENTS: [&str; 1] = ["EVENTS"];
/// The constants of a model with constraints.
pub(crate) const CONSTANTS_OF_CONSTRAINTS: [&str; 1] = ["CONSTRAINTS"];
