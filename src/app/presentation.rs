//! Presentation: the key panel, one formula and one sentence, readable from eight times the screen's height.

use super::layout::{GAP, MARGIN};
use super::panel_on::entered;
use super::panel_view::Scale;
use super::prose::{prose, set};
use super::session::{Command, Session, Standing};
use super::window_state::Window;
use super::{strings, style};
use crate::lesson::{Answer, Question};
use crate::panels::Panel;
use crate::picture::{Ink, Tag};
use egui::{FontId, Id, Label, LayerId, Rect, ScrollArea, Stroke, Ui, Vec2, pos2};

/// Heights of the least text in the height of the screen.
const LINES: f32 = 28.0;
/// The least text of a panel, in points.
const LEAST_TEXT: f32 = 11.0;
/// Parts of the height for the key panel: beside a sentence, a question, and an answer with its reason.
const KEY: f32 = 0.64;
const KEY_ASKED: f32 = 0.51;
const KEY_ANSWERED: f32 = 0.46;
/// Part of the width for the sentence.
const SAID: f32 = 0.5;

/// Where what is presented stands, and how large it is.
pub struct Places {
    pub key: Rect,
    pub said: Rect,
    /// Empty beside a question.
    pub formula: Rect,
    /// Height of the text.
    text: f32,
}

impl Places {
    /// `asked` is how a question stands, where there is one.
    pub fn new(whole: Rect, asked: Option<Standing>) -> Self {
        let (key, said) = match asked {
            None => (KEY, SAID),
            Some(Standing::Open) => (KEY_ASKED, 1.0),
            Some(_) => (KEY_ANSWERED, 1.0),
        };
        let inner = whole.shrink(GAP);
        let border = inner.top() + key * inner.height();
        let column = inner.left() + said * inner.width();
        Places {
            key: Rect::from_min_max(inner.min, pos2(inner.right(), border)).shrink(MARGIN),
            said: Rect::from_min_max(
                pos2(inner.left(), border + GAP),
                pos2(column, inner.bottom()),
            ),
            formula: Rect::from_min_max(pos2(column + GAP, border + GAP), inner.max).shrink(MARGIN),
            text: whole.height() / LINES,
        }
    }

    /// How much larger than usual panels are.
    pub fn zoom(&self) -> f32 {
        self.text / LEAST_TEXT
    }
}

/// Shows the presentation in `whole`; returns what lies under the pointer.
pub fn show(
    session: &Session,
    window: &mut Window,
    whole: Rect,
    commands: &mut Vec<Command>,
    ui: &mut Ui,
) -> Option<Tag> {
    let question = session.question();
    let places = Places::new(whole, question.map(|(_, standing)| standing));
    let mut under = None;
    let formula = question.is_none().then_some(Panel::Formula);
    let panels = [(session.key_panel(), places.key), (formula, places.formula)];
    for (panel, rect) in panels {
        let Some(panel) = panel else { continue };
        style::card(session.look.theme, rect.expand(MARGIN), ui);
        let view = window.views.entry(panel).or_default();
        let scale = Scale::Times(places.zoom());
        let (response, tag) = view.show(session, panel, rect, scale, ui);
        let goes = response.double_clicked() || entered(&response, ui);
        if goes || response.clicked() {
            commands.extend(tag.map(|tag| match goes {
                true => Command::Go(tag),
                false => Command::Click(tag),
            }));
        }
        under = tag.or(under);
    }
    let Places { said, text, .. } = places;
    style::card(session.look.theme, said, ui);
    let mut ui = ui.new_child(egui::UiBuilder::new().max_rect(said.shrink(0.5 * text)));
    ScrollArea::vertical()
        .id_salt((session.recording(), session.step()))
        .show(&mut ui, |ui| {
            ui.set_width(ui.available_width());
            match question {
                Some((question, standing)) => asked(session, question, standing, text, ui),
                None => sentence(session, window, text, ui),
            }
        });
    spot(session, whole.height(), &ui);
    under
}

/// What is said here in one sentence, or what the step does.
fn sentence(session: &Session, window: &Window, size: f32, ui: &mut Ui) {
    let said = session.narration_here();
    let said = said.map(|said| first_sentence(said.text(session.look.language)));
    let step = window.views.get(&Panel::Formula).map(|view| view.alt());
    let words = said.or(step).unwrap_or_default();
    ui.add(Label::new(prose(session, words, size, Ink::Text)).wrap());
}

/// Up to the first full stop, question mark or exclamation mark that a space or a new line follows.
fn first_sentence(text: &str) -> &str {
    let mut ends = text.char_indices().filter(|&(at, c)| {
        matches!(c, '.' | '?' | '!') && text[at + 1..].starts_with(char::is_whitespace)
    });
    ends.next().map_or(text, |(at, _)| &text[..=at])
}

/// A question for the room; a key shows the answer.
fn asked(session: &Session, question: &Question, standing: Standing, size: f32, ui: &mut Ui) {
    let language = session.look.language;
    ui.add(Label::new(prose(session, question.ask(language), size, Ink::Text)).wrap());
    if standing == Standing::Open {
        if let Answer::Choice { options, .. } | Answer::Order { items: options, .. } =
            &question.answer
        {
            for (letter, option) in ('A'..).zip(options) {
                let option = format!("{letter}  {}", option[language as usize]);
                ui.add(Label::new(prose(session, &option, size, Ink::Linked)).wrap());
            }
        }
        let text = session.localize(strings::ANSWER_WITH_A_KEY);
        ui.add(Label::new(prose(session, text, size, Ink::Muted)).wrap());
    } else {
        let mut answer = question.answer.in_words(language);
        if let Answer::Choice { right, .. } = question.answer
            && let Some(letter) = ('A'..).nth(right)
        {
            answer = format!("{letter}  {answer}");
        }
        let answer = set(
            session,
            &answer,
            FontId::new(size, style::bold()),
            Ink::Good,
        );
        ui.add(Label::new(answer).wrap());
        ui.add(Label::new(prose(session, question.why(language), size, Ink::Text)).wrap());
    }
}

/// A spot around the pointer, which the back row sees. Where everything became larger or smaller, its place is known when it moves.
fn spot(session: &Session, height: f32, ui: &Ui) {
    let zoom = ui.ctx().zoom_factor();
    let moved = ui.input(|input| input.pointer.delta() != Vec2::ZERO);
    let moved_at = ui.data_mut(|data| {
        let moved_at = data.get_temp_mut_or(Id::unique("spot"), 0.0);
        if moved {
            *moved_at = zoom;
        }
        *moved_at
    });
    let at = ui.input(|input| input.pointer.hover_pos());
    let Some(at) = at.filter(|_| moved_at == zoom) else {
        return;
    };
    let ink = style::color(session.look.theme, Ink::This);
    let radius = height / LINES;
    let painter = ui.ctx().layer_painter(LayerId::new(
        egui::Order::Foreground,
        egui::Id::unique("spot"),
    ));
    painter.circle_filled(at, radius, ink.gamma_multiply(0.18));
    painter.circle_stroke(at, radius, Stroke::new(0.12 * radius, ink));
}
