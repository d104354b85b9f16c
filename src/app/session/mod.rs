//! Everything that the window shows, without a window: a [`Command`] changes it, and nothing else does.

mod against;
mod author;
mod change;
mod command;
mod document;
mod fan;
mod focus;
mod forced;
mod kept;
mod key_panel;
mod lessons;
mod link;
mod look;
mod mistakes;
mod outline;
mod own;
mod pick;
mod pin;
mod play;
mod playing;
mod preview;
mod progress_file;
mod question;
mod results;
mod search;
mod select;
mod study;
mod study_commands;
mod take_away;
mod titles;
mod turn;
mod update;
mod what_if;

#[cfg(test)]
mod tests;

pub use against::Against;
pub use command::{Choice, Command, PointAt, Refused, Sheet, StudyCommand};
pub use kept::{Kept, Progress};
pub use lessons::{Listed, listed};
pub use look::{Drawer, Look};
pub use outline::Entry;
pub use own::{FolderOfLessons, LessonFromFile};
pub use playing::Direction;
pub use progress_file::is_progress;
pub use question::Standing;
pub use results::Results;
pub use study::{Outcome, Studying, name_of_point};
pub use take_away::{Source, Wanted};

use crate::algorithms::enclosure;
use crate::algorithms::focus::Focus;
use crate::algorithms::prepared_scene::PreparedScene;
use crate::language::Message;
use crate::lesson::{Guess, Lesson, LessonError, Narrated, OpenLesson};
use crate::methods::Setup;
use crate::panels::{
    ImageView, InspectorView, Panel, PanelInput, PixelLayer, Reused, SpaceView, TreeView,
};
use crate::picture::Tag;
use crate::render::smooth_patches;
use crate::replay::Walk;
use crate::replay::rays::State;
use fan::Fan;
use look::TEXT_SIZES;
use playing::{Loop, Play};
use preview::{Methods, Preview};
use std::collections::{BTreeMap, HashMap};
use std::path::PathBuf;

/// The methods whose pictures are rendered in the background.
fn methods(open: &OpenLesson) -> Methods {
    Methods {
        picture: open.lesson.method,
        compared: open.lesson.compare.clone(),
    }
}

/// A lesson that is walked through.
///
/// Invariant: the run is the recording of `focus`; where that is the lesson's own, the narration belongs to its steps.
pub struct Session {
    open: OpenLesson,
    /// The file that the lesson is from, where it is not one of the program's own.
    pub file: Option<PathBuf>,
    /// The lessons of a folder.
    own: Option<own::Chapter>,
    focus: Focus,
    /// The step at which the lesson's own focus was left for another one.
    left_at: usize,
    /// Steps at which something is said under this focus.
    narrated: Vec<usize>,
    /// How each narrated step's question stands.
    standings: Vec<Standing>,
    /// What was answered so far, by the index of the explanation that asks.
    guesses: BTreeMap<usize, Vec<Guess>>,
    /// What has other values than the lesson gives it.
    changes: change::Changes,
    /// The recording and the step at which an arrow is turned, and its degrees so far.
    turned: Option<((u64, usize), f64)>,
    /// How far each lesson has come, by its id.
    progress: BTreeMap<String, Progress>,
    /// The scenes of one's own that were walked through, packed as in an address, by the names of their files.
    scenes: BTreeMap<String, String>,
    /// The last lesson whose progress was noted, by its id.
    kept_lesson: Option<String>,
    preview: Preview,
    /// Counts the pictures that have arrived, so that an earlier one is known to be old.
    pictures: u64,
    /// Counts the recordings, so that pictures of an earlier one are known to be old.
    recording: u64,
    breakpoints: HashMap<Focus, Vec<usize>>,
    play: Option<Play>,
    /// An index into the speeds.
    speed: usize,
    around: Loop,
    /// What of the picture is shown.
    image: ImageView,
    /// What of the scene in space is shown.
    space: SpaceView,
    fan: Fan,
    /// Which part of the ray tree is shown.
    tree: TreeView,
    reused: Reused,
    /// Which values the inspector shows.
    inspector: InspectorView,
    /// The ray tree that others are compared with, and how often one was pinned or taken away.
    pinned: Option<State>,
    pins: u64,
    /// The channel chosen for formulas.
    channel: Option<usize>,
    pub look: Look,
    hovered: Option<Tag>,
    selected: Option<select::Selected>,
    /// The key panel that the user has chosen.
    chosen: Option<Panel>,
    /// Whether the key panel fills the window.
    filled: bool,
    results: Option<Results>,
    /// The search text of the last search.
    pub search: String,
    /// Whether the keyboard should go to the search field; the window takes this.
    pub search_wanted: bool,
    /// A command line on its way to the clipboard; the window takes this.
    pub shared: Option<String>,
    /// What the window is to save, load or copy.
    pub wanted: Wanted,
    studying: Studying,
    /// The picture that is compared with ours.
    against: Option<Against>,
    what_if: what_if::WhatIf,
}

