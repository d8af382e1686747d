//! The part of a plan to which a figure belongs.

pub use technolog_tables::quantity::Quantity;

/// The part of a plan to which a figure belongs; parts of a list by their index, from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Scope {
    /// A constant of the formulas.
    Constant,
    /// A row of the route.
    Row(usize),
    /// Conditions.
    Conditions(usize),
    /// A tool.
    Tool(usize),
    /// The clamping.
    Clamping,
    /// The times.
    Times,
}

/// One figure of a plan.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Id {
    /// Where it belongs.
    pub scope: Scope,
    /// What it is.
    pub quantity: Quantity,
    /// The place among several of the same kind, as factors are; else 0.
    pub index: usize,
}

impl Id {
    /// The figure of that quantity there.
    pub const fn new(scope: Scope, quantity: Quantity) -> Self {
        Self { scope, quantity, index: 0 }
    }

    /// Its key where it belongs in a plan file: the force of the clamping is called `force` there.
    pub fn key(self) -> &'static str {
        match (self.scope, self.quantity) {
            (Scope::Clamping, Quantity::ClampForce) => Quantity::Force.key(),
            (_, quantity) => quantity.key(),
        }
    }
}
