//! What a shaft is turned with: the lathes of `catalogs/lathes` and the tools of `catalogs/tools/turning`.
//!
//! A figure that a record or a row does not have is `None` here, never a guess. What needs it refuses with the missing
//! figure (docs/turning-tools.md).

mod lathe;
mod tool;
mod workholding;

pub use lathe::{Lathe, Share, Spindle};
pub use tool::{Hand, Place, Shank, ToolKind, TurningTool};
pub use workholding::{Seconds, Workholding};
