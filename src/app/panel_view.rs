//! A panel on the screen.

use super::layout;
use super::picture_place::Place;
use super::picture_view::PictureView;
use super::prose::prose;
use super::said_beside::said_beside;
use super::session::{Command, Session};
use super::strings;
use super::style;
use crate::algorithms::focus::Focus;
use crate::language::Language;
use crate::panels::{self, Answered, ImageView, InspectorView, Panel, SpaceView, TreeView, draw};
use crate::picture::{Ink, Tag};
use crate::record::Value;
use crate::vocabulary::counted;
use egui::{Rect, Response, Sense, Ui};

/// All that a panel's picture depends on, its place and highlights aside.
#[derive(Clone, PartialEq)]
pub struct Key {
    recording: u64,
    /// Of what is made in the background; always 0 where a panel does not show it.
    pictures: u64,
    step: usize,
    language: Language,
    breakpoints: Vec<usize>,
    /// Of the ray tree alone.
    tree: Option<(TreeView, u64)>,
    /// Of the inspector alone.
    inspector: Option<InspectorView>,
    /// Of formulas alone.
    channel: Option<usize>,
    presented: bool,
    /// Of the image alone.
    image: Option<ImageView>,
    /// Of the scene in space alone.
    space: Option<(SpaceView, u64)>,
    /// Of the room alone.
    smooth: bool,
    unshot: bool,
    /// Of the room and the scene in space.
    pair: Option<[usize; 2]>,
    /// Whether a question waits, and the last step that is not hidden by one.
    pending: (bool, usize),
    answered: Answered,
    /// Of the inspector alone.
    selected: Option<usize>,
}

/// How large a panel's picture is shown.
#[derive(Clone, Copy, PartialEq)]
pub enum Scale {
    /// Laid out for the room that it has.
    Full,
    /// Laid out for more room, where it has too little to be read.
    Small,
    /// All of it so many times as large, for those who sit far away.
    Times(f32),
}

/// A panel from frame to frame.
pub type PanelView = PictureView<Key>;

impl PanelView {
    /// Shows the panel in `rect` at that scale. Returns the response, and what lies under the pointer.
    pub fn show(
        &mut self,
        session: &Session,
        panel: Panel,
        rect: Rect,
        scale: Scale,
        ui: &mut Ui,
    ) -> (Response, Option<Tag>) {
        let mut place = Place::on_pixels(rect, session.look.theme, ui);
        place = match scale {
            Scale::Full => place,
            Scale::Small => place.laid_out_for(layout::SMALL),
            Scale::Times(zoom) => place.enlarged(zoom),
        };
        let key = Key::new(session, panel);
        self.draw(place, key, session.lit(), ui, |size| {
            draw(panel, &session.panel_input(), size)
        });
        let sense = if scale == Scale::Full
            && matches!(
                panel,
                Panel::TimeLine
                    | Panel::Inspector
                    | Panel::RayTree
                    | Panel::Space
                    | Panel::Vectors
                    | Panel::Image
                    | Panel::ScanLine
                    | Panel::Comparison
                    | Panel::Difference
            ) {
            Sense::click_and_drag()
        } else {
            Sense::click()
        };
        let response = ui.interact(place.rect, ui.scope_id().with(panel.name()), sense);
        let under = self.paint(place, session.localize(panel.title()), &response, ui);
        if let Some(tag) = under
            && let Some(meaning) = meaning(session, panel, tag)
        {
            let text = prose(session, &meaning, 13.0, Ink::Text);
            said_beside(&response, self.bounds(tag, place), text);
        }
        (response, under)
    }
}

impl Key {
    pub fn new(session: &Session, panel: Panel) -> Self {
        Key {
            recording: session.recording(),
            pictures: match panel {
                Panel::Image | Panel::Race => session.pictures(),
                _ if panel.compares() => session.pictures(),
                _ => 0,
            },
            step: session.step(),
            language: session.look.language,
            breakpoints: session.breakpoints().to_vec(),
            tree: (panel == Panel::RayTree).then(|| (session.tree().clone(), session.pins())),
            inspector: (panel == Panel::Inspector).then(|| session.inspector().clone()),
            channel: session
                .panel_input()
                .channel
                .filter(|_| panel == Panel::Formula),
            presented: panel == Panel::Formula && session.look.presenting,
            image: (panel == Panel::Image || panel.compares()).then(|| session.image()),
            space: (panel == Panel::Space).then(|| (session.space(), session.fan().version())),
            smooth: matches!(panel, Panel::Radiosity | Panel::Image) && session.look.smooth,
            unshot: panel == Panel::Radiosity && session.look.unshot,
            pair: session
                .pair()
                .filter(|_| matches!(panel, Panel::Radiosity | Panel::Space)),
            pending: {
                let input = session.panel_input();
                (input.is_pending(), input.last_known())
            },
            answered: session.panel_input().answered,
            selected: session
                .selected_step()
                .filter(|_| panel == Panel::Inspector),
        }
    }
}

