//! The language of every answer.

pub use technolog_words::Lang;