impl Session {
    /// Opens a lesson at its first explanation. Errors: those of the lesson.
    pub fn new(lesson: Lesson) -> Result<Self, LessonError> {
        let open = lesson.open()?;
        let mut session = Session {
            focus: open.lesson.focus,
            file: None,
            own: None,
            left_at: 0,
            narrated: Vec::new(),
            standings: Vec::new(),
            guesses: BTreeMap::new(),
            changes: Default::default(),
            turned: None,
            progress: BTreeMap::new(),
            scenes: BTreeMap::new(),
            kept_lesson: None,
            preview: Preview::new(open.setup.clone(), methods(&open)),
            pictures: 0,
            recording: 0,
            breakpoints: HashMap::new(),
            play: None,
            speed: playing::NORMAL_SPEED,
            around: Loop::default(),
            image: ImageView::WHOLE,
            space: SpaceView::default(),
            fan: Fan::default(),
            tree: TreeView::WHOLE,
            reused: Reused::default(),
            pinned: None,
            pins: 0,
            inspector: InspectorView::WHOLE,
            channel: None,
            look: Look::new(),
            hovered: None,
            selected: None,
            chosen: None,
            filled: false,
            results: None,
            search: String::new(),
            search_wanted: false,
            shared: None,
            wanted: Wanted::default(),
            studying: Studying::new(),
            against: None,
            what_if: Default::default(),
            open,
        };
        session.start_over();
        Ok(session)
    }

    /// Puts another lesson in place of this one, where it was left; what belongs to the user (language, theme, speed) stays.
    fn replace(&mut self, lesson: Lesson) -> Result<(), LessonError> {
        let open = lesson.open()?;
        self.note_progress();
        self.forget_comparison();
        self.what_if.forget();
        self.preview = Preview::new(open.setup.clone(), methods(&open));
        self.focus = open.lesson.focus;
        self.changes = Default::default();
        self.open = open;
        self.start_over();
        self.resume();
        Ok(())
    }

    fn start_over(&mut self) {
        self.recording += 1;
        self.chosen = None;
        self.filled = false;
        self.look.sheet = None;
        self.results = None;
        let radiosity: enclosure::Settings = self.open.setup.settings.get();
        self.look.smooth = radiosity.smooth;
        self.look.unshot = false;
        self.narrated = self.open.narrated.iter().map(|said| said.step).collect();
        self.standings = vec![Standing::Open; self.open.lesson.explanations()];
        self.guesses.clear();
        self.turned = None;
        self.breakpoints.clear();
        self.play = None;
        self.around = Loop::default();
        self.image = ImageView::WHOLE;
        self.space = SpaceView::default();
        self.channel = None;
        self.tree = TreeView::WHOLE;
        self.pinned = None;
        self.inspector = InspectorView::WHOLE;
        self.hovered = None;
        self.selected = None;
        let first = self.narrated.first().copied().unwrap_or(0);
        self.open.run.walk_mut().seek(first);
    }

