//! The knowledge base inside the program: compiled tables for planning, and their YAML for `lint`, which needs the
//! place of every cell.

use technolog_knowledge::{Knowledge, SourceFile};

/// The tables, compiled while the program was built.
static COMPILED: &[u8] = include_bytes!(concat!(env!("OUT_DIR"), "/knowledge.bin"));

/// The files they were compiled from.
pub const SOURCES: &[SourceFile<'static>] = include!(concat!(env!("OUT_DIR"), "/sources.rs"));

/// The shipped tables, without parsing.
///
/// # Errors
/// The compiled form does not fit this program, which means a broken build.
pub fn knowledge() -> Result<Knowledge, String> {
    Knowledge::from_bytes(COMPILED)
}
