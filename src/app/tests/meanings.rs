//! What a value means is said where the pointer rests on it.

use super::triangle;
use crate::app::session::Command;
use crate::panels::Panel;
use crate::panels::strings::Language;
use crate::picture::Tag;
use egui_kittest::kittest::Queryable;

#[test]
fn a_value_under_the_pointer_is_explained_in_the_readers_language() {
    for (language, meaning) in [
        (Language::English, "the intensity where the scan line cuts"),
        (Language::Indonesian, "intensitas di potongan garis scan"),
    ] {
        let mut screen = triangle([Command::Questions, Command::Speak(language)]);
        let walk = screen.session().walk();
        let step = (0..walk.len()).find(|&step| walk.kind(step) == "EdgeInterpolated");
        let step = step.expect("an edge is cut");
        screen
            .session_mut()
            .update(Command::Seek(step))
            .expect("a step of the run");
        screen.harness.run();
        let name = screen.place_of(Panel::Inspector, Tag::Field("I_4"));
        let at = name.left_center() + egui::vec2(4.0, 0.0);
        screen.harness.hover_at(at);
        screen.harness.run();
        screen.keep(&format!("meaning-{}", language.code()));
        let mut found = screen.harness.query_all_by_label_contains(meaning);
        assert!(found.next().is_some(), "{meaning}");
    }
}