    /// The scene in front of its camera.
    pub fn prepared(&self) -> &PreparedScene {
        &self.open.setup.prepared
    }

    pub fn setup(&self) -> &Setup {
        &self.open.setup
    }

    pub fn lesson(&self) -> &Lesson {
        &self.open.lesson
    }

    pub fn walk(&self) -> &dyn Walk {
        self.open.run.walk()
    }

    /// The step that is shown.
    pub fn step(&self) -> usize {
        self.walk().position()
    }

    /// The last step, by its number.
    pub fn last_step(&self) -> usize {
        self.walk().len().saturating_sub(1)
    }

    pub fn focus(&self) -> Focus {
        self.focus
    }

    /// Whether the focus is the lesson's own.
    pub fn follows_lesson(&self) -> bool {
        self.focus == self.open.lesson.focus
    }

    /// Counts the recordings of this session.
    pub fn recording(&self) -> u64 {
        self.recording
    }

    /// Takes what has arrived of the whole picture, which is rendered in the background.
    pub fn take_picture(&mut self) {
        if self.image.layer != PixelLayer::Color {
            self.preview
                .survey(&self.open.setup, self.open.run.method());
        }
        self.pictures += u64::from(self.preview.take());
    }

    /// Counts the pictures that were taken.
    pub fn pictures(&self) -> u64 {
        self.pictures
    }

    /// Whether the whole picture is still being rendered.
    pub fn awaits_picture(&self) -> bool {
        !self.preview.is_done()
    }

    /// How much of the whole picture is rendered, in percent, where it takes long.
    pub fn picture_percent(&self) -> Option<usize> {
        self.preview.percent()
    }

    /// Waits for the whole picture.
    #[cfg(test)]
    pub fn wait_for_picture(&mut self) {
        self.preview.wait();
        self.pictures += 1;
    }

    pub fn panel_input(&self) -> PanelInput<'_> {
        PanelInput {
            run: &self.open.run,
            finished: self.preview.finished(),
            focus: self.focus,
            language: self.look.language,
            narrated: &self.narrated,
            breakpoints: self.breakpoints(),
            tree: &self.tree,
            pinned: self.pinned.as_ref(),
            inspector: &self.inspector,
            presented: self.presented(),
            channel: self.channel,
            image: self.image,
            space: self.space,
            fan: self.fan.rays(),
            smooth: self.look.smooth.then_some(smooth_patches),
            pending: self.pending(),
            waiting: self.question_between(self.step(), usize::MAX),
            answered: self.answered(),
            selected: self.selected_step(),
            unshot: self.look.unshot,
            pair: self.pair(),
            reused: Some(self.reused.of(self.recording, self.pictures)),
        }
    }

    /// What is said at exactly this step.
    pub fn narration_here(&self) -> Option<&Narrated> {
        self.narrated_here().map(|index| &self.open.narrated[index])
    }

    fn narrated_here(&self) -> Option<usize> {
        self.narrated.binary_search(&self.step()).ok()
    }

    /// Ascending.
    pub fn breakpoints(&self) -> &[usize] {
        self.breakpoints.get(&self.focus).map_or(&[], |steps| steps)
    }

    pub fn image(&self) -> ImageView {
        self.image
    }

    pub fn space(&self) -> SpaceView {
        self.space
    }

    /// The pixels whose rays are shown in space beside those of the run.
    pub fn fan(&self) -> &Fan {
        &self.fan
    }

    pub fn inspector(&self) -> &InspectorView {
        &self.inspector
    }

    pub fn tree(&self) -> &TreeView {
        &self.tree
    }

    pub fn hovered(&self) -> Option<Tag> {
        self.hovered
    }

    pub fn localize(&self, strings: Message) -> &'static str {
        strings.text(self.look.language)
    }
}
