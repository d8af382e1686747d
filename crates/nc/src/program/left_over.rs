//! What the program before may have left: what every control asks of it alike.

/// The words of those groups that a block relies on and that the program has never set: there what the program before has left
/// acts. Each is told once. A group is given by its number in `own`, its word, and whether the block relies on it.
pub(super) fn never_set<W>(own: &mut [bool], relied_on: impl IntoIterator<Item = (usize, W, bool)>) -> Vec<W> {
    let first =
        |(group, word, used): (usize, W, bool)| (used && !std::mem::replace(&mut own[group], true)).then_some(word);
    relied_on.into_iter().filter_map(first).collect()
}

/// Whether a way along X or Y comes before the program has brought Z anywhere: the quill may be down. It is told once.
pub(super) fn height_unknown(known: &mut bool, lifts: bool, goes: bool) -> bool {
    *known |= lifts;
    goes && !std::mem::replace(known, true)
}
