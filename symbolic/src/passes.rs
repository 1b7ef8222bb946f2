//! The passes that can be switched off, so that what each of them earns can be measured.
//!
//! A pass changes what a result costs, never what it is: with any of them off, the equations are the same.
//! Normal forms, numbering of values and the choice of the cheapest way are no passes: nothing works
//! without them. Where a new pass is applied it asks [`Passes::has`], and the benchmark's ablation gets a
//! line more.

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
    /// Multiplying out where that makes an expression cheaper.
    Expansion = "expansion",
    /// T + V for the energy function, where it is that.
    TotalEnergy = "total-energy",
    /// Keeping intermediate results whole in what is made of them.
    Whole = "whole",
    /// The accelerations along the tree that quasi-velocities form.
    Tree = "tree",
    /// Dividing a tree's equations by the inertia of which all others are multiples.
    Unit = "unit",
    /// The accelerations by elimination of the mass matrix before any number is known.
    Elimination = "elimination",
    /// The accelerations through as many quasi-velocities as there are coordinates.
    QuasiVelocities = "quasi-velocities",
    /// Quasi-velocities from the mass matrix, besides those that were declared.
    Inertias = "inertias",
    /// Gyroscopic terms by structure constants, as in ω × Iω.
    StructureConstants = "structure-constants",
    /// One reciprocal for all that is divided by the same.
    Reciprocals = "reciprocals",
    /// Sums that are computed anyway, found again among the multiples of a factor.
    Collecting = "collecting",
    /// Common factors taken out of sums.
    Factoring = "factoring",
    /// Constant factors moved into sums whose terms have constant factors.
    Distribution = "distribution",
    /// What depends on parameters alone gathered within products and sums.
    Gathering = "gathering",
    /// What depends on parameters alone computed once and not at every evaluation.
    Preparation = "preparation",
    /// Products that several products have in common.
    SharedProducts = "shared-products",
    /// Sums that several sums have in common.
    SharedSums = "shared-sums",
    /// Sine and cosine of one angle in one operation.
    Pairing = "pairing",
    /// Sines and cosines of several angles at once, on vectors.
    Vectors = "vectors",
    /// Products fused with sums where the target has the instruction.
    Fusion = "fusion",
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
