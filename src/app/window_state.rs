//! What the window remembers from frame to frame.

use super::author::Author;
use super::background::Work;
use super::borders::Borders;
use super::home::HomePage;
use super::keeper::{BUSY, Keeper, Saved, State};
use super::mistakes_page::MistakesPage;
use super::opened::Opened;
use super::panel_view::{Key, PanelView};
use super::scene_page::ScenePage;
use super::session::Session;
use super::study_plot::StudyPlot;
use super::take_away::Taking;
use crate::language::Message;
use crate::panels::Panel;
use crate::picture::Theme;
use std::collections::HashMap;
use std::path::PathBuf;

/// What was decided about closing the window over changes that are not saved.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) enum Closing {
    #[default]
    No,
    Asked,
    Agreed,
}

/// What the window keeps that the session need not know: textures, tile borders, half-typed texts.
#[derive(Default)]
pub struct Window {
    pub(super) views: HashMap<Panel, PanelView>,
    pub(super) study_plot: StudyPlot,
    pub(super) home: HomePage,
    pub(super) mistakes: MistakesPage,
    pub(super) scene_page: ScenePage,
    pub(super) author: Author,
    pub(super) answer: String,
    /// Whether the answer was given, and is no number.
    pub(super) misread: bool,
    /// The recording and the step at which items are put in order, and their order so far.
    pub(super) order: ((u64, usize), Vec<usize>),
    /// The recording, step and number of answers for which the question was brought into view.
    pub(super) asked: Option<(u64, usize, usize)>,
    pub(super) search: String,
    /// Why the last command was refused, or what it did, until the next one.
    pub(super) notice: Option<String>,
    pub(super) borders: Borders,
    /// Files that are opened in the window; none in tests.
    pub(super) opened: Option<Opened>,
    /// Whether it stands in a page of somebody else's, without its bar.
    pub(super) embedded: bool,
    /// A file that is being asked for.
    pub(super) choosing: Option<Work<Result<Option<PathBuf>, Message>>>,
    /// What is made to be taken away.
    pub(super) taking: Vec<Taking>,
    pub(super) closing: Closing,
    /// Where progress is kept; nowhere in tests.
    pub(super) keeper: Option<Keeper>,
    /// The least heights of the first formula and of all, with their numbers, and what they depend on.
    pub(super) formula: Option<(Key, f32, [f32; 2])>,
    /// Height of narration and question in the frame before.
    pub(super) said_height: f32,
    /// The theme, and whether what can be pressed is as large as a finger needs it.
    pub(super) styled: Option<(Theme, bool)>,
    pub(super) title: String,
    pub(super) full_screen: bool,
    /// That of the page, without what follows its `#`; none on a screen.
    pub(super) address: Option<String>,
    /// When the frame before was shown, in seconds.
    pub(super) time: Option<f64>,
}

impl Window {
    /// Keeps progress and settings, if they have changed.
    pub(super) fn keep(&mut self, session: &mut Session, ctx: &egui::Context) {
        let Some(keeper) = &mut self.keeper else {
            return;
        };
        let state = State {
            session: session.keep(),
            layout: self.borders,
        };
        match keeper.save(&state) {
            Ok(Saved::Busy) => ctx.request_repaint_after(BUSY),
            Ok(_) => {}
            Err(trouble) => {
                self.notice = Some(trouble.in_language(session.look.language));
                ctx.request_repaint();
            }
        }
    }
}
