//! The lathes of `catalogs/lathes` and the tools of `catalogs/tools/turning`.
//!
//! A figure missing in a record or a row is `None` here, never a guess. Code that needs it refuses with the missing
//! figure (docs/turning-tools.md).

mod lathe;
mod tool;
mod workholding;

pub use lathe::{Lathe, Share, Spindle};
pub use tool::{Hand, Place, Shank, ToolKind, TurningTool};
pub(crate) use workholding::figure;
pub use workholding::{Seconds, Workholding};
