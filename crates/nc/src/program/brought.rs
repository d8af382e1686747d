//! Whether a length offset is that of a tool that T has named and no change has brought: with it the tool before would
//! go down. T alone is right while the tool before works, and that may have a second offset: so the register decides, and
//! where nothing is known of it, whether the tool of T comes after all. At its end a program may name its first tool for the
//! next part.

use std::collections::BTreeSet;
use std::rc::Rc;

use super::TextSpan;

/// Who has used an F or an S since it was given.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum User {
    /// No tool.
    Nobody,
    /// The tool in the spindle.
    ToolInSpindle,
    /// Only a tool before it.
    ToolBefore,
}

impl User {
    /// The tool in the spindle uses it: whether it was that of the tool before.
    pub fn uses(&mut self) -> bool {
        std::mem::replace(self, Self::ToolInSpindle) == Self::ToolBefore
    }

    /// Another tool comes.
    pub fn changes(&mut self) {
        if *self == Self::ToolInSpindle {
            *self = Self::ToolBefore;
        }
    }
}

/// The tool in the spindle, and the one of T.
#[derive(Clone, Copy, Debug)]
pub(super) struct Named {
    pub tool: u32,
    pub wanted: u32,
}

/// What the length offset that begins to act is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Owner {
    /// Of the tool in the spindle, for all that is known.
    InSpindle,
    /// Of the tool of T.
    Wanted,
    /// Of either: another register than those that the tool in the spindle has had.
    Either,
}

/// A place where the offset was set that may be of a tool not brought: that tool, its register, the place.
#[derive(Clone, Copy, Debug)]
pub(super) struct Open {
    pub tool: u32,
    pub span: TextSpan,
    pub block: Option<u32>,
}

/// What a run has shown of tools and their registers so far.
#[derive(Clone, Debug, Default)]
pub(super) struct Registers {
    /// Pairs of a tool and a register that it has had in the spindle.
    used: Rc<BTreeSet<(u32, u32)>>,
    /// The first tool that came.
    first: Option<u32>,
    open: Option<Open>,
}

impl Registers {
    /// Whose a register is.
    fn owner(&self, register: u32, Named { tool, wanted }: Named) -> Owner {
        if register == 0 || wanted == 0 || wanted == tool {
            Owner::InSpindle
        } else if register == wanted {
            Owner::Wanted
        } else if self.used.contains(&(tool, register)) {
            Owner::InSpindle
        } else if self.used.contains(&(wanted, register)) {
            Owner::Wanted
        } else if self.used.iter().any(|(one, _)| *one == tool) {
            Owner::Either
        } else {
            // The first register of the tool in the spindle.
            Owner::InSpindle
        }
    }

    /// Whether a register has been the length of a tool.
    pub(super) fn is_length(&self, register: u32) -> bool {
        self.used.iter().any(|(_, used)| *used == register)
    }

    /// A register begins to act: whether it is that of a tool not brought. What is open is known later.
    pub(super) fn takes(&mut self, register: u32, named: Named, span: TextSpan, block: Option<u32>) -> bool {
        let owner = self.owner(register, named);
        match owner {
            // What is known already needs no copy.
            Owner::InSpindle if register > 0 && named.tool > 0 && !self.used.contains(&(named.tool, register)) => {
                Rc::make_mut(&mut self.used).insert((named.tool, register));
            }
            Owner::Either if self.open.is_none() => {
                self.open = Some(Open { tool: named.wanted, span, block });
            }
            _ => {}
        }
        owner == Owner::Wanted
    }

    /// T names a tool: one that was open and is forgotten now never came.
    pub(super) fn names(&mut self, wanted: u32) -> Option<Open> {
        self.open.take_if(|open| open.tool != wanted)
    }

    /// M6 brings the tool of T: so it was only named in advance.
    pub(super) fn brings(&mut self, tool: u32) {
        self.first.get_or_insert(tool);
        self.open = None;
    }

    /// The program ends: one that was open never came, but the first tool comes for the next part.
    pub(super) fn ends(&mut self) -> Option<Open> {
        self.open.take().filter(|open| self.first != Some(open.tool))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HERE: TextSpan = TextSpan { line: 1, column: 1, width: 1 };

    #[test]
    fn the_register_says_whose_the_offset_is() {
        let mut registers = Registers::default();
        registers.brings(1);
        let mut takes = |register, tool, wanted| {
            let wrong = registers.takes(register, Named { tool, wanted }, HERE, None);
            (wrong, registers.ends().is_some())
        };
        assert_eq!(takes(1, 1, 1), (false, false));
        assert_eq!(takes(2, 1, 2), (true, false), "the number of the tool named");
        assert_eq!(takes(11, 1, 2), (false, true), "never brought");
        assert_eq!(takes(12, 2, 2), (false, false));
        assert_eq!(takes(12, 1, 2), (true, false), "the one that T2 has had");
        assert_eq!(takes(5, 3, 4), (false, false), "the first of T3");
        assert_eq!(takes(6, 3, 1), (false, false), "T1 for the next part");
        assert_eq!(takes(9, 1, 0), (false, false), "no T");
    }

    #[test]
    fn a_tool_that_comes_was_named_in_advance() {
        let named = Named { tool: 1, wanted: 2 };
        let mut registers = Registers::default();
        registers.brings(1);
        assert!(!registers.takes(1, Named { wanted: 1, ..named }, HERE, None));
        assert!(!registers.takes(11, named, HERE, None) && registers.names(2).is_none());
        registers.brings(2);
        assert!(registers.names(3).is_none());
        assert!(!registers.takes(12, named, HERE, None));
        assert!(registers.names(3).is_some_and(|open| open.tool == 2), "another one is named");
    }
}
