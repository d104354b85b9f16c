//! What the window remembers from frame to frame.

use super::home::HomePage;
use super::keeper::Keeper;
use super::mistakes_page::MistakesPage;
use super::opened::Opened;
use super::panel_view::{Key, PanelView};
use super::scene_page::ScenePage;
use super::study_plot::StudyPlot;
use crate::panels::Panel;
use crate::picture::Theme;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;

/// What the window keeps that the session need not know: textures, tile borders, half-typed texts.
#[derive(Default)]
pub struct Window {
    pub(super) views: HashMap<Panel, PanelView>,
    pub(super) study_plot: StudyPlot,
    pub(super) home: HomePage,
    pub(super) mistakes: MistakesPage,
    pub(super) scene_page: ScenePage,
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

/// How the user has divided the window; what was not chosen is as usual. It is kept from one start of the program to the next.
#[derive(Clone, Copy, Debug, Default, PartialEq, Deserialize, Serialize)]
#[serde(default)]
pub(super) struct Borders {
    /// Width of the left column.
    pub column: Option<f32>,
    /// Height of the time line without its buttons.
    pub time_line: Option<f32>,
}
