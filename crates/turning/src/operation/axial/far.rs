//! Threads that are tapped from the other end than their hole is drilled.

use crate::error::KnowledgeError;
use crate::turning::contour::{Profile, Side, SurfaceName};
use crate::turning::jobs::hole;
use crate::turning::operation::tools::Bench;
use crate::turning::zones::{SetUp, TurnedSide};

use super::Axial;

impl Axial {
    /// The narrow end of the bore of each set-up. A tapped thread behind a plain cylinder of its diameter is left to the second one.
    ///
    /// # Errors
    /// As for [`Axial::of`].
    pub fn of_set_ups(set_ups: &[SetUp], bench: &Bench<'_, '_>) -> Result<Vec<Option<Self>>, KnowledgeError> {
        let axials = set_ups.iter().map(|one| one.inner.as_ref().map(|inner| Self::of(inner, bench)).transpose());
        let mut axials = axials.map(|axial| Ok(axial?.flatten())).collect::<Result<Vec<_>, KnowledgeError>>()?;
        if let ([Some(near), far], Some(inner)) = (axials.as_mut_slice(), &bench.workpiece.inner) {
            near.leave(bench);
            if !near.left.is_empty() {
                let bored = set_ups.get(1).and_then(|second| second.inner.clone());
                let whole = inner.turned_over(bench.workpiece.length());
                *far = Some(Self::take(far.take(), &near.left, bored, whole));
            }
        }
        Ok(axials)
    }

    /// Leaves the tapped threads behind plain cylinders of their diameter to the next set-up.
    fn leave(&mut self, bench: &Bench<'_, '_>) {
        let is_tapped =
            |name: &SurfaceName| bench.workpiece.thread_on(name).is_some_and(|thread| thread.tapped.is_some());
        let surfaces = &self.whole.surfaces;
        let behind = (0..surfaces.len()).filter(|index| hole::plain_before(surfaces, *index).is_some());
        let names = behind.filter_map(|index| surfaces.get(index)).map(|surface| surface.name.clone());
        let known: Vec<&SurfaceName> = self.holes.iter().flat_map(|hole| &hole.threads).collect();
        self.left = names.filter(|name| known.contains(&name) && is_tapped(name)).collect();
    }

    /// With the threads that the set-up before has left; `bored` is the bore of this one, `whole` that of the part as it sees it.
    fn take(axial: Option<Self>, left: &[SurfaceName], bored: Option<TurnedSide>, whole: Profile) -> Self {
        let (far, nothing) = (Some((whole, left.to_vec())), Profile { side: Side::Inner, surfaces: Vec::new() });
        match axial {
            Some(axial) => Self { far, ..axial },
            None => Self { holes: Vec::new(), far_mouth: None, bored, whole: nothing, left: Vec::new(), far },
        }
    }

    /// The threads that the set-up before has left to this one.
    pub fn far(&self) -> impl Iterator<Item = &SurfaceName> {
        self.far.iter().flat_map(|(_, names)| names)
    }
}
