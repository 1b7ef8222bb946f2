//! Which kinds of symbols an expression contains, at any depth.
//!
//! A synthesized attribute of the graph (Knuth, Semantics of context-free languages, 1968): it is computed from
//! those of the operands when a node is interned, so that asking for it costs no traversal.

use crate::{Node, Symbol, Unary};

/// The kinds of symbols that an expression contains, and whether it contains an absolute value.
#[derive(Clone, Copy, PartialEq, Eq, Default, Debug)]
pub struct Contents(u16);

impl Contents {
    const TIME: u16 = 1;
    const COORDINATE: u16 = 1 << 1;
    const VELOCITY: u16 = 1 << 2;
    const ACCELERATION: u16 = 1 << 3;
    const PARAMETER: u16 = 1 << 4;
    const INPUT: u16 = 1 << 5;
    const INVARIANT: u16 = 1 << 6;
    const ABSOLUTE_VALUE: u16 = 1 << 7;
    const ARGUMENT: u16 = 1 << 8;
    const COMPONENT: u16 = 1 << 9;

    /// The contents of a node, where `known` has those of all earlier nodes.
    pub(crate) fn of(node: &Node, known: &[Self]) -> Self {
        let mut contents = match node {
            Node::Symbol(symbol) => Self::symbol(*symbol),
            Node::Unary(Unary::Abs, _) => Self::ABSOLUTE_VALUE,
            _ => 0,
        };
        node.for_each_operand(|operand| contents |= known[operand.index()].0);
        Self(contents)
    }

    const fn symbol(symbol: Symbol) -> u16 {
        match symbol {
            Symbol::Time => Self::TIME,
            Symbol::Coordinate(_) => Self::COORDINATE,
            Symbol::Velocity(_) | Symbol::QuasiVelocity(_) => Self::VELOCITY,
            Symbol::Acceleration(_)
            | Symbol::QuasiVelocityRate(_)
            | Symbol::RightHandSide(_)
            | Symbol::Variation(_) => Self::ACCELERATION,
            Symbol::Parameter(_) => Self::PARAMETER,
            Symbol::Input(_) => Self::INPUT,
            Symbol::Invariant(_) => Self::INVARIANT,
            Symbol::Argument(_) => Self::ARGUMENT,
            Symbol::PositionComponent(_) => Self::COORDINATE | Self::COMPONENT,
            Symbol::VelocityComponent(_) => Self::VELOCITY | Self::COMPONENT,
            // Symbols of programs, which no expression contains.
            Symbol::Order | Symbol::ReciprocalOrder | Symbol::Convolution(_) => 0,
        }
    }

    /// Whether there is a velocity.
    #[must_use]
    pub const fn has_velocity(self) -> bool {
        self.0 & Self::VELOCITY != 0
    }

    /// Whether there is an acceleration.
    #[must_use]
    pub const fn has_acceleration(self) -> bool {
        self.0 & Self::ACCELERATION != 0
    }

    /// Whether there is an input.
    #[must_use]
    pub const fn has_input(self) -> bool {
        self.0 & Self::INPUT != 0
    }

    /// Whether there is what can change along a motion: the time, a coordinate, a velocity, an acceleration or an input.
    #[must_use]
    pub const fn varies_in_motion(self) -> bool {
        let varying =
            Self::TIME | Self::COORDINATE | Self::VELOCITY | Self::ACCELERATION | Self::INPUT;
        self.0 & varying != 0
    }

    /// Whether there is a component of a vector that is not resolved yet.
    #[must_use]
    pub const fn has_component(self) -> bool {
        self.0 & Self::COMPONENT != 0
    }

    /// Whether there is an absolute value.
    #[must_use]
    pub const fn has_absolute_value(self) -> bool {
        self.0 & Self::ABSOLUTE_VALUE != 0
    }

    /// Whether there is the time, or what changes with it: not a function's argument, which may or may not.
    #[must_use]
    pub const fn varies_in_time(self) -> bool {
        let constant = Self::PARAMETER | Self::INVARIANT | Self::ABSOLUTE_VALUE | Self::ARGUMENT;
        self.0 & !constant != 0
    }

    /// Whether there is any symbol other than parameters and invariants.
    #[must_use]
    pub const fn varies(self) -> bool {
        self.0 & !(Self::PARAMETER | Self::INVARIANT | Self::ABSOLUTE_VALUE) != 0
    }
}
