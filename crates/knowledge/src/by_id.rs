//! A map by id: iterates in the order of the ids and finds one with few comparisons. A plan looks tables up thousands
//! of times.

use std::borrow::Cow;
use std::collections::BTreeMap;

/// Things by their ids.
#[derive(Debug)]
pub struct ById<T> {
    /// In the order of their ids.
    entries: Vec<(Cow<'static, str>, T)>,
    /// The digest of every id with the index of its entry, ascending.
    digests: Vec<(u64, usize)>,
}

impl<T> Default for ById<T> {
    fn default() -> Self {
        Self { entries: Vec::new(), digests: Vec::new() }
    }
}

impl<T> From<BTreeMap<Cow<'static, str>, T>> for ById<T> {
    fn from(things: BTreeMap<Cow<'static, str>, T>) -> Self {
        let entries: Vec<_> = things.into_iter().collect();
        let mut digests: Vec<_> = entries.iter().enumerate().map(|(place, (id, _))| (digest(id), place)).collect();
        digests.sort_unstable();
        Self { entries, digests }
    }
}

impl<T> ById<T> {
    /// The thing of that id.
    pub fn get(&self, id: &str) -> Option<&T> {
        let wanted = digest(id);
        let first = self.digests.partition_point(|(digest, _)| *digest < wanted);
        // Two ids may have the same digest.
        let alike = self.digests[first..].iter().take_while(|(digest, _)| *digest == wanted);
        alike.map(|&(_, place)| &self.entries[place]).find(|(known, _)| known == id).map(|(_, thing)| thing)
    }

    /// The ids, in their order.
    pub fn ids(&self) -> impl Iterator<Item = &str> {
        self.entries.iter().map(|(id, _)| id.as_ref())
    }

    /// The things, by their ids.
    pub fn items(&self) -> impl Iterator<Item = &T> {
        self.entries.iter().map(|(_, thing)| thing)
    }

    /// The things themselves, by their ids.
    pub fn into_items(self) -> impl Iterator<Item = T> {
        self.entries.into_iter().map(|(_, thing)| thing)
    }
}

/// FNV-1a: short, the same everywhere, and ids are short.
fn digest(id: &str) -> u64 {
    id.bytes().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_thing_is_found_by_its_id_and_no_other_is() {
        // The test vectors of the algorithm's authors.
        assert_eq!(digest(""), 0xcbf2_9ce4_8422_2325);
        assert_eq!(digest("a"), 0xaf63_dc4c_8601_ec8c);
        assert_eq!(digest("foobar"), 0x8594_4171_f739_67e8);

        let ids = ["b", "a", "A.8", "A.80", ""];
        let things = ById::from(ids.iter().map(|id| (Cow::Borrowed(*id), id.len())).collect::<BTreeMap<_, _>>());
        assert!(ids.iter().all(|id| things.get(id) == Some(&id.len())));
        assert_eq!(things.get("A"), None);
        assert_eq!(things.ids().collect::<Vec<_>>(), ["", "A.8", "A.80", "a", "b"]);
        assert_eq!(things.items().copied().collect::<Vec<_>>(), [0, 3, 4, 1, 1]);
        assert_eq!(ById::<usize>::default().get("a"), None);
    }
}
