//! Every finding is said in every language, with all its figures.
