//! The functions of the declaration language, by name.

use lagrangian_symbolic::{ARRAY_FUNCTIONS, Binary, Unary};

/// Functions that have an index, or the number of rows, as an argument.
const OF_INDICES: [&str; 3] = ["row", "column", "identity"];

/// Functions of rotations and of angles: examples, one for each kind.
const OF_ROTATIONS: [&str; 8] = [
    "rotation_x",
    "rotation_zxz",
    "rotation_zyx",
    "angular_velocity",
    "angular_velocity_inertial",
    "angular_velocity_zxz",
    "angular_velocity_zyx",
    "angular_velocity_zxz_inertial",
];

/// Functions of a body and of where it is.
const OF_BODIES: [&str; 2] = ["kinetic_energy", "potential_energy"];

/// Functions of blocks of matrices, each with an example.
const OF_BLOCKS: [(&str, &str); 6] = [
    ("view", "m.view((0, 0), (3, 3))"),
    ("rows", "m.rows(0, 3)"),
    ("columns", "m.columns(0, 3)"),
    ("xyz", "v.xyz()"),
    ("push", "v.push(1.0)"),
    ("homogeneous", "homogeneous(r, p)"),
];

/// How a function of blocks of matrices is written, if it is one.
pub(super) fn example_of_blocks(name: &str) -> Option<&'static str> {
    let mut all = OF_BLOCKS.into_iter();
    all.find_map(|(known, example)| (known == name).then_some(example))
}

/// Whether a function is built in.
pub(crate) fn is_function(name: &str) -> bool {
    functions().any(|function| function == name)
}

/// Whether an external function may not have this name. The short words for blocks are free: a function that is declared
/// comes before them.
pub(crate) fn is_reserved(name: &str) -> bool {
    is_function(name) && (name == "homogeneous" || example_of_blocks(name).is_none())
}

/// All functions that are built in.
pub(super) fn functions() -> impl Iterator<Item = &'static str> {
    of_scalars()
        .chain(ARRAY_FUNCTIONS.iter().map(|function| function.name))
        .chain(OF_INDICES)
        .chain(OF_ROTATIONS)
        .chain(OF_BODIES)
        .chain(OF_BLOCKS.map(|(name, _)| name))
        .chain(["vector", "reaction"])
}

/// Those of scalars.
pub(super) fn of_scalars() -> impl Iterator<Item = &'static str> {
    let unary = Unary::ALL.into_iter().filter(|one| one.is_written());
    let unary = unary.map(Unary::name);
    let binary = Binary::ALL.into_iter().map(Binary::name);
    unary.chain(binary).chain(["sqrt", "powi", "recip", "dot"])
}
