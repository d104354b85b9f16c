//! Which panel is shown large: the one that the explanation names, the one in which its question is answered, or the user's choice.

use super::{Drawer, Refused, Session};
use crate::algorithms::focus::Focus;
use crate::app::strings;
use crate::panels::Panel;

impl Session {
    /// The lesson's panels; their numbers count from 1. Whoever follows a form factor sees its panel too.
    pub fn panels(&self) -> Vec<Panel> {
        let mut panels = self.open.lesson.panels.clone();
        let follows = matches!(self.focus, Focus::FormFactor { .. });
        if follows && !panels.contains(&Panel::FormFactor) {
            panels.push(Panel::FormFactor);
        }
        panels
    }

    /// The panel shown large. None in a lesson without panels.
    pub fn key_panel(&self) -> Option<Panel> {
        let said = self.explanation().map(|index| &self.open.narrated[index]);
        let named = || said.and_then(|said| said.key);
        let panels = self.panels();
        self.chosen
            .filter(|chosen| panels.contains(chosen))
            .or_else(|| self.answer_panel())
            .or_else(named)
            .or_else(|| panels.first().copied())
    }

    /// The panel in which the question at this step is answered, before and after. The one that the explanation names, where that
    /// will do.
    fn answer_panel(&self) -> Option<Panel> {
        let (question, _) = self.question()?;
        let named = self.narration_here().and_then(|said| said.key);
        let first = self.panels().first().copied();
        let fits = question.answer.panels();
        let wished = named.or(first).into_iter().chain(fits.iter().copied());
        let mut shown = wished.filter(|panel| self.panels().contains(panel));
        shown.find(|panel| fits.contains(panel))
    }

    /// The others, in their order.
    pub fn other_panels(&self) -> Vec<Panel> {
        let key = self.key_panel();
        let panels = self.panels().into_iter();
        panels.filter(|&panel| Some(panel) != key).collect()
    }

    /// Whether the key panel fills the window.
    pub fn is_filled(&self) -> bool {
        self.filled
    }

    pub(super) fn choose_key(&mut self, panel: Panel) {
        self.chosen = Some(panel);
    }

    /// The panel of that number, from 1.
    pub(super) fn numbered(&self, number: usize) -> Result<Panel, Refused> {
        let index = number.checked_sub(1).filter(|&i| i < self.panels().len());
        index
            .map(|i| self.panels()[i])
            .ok_or(strings::NO_SUCH_PANEL.into())
    }

    pub(super) fn fill(&mut self) {
        self.filled = !self.filled;
    }

    /// Where an explanation just reached names a panel, or its question is answered in one, that panel is shown.
    pub(super) fn follow_narration(&mut self, from: usize) {
        let before = self.narrated.partition_point(|&step| step <= from);
        let now = self.narrated.partition_point(|&step| step <= self.step());
        let named = |count: usize| self.open.narrated.get(count.checked_sub(1)?)?.key;
        if before != now && (named(now).is_some() || self.answer_panel().is_some()) {
            self.chosen = None;
        }
    }

    pub(super) fn toggle_drawer(&mut self, drawer: Drawer) {
        let shown = self.look.drawer.filter(|_| !self.covers_window());
        self.look.drawer = Some(drawer).filter(|_| shown != Some(drawer));
        self.show_window();
    }

    /// Whether the presentation or one panel takes the place of the window's bar and drawers.
    fn covers_window(&self) -> bool {
        self.filled || self.look.presenting
    }

    /// In the presentation, the values that the explanation at this step shows.
    pub(super) fn presented(&self) -> Option<&[String]> {
        let said = self.narration_here();
        let values = said.map_or(&[][..], |said| &said.values);
        self.look.presenting.then_some(values)
    }

    /// Ends what covers the window's bar and drawers.
    pub(super) fn show_window(&mut self) {
        self.filled = false;
        self.look.stop_presenting();
    }
}
