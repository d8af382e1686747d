//! Row types: the words that many tables share.

use technolog_knowledge::rows;

rows! {
    /// A word of a vocabulary, read by the loader of tables: enum columns name the vocabulary.
    pub struct VocabularyWord of Each(&["material-groups", "steel-classes", "alloy-classes", "practice-ways", "practice-groups", "field-letters", "iso-controls"]) {
        word: &'t str,
    } shown { name_uk, name_en }
}
