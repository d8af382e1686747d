//! Finishing allowances, and the rough contour that leaves them (lecture 12.2).
//!
//! - [`mod@capability`]: the intermediate allowance where the lathe cannot finish a surface;
//! - [`mod@finishing`]: the finishing allowance of each surface, from a table, from errors or as stated;
//! - [`mod@equidistant`]: the rough contour at these allowances (`union` joins the strips, `read_back` makes pieces of
//!   them);
//! - [`mod@areas`]: the three allowances as areas and volumes.

pub mod areas;
pub mod capability;
pub mod equidistant;
pub mod finishing;
mod read_back;
pub mod surfaces;
mod union;

pub use areas::{Area, Areas, areas, between};
pub use capability::{Elsewhere, LatheAccuracy, elsewhere};
pub use equidistant::{EquidistantError, Over, equidistant, equidistant_over};
pub use finishing::{Allowance, Errors, Method, allowance, finishing, least};
pub use surfaces::Place;
