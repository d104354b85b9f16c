//! What hands do in the drawer.

use super::*;

impl Screen {
    /// The drawer looks at its file again and again: it never comes to rest by itself.
    pub(super) fn rest(&mut self) {
        self.harness.run_steps(3);
    }

    pub(super) fn localize(&self, message: Message) -> &'static str {
        self.session().localize(message)
    }

    pub(super) fn act(&mut self, message: Message) {
        let label = self.localize(message);
        self.click_there(label);
    }

    /// Brings a button into view, and clicks it.
    pub(super) fn click_there(&mut self, label: &str) {
        self.harness.get_by_label(label).scroll_to_me();
        self.rest();
        self.harness.get_by_label(label).click();
        self.rest();
    }

    /// Walks to a step by the arrows.
    pub(super) fn walk_to(&mut self, step: usize) {
        while self.session().step() != step {
            let away = step as isize - self.session().step() as isize;
            let held = match away.abs() >= 10 {
                true => Modifiers::SHIFT,
                false => Modifiers::NONE,
            };
            let key = if away > 0 {
                Key::ArrowRight
            } else {
                Key::ArrowLeft
            };
            self.harness.key_press_modifiers(held, key);
            self.harness.run_steps(1);
        }
        self.rest();
    }

    /// Puts a text in place of what stands in a field.
    pub(super) fn write(&mut self, message: Message, language: Language, text: &str) {
        let label = format!(
            "{}, {}",
            self.localize(message),
            language.code().to_uppercase()
        );
        self.type_over(&label, text);
    }

    pub(super) fn type_over(&mut self, label: &str, text: &str) {
        let roles = [egui::Role::TextInput, egui::Role::MultilineTextInput];
        let role = roles.into_iter().find(|&role| {
            let mut found = self.harness.query_all_by_role_and_label(role, label);
            found.next().is_some()
        });
        let role = role.expect("a field");
        self.harness
            .get_by_role_and_label(role, label)
            .scroll_to_me();
        self.rest();
        self.harness.get_by_role_and_label(role, label).focus();
        self.rest();
        self.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        self.harness.run_steps(1);
        self.harness
            .get_by_role_and_label(role, label)
            .type_text(text);
        self.rest();
        // The keys are those of the walk again.
        self.harness
            .ctx
            .memory_mut(|memory| memory.stop_text_input());
        self.rest();
    }

    pub(super) fn text_of_lesson(&mut self) -> String {
        let (_, window) = self.harness.state_mut();
        window.author.documents.only().text().to_owned()
    }

    pub(super) fn problems(&mut self) -> String {
        let (_, window) = self.harness.state_mut();
        window.author.documents.only().in_words()
    }

    /// Chooses the explanation of that index in the list.
    pub(super) fn pick_row_of(&mut self, index: usize) {
        let (_, window) = self.harness.state_mut();
        let lesson = window.author.documents.only().value.clone();
        let code = self.session().look.language.code();
        let title = lesson["steps"][index]["title"][code].as_str().unwrap();
        self.click_there(&format!("{}  {title}", index + 1));
    }
}
