//! Reads the diameter of a hole or a step: a size with its tolerance, or a thread.

use crate::knowledge::diagnostic::Place;
use crate::knowledge::form::{Form, KeyOf};
use crate::knowledge::yaml::{Fields, Node, NodeKind};
use crate::units::{Deviation, Micrometres, Roughness};
use technolog_note::note;

use super::file::hole::Limits;
use super::read::Reader;
use super::{Thread, ToleratedDiameter, thread};

/// The diameter of a group or a step, as read.
pub(super) struct Sized {
    pub diameter: ToleratedDiameter,
    pub thread: Option<Thread>,
    pub place: Place,
}

impl Sized {
    /// The diameter of the removed metal: for a thread its own.
    pub fn widest(&self) -> Micrometres {
        let nominal = self.diameter.nominal;
        self.thread.as_ref().map_or(nominal, |thread| thread.size.max(nominal))
    }
}

impl Reader<'_> {
    /// The diameter and the thread of a hole or a step; a thread gives the diameter itself.
    pub(super) fn sized<F: Form>(
        &mut self,
        fields: &mut Fields<'_, F>,
        thread: KeyOf<F>,
        diameter: KeyOf<F>,
        required: bool,
    ) -> Option<Sized> {
        let thread_node = fields.take(thread);
        let diameter_node = match thread_node {
            None if required && !fields.means(thread) => fields.need(diameter, self.problems),
            _ => fields.take(diameter),
        };
        let Some(node) = thread_node else {
            let node = diameter_node?;
            return Some(Sized { diameter: self.diameter(node)?, thread: None, place: node.place.clone() });
        };
        let threaded = match thread::read(self.problems.text(node)?, self.knowledge) {
            Ok(threaded) => threaded,
            Err(error) => return self.problems.error_help(error.code, error.message, &node.place, error.help),
        };
        let (thread, hole) = (threaded.thread, threaded.hole);
        if let Some(stated) = diameter_node {
            let text = self.problems.text(stated)?;
            let size = super::tolerance::without_sign(text).parse();
            if size != Ok(thread.size) && size != Ok(hole) {
                let (written, nominal) = (&thread.written, thread.size);
                let message = note!(
                    "part-diameter-but-hole-under",
                    text = text,
                    written = written,
                    nominal = nominal,
                    hole = hole
                );
                let help = note!("part-leave-diameter-out-thread-says");
                return self.problems.error_help("bad-diameter", message, &stated.place, help);
            }
        }
        match ToleratedDiameter::under_thread(hole, &thread, self.knowledge) {
            Ok(diameter) => Some(Sized { diameter, thread: Some(thread), place: node.place.clone() }),
            Err(message) => self.problems.error("bad-diameter", message, &node.place),
        }
    }

    /// The roughness of a thread whose drawing gives none.
    pub(super) fn thread_roughness(&mut self, place: &Place) -> Option<Roughness> {
        match thread::roughness(self.knowledge) {
            Ok(roughness) => Some(roughness),
            Err(message) => self.problems.error("bad-value", message, place),
        }
    }

    pub(super) fn diameter(&mut self, node: &Node) -> Option<ToleratedDiameter> {
        let diameter = if matches!(node.kind, NodeKind::Map(_)) {
            let mut fields = self.problems.map(node)?;
            let nominal = self.need_size(&mut fields, Limits::nominal);
            let upper =
                fields.need(Limits::upper, self.problems).and_then(|node| self.problems.scalar::<Deviation>(node));
            let lower =
                fields.need(Limits::lower, self.problems).and_then(|node| self.problems.scalar::<Deviation>(node));
            fields.finish(self.problems);
            ToleratedDiameter::from_limits(nominal?, upper?.0, lower?.0, self.knowledge)
        } else {
            ToleratedDiameter::parse(self.problems.text(node)?, self.knowledge)
        };
        match diameter {
            Ok(diameter) => Some(diameter),
            Err(message) => self.problems.error("bad-diameter", message, &node.place),
        }
    }
}
