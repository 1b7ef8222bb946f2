//! The passes that can be switched off, so that what each of them earns can be measured.
//!
//! A pass changes the cost of a result, never its value: with any of them off, the equations are the same.
//! Normal forms, value numbering and the choice of the cheapest solver are no passes: nothing works without
//! them. A new pass is guarded by [`Passes::has`] where it is applied, and the benchmark's ablation study gets
//! one more row.

use core::str::FromStr;

/// Writes the enumeration, the list of all and their names from one row for each pass.
macro_rules! passes {
    ($($(#[doc = $doc:literal])+ $pass:ident = $name:literal,)+) => {
        /// A pass that can be switched off.
        #[derive(Clone, Copy, PartialEq, Eq, Debug)]
        pub enum Pass {
            $($(#[doc = $doc])+ $pass,)+
        }

        impl Pass {
            /// All passes, in the order in which they are applied to a model.
            pub const ALL: &[Self] = &[$(Self::$pass),+];

            /// The name by which a pass is switched off.
            #[must_use]
            pub const fn name(self) -> &'static str {
                match self {
                    $(Self::$pass => $name,)+
                }
            }
        }
    };
}

passes! {
    /// sin² + cos² = 1 and its consequences, in sums.
    Pythagoras = "pythagoras",
    /// Expansion where that makes an expression cheaper.
    Expansion = "expansion",
    /// T + V for the energy function, where it is that.
    TotalEnergy = "total-energy",
    /// Opaque nodes for intermediate results.
    Opaque = "opaque",
    /// The equations and the accelerations along the tree of quasi-velocities, or along the links of a mechanism.
    ArticulatedBodies = "articulated-bodies",
    /// Equations along a tree divided by the inertia of which all others are multiples.
    InertiaScaling = "inertia-scaling",
    /// The accelerations by the symbolic factorization of the mass matrix.
    Ldlt = "ldlt",
    /// The accelerations through as many quasi-velocities as there are coordinates.
    QuasiVelocities = "quasi-velocities",
    /// Quasi-velocities recovered from the mass matrix, besides the declared ones.
    RecoveredForms = "recovered-forms",
    /// Gyroscopic terms by structure constants, as in ω × Iω.
    StructureConstants = "structure-constants",
    /// One reciprocal for all quotients with the same divisor.
    Reciprocals = "reciprocals",
    /// Existing sums, found again among the multiples of a factor.
    Collecting = "collecting",
    /// Common factors taken out of sums.
    Factoring = "factoring",
    /// Invariant factors distributed over sums whose terms have invariant factors.
    Distribution = "distribution",
    /// Invariant factors and terms gathered within products and sums.
    Gathering = "gathering",
    /// Invariants hoisted into a setup program that runs once, not at every evaluation.
    Staging = "staging",
    /// Common subexpressions of products.
    SharedProducts = "shared-products",
    /// Common subexpressions of sums.
    SharedSums = "shared-sums",
    /// Sine and cosine of one angle in one operation.
    Pairing = "pairing",
    /// Sines and cosines of several angles at once, on vectors.
    Vectors = "vectors",
    /// Products fused with sums where the target has the instruction.
    Fusion = "fusion",
    /// Terms added in the order in which they are known, in long programs.
    Reassociation = "reassociation",
    /// Long programs in an order in which fewer values wait in memory.
    Ordering = "ordering",
}

/// Which passes are applied; by default all of them.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Passes {
    /// A bit for each pass that is switched off.
    off: u32,
}

impl Passes {
    /// None of them.
    pub const NONE: Self = Self { off: u32::MAX };

    /// Whether `pass` is applied.
    #[must_use]
    pub const fn has(self, pass: Pass) -> bool {
        self.off & 1 << pass as u32 == 0
    }

    /// The same without `pass`.
    #[must_use]
    pub const fn without(self, pass: Pass) -> Self {
        Self {
            off: self.off | 1 << pass as u32,
        }
    }
}

/// A name that no pass has.
#[derive(Clone, PartialEq, Eq, Debug)]
pub struct UnknownPass(pub String);

impl FromStr for Pass {
    type Err = UnknownPass;

    fn from_str(name: &str) -> Result<Self, UnknownPass> {
        let mut passes = Self::ALL.iter().copied();
        passes
            .find(|pass| pass.name() == name)
            .ok_or_else(|| UnknownPass(name.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_pass_is_switched_off_alone() {
        for pass in Pass::ALL {
            assert_eq!(pass.name().parse(), Ok(*pass));
            let passes = Passes::default().without(*pass);
            let off = Pass::ALL.iter().filter(|other| !passes.has(**other));
            assert_eq!(off.collect::<Vec<_>>(), [pass]);
        }
    }

    #[test]
    fn other_names_are_refused() {
        let name = "sharing";
        assert_eq!(name.parse::<Pass>(), Err(UnknownPass(name.to_owned())));
    }
}
