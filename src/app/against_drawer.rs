//! The user's own picture beside ours: how far off it is, what explains that, and where. A click on a pixel walks our run of it.

use super::compared_pictures::{self, Compared, Names, pictures, worst};
use super::prose::prose;
use super::session::{Against, Command, Session};
use super::{strings, style};
use crate::picture::Ink;
use crate::study::against::Comparison;
use egui::{ProgressBar, Rect, RichText, ScrollArea, Ui, UiBuilder};

const TEXT: f32 = 13.0;

const NAMES: Names = Names {
    mine: strings::COMPARE_MINE,
    reference: strings::COMPARE_REFERENCE,
    difference: strings::COMPARE_DIFFERENCE,
    pixel: strings::COMPARE_PIXEL,
};

/// Shows the comparison in `rect`.
pub fn show(session: &Session, commands: &mut Vec<Command>, rect: Rect, ui: &mut Ui) {
    let Some(against) = session.against() else {
        return;
    };
    let mut ui = ui.new_child(UiBuilder::new().max_rect(rect.shrink2(egui::vec2(8.0, 2.0))));
    ScrollArea::vertical()
        .auto_shrink(false)
        .show(&mut ui, |ui| {
            ui.spacing_mut().item_spacing.y = 4.0;
            ui.label(style::strong(&against.name, TEXT));
            if session.panel_input().is_pending() {
                ui.label(session.localize(strings::AFTER_YOUR_ANSWER));
                return;
            }
            let Some(found) = &against.found else {
                ui.label(session.localize(strings::COMPARE_DRAWING));
                return;
            };
            figures(session, found, ui);
            mistakes(session, against, found, ui);
            let compared = Compared {
                mine: &against.mine,
                found,
                version: against.version,
                names: &NAMES,
            };
            pictures(session, compared, commands, ui);
            worst(session, compared, commands, ui);
        });
}

/// Size, encoding, and how far off it is.
fn figures(session: &Session, found: &Comparison, ui: &mut Ui) {
    let language = session.look.language;
    let [width, height] = found.size;
    let size = format!("{width} × {height}");
    let encoding = match found.encoding {
        "linear" => session.localize(strings::COMPARE_LINEAR),
        _ => "sRGB",
    };
    let words = [("size", size.as_str()), ("encoding", encoding)];
    let mut said = strings::COMPARE_SIZE_IS.format(language, &words);
    said.push(' ');
    said += &match found.off {
        0 => session.localize(strings::COMPARE_EQUAL).to_owned(),
        _ => compared_pictures::figures(found, language),
    };
    ui.label(prose(session, &said, TEXT, Ink::Text));
}

/// What explains the difference, best first.
fn mistakes(session: &Session, against: &Against, found: &Comparison, ui: &mut Ui) {
    if let Some(percent) = against.percent() {
        let percent_written = percent.to_string();
        let words = [("percent", percent_written.as_str())];
        let said = strings::COMPARE_TRYING.format(session.look.language, &words);
        ui.add(ProgressBar::new(percent as f32 / 100.0).text(RichText::new(said).size(TEXT)));
        return;
    }
    if found.off > 0 && found.mistakes.is_empty() {
        ui.label(session.localize(strings::COMPARE_NO_MISTAKE));
    }
    for mistake in &found.mistakes {
        let name = mistake.mistake.in_words(session.look.language);
        let [explains, of] = [mistake.explains, mistake.of].map(|count| count.to_string());
        let words = [
            ("mistake", name.as_str()),
            ("explains", &explains),
            ("of", &of),
        ];
        let said = strings::COMPARE_EXPLAINS.format(session.look.language, &words);
        ui.label(prose(session, &said, TEXT, Ink::This));
    }
}