/// What the value under the pointer means; of a pixel, what it is; of a patch and a form factor, what is known of them.
fn meaning(session: &Session, panel: Panel, tag: Tag) -> Option<String> {
    let shows_patches = matches!(panel, Panel::Radiosity | Panel::Space | Panel::Matrix);
    match tag {
        Tag::Field(name) if panel == Panel::Inspector => {
            let input = session.panel_input();
            let step = session.inspected();
            panels::meaning_and_origin(input.run, step, name, input.language)
        }
        Tag::Patch(patch) if shows_patches => panels::patch_values(&session.panel_input(), patch),
        Tag::FormFactor { i, j } => panels::form_factor_values(&session.panel_input(), [i, j]),
        Tag::Field(name) => {
            panels::meaning(session.walk(), session.step(), name, session.look.language)
        }
        Tag::Pixel { x, y } if panel.compares() => {
            panels::compared_values(&session.panel_input(), x, y)
        }
        Tag::Pixel { x, y } if panel == Panel::Image => {
            let input = session.panel_input();
            let pixel = panels::pixel_value(&input, x, y);
            let patch = session.patch_at(x, y);
            let patch = patch.and_then(|patch| panels::patch_values(&input, patch));
            Some(patch.map_or(pixel.clone(), |patch| format!("{pixel}\n{patch}")))
        }
        _ => None,
    }
}

/// What else can be done at a place of a picture, as a menu.
pub fn menu(session: &Session, tag: Option<Tag>, ui: &mut Ui) -> Option<Command> {
    let mut choices: Vec<(String, Command)> = Vec::new();
    if let Some(Tag::Pixel { x, y }) = tag {
        choices.push((
            crate::panels::strings::focus(Focus::Pixel { x, y }, session.look.language),
            Command::Focus(Focus::Pixel { x, y }),
        ));
        choices.push((
            strings::LINE.format(session.look.language, &[("y", &y.to_string())]),
            Command::Focus(Focus::ScanLine(y)),
        ));
        choices.push((
            session.localize(strings::POLYGON).to_owned(),
            Command::FocusOnPolygonAt { x, y },
        ));
    }
    choices.push((
        session.localize(strings::FRAME).to_owned(),
        Command::Focus(Focus::Frame),
    ));
    if !session.follows_lesson() {
        choices.push((
            session.localize(strings::THE_LESSONS_PART).to_owned(),
            Command::Focus(session.lesson().focus),
        ));
    }
    ui.label(style::strong(session.localize(strings::FOCUS_ON), 13.0));
    let chosen = choices
        .into_iter()
        .find(|(label, _)| ui.button(label).clicked());
    chosen.map(|(_, command)| command)
}

/// The part of the run that is looked at, in words.
pub fn focus_words(session: &Session) -> String {
    crate::panels::strings::focus(session.focus(), session.look.language)
}

/// The quiet words at the right of a panel's title.
pub fn caption(session: &Session, panel: Panel) -> String {
    let walk = session.walk();
    let whole = |name| match walk.is_empty() {
        true => None,
        false => match walk.fields(session.step()).get(name) {
            Some(value) => match counted(name, value) {
                Value::Integer(value) => Some(value),
                _ => None,
            },
            None => None,
        },
    };
    match panel {
        Panel::Image => session
            .picture_percent()
            .map(|percent| {
                strings::MAKING_THE_PICTURE
                    .format(session.look.language, &[("percent", &percent.to_string())])
            })
            .unwrap_or_default(),
        Panel::ScanLine => whole("y").map(|y| format!("y = {y}")).unwrap_or_default(),
        Panel::ActiveEdges => session.localize(strings::CLICK_A_ROW).to_owned(),
        Panel::Vertex => whole("vertex")
            .map(|vertex| vertex.to_string())
            .unwrap_or_default(),
        _ => String::new(),
    }
}
