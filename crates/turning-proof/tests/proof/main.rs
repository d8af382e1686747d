//! The proof of turned parts: by hand, by a law, and what it says.

mod clean;
mod faults;
mod laws;
mod made;
mod tools;
mod words;
