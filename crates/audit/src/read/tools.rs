//! Tools and holders.

use crate::knowledge::form::Form;
use crate::knowledge::yaml::{Node, NodeKind};
use technolog_note::note;

use super::Reader;
use super::rows::number_of_tool;
use crate::audit::finding::Section;
use crate::audit::quantity::Quantity;
use crate::audit::stated::{StatedFigure, StatedValue, Tool};
use crate::audit::{file, limits};

impl Reader<'_> {
    /// Tools by their places: `T1: {…}`.
    pub(super) fn tools(&mut self, node: &Node) -> Vec<Tool> {
        let NodeKind::Map(entries) = &node.kind else {
            let message = note!("yaml-mapping-expected-here", kind_name = node.kind_name());
            let help = note!("planfile-name-tools-by-their-places");
            let _ = self.problems.error_help::<()>("bad-value", message, &node.place, help);
            return Vec::new();
        };
        let mut tools: Vec<Tool> = Vec::new();
        // Tools whose holder is that of another, with its number.
        let mut shared: Vec<(u32, StatedValue<u32>)> = Vec::new();
        for (key, node) in limits::tools(entries, |(key, _)| &key.place, &mut self.problems) {
            let Some(number) = number_of_tool(&key.text) else {
                let message = note!("planfile-no-tool", text = key.text);
                let help = note!("planfile-name-by-place-t-t");
                let _ = self.problems.error_help::<()>("bad-value", message, &key.place, help);
                continue;
            };
            let Some(tool) = self.tool(node, number) else { continue };
            if tools.iter().any(|known| known.number == number) {
                let message = note!("planfile-tool-t-stands-twice", number = number);
                let help = note!("planfile-give-each-tool-own-place");
                let _ = self.problems.error_help::<()>("duplicate-tool", message, &key.place, help);
            }
            let holder =
                node.get(file::Tool::holder.name()).filter(|holder| holder.text().is_some() && !holder.is_null());
            if let Some(same) = holder.and_then(|holder| self.tool_number(holder)) {
                shared.push((number, same));
            }
            tools.push(tool);
        }
        for (number, same) in shared {
            self.share(&mut tools, number, &same);
        }
        tools
    }

    /// `holder: T1`: the tool has the holder that T1 has.
    fn share(&mut self, tools: &mut [Tool], number: u32, same: &StatedValue<u32>) {
        let same_tool =
            tools.iter().find(|tool| tool.number == same.value && tool.number != number && tool.holder.is_some());
        let Some(same_tool) = same_tool.cloned() else {
            let message = note!("planfile-t-has-no-holder-own", value = same.value);
            let help = note!("planfile-name-tool-whose-holder-written");
            let _ = self.problems.error_help::<()>("unknown-tool", message, &same.place, help);
            return;
        };
        let Some(tool) = tools.iter_mut().find(|tool| tool.number == number) else { return };
        let place = || same.place.clone();
        tool.holder = same_tool.holder.map(|text| StatedValue { place: place(), ..text });
        tool.holder_standard = same_tool.holder_standard.map(|text| StatedValue { place: place(), ..text });
        let keys = file::Holder::KEYS.iter().filter_map(|key| Quantity::of_key(&format!("holder.{}", key.name())));
        for quantity in keys {
            let figure = same_tool.figures.get(&quantity).cloned();
            tool.figures.extend(figure.map(|figure| (quantity, StatedFigure { place: place(), ..figure })));
        }
    }

    fn tool(&mut self, node: &Node, number: u32) -> Option<Tool> {
        let mut fields = self.problems.map(node)?;
        let designation = self.text_of(&mut fields, file::Tool::designation);
        let standard = self.text_of(&mut fields, file::Tool::standard);
        let table = self.text_of(&mut fields, file::Tool::table);
        let shank = fields.take(file::Tool::shank).and_then(|node| {
            let names = ["cylindrical", "morse", "shell", "taper"].map(|name| (name, name));
            let value = self.choice(node, &names)?.to_owned();
            Some(StatedValue { value, place: node.place.clone() })
        });
        let correction_word = fields.take(file::Tool::with).and_then(|node| {
            let value = self.choice(node, &[("G43", "G43"), ("G44", "G44")])?.to_owned();
            Some(StatedValue { value, place: node.place.clone() })
        });
        let holder_node = fields.take(file::Tool::holder);
        let mut figures = self.figures(Section::Tools, &mut fields);
        fields.finish(&mut self.problems);
        let (mut holder, mut holder_standard) = (None, None);
        // A text names the tool that has the same holder.
        let holder_node = holder_node.filter(|node| node.text().is_none());
        if let Some(mut fields) = holder_node.and_then(|node| self.problems.map(node)) {
            holder = self.text_of(&mut fields, file::Holder::designation);
            holder_standard = self.text_of(&mut fields, file::Holder::standard);
            figures.extend(self.figures_under(Section::Holders, "holder.", &mut fields));
            fields.finish(&mut self.problems);
        }
        Some(Tool {
            number,
            place: node.place.clone(),
            designation,
            standard,
            table,
            shank,
            holder,
            holder_standard,
            correction_word,
            figures,
        })
    }
}
